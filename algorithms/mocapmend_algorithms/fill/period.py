"""How long a cycle of periodic motion lasts."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

STEP_S = 0.04
"""Displacements over this time are compared: shorter ones are mostly noise."""
SHORTEST_S = 0.2
LEAST_SHARED_S = 0.5
"""Less of the motion, compared with itself, is alike by chance."""
MOST_UNLIKE = 0.4
"""Motion that has nothing to do with itself a lag later has an unlikeness of 1."""
NEARLY = 1.25, 0.02
"""Twice the period is a period too: the shortest nearly as good is taken."""


def find_period(points: FloatArray, rate: float) -> float | None:
    """Estimate the period of markers that move in cycles.

    The displacements over 40 ms, less their mean, are compared with those a lag later (as in de
    Cheveigné and Kawahara 2002, YIN, eqs. 6 to 8), so that neither place nor steady progress
    matters. All markers count together, those that move more count more.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Trajectories, NaN where missing.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    float or None
        In frames; None where the motion does not repeat, or less than one and a half cycles were
        seen.
    """
    unlike = unlikeness(points, rate)
    shortest = max(2, round(SHORTEST_S * rate))
    lags = np.arange(shortest, unlike.size - 1)
    here, before, after = unlike[lags], unlike[lags - 1], unlike[lags + 1]
    # Not at the beginning, where it only rises from 0: NaN compares false.
    dips = lags[(here < MOST_UNLIKE) & (here <= before) & (here <= after)]
    if not dips.size:
        return None
    limit = NEARLY[0] * unlike[dips].min() + NEARLY[1]
    lag = int(dips[unlike[dips] <= limit][0])
    low, middle, high = unlike[lag - 1 : lag + 2]
    bend = low - 2 * middle + high
    return lag + (0.5 * float((low - high) / bend) if bend > 0 else 0.0)


def unlikeness(points: FloatArray, rate: float) -> FloatArray:
    """Compare the displacements of markers with those a lag later.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Trajectories, NaN where missing.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    ndarray, shape (lags,)
        Their squared difference relative to their squares, for lags of 0, 1, ... frames: 0 for
        equal, about 1 for unrelated displacements. NaN where less than half a lag or half a second
        can be compared.
    """
    step = max(1, round(STEP_S * rate))
    moved = points[step:] - points[:-step]
    frames = moved.shape[0]
    product, square, pairs = np.zeros((3, frames))
    for marker in range(points.shape[1]):
        seen = ~np.isnan(moved[:, marker, 0])
        if not seen.any():
            continue
        around = np.where(seen[:, None], moved[:, marker] - moved[seen, marker].mean(axis=0), 0.0)
        power = np.sum(around**2, axis=1)
        mask = seen.astype(np.float64)
        product += sum(_correlate(axis, axis) for axis in around.T)
        square += _correlate(power, mask) + _correlate(mask, power)
        pairs += _correlate(mask, mask)
    least = np.maximum(np.arange(frames) / 2, LEAST_SHARED_S * rate)
    enough = pairs > points.shape[1] * least
    known = enough & (square > 1e-12 * max(square.max(initial=0.0), 1e-300))
    ratio = 1 - 2 * product / np.where(known, square, 1.0)
    return np.where(known, ratio, np.nan)


def _correlate(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return the sums over t of first(t) second(t + lag) for all lags."""
    from scipy.fft import irfft, next_fast_len, rfft

    size = next_fast_len(2 * first.size, real=True)
    spectrum = np.conj(rfft(first, size)) * rfft(second, size)
    correlation: FloatArray = irfft(spectrum, size)[: first.size]
    return correlation
