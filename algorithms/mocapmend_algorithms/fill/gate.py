"""An innovation gate: single samples that the constant-velocity model does not believe.

The innovation of a sample is its distance from what the model makes of the others in its window,
its Mahalanobis length that distance over the standard deviation which the model gives it. Under
the model z ~ N(line, q C), C = covariance of twice integrated white noise + ratio, both are rows of
L = C^-1 - C^-1 H (H' C^-1 H)^-1 H' C^-1, which takes out any straight line H: the innovation is
(L z)_i / L_ii and its variance q / L_ii.
"""

from functools import lru_cache

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray

RATIO = 1.0
"""Measurement variance over process noise, as in `constant_velocity`."""
STENCIL = 9
LEAST_KEPT = 6
MOST_DROPPED = 3
MEDIAN_PER_VARIANCE = 0.789
"""Median of a mean of three squared standard normal variables."""
ROUNDING = 1e-9
"""Of the largest coordinate: less is no innovation."""

Frames = tuple[int, ...]


def usual_level(points: FloatArray) -> float:
    """Measure the mean square Mahalanobis length of a marker's innovations.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        Its trajectory, NaN where missing.

    Returns
    -------
    float
        In the square of its unit, per axis; 0 where it is nowhere seen for nine frames running.
    """
    if points.shape[0] < STENCIL:
        return 0.0
    row = _whitener(tuple(range(STENCIL)))[STENCIL // 2]
    windows = np.lib.stride_tricks.sliding_window_view(points, STENCIL, axis=0)
    square = np.mean((windows @ row) ** 2, axis=1)
    square = square[~np.isnan(square)]
    return float(square.mean()) if square.size else 0.0


def unbelievable(frames: IntArray, values: FloatArray, level: float, gate: float) -> BoolArray:
    """Mark single bad samples among a few.

    Parameters
    ----------
    frames : ndarray of int, shape (samples,)
        Ascending.
    values : ndarray, shape (samples, 3)
        What was observed there.
    level : float
        See `usual_level`; where the window itself is less quiet, its median counts.
    gate : float
        The Mahalanobis length, relative to the usual one, above which a sample is bad.

    Returns
    -------
    ndarray of bool, shape (samples,)
        At most three, and never so many that fewer than six are left.
    """
    kept = np.ones(frames.size, dtype=np.bool_)
    least = max(level, float(ROUNDING * np.abs(values).max()) ** 2)
    for _ in range(min(MOST_DROPPED, frames.size - LEAST_KEPT)):
        left = np.flatnonzero(kept)
        whitener = _whitener(tuple((frames[left] - frames[left[0]]).tolist()))
        square = np.mean((whitener @ (values[left] - values[left[0]])) ** 2, axis=1)
        usual = max(least, float(np.median(square)) / MEDIAN_PER_VARIANCE)
        worst = int(np.argmax(square))
        if square[worst] <= gate**2 * usual:
            break
        kept[left[worst]] = False
    return ~kept


@lru_cache(maxsize=256)
def _whitener(frames: Frames) -> FloatArray:
    """Rows L_i / sqrt(L_ii); frames count from 0."""
    time = np.array(frames, dtype=np.float64)
    early, late = np.minimum.outer(time, time), np.maximum.outer(time, time)
    covariance = early**2 * (3 * late - early) / 6 + RATIO * np.eye(time.size)
    inverse = np.linalg.inv(covariance)
    line = np.stack((np.ones_like(time), time), axis=1)
    seen = inverse @ line
    rows = inverse - seen @ np.linalg.solve(line.T @ seen, seen.T)
    whitened: FloatArray = rows / np.sqrt(np.diag(rows))[:, None]
    return whitened
