"""The command line of the benchmarks."""

import argparse
import json
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import Any, Protocol

SCHEMA = 1
BENCHES = {
    "io": "reading and saving a large C3D file, against numpy, a file copy, c3d and ezc3d",
    "gui": "speed, pauses and memory of the window, against pyqtgraph and MNE-Qt-Browser",
    "kalman": "the constant-velocity filter: a paper's experiment, and its speed beside filterpy",
    "fuzz": "damaged files: each must open or be refused, soon and without much memory",
    "poses": "sparse codes of poses: dictionary size, gap length, missing markers",
    "paper": "a paper's experiment: joints of a skeleton, neighbours missing for long",
    "smoothing": "noise taken away and motion lost by smoothing, on recordings with added noise",
    "labels": "points without names labelled from other recordings, against a fixed pose",
    "gaps": "methods of repair on gap cases with known truth, against published methods",
    "kinect": "refinement of Kinect joints by networks, against regressions, on UI-PRMD",
    "problems": "detectors of bad samples, on recordings with errors put in",
}
"""Each is a module with `add_arguments(parser)` and `run(arguments)`, which returns a result."""


class Result(Protocol):
    """What a benchmark found: a `Table` or a `Report`."""

    @property
    def failed(self) -> bool:
        """Whether the program did something wrong: then the command ends with code 1."""

    def as_json(self) -> dict[str, Any]:
        """Return it for a JSON document."""

    def as_markdown(self) -> str:
        """Return it as the documentation has it."""


def main(argv: Sequence[str]) -> int:
    """Run a benchmark and print what it found; return the exit code."""
    name = _name(argv[:1])
    module = import_module(f"mocapmend.bench.{name}")
    parser = argparse.ArgumentParser(prog=f"mocapmend bench {name}", description=module.__doc__)
    module.add_arguments(parser)
    parser.add_argument("--json", action="store_true", help="print the table as JSON")
    arguments = parser.parse_args(argv[1:])
    result: Result = module.run(arguments)
    if arguments.json:
        document = {"schema": SCHEMA, "command": f"bench {name}", **result.as_json()}
        sys.stdout.write(json.dumps(document, indent=2) + "\n")
    else:
        sys.stdout.write(result.as_markdown())
    return int(result.failed)


def _name(argv: Sequence[str]) -> str:
    """Read which benchmark is asked for, without loading any."""
    parser = argparse.ArgumentParser(prog="mocapmend bench", description=__doc__)
    commands = parser.add_subparsers(dest="bench", required=True)
    for name, text in BENCHES.items():
        commands.add_parser(name, help=text)
    chosen: str = parser.parse_args(argv).bench
    return chosen
