"""Recordings that were repaired before, for the tests that open them."""

from pathlib import Path
from typing import Any

import numpy as np
from c3d_synthetic import Machine, Synthetic, encode, walk

from mocapmend import engine
from mocapmend.files import C3DFile, read_c3d, read_recording
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


def write_three_gaps(folder: Path, machine: Machine = "intel", **more: Any) -> C3DFile:
    """Write a file with three gaps; its second point is a model output."""
    points = walk()
    fourth = np.zeros(points.shape[:2])
    for point, start, stop in ((0, 10, 14), (0, 20, 21), (3, 10, 14)):
        points[start:stop, point] = 0.0
        fourth[start:stop, point] = -1.0
    spec = Synthetic(
        points,
        machine,
        fourth=fourth,
        first_frame=101,
        labels=["A", "Angle", "B", "C", "Ψ D"],
        parameters={"POINT:ANGLES": ["Angle"]},
        **more,
    )
    path = folder / "source.c3d"
    path.write_bytes(encode(spec))
    return read_c3d(path)
