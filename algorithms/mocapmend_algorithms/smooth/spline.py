"""The natural smoothing spline of samples at equal distances, in banded form.

The curve s minimises, with times in frames,

    sum over samples of (y - s)^2  +  p * integral of (m-th derivative of s)^2,

a cubic spline for m = 2 and a quintic one for m = 3. With Q' the m-th differences of neighbouring
samples and R the overlap of the B-splines that the m-th derivative is made of (its entries are a
B-spline of twice the order at whole numbers),

    y - s = p Q (R + p Q'Q)^-1 Q' y

(Green and Silverman 1994, Nonparametric Regression and Generalized Linear Models, for cubics).
Everything is banded, so the work grows with the number of samples alone.
`fill.woltring` has the quintic spline for a few knots at any distance.

The same curve is what a Kalman smoother makes of an m times integrated random walk that is seen
with noise of p times its variance (Wahba 1978, J. R. Stat. Soc. B 40(3):364-372): the differences
Q' y then have the covariance q (R + p Q'Q), whatever the first state.
"""

from functools import lru_cache
from math import comb

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

LEAST = 8
"""Samples: twice the order of the penalty, and two more to choose by."""
OVERLAP = {2: np.array([4.0, 1.0, 0.0]) / 6, 3: np.array([66.0, 26.0, 1.0, 0.0]) / 120}
SQUARE = {2: np.array([6.0, -4.0, 1.0]), 3: np.array([20.0, -15.0, 6.0, -1.0])}
"""Diagonals of R and of Q'Q by m, the main one first."""
PER_DECADE = 20
SLOWEST = 0.012
"""Radians per frame: below, the equations lose their digits."""
SLOWEST_HZ = 0.25
STATIONARY = 3000
"""Rows after which the pivots of even the slowest curve are all alike: exp(-0.012 x 3000) is 0."""


def lowest_cutoff(rate: float) -> float:
    """Return the lowest cut-off in Hz at which the equations keep their digits."""
    return SLOWEST * rate / (2 * np.pi)


def cutoff_grid(rate: float) -> tuple[float, ...]:
    """Return cut-offs to choose from in Hz, descending evenly by their logarithm.

    Parameters
    ----------
    rate : float
        Frames per second (Hz); the first is half of it.
    """
    highest = rate / 2
    lowest = min(max(SLOWEST_HZ, lowest_cutoff(rate)), highest / 2)
    count = int(PER_DECADE * np.log10(highest / lowest)) + 2
    return tuple(np.geomspace(highest, lowest, count).tolist())


def penalty(cutoff: float, rate: float, order: int) -> float:
    """Return the p of a spline that halves the power at a frequency.

    Far from the ends, a wave of angular frequency w (per frame) is multiplied by about
    1 / (1 + p w^2m), as by a Butterworth filter of order m that goes forwards and backwards.

    Parameters
    ----------
    cutoff, rate : float
        In Hz.
    order : int
        m, 2 or 3.
    """
    return float((np.sqrt(2) - 1) / (2 * np.pi * cutoff / rate) ** (2 * order))


def residuals(samples: FloatArray, p: float, order: int) -> FloatArray:
    """Return what the spline leaves over.

    Parameters
    ----------
    samples : ndarray, shape (samples, columns)
        At least `LEAST`, without a gap.
    p : float
        Weight of the penalty.
    order : int
        m, 2 or 3.

    Returns
    -------
    ndarray, shape (samples, columns)
        The samples less the curve.
    """
    from scipy.linalg import solveh_banded

    bent = np.diff(samples, n=order, axis=0)
    bent = solveh_banded(_matrix(len(bent), p, order), bent, lower=True, check_finite=False)
    left = np.zeros_like(samples)
    for place in range(order + 1):
        weight = comb(order, place) * (-1) ** (order - place)
        left[place : place + len(bent)] += p * weight * bent
    return left


def roughness(samples: FloatArray, p: float, order: int) -> tuple[FloatArray, float]:
    """Return what the likelihood of the samples is made of.

    Parameters
    ----------
    samples, p, order
        As for `residuals`.

    Returns
    -------
    roughness : ndarray, shape (columns,)
        y'Q (R + p Q'Q)^-1 Q'y: the least sum of the spline over p.
    log_determinant : float
        Of R + p Q'Q.
    """
    from scipy.linalg import cho_solve_banded, cholesky_banded

    bent = np.diff(samples, n=order, axis=0)
    factor = cholesky_banded(_matrix(len(bent), p, order), lower=True, check_finite=False)
    solved = cho_solve_banded((factor, True), bent, check_finite=False)
    return np.sum(bent * solved, axis=0), float(2 * np.sum(np.log(factor[0])))


def degrees_left(samples: int, penalties: tuple[float, ...], order: int) -> FloatArray:
    """Return the trace of what turns samples into residuals, of each p.

    That is the derivative of the log-determinant of R + p Q'Q by log p, and this the sum of the
    logarithms of its pivots, which are the same for any number of samples.

    Parameters
    ----------
    samples : int
        How many there are.
    penalties : tuple of float
        The p.
    order : int
        m, 2 or 3.

    Returns
    -------
    ndarray, shape (penalties,)
        From 0, nothing smoothed, to `samples` - m, a polynomial.
    """
    size = samples - order
    by_row = _pivot_growth(penalties, order)
    left: FloatArray = by_row[:size].sum(axis=0) + max(0, size - STATIONARY) * by_row[-1]
    return left


@lru_cache(maxsize=16)
def _pivot_growth(penalties: tuple[float, ...], order: int) -> FloatArray:
    """Return the derivative by log p of the logarithm of each pivot, (STATIONARY, penalties)."""
    from scipy.linalg import toeplitz

    smooth = np.array(penalties)[:, None, None] * toeplitz(SQUARE[order])
    whole = toeplitz(OVERLAP[order]) + smooth
    # What is left of the next rows when those before are eliminated, and its derivative.
    rest, change = whole.copy(), smooth.copy()
    growth = np.empty((STATIONARY, len(penalties)))
    for row in range(STATIONARY):
        share = rest[:, 1:, 0] / rest[:, :1, 0]
        growth[row] = change[:, 0, 0] / rest[:, 0, 0]
        shift = change[:, 1:, 0] - 0.5 * growth[row][:, None] * rest[:, 1:, 0]
        cross = shift[:, :, None] * share[:, None]
        new = rest[:, 1:, 1:] - share[:, :, None] * rest[:, None, 1:, 0]
        new_change = change[:, 1:, 1:] - cross - cross.transpose(0, 2, 1)
        rest, change = whole.copy(), smooth.copy()
        rest[:, :-1, :-1], change[:, :-1, :-1] = new, new_change
    growth.flags.writeable = False
    return growth


def by_axis(samples: FloatArray, penalties: list[float], order: int) -> FloatArray:
    """Return the curve of each column with a penalty of its own, shape as the samples."""
    columns = [
        samples[:, [axis]] - residuals(samples[:, [axis]], p, order)
        for axis, p in enumerate(penalties)
    ]
    return np.concatenate(columns, axis=1)


def _matrix(size: int, p: float, order: int) -> FloatArray:
    """Return the diagonals of R + p Q'Q, the main one first."""
    return np.tile((OVERLAP[order] + p * SQUARE[order])[:, None], size)
