"""The bad samples of the spoilt walk: bad runs that detectors are to find in it."""

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms import Gap

SPIKE = Gap(3, 100, 102)
SWAP, OTHER = Gap(8, 180, 230), 9
HOLE = Gap(20, 140, 160)
LEAP = 90.0
"""Millimetres of the spike."""


def spoil(points: NDArray[np.float64]) -> None:
    """Put a spike and a swap into the bundled walk, in place."""
    points[SPIKE.start : SPIKE.stop, SPIKE.marker] += LEAP / np.sqrt(3.0)
    pair = [SWAP.marker, OTHER]
    rows = slice(SWAP.start, SWAP.stop)
    points[rows, pair] = points[rows, pair[::-1]]
