"""Fill gaps and write a repaired copy in which nothing else differs.

A C3D file is copied and patched. A recording of another format, or for another format, is written
as a new file; the ending of OUT says which.

Without limits, gaps stay open whose expected error is above 20 mm or could not be estimated, and
where the method interpolates those longer than 0.2 s (shorter ones are filled without an estimate
too); the output lists them. --max-error and --max-gap replace these limits.
"""

import argparse
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from mocapmend import repairing
from mocapmend.cli import common, outcome, target
from mocapmend.cli.console import Console
from mocapmend.cli.usage import UsageError
from mocapmend.plan import Plan, Smoothing, read_plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request
from mocapmend.report import check_report_ending
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.problems.registry import DETECTORS, chosen
from mocapmend_algorithms.smooth import registry as smoothers
from mocapmend_algorithms.smooth.registry import SMOOTHERS, Smoother
from mocapmend_resources import training

DEFAULT_METHOD = "auto"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    parser.add_argument("file", type=Path, metavar="IN", help="a recording")
    target.add_arguments(parser)
    parser.add_argument(
        "--method",
        type=_method,
        metavar="ID",
        help=f"one of {', '.join(registry.METHODS)} (default: {DEFAULT_METHOD})",
    )
    parser.add_argument(
        "--param",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="a parameter of the method, such as donors=LASI,RASI, or training=SET: a file of "
        f"“mocapmend train”, or one that ships{_shipped()}; may be given several times",
    )
    parser.add_argument(
        "--max-gap", type=_frames, metavar="FRAMES", help="leave longer gaps open; 0 fills none"
    )
    parser.add_argument(
        "--max-error",
        type=_millimetres,
        metavar="MM",
        help="leave gaps with a larger expected error open; inf fills all that the method can",
    )
    parser.add_argument(
        "--fix",
        type=_detectors,
        default=(),
        metavar="ID[,ID...]",
        help="first put bad samples right that these detectors find, or all: "
        f"{', '.join(DETECTORS)}; what is wrong is set aside and filled as a gap, what has changed "
        "places is exchanged",
    )
    parser.add_argument(
        "--smooth",
        type=_smoother,
        metavar="ID",
        help=f"at last smooth all markers (or those of --markers): {', '.join(SMOOTHERS)}",
    )
    parser.add_argument(
        "--smooth-param",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="a parameter of the smoothing, such as cutoff_hz=6; may be given several times",
    )
    parser.add_argument(
        "--plan",
        type=Path,
        metavar="FILE",
        help="method, parameters and limits from a plan that was saved in the window",
    )
    parser.add_argument(
        "--dry-run", action="store_true", help="say what would be filled, and write nothing"
    )
    parser.add_argument(
        "--markers",
        nargs="+",
        action="extend",
        metavar="LABEL[,LABEL...]",
        help="fill gaps of these markers alone",
    )
    parser.add_argument(
        "--report",
        type=Path,
        metavar="FILE",
        help="write a report of what was done: .html or .pdf, by its ending",
    )
    parser.add_argument(
        "--recipe", type=Path, metavar="FILE", help="write down the edits, to be replayed"
    )
    parser.add_argument(
        "--samples", action="store_true", help="with --json: the 90%% radius of every sample"
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Repair a recording, say what was done, and return the exit code."""
    request = _request(arguments)
    source = repairing.read(request)
    common.show_warnings(source, console)
    done = repairing.repair(source, request, console.progress, console.start)
    files = {"report": request.report, "recipe": request.recipe}
    if console.as_json:
        console.result(**outcome.as_json(done, files, samples=arguments.samples))
    outcome.show(done, files, console)
    return 0


def _request(arguments: argparse.Namespace) -> Request:
    out = _target(arguments)
    if arguments.report is not None:
        check_report_ending(arguments.report)
    words = arguments.markers
    if words is not None and not any(part.strip() for word in words for part in word.split(",")):
        raise UsageError("--markers names no marker")
    return Request(
        file=arguments.file,
        plan=_given(arguments),
        limits=None if arguments.plan else Limits(arguments.max_gap, arguments.max_error),
        out=out,
        markers=None if words is None else tuple(words),
        report=arguments.report,
        recipe=arguments.recipe,
        replace_source=arguments.in_place,
        accept_truncated=arguments.accept_truncated,
    )


def _target(arguments: argparse.Namespace) -> Path | None:
    """Return where the repaired copy goes; None in a dry run, which writes nothing."""
    if not arguments.dry_run:
        return target.choose(arguments, arguments.report, arguments.recipe)
    for name in ("output", "in_place", "report", "recipe"):
        if getattr(arguments, name):
            raise UsageError(f"--dry-run writes nothing: leave out --{name.replace('_', '-')}")
    return None


def _given(arguments: argparse.Namespace) -> Plan:
    """Return what the plan says, or the arguments."""
    names = ("method", "param", "max_gap", "max_error", "fix", "smooth", "smooth_param")
    if arguments.plan is None:
        method = arguments.method or registry.method(DEFAULT_METHOD)
        way = Way(method.id, _params(method, arguments.param))
        return Plan(way, fix=arguments.fix, smooth=_smoothing(arguments))
    if any(getattr(arguments, name) not in (None, [], ()) for name in names):
        raise UsageError("--plan says the method and the limits: give no others")
    return read_plan(arguments.plan)


def _shipped() -> str:
    names = training.names()
    return f" ({', '.join(names)})" if names else ""


def _method(text: str) -> registry.Method:
    try:
        return registry.method(text)
    except KeyError as error:
        raise argparse.ArgumentTypeError(error.args[0]) from None


def _frames(text: str) -> int:
    try:
        frames = int(text)
    except ValueError:
        frames = -1
    if frames < 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of frames")
    return frames


def _millimetres(text: str) -> float:
    try:
        length = float(text)
    except ValueError:
        length = math.nan
    if not length >= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is neither a length in mm nor inf")
    return length


def _detectors(text: str) -> tuple[str, ...]:
    if text.strip() == "all":
        return tuple(DETECTORS)
    try:
        return tuple(each.id for each in chosen(map(str.strip, text.split(","))))
    except KeyError as error:
        raise argparse.ArgumentTypeError(error.args[0]) from None


def _smoother(text: str) -> Smoother:
    try:
        return smoothers.smoother(text)
    except KeyError as error:
        raise argparse.ArgumentTypeError(error.args[0]) from None


def _smoothing(arguments: argparse.Namespace) -> Smoothing | None:
    smoother, pairs = arguments.smooth, arguments.smooth_param
    if smoother is None:
        if pairs:
            raise UsageError("--smooth-param belongs to --smooth")
        return None
    try:
        params = smoothers.parse_params(smoother, common.name_values("--smooth-param", pairs))
    except ValueError as error:
        raise UsageError(f"smoothing {smoother.id}: {error}") from None
    return Smoothing(smoother.id, params)


def _params(method: registry.Method, pairs: Sequence[str]) -> Any:
    try:
        return registry.parse_params(method, common.name_values("--param", pairs))
    except ValueError as error:
        raise UsageError(f"method {method.id}: {error}") from None
