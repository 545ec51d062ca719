"""What the tests of recipes have in common."""

from pathlib import Path
from typing import Any

from recording_samples import NO_LIMITS

from mocapmend import engine, recipe, replaying
from mocapmend.files import RepairRecord, Source, read_recording
from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.registry import METHODS


def interior(source: Source) -> list[Gap]:
    recording = source.measured
    gaps = find_gaps(recording.present)
    return [gap for gap in gaps if gap.kind(recording.frames) == "interior"]


def fills(source: Source, gaps: list[Gap], method: str, **params: Any) -> tuple[RepairRecord, ...]:
    """Fill gaps together and return their records alone."""
    values = METHODS[method].params(**params)
    result = engine.fill(source.measured, gaps, method, values, NO_LIMITS, no_progress)
    return tuple(engine.record(source, patch, method, values) for patch in result.patches)


def export(source: Source, changes: engine.Changes, out: Path) -> Path:
    engine.export(source, changes, out, False, False, no_progress)
    return out


def replayed(path: Path, written: Path, out: Path) -> Path:
    """Replay a recipe in a file that is read anew."""
    source = read_recording(path)
    changes = replaying.replay(source, recipe.read_recipe(written), no_progress)
    return export(source, changes, out)


ITEM: dict[str, Any] = {
    "do": "fill",
    "marker": "M001",
    "point": 1,
    "first_frame": 17,
    "last_frame": 21,
    "method": "linear",
    "parameters": {},
    "donors": [],
    "expected_error_mm": 1.5,
    "r90_mm": None,
}
REOPENED = ITEM | {"do": "reopen"}
KEPT: dict[str, Any] = {
    "do": "keep open",
    "marker": "M001",
    "point": 1,
    "first_frame": 17,
    "last_frame": 21,
    "never": True,
    "reason": "the marker fell off",
}
FREED = KEPT | {"do": "free"}
KALMAN = ITEM | {"method": "kalman"}
AUTO = ITEM | {"method": "auto"}
HASH = "0" * 64


def document(*edits: object, **head: object) -> dict[str, Any]:
    start = {"mocapmend_recipe": 1, "program": "mocapmend 0.1", "input_sha256": HASH}
    return start | {"edits": list(edits)} | head
