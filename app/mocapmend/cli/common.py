"""What several commands share: their arguments, reading a file, describing a gap."""

import argparse
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mocapmend.cli.console import Console
from mocapmend.cli.usage import UsageError
from mocapmend.engine import Exported
from mocapmend.files import CheckReport, Saved, Source
from mocapmend.files.sidecar import sidecar_path
from mocapmend.wording import count as count
from mocapmend.wording import span as span
from mocapmend_algorithms import Gap, Recording

if TYPE_CHECKING:
    # Most commands need no detector.
    from mocapmend_algorithms.problems import BadRun

MOST_ROWS = 20
"""Of a table that people read."""


def add_file(parser: argparse.ArgumentParser) -> None:
    """Let a command take a recording."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a recording")


def name_values(option: str, given: Sequence[str]) -> dict[str, str]:
    """Read what an option was given as NAME=VALUE, several times.

    Raises
    ------
    UsageError
        If something has no "=".
    """
    values = {}
    for text in given:
        name, equals, value = text.partition("=")
        if not equals:
            raise UsageError(f"{option} takes NAME=VALUE, not {text!r}")
        values[name.strip()] = value
    return values


def show_warnings(source: Source, console: Console) -> None:
    """Say on stderr what is odd about a file."""
    for warning in source.warnings:
        console.warn(f"{source.path}: {warning}")


def facts(source: Source) -> dict[str, Any]:
    """Return what every JSON document says about its file."""
    return {
        "file": str(source.path),
        "truncated": source.truncated,
        "warnings": list(source.warnings),
    }


def written(exported: Exported) -> dict[str, Any]:
    """Return what every JSON document says about a file that was written."""
    saved = exported.saved
    return {
        "repair_record": record_place(saved),
        "converted_to_floats": saved.converted,
        "notes": list(saved.notes),
        "second_reader": exported.second_reader,
        "check": None if exported.check is None else comparison(exported.check),
    }


def record_place(saved: Saved) -> dict[str, Any]:
    """Return where the repair record of a file is, for JSON."""
    beside = sidecar_path(saved.path) if saved.record == "sidecar" else None
    return {"place": saved.record or None, "file": None if beside is None else str(beside)}


def comparison(found: CheckReport) -> dict[str, Any]:
    """Return what a comparison of two files found, for JSON."""
    return {
        "passed": found.passed,
        "identical": found.identical,
        "changed_samples": found.changed_samples,
        "changed": [asdict(run) for run in found.changed],
        "allowed": list(found.allowed),
        "other_differences": list(found.other_differences),
    }


def place(recording: Recording, gap: Gap) -> dict[str, Any]:
    """Return where a gap is, for JSON; frames as the file counts them."""
    return {
        "marker": recording.labels[gap.marker],
        "marker_index": gap.marker,
        "first_frame": recording.first_frame + gap.start,
        "last_frame": recording.first_frame + gap.stop - 1,
    }


def bad_run(recording: Recording, run: "BadRun") -> dict[str, Any]:
    """Return what was found wrong with a run, for JSON."""
    return {
        "kind": run.kind,
        **place(recording, Gap(run.marker, run.start, run.stop)),
        "score": run.score,
        "deviation_mm": float(run.deviation * recording.mm),
        "reason": run.reason,
        "other": None if run.other is None else recording.labels[run.other],
        "other_index": run.other,
    }


def frames_text(recording: Recording, gap: Gap) -> str:
    """Return the frames of a gap as people write them."""
    return span(recording.first_frame + gap.start, recording.first_frame + gap.stop - 1)


def milliseconds(recording: Recording, gap: Gap) -> float:
    """Return how long a gap is."""
    return 1000 * gap.length / recording.rate


def missing_percent(recording: Recording) -> list[float]:
    """Return in how many % of the frames each marker is missing."""
    missing = np.count_nonzero(~recording.present, axis=0)
    return [100 * count / max(recording.frames, 1) for count in missing.tolist()]
