"""Whether what comes at a frame continues what was before it.

The error of a continuation is the least of three: from the line through the two samples before,
from the sample before, and backwards from the line through the two samples after. So it is small
for smooth motion even where one side has a wrong sample next to it.
"""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

AHEAD = 2
"""Frames that are looked at before and after the place."""


def own_errors(points: FloatArray) -> FloatArray:
    """Measure how badly each sample continues its own trajectory.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        One trajectory, NaN = missing.

    Returns
    -------
    ndarray, shape (frames,)
        In the unit of the coordinates; NaN where the sample or the one before is missing.
    """
    frames = len(points)
    errors = np.full(frames, np.nan)
    if frames < 2:
        return errors
    step = np.diff(points, axis=0)
    errors[1:] = _norm(step)
    bend = _norm(np.diff(step, axis=0))
    errors[2:] = np.fmin(errors[2:], np.where(np.isnan(errors[2:]), np.nan, bend))
    errors[1:-1] = np.fmin(errors[1:-1], np.where(np.isnan(errors[1:-1]), np.nan, bend))
    return errors


def cross_errors(points: FloatArray, frame: int) -> FloatArray:
    """Measure how badly the samples at a frame continue each of several trajectories.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Some trajectories, NaN = missing.
    frame : int
        At least 1.

    Returns
    -------
    ndarray, shape (markers, markers)
        [a, b]: the error of b at the frame as what follows a; infinite where one is missing.
    """
    before, after = points[frame - 1], points[frame]
    ways = [before[:, None] - after[None]]
    if frame >= AHEAD:
        ways.append((2.0 * before - points[frame - 2])[:, None] - after[None])
    if frame + 1 < len(points):
        ways.append(before[:, None] - (2.0 * after - points[frame + 1])[None])
    errors: FloatArray = np.fmin.reduce([_norm(way) for way in ways])
    return np.where(np.isnan(errors), np.inf, errors)


def _norm(vectors: FloatArray) -> FloatArray:
    length: FloatArray = np.sqrt(np.einsum("...k,...k->...", vectors, vectors))
    return length
