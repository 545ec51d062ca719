"""List the gaps of a file: runs of frames in which a marker is missing.

With --rank, repairs are tried on all of them, and the gaps come in the order of the expected harm:
expected error of the best repair times missing frames. Gaps that are never to be filled come last.
"""

import argparse
from typing import Any

import numpy as np

from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.files import Source, read_recording
from mocapmend.ranking import Problem, Status, rank
from mocapmend_algorithms import Recording, find_gaps


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    common.add_file(parser)
    parser.add_argument(
        "--rank", action="store_true", help="try repairs, and list the most harmful gaps first"
    )


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print every gap and return the exit code."""
    source = read_recording(arguments.file)
    common.show_warnings(source, console)
    recording = source.recording
    gaps = find_gaps(recording.present)
    missing = int(np.count_nonzero(~recording.present))
    problems = [Problem(gap, Status.OPEN) for gap in gaps]
    if arguments.rank:
        console.start("Ranking")
        never = source.never_filled
        rest = [gap for gap in gaps if gap not in never]
        problems = rank(source.measured, rest, console.progress)
        problems += [Problem(gap, Status.NEVER) for gap in sorted(never)]
    console.result(
        **common.facts(source),
        gaps=[_as_json(source, problem, ranked=arguments.rank) for problem in problems],
        missing_samples=missing,
        markers_with_gaps=len({gap.marker for gap in gaps}),
    )
    if problems:
        headers: tuple[str, ...] = ("Marker", ">Frames", ">Length", ">ms", "Kind")
        rows = [_row(recording, problem) for problem in problems]
        if arguments.rank:
            headers += (">Error", ">Harm", "Best")
            rows = [(*row, *_rank(recording, p)) for row, p in zip(rows, problems, strict=True)]
        if source.kept_open:
            headers += ("Kept open",)
            rows = [(*row, _why(source, p)) for row, p in zip(rows, problems, strict=True)]
        console.table(headers, rows)
    console.say(
        f"{common.count(len(gaps), 'gap')}, {common.count(missing, 'missing sample')} "
        f"of {recording.present.size}."
    )
    return 0


def _as_json(source: Source, problem: Problem, *, ranked: bool) -> dict[str, Any]:
    recording, gap, best = source.recording, problem.gap, problem.best
    kept = source.kept_open.get(gap)
    described = {
        **common.place(recording, gap),
        "length_frames": gap.length,
        "length_ms": common.milliseconds(recording, gap),
        "kind": gap.kind(recording.frames),
        "kept_open": None if kept is None else {"never": kept.never, "reason": kept.reason},
    }
    if ranked:
        described |= {
            "best_method": None if best is None else best.method,
            "expected_error_mm": problem.error * recording.mm,
            "harm_mm_frames": problem.harm * recording.mm,
        }
    return described


def _row(recording: Recording, problem: Problem) -> tuple[str, ...]:
    gap = problem.gap
    return (
        recording.labels[gap.marker],
        common.frames_text(recording, gap),
        str(gap.length),
        f"{common.milliseconds(recording, gap):.0f}",
        gap.kind(recording.frames),
    )


def _why(source: Source, problem: Problem) -> str:
    kept = source.kept_open.get(problem.gap)
    return "" if kept is None else kept.reason


def _rank(recording: Recording, problem: Problem) -> tuple[str, ...]:
    if problem.best is None:
        return ("?", "?", "")
    error, harm = problem.error * recording.mm, problem.harm * recording.mm
    return (f"{error:.1f} mm", f"{harm:.0f}", problem.best.method)
