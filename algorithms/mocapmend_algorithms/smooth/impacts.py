"""Smoothing less at impacts, where one amount for a whole stretch rounds them off.

Besides the curve that was chosen, lighter ones with higher cut-offs are made. At each sample the
smoothest curve is taken that no lighter one contradicts: two curves contradict each other where
they differ by more than noise explains (Lepski's rule: Lepskii 1991, Theory of Probability and its
Applications 35(3):454-466). How large the noise is, is what was found for the stretch, or more
where what the lightest curve leaves over is larger: so a burst of jitter, which no curve follows,
is smoothed as before, while a foot strike, which the lighter curves follow, is kept.
"""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.smooth.spline import by_axis, penalty

STEPS = 4
"""Curves, with the one that was chosen."""
FACTOR = 1.6
"""Between their cut-offs."""
CONTRADICTION = 4.0
"""Times the variance that noise explains."""
LOCAL_S = 0.15
"""Over which the noise of a place is looked at."""
BLEND = 5
"""Frames over which one curve goes over into another."""
SPECTRUM = 512
SMALLEST = np.finfo(np.float64).tiny


def lighter_at_impacts(
    samples: FloatArray, cutoffs: FloatArray, noise: FloatArray, rate: float, order: int
) -> tuple[FloatArray, float]:
    """Smooth, and less where the motion is faster than the chosen cut-offs.

    Parameters
    ----------
    samples : ndarray, shape (samples, axes)
        Without a gap.
    cutoffs : ndarray, shape (axes,)
        Those that were chosen, in Hz.
    noise : ndarray, shape (axes,)
        Standard deviation of a coordinate, in the samples' unit.
    rate : float
        Samples per second (Hz).
    order : int
        Of the penalty; see `spline`.

    Returns
    -------
    curve : ndarray, shape (samples, axes)
    share : float
        Of the samples that were smoothed less, from 0 to 1.
    """
    from scipy.ndimage import uniform_filter1d

    # More than the rate is next to no smoothing.
    ladder = [np.minimum(cutoffs * FACTOR**step, rate) for step in range(STEPS)]
    penalties = [[penalty(one, rate, order) for one in rung.tolist()] for rung in ladder]
    curves = np.array([by_axis(samples, some, order) for some in penalties])
    responses = np.array([_responses(some, order) for some in penalties])
    left = np.mean((1 - responses[-1]) ** 2, axis=1)
    local = uniform_filter1d((samples - curves[-1]) ** 2, _odd(LOCAL_S * rate), axis=0)
    variance = np.maximum(noise**2, local / left)
    widths = [_odd(rate / (2 * float(np.mean(rung)))) for rung in ladder]
    chosen = _uncontradicted(curves, responses, variance, widths)
    weights = np.zeros(curves.shape[:2])
    weights[chosen, np.arange(len(samples))] = 1.0
    blended = np.einsum("ct,cta->ta", uniform_filter1d(weights, BLEND, axis=1), curves)
    return blended, float(np.mean(chosen > 0))


def _uncontradicted(
    curves: FloatArray, responses: FloatArray, variance: FloatArray, widths: list[int]
) -> IntArray:
    """Return the place of the smoothest curve at each sample that no lighter one contradicts."""
    from scipy.ndimage import uniform_filter1d

    chosen = np.full(curves.shape[1], len(curves) - 1)
    agreed = np.ones(curves.shape[1], dtype=np.bool_)
    for place in range(len(curves) - 2, -1, -1):
        for lighter in range(place + 1, len(curves)):
            explained = np.mean((responses[lighter] - responses[place]) ** 2, axis=1)
            away = (curves[lighter] - curves[place]) ** 2
            times = np.mean(away / np.maximum(explained * variance, SMALLEST), axis=1)
            agreed &= uniform_filter1d(times, widths[place]) < CONTRADICTION
        chosen[agreed] = place
    return chosen


def _responses(penalties: list[float], order: int) -> FloatArray:
    """Return what waves are multiplied by, evenly from 0 to half the rate, (axes, waves)."""
    waves = np.pi * (np.arange(SPECTRUM) + 0.5) / SPECTRUM
    return 1 / (1 + np.array(penalties)[:, None] * waves ** (2 * order))


def _odd(frames: float) -> int:
    return max(3, 2 * int(frames / 2) + 1)
