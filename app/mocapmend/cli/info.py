"""Say what a file holds: frames, markers and what is missing of them, events, analog data."""

import argparse
import math
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np

from mocapmend import engine
from mocapmend.cli import common
from mocapmend.cli.console import Console
from mocapmend.files import NO_CORRECTIONS, C3DFile, Corrections, ForcePlate, Layout, Source
from mocapmend.files.corrections import KINDS
from mocapmend.files.records import RecordedRun
from mocapmend.files.refinement import Refinement
from mocapmend_algorithms.gaps import count_gaps
from mocapmend_algorithms.skeleton import Skeleton

Run = TypeVar("Run", bound=RecordedRun)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the command takes."""
    common.add_file(parser)


def run(arguments: argparse.Namespace, console: Console) -> int:
    """Print the facts and return the exit code."""
    console.start("Reading")
    source, skeleton = engine.load(arguments.file, console.progress)
    common.show_warnings(source, console)
    markers = _markers(source)
    console.result(**common.facts(source), **_content(source, skeleton), markers=markers)
    for line in _summary(source, skeleton):
        console.say(line)
    incomplete = [marker for marker in markers if marker["gaps"]]
    if incomplete:
        console.say("")
        console.table(
            ("Marker", ">Missing %", ">Gaps", ">Longest gap (frames)"),
            [
                (m["label"], f"{m['missing_percent']:.2f}", str(m["gaps"]), str(m["longest_gap"]))
                for m in incomplete
            ],
        )
    _show_repairs(source, console)
    _show_kept_open(source, console)
    _show_corrections(source, console)
    return 0


def _show_repairs(source: Source, console: Console) -> None:
    """List the repairs that the file has had."""
    _show_runs(
        console,
        ("Repaired marker", ">Frames", ">Length", "Method", ">Expected error (mm)"),
        source.repairs,
        lambda record: (
            record.method,
            "" if math.isnan(error := record.expected_error_mm) else f"{error:.1f}",
        ),
    )


def _show_kept_open(source: Source, console: Console) -> None:
    """List the gaps that are kept open."""
    _show_runs(
        console,
        ("Kept open", ">Frames", ">Length", "Why"),
        tuple(source.kept_open.values()),
        lambda entry: (entry.reason,),
    )


def _show_corrections(source: Source, console: Console) -> None:
    """List what else was put right."""
    known = _corrections(source)
    _show_runs(
        console,
        ("Set aside", ">Frames", ">Length", "Why"),
        known.set_aside,
        lambda entry: (f"{entry.problem}: {entry.reason}",),
    )
    _show_runs(
        console,
        ("Exchanged", ">Frames", ">Length", "Holds what was stored as"),
        known.moved,
        lambda entry: (entry.from_marker,),
    )
    _show_runs(
        console,
        ("Smoothed", ">Frames", ">Length", "Method", ">Moved by (mm rms)"),
        known.smoothed,
        lambda entry: (entry.method, f"{entry.rms_change_mm:.2g}"),
    )
    if known.renamed:
        console.say("")
        console.table(
            ("Renamed", "Was called"), [(entry.marker, entry.former) for entry in known.renamed]
        )


def _corrections(source: Source) -> Corrections:
    return NO_CORRECTIONS if source.provenance is None else source.provenance.corrections


def _refined(source: Source) -> Refinement | None:
    return None if source.provenance is None else source.provenance.refined


def _show_runs(
    console: Console,
    headers: Sequence[str],
    runs: Sequence[Run],
    more: Callable[[Run], tuple[str, ...]],
) -> None:
    """List runs and what more there is to say of each, as many as people read."""
    if not runs:
        return
    console.say("")
    console.table(
        headers,
        [
            (run.marker, common.span(run.first_frame, run.last_frame), str(run.frames), *more(run))
            for run in runs[: common.MOST_ROWS]
        ],
    )
    if len(runs) > common.MOST_ROWS:
        console.say(f"and {len(runs) - common.MOST_ROWS} more: --json lists them all.")


def _content(source: Source, skeleton: Skeleton) -> dict[str, Any]:
    recording = source.recording
    layout = source.layout if isinstance(source, C3DFile) else None
    return {
        "format": source.kind,
        "frames": recording.frames,
        "first_frame": recording.first_frame,
        "last_frame": recording.first_frame + recording.frames - 1,
        "rate_hz": recording.rate,
        "duration_s": recording.frames / recording.rate,
        "unit": recording.unit,
        "up_axis": recording.up,
        "processor": layout.processor.name.lower() if layout else None,
        "number_format": _numbers(layout) if layout else None,
        "model_outputs": list(source.model_outputs),
        "events": [
            {
                "label": event.label,
                "context": event.context,
                "frame": recording.first_frame + event.frame,
                "time_s": event.time,
            }
            for event in source.events
        ],
        "analog": {"channels": len(source.analog_labels), "rate_hz": source.analog_rate},
        "repairs": [record.as_json() for record in source.repairs],
        "kept_open": [entry.as_json() for entry in source.kept_open.values()],
        "refined": None if (made := _refined(source)) is None else made.as_json(),
        **{
            kind: [entry.as_json() for entry in getattr(_corrections(source), kind)]
            for kind in KINDS
        },
        "force_plates": [_force_plate(plate, recording.mm) for plate in source.force_plates],
        "skeleton": {
            "name": skeleton.name,
            "source": skeleton.source,
            "bones": len(skeleton.bones),
            "segments": [
                {"name": part.name, "markers": [recording.labels[m] for m in part.markers]}
                for part in skeleton.segments
            ],
        },
    }


def _numbers(layout: Layout) -> str:
    return "float" if layout.is_float else "integer"


def _repairs(source: Source) -> str:
    if source.provenance is None:
        return "none that a repair record lists"
    count = common.count(len(source.repaired), "gap")
    return f"{count} filled by {source.provenance.program}"


def _force_plate(plate: ForcePlate, mm: float) -> dict[str, Any]:
    corners = plate.corners * mm
    return {
        "type": plate.type,
        "corners_mm": corners.tolist() if np.isfinite(corners).all() else None,
        "channels": [channel + 1 for channel in plate.channels],
    }


def _plates_in_words(plates: tuple[ForcePlate, ...]) -> str:
    types = sorted({"unknown" if plate.type is None else str(plate.type) for plate in plates})
    return f"{len(plates)}, of type {' and '.join(types)}" if plates else "0"


def _markers(source: Source) -> list[dict[str, Any]]:
    recording = source.recording
    rows = zip(
        recording.labels,
        common.missing_percent(recording),
        *count_gaps(recording.present),
        strict=True,
    )
    return [
        {"label": label, "missing_percent": missing, "gaps": gaps, "longest_gap": longest}
        for label, missing, gaps, longest in rows
    ]


def _summary(source: Source, skeleton: Skeleton) -> list[str]:
    recording = source.recording
    seconds = recording.frames / recording.rate
    last = recording.first_frame + recording.frames - 1
    stored = source.kind
    if isinstance(source, C3DFile):
        stored += f", {source.layout.processor.name}, {_numbers(source.layout)}s"
    found = {"file": "the file's own", "distances": "from constant distances", "none": "none"}
    origin = found.get(skeleton.source, skeleton.name)
    bones = common.count(len(skeleton.bones), "bone")
    segments = common.count(len(skeleton.segments), "segment")
    span = f"{recording.frames} ({recording.first_frame}-{last})"
    lines = [
        ("File", str(source.path)),
        ("Format", stored),
        ("Frames", f"{span}, {recording.rate:g} Hz, {seconds:.2f} s"),
        ("Markers", f"{recording.markers}, in {recording.unit}, {recording.up} up"),
        ("Model outputs", str(len(source.model_outputs))),
        ("Events", str(len(source.events))),
        ("Analog", f"{len(source.analog_labels)} channels, {source.analog_rate:g} Hz"),
        ("Repairs", _repairs(source)),
        ("Force plates", _plates_in_words(source.force_plates)),
        (
            "Skeleton",
            f"{origin}, {bones} in {segments}" if skeleton.segments else f"{origin}, {bones}",
        ),
    ]
    if (made := _refined(source)) is not None:
        lines.append(("Computed by", f"the network “{made.model}”, {made.profile}; none measured"))
    return [f"{name + ':':<15}{text}" for name, text in lines]
