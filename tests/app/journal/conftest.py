"""A small recording, and edits of it."""

from pathlib import Path

import numpy as np
import pytest

from mocapmend.document import Document
from mocapmend.files import Source, Stamp
from mocapmend_algorithms import Recording
from mocapmend_algorithms.skeleton import Skeleton

FRAMES, MARKERS = 12, 3


@pytest.fixture
def source(tmp_path: Path) -> Source:
    """Return a recording of three markers with two gaps each."""
    points = np.arange(FRAMES * MARKERS * 3, dtype=float).reshape(FRAMES, MARKERS, 3)
    points[2:5] = np.nan
    points[8:9] = np.nan
    recording = Recording(points, labels=("A", "B", "C"), rate=100.0, unit="mm", up="+z")
    return Source(
        path=tmp_path / "walk.c3d", kind="C3D", recording=recording, stamp=Stamp(999, 10**18 + 1)
    )


@pytest.fixture
def small(source: Source) -> Document:
    """Return the recording as a document."""
    return Document(source, Skeleton("", (), "none"))
