"""What `repair` says about what it did, as JSON and as text."""

import dataclasses
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.engine import Exported
from mocapmend.repair_outcome import Outcome
from mocapmend_algorithms.smooth.contract import SmoothResult

_NOTHING_WRITTEN: Mapping[str, Any] = dict.fromkeys(
    (
        "methods_paragraph",
        "references",
        "repair_record",
        "converted_to_floats",
        "notes",
        "second_reader",
        "check",
    )
)


def as_json(done: Outcome, files: Mapping[str, Path | None], *, samples: bool) -> dict[str, Any]:
    """Return the document's content."""
    recording = done.source.recording
    missing, filled = done.samples_missing, done.samples_filled
    exported = done.exported
    return {
        **common.facts(done.source),
        "dry_run": exported is None,
        "output": None if exported is None else str(exported.saved.path),
        **{name: None if path is None else str(path) for name, path in files.items()},
        "method": done.method.id,
        "parameters": dataclasses.asdict(done.params),
        "limits": {
            "default_guard": done.limits.default,
            "max_gap_frames": done.limits.frames(done.method, recording.rate),
            "max_error_mm": done.limits.error_mm,
        },
        "fixed": [common.bad_run(recording, run) for run in done.fixed],
        "smoothed": [] if done.smoothing is None else _smoothed(done, done.smoothing),
        "gaps": _gaps(done, samples=samples),
        "totals": {
            "gaps": len(done.repairs) + len(done.result.unfilled),
            "filled": len(done.repairs),
            "left_open": len(done.result.unfilled),
            "samples_filled": filled,
            "samples_missing_before": missing,
            "samples_missing_after": missing - filled,
        },
        **(_NOTHING_WRITTEN if exported is None else _as_written(done, exported)),
    }


def _as_written(done: Outcome, exported: Exported) -> dict[str, Any]:
    methods = done.methods()
    return {
        "methods_paragraph": methods.paragraph,
        "references": list(methods.references),
        **common.written(exported),
    }


def _smoothed(done: Outcome, result: SmoothResult) -> list[dict[str, Any]]:
    recording = done.source.recording
    return [
        {
            **common.place(recording, one.run),
            "method": result.method,
            "parameters": result.params,
            "chosen": one.chosen,
            "rms_change_mm": one.rms * recording.mm,
            "largest_change_mm": one.largest * recording.mm,
        }
        for one in result.runs
    ]


def _gaps(done: Outcome, *, samples: bool) -> list[dict[str, Any]]:
    recording = done.source.recording
    rows = {}
    for repair, patch in zip(done.repairs, done.result.patches, strict=True):
        rows[repair.gap] = {
            **common.place(recording, repair.gap),
            "method": repair.method,
            "donors": list(repair.donors),
            "expected_error_mm": repair.expected_error_mm,
            "r90_mm": repair.r90_mm,
            "filled": True,
            "reason": None,
        }
        if samples:
            rows[repair.gap]["r90_samples_mm"] = (patch.r90 * recording.mm).tolist()
    for entry in done.result.unfilled:
        rows[entry.gap] = {
            **common.place(recording, entry.gap),
            "method": None,
            "donors": [],
            "expected_error_mm": None,
            "r90_mm": None,
            "filled": False,
            "reason": entry.reason,
        }
        if samples:
            rows[entry.gap]["r90_samples_mm"] = None
    return [rows[gap] for gap in sorted(rows)]


def show(done: Outcome, files: Mapping[str, Path | None], console: Console) -> None:
    """Print it for people."""
    exported = done.exported
    if exported is None:
        console.say("Dry run:  nothing is written")
    else:
        console.say(f"Repaired: {exported.saved.path}")
    for name, path in files.items():
        if path is not None:
            console.say(f"{name.capitalize() + ':':<10}{path}")
    console.say(f"Method:   {done.method_text}")
    console.say(f"Limits:   {done.limits_text}")
    for kind, found in Counter(run.kind for run in done.fixed).items():
        console.say(f"Fixed:    {common.count(found, 'run')} ({kind})")
    if done.smoothing is not None:
        console.say(_smoothing_text(done, done.smoothing))
    total = len(done.repairs) + len(done.result.unfilled)
    title = "To fill:" if exported is None else "Filled:"
    console.say(
        f"{title:<10}{len(done.repairs)} of {common.count(total, 'gap')}, "
        f"{common.count(done.samples_filled, 'sample')}{_worst(done)}"
    )
    for note in () if exported is None else exported.sentences:
        console.say(note)
    _show_open_gaps(done, console)


def _smoothing_text(done: Outcome, result: SmoothResult) -> str:
    changes = [one.rms * done.source.recording.mm for one in result.runs]
    moved = f", moved by {np.median(changes):.2g} mm rms (median)" if changes else ""
    return f"Smoothed: {common.count(len(result.runs), 'marker')} ({result.method}){moved}"


def _show_open_gaps(done: Outcome, console: Console) -> None:
    unfilled, recording = done.result.unfilled, done.source.recording
    if not unfilled:
        return
    console.say(f"\n{common.count(len(unfilled), 'gap')} left open:")
    console.table(
        ("Marker", ">Frames", ">Length", "Why"),
        [
            (
                recording.labels[entry.gap.marker],
                common.frames_text(recording, entry.gap),
                str(entry.gap.length),
                entry.reason,
            )
            for entry in unfilled[: common.MOST_ROWS]
        ],
    )
    if len(unfilled) > common.MOST_ROWS:
        console.say(
            f"and {len(unfilled) - common.MOST_ROWS} more: --json and --report list them all."
        )
    if done.limits.default:
        console.say("--max-gap and --max-error replace the default guard.")


def _worst(done: Outcome) -> str:
    known = [row for row in done.repairs if not np.isnan(row.expected_error_mm)]
    if not known:
        return ""
    worst = max(known, key=lambda row: row.expected_error_mm)
    return f"; largest expected error {worst.expected_error_mm:.1f} mm ({done.place(worst.gap)})"
