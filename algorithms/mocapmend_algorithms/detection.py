"""Samples that are lost or wrong because a marker jumps (L21 eq. 1).

L21 = Wang, Lü, Mu 2021, Techniques of Automation and Applications 40(4):116-119. The rule as
printed marks the frame of a jump; of the samples before and after it, `wrong_samples` tells which
to believe.
"""

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.gaps import runs

FASTEST = 0.99
TIMES_FASTEST = 3.0
LEAST_STEPS = 20


def jump_threshold(points: FloatArray) -> FloatArray:
    """Estimate for each marker the step between two frames that is too large to be a motion.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates, NaN = missing.

    Returns
    -------
    ndarray, shape (markers,)
        Three times the 99th percentile of its steps, after a running median of five, which a
        jump there and back does not pass; in the unit of the coordinates. Infinite for a marker
        that never moves or is seen for fewer than 20 steps.
    """
    delta = np.full(points.shape[1], np.inf)
    for marker, steps in enumerate(_steps(points).T):
        seen = steps[~np.isnan(steps)]
        if seen.size < LEAST_STEPS:
            continue
        calm = _median_of_five(seen)
        at = round(FASTEST * (calm.size - 1))
        delta[marker] = TIMES_FASTEST * float(np.partition(calm, at)[at]) or np.inf
    return delta


def jumps(points: FloatArray, delta: float | FloatArray) -> BoolArray:
    """Mark where |f_t - f_(t-1)| > delta (L21 eq. 1).

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates, NaN = missing.
    delta : float or ndarray, shape (markers,)
        In the unit of the coordinates; see `jump_threshold`.

    Returns
    -------
    ndarray of bool, shape (frames, markers)
        True at t. As printed, the way back from a wrong sample is marked as well. The first frame
        and those beside a missing one are not marked.
    """
    marked = np.zeros(points.shape[:2], dtype=np.bool_)
    marked[1:] = _steps(points) > delta
    return marked


def wrong_samples(points: FloatArray, delta: float | FloatArray, longest: int) -> BoolArray:
    """Mark the samples that a marker has jumped to and does not stay at.

    Jumps cut each seen stretch of a marker into pieces. A piece of at most `longest` frames is
    wrong, if the stretch has a longer one to believe in.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates, NaN = missing.
    delta : float or ndarray, shape (markers,)
        As in `jumps`.
    longest : int
        Frames.

    Returns
    -------
    ndarray of bool, shape (frames, markers)
    """
    wrong = np.zeros(points.shape[:2], dtype=np.bool_)
    marked = jumps(points, delta)
    for marker in np.flatnonzero(marked.any(axis=0)).tolist():
        cuts = np.flatnonzero(marked[:, marker])
        for start, stop in runs(~np.isnan(points[:, marker, 0])):
            inside = cuts[(cuts > start) & (cuts < stop)]
            ends = np.concatenate(([start], inside, [stop]))
            short = np.diff(ends) <= longest
            if not short.all():
                wrong[start:stop, marker] = np.repeat(short, np.diff(ends))
    return wrong


def _steps(points: FloatArray) -> FloatArray:
    moves = np.diff(points, axis=0)
    steps: FloatArray = np.sqrt(np.einsum("tmk,tmk->tm", moves, moves))
    return steps


def _median_of_five(steps: FloatArray) -> FloatArray:
    """Take a running median: of four the extremes drop out, the fifth joins the other two."""
    a, b, c, d, e = (steps[at : steps.size - 4 + at] for at in range(5))
    low = np.maximum(np.minimum(a, b), np.minimum(c, d))
    high = np.minimum(np.maximum(a, b), np.maximum(c, d))
    low, high = np.minimum(low, high), np.maximum(low, high)
    median: FloatArray = np.clip(e, low, high)
    return median
