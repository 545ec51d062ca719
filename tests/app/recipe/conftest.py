"""A recording with gaps to make recipes of."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    """Write a recording with six interior gaps of three markers, and a leading one."""
    points = walk(frames=120)
    fourth = np.zeros(points.shape[:2])
    places = [(10, 15, 0), (40, 60, 0), (80, 82, 0), (30, 33, 2), (90, 99, 2), (50, 70, 4)]
    for start, stop, marker in [*places, (0, 4, 3)]:
        fourth[start:stop, marker] = -1
        points[start:stop, marker] = 0
    path = tmp_path / "holed.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, first_frame=7)))
    return path
