"""An innovation gate: single samples that the constant-velocity model does not believe.

The innovation of a sample is its distance from what the model makes of the others in its window.
Under the model z ~ N(line, q C), C = covariance of twice integrated white noise + ratio, the matrix
L = C^-1 - C^-1 H (H' C^-1 H)^-1 H' C^-1, which takes out any straight line H, gives both: the
innovation is (L z)_i / L_ii and its variance q / L_ii. Bodies are not white noise, so q is
measured for each place in the window, on the marker's other windows.
"""

from functools import lru_cache

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray

RATIO = 1.0
"""Measurement variance over process noise, as in `constant_velocity`."""
MOST_SAMPLES = 16
LEAST_KEPT = 5
MOST_DROPPED = 3
LEAST_WINDOWS = 20
MEDIAN_PER_VARIANCE = 0.789
"""Median of the mean of three squared standard normal variables."""
ROUNDING = 1e-9
"""Of the largest coordinate: less is no innovation."""

Frames = tuple[int, ...]


def unbelievable(points: FloatArray, side: IntArray, gate: float) -> BoolArray:
    """Mark single bad samples on one side of a gap.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        The marker's trajectory, NaN where missing.
    side : ndarray of int, shape (samples,)
        Frames of the samples beside the gap, ascending.
    gate : float
        The Mahalanobis length, relative to the usual one, above which a sample is bad. Where the
        side itself is less quiet than usual, its own median counts.

    Returns
    -------
    ndarray of bool, shape (samples,)
        At most three, and never so many that fewer than five are left; none where the marker is
        seen too little elsewhere to know what is usual.
    """
    kept = np.ones(side.size, dtype=np.bool_)
    if side.size <= LEAST_KEPT:
        return ~kept
    usual = _usual(points, side)
    for _ in range(min(MOST_DROPPED, side.size - LEAST_KEPT)):
        left = np.flatnonzero(kept)
        lengths = _lengths(points, side[left])
        worst = int(np.argmax(lengths))
        others = np.delete(left, worst)
        # A bad sample spoils what is made of its neighbours, so they are judged without it.
        restless = np.median(_lengths(points, side[others]) / usual[others]) / MEDIAN_PER_VARIANCE
        if not lengths[worst] > gate**2 * usual[left[worst]] * max(1.0, float(restless)):
            break
        kept[left[worst]] = False
    return ~kept


def _usual(points: FloatArray, side: IntArray) -> FloatArray:
    """Measure the mean square length at each place of a window, away from this one."""
    size = side.size
    nothing = np.full(size, np.inf)
    if points.shape[0] < size:
        return nothing
    windows = np.lib.stride_tricks.sliding_window_view(points, size, axis=0).swapaxes(1, 2)
    start = np.arange(windows.shape[0])
    away = (start + size <= side[0]) | (start > side[-1])
    windows = windows[away & np.isfinite(windows).all(axis=(1, 2))]
    if windows.shape[0] < LEAST_WINDOWS:
        return nothing
    square = _squares(tuple(range(size)), windows - windows[:, :1]).mean(axis=0)
    least = float(ROUNDING * np.abs(points[side]).max()) ** 2
    usual: FloatArray = np.maximum(square, max(least, np.finfo(np.float64).tiny))
    return usual


def _lengths(points: FloatArray, frames: IntArray) -> FloatArray:
    """Return the squared lengths of the samples in these frames."""
    around = points[frames] - points[frames[0]]
    return _squares(tuple((frames - frames[0]).tolist()), around)


def _squares(frames: Frames, windows: FloatArray) -> FloatArray:
    """Return the squared lengths (mean of the axes), shape (..., samples)."""
    white = _whitener(frames) @ windows
    squares: FloatArray = np.einsum("...k,...k->...", white, white) / white.shape[-1]
    return squares


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
