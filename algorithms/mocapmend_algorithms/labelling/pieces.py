"""Points cut into pieces, each of which can be one marker only."""

from itertools import pairwise

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.labelling.result import Piece

JUMP_MM = 40.0
"""Departure from steady motion within a frame that no marker makes at 100 frames per second."""
TIMES_USUAL = 12.0
"""Beside what is usual for a point where it moves, as its neighbours in time show."""
AROUND = 4
"""Frames at either side that show what is usual."""


def cut_pieces(points: FloatArray, rate: float) -> list[Piece]:
    """Cut each point where it is not seen, and where it jumps.

    A jump is a step that departs from the steps before and after it by far more than the steps
    near by do from theirs. A point that holds one marker before a swap and another after it is
    cut there; a single wrong sample becomes a piece of its own.

    Parameters
    ----------
    points : ndarray, shape (frames, points, 3)
        In mm; NaN = missing.
    rate : float
        Frames per second.

    Returns
    -------
    list of Piece
        By point and start; together they hold every sample that is seen.
    """
    pieces = []
    least = JUMP_MM * 100.0 / rate
    for point in range(points.shape[1]):
        for start, stop in runs(~np.isnan(points[:, point, 0])):
            cuts = _jumps(points[start:stop, point], least)
            ends = [start, *(start + cuts).tolist(), stop]
            pieces += [Piece(point, a, b) for a, b in pairwise(ends)]
    return pieces


def _jumps(path: FloatArray, least: float) -> IntArray:
    """Return the frames of an unbroken path before which it jumps."""
    steps = np.diff(path, axis=0)
    if len(steps) < 2:
        far = np.linalg.norm(steps, axis=1) > 4 * least
        return np.flatnonzero(far) + 1
    # The less that a step differs from either of its neighbours, the more it belongs to a motion.
    change = np.linalg.norm(np.diff(steps, axis=0), axis=1)
    before = np.concatenate(([change[0]], change))
    after = np.concatenate((change, [change[-1]]))
    departure = np.minimum(before, after)
    padded = np.pad(departure, AROUND, mode="reflect" if len(departure) > AROUND else "edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * AROUND + 1)
    usual = np.median(windows, axis=1)
    return np.flatnonzero((departure > least) & (departure > TIMES_USUAL * usual)) + 1
