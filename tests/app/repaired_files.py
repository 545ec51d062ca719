"""Recordings that were repaired before, for the tests that open them."""

from pathlib import Path

from mocapmend import engine
from mocapmend.files import read_recording
from mocapmend_algorithms import find_gaps, no_progress
from mocapmend_algorithms.fill import registry


def write_repaired(original: Path, out: Path, method: str = "linear", longest: int = 10**6) -> Path:
    """Write a copy of a file in which a method has filled all gaps that it can."""
    source = read_recording(original)
    gaps = [gap for gap in find_gaps(source.measured.present) if gap.length <= longest]
    chosen = registry.method(method)
    params = chosen.params()
    result = chosen.function(source.measured, gaps, params, no_progress)
    changes = engine.changes_of(source, result, method, params)
    engine.export(source, changes, out, False, False, no_progress)
    return out
