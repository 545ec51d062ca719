"""The command line of the benchmarks."""

import argparse
import json
import sys
from collections.abc import Sequence
from importlib import import_module

from mocapmend.bench.table import Table

SCHEMA = 1
BENCHES = {
    "io": "reading and saving a large C3D file, against plain numpy and a file copy",
    "gui": "scrubbing a large recording, and the time to the first picture",
}


def main(argv: Sequence[str]) -> int:
    """Run a benchmark and print its table; return the exit code."""
    parser = argparse.ArgumentParser(prog="mocapmend bench", description=__doc__)
    commands = parser.add_subparsers(dest="bench", required=True)
    for name, text in BENCHES.items():
        bench = commands.add_parser(name, help=text, description=text)
        bench.add_argument("--json", action="store_true", help="print the table as JSON")
        bench.add_argument(
            "--runs", type=_positive, default=5, help="counted runs (median is shown)"
        )
        bench.add_argument(
            "--frames", type=_frames, default=100_000, help="frames of the recording"
        )
    arguments = parser.parse_args(argv)
    module = import_module(f"mocapmend.bench.{arguments.bench}")
    table: Table = module.run(frames=arguments.frames, runs=arguments.runs)
    if arguments.json:
        document = {"schema": SCHEMA, "command": f"bench {arguments.bench}", **table.as_json()}
        sys.stdout.write(json.dumps(document, indent=2) + "\n")
    else:
        sys.stdout.write(table.as_markdown())
    return 0


def _positive(text: str) -> int:
    return _at_least(text, 1)


def _frames(text: str) -> int:
    return _at_least(text, 100)


def _at_least(text: str, least: int) -> int:
    value = int(text)
    if value < least:
        raise argparse.ArgumentTypeError(f"at least {least}, not {value}")
    return value
