"""A recording to repair, and where the repaired file shall go."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode, walk


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Return where the repaired file shall go."""
    return tmp_path / "out.c3d"


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    """Write a recording at 100 Hz with gaps of 5, 30 and (leading) 4 frames; first frame 7."""
    points = walk(frames=120)
    fourth = np.zeros(points.shape[:2])
    for rows, marker in ((slice(10, 15), 0), (slice(40, 70), 0), (slice(0, 4), 2)):
        fourth[rows, marker] = -1
        points[rows, marker] = 0
    labels = ["A", "B,C", "D", "A", "E"]
    path = tmp_path / "holed.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=labels, first_frame=7)))
    return path
