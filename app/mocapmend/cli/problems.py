"""List the samples of a file that are there but wrong, the most harmful first.

Harm is the estimated deviation from the truth times frames, so that it compares with gaps. What
several detectors find is listed once, as what explains it best.
"""

import argparse
import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from mocapmend import engine
from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.cli.usage import UsageError
from mocapmend.files import Source, read_recording
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms import params as parameters
from mocapmend_algorithms.problems import BadRun, detect
from mocapmend_algorithms.problems.registry import DETECTORS, detector, remedy
from mocapmend_algorithms.progress import part


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    common.add_file(parser)
    parser.add_argument(
        "--only",
        type=_kinds,
        metavar="KIND,...",
        help=f"kinds of problems to look for: {', '.join(DETECTORS)} (default: all)",
    )
    names = [f"{kind}.{name}" for kind, way in DETECTORS.items() for name in _names(way.params)]
    parser.add_argument(
        "--param",
        action="append",
        default=[],
        metavar="KIND.NAME=VALUE",
        help="a parameter of what looks for a kind, such as spikes.least_mm=5; may be given "
        f"several times. There are: {', '.join(names)}",
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print every bad run and return the exit code."""
    params = _params(arguments.only, arguments.param)
    source = read_recording(arguments.file)
    common.show_warnings(source, console)
    recording = source.measured
    console.start("Looking for problems")
    skeleton = engine.find_skeleton(source, part(console.progress, 0.0, 0.1))
    looked = part(console.progress, 0.1, 1.0)
    found = detect(recording, skeleton, arguments.only, looked, params=params)
    found.sort(key=lambda each: (-each.harm, each.marker, each.start))
    samples = _samples(recording, found)
    console.result(
        **common.facts(source),
        kinds=list(params),
        parameters={kind: dataclasses.asdict(own) for kind, own in params.items()},
        problems=[_as_json(source, each) for each in found],
        bad_samples=samples,
    )
    if found:
        headers = ("Kind", "Marker", "Other", ">Frames", ">Length", ">Deviation", ">Harm", ">Sure")
        console.table((*headers, "Reason"), [_row(recording, each) for each in found])
    console.say(
        f"{common.count(len(found), 'problem')}, {common.count(samples, 'bad sample')} "
        f"of {int(np.count_nonzero(recording.present))}."
    )
    return 0


def _kinds(text: str) -> list[str]:
    try:
        return [detector(name.strip()).id for name in text.split(",")]
    except KeyError as error:
        raise argparse.ArgumentTypeError(error.args[0]) from None


def _names(params: type[Any]) -> list[str]:
    return [field.name for field in dataclasses.fields(params)]


def _params(only: Sequence[str] | None, given: Sequence[str]) -> dict[str, Any]:
    """Return the parameters of each kind that is looked for."""
    pairs: dict[str, dict[str, str]] = {kind: {} for kind in only or DETECTORS}
    for name, value in common.name_values("--param", given).items():
        kind, _, own = name.partition(".")
        if kind not in pairs:
            kinds = ", ".join(pairs)
            raise UsageError(f"--param takes KIND.NAME=VALUE, with a kind of {kinds}; not {name!r}")
        pairs[kind][own] = value
    try:
        return {kind: parameters.parse(detector(kind).params, own) for kind, own in pairs.items()}
    except ValueError as error:
        raise UsageError(f"--param: {error}") from None


def _samples(recording: Recording, found: Sequence[BadRun]) -> int:
    """Count the samples that are bad; those of both markers of a swap."""
    bad = np.zeros_like(recording.present)
    for each in found:
        bad[each.start : each.stop, each.marker] = True
        if each.kind == "swaps" and each.other is not None:
            bad[each.start : each.stop, each.other] = True
    return int(np.count_nonzero(bad & recording.present))


def _as_json(source: Source, found: BadRun) -> dict[str, Any]:
    recording = source.measured
    run_of_frames = Gap(found.marker, found.start, found.stop)
    return {
        **common.bad_run(recording, found),
        "length_frames": found.length,
        "length_ms": common.milliseconds(recording, run_of_frames),
        "harm_mm_frames": float(found.deviation * found.length * recording.mm),
        "remedy": remedy(found),
    }


def _row(recording: Recording, found: BadRun) -> tuple[str, ...]:
    known = found.deviation == found.deviation
    away = f"{found.deviation * recording.mm:.0f} mm" if known else "?"
    return (
        found.kind,
        recording.labels[found.marker],
        "" if found.other is None else recording.labels[found.other],
        common.frames_text(recording, Gap(found.marker, found.start, found.stop)),
        str(found.length),
        away,
        f"{found.harm * recording.mm:.0f}" if known else "?",
        f"{100 * found.score:.0f} %",
        found.reason,
    )
