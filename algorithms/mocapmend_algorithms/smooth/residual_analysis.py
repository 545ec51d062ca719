"""Residual analysis: how much noise there is, and which cut-off frequency suits it.

W09 = Winter 2009, Biomechanics and Motor Control of Human Movement, 4th ed. The residual R(f) is
the root mean square of what a filter with cut-off f takes away. Above the bandwidth of the motion,
what it takes is noise alone, and R falls along a line that W09 draws by eye; where it meets 0 Hz is
the noise that is in the samples. Here the line is the one that white noise follows, which is known
for each filter, and it is fitted where it is `NOISE_ALONE`.

Two rules choose the cut-off from the noise. W09's takes the one whose residual equals the noise:
there, the motion that is lost is as large as the noise that is let through. The other takes the
one with the least expected error (Mallows 1973, Technometrics 15(4):661-675), which is higher:
Yu et al. 1999, J. Appl. Biomech. 15(3):318-329, found W09's too low, above all at high frame rates.
"""

from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

NOISE_ALONE = 0.5, 0.9
"""Shares of the Nyquist frequency between which what a filter takes counts as noise."""
PER_DECADE = 20
LOWEST_HZ = 0.5
HIGHEST = 0.95
"""Of the Nyquist frequency."""

Rule = Literal["least-error", "winter"]


def candidates(rate: float) -> FloatArray:
    """Return the cut-offs to try in Hz, ascending evenly by their logarithm."""
    highest = HIGHEST * rate / 2
    lowest = min(LOWEST_HZ, highest / 4)
    return np.geomspace(lowest, highest, int(PER_DECADE * np.log10(highest / lowest)) + 2)


def noise_variance(
    squares: FloatArray, taken: FloatArray, frequencies: FloatArray, rate: float
) -> FloatArray:
    """Estimate how much white noise is in trajectories.

    Parameters
    ----------
    squares : ndarray, shape (frequencies, trajectories)
        Mean square of the residual.
    taken : ndarray, shape (frequencies,)
        Share of the power of white noise that the residual has.
    frequencies : ndarray, shape (frequencies,)
        The cut-offs in Hz; see `candidates`.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    ndarray, shape (trajectories,)
        Variance, in the square of the trajectories' unit.
    """
    low, high = (share * rate / 2 for share in NOISE_ALONE)
    alone = (frequencies >= low) & (frequencies <= high)
    return np.asarray(np.mean(squares[alone] / taken[alone, None], axis=0), dtype=np.float64)


def choose_cutoffs(
    squares: FloatArray, noise: FloatArray, passed: FloatArray, rule: Rule
) -> list[int]:
    """Choose the cut-off of each trajectory.

    Parameters
    ----------
    squares : ndarray, shape (frequencies, trajectories)
        Mean square of the residual, for ascending cut-offs.
    noise : ndarray, shape (trajectories,)
        Variance of the noise.
    passed : ndarray, shape (frequencies,)
        Mean response of the filter over all frequencies: the share of a sample's own noise that
        stays in its smoothed value.
    rule : str
        See the module.

    Returns
    -------
    list of int
        Places in the frequencies; the highest, where no residual is as small as the noise.
    """
    if rule == "least-error":
        places = np.argmin(squares + 2 * noise * passed[:, None], axis=0)
    else:
        small = squares <= noise
        places = np.where(small.any(axis=0), small.argmax(axis=0), len(squares) - 1)
    return [int(place) for place in places]
