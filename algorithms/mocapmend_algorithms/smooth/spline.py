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


@lru_cache(maxsize=32)
def degrees_left(samples: int, penalties: tuple[float, ...], order: int) -> FloatArray:
    """Return the trace of what turns samples into residuals, of each p.

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
        From 0, nothing smoothed, to `samples` - m, a polynomial. By Hutchinson and de Hoog 1985,
        Smoothing noisy data with spline functions, Numerische Mathematik 47:99-106.
    """
    from scipy.linalg import cholesky_banded

    size = samples - order
    factors = np.stack(
        [
            cholesky_banded(_matrix(size, p, order), lower=True, check_finite=False)
            for p in penalties
        ]
    )
    pivots, below = factors[:, 0] ** 2, factors[:, 1:] / factors[:, :1]
    weights = OVERLAP[order] * np.append(1.0, np.full(order, 2.0))
    # inverse[:, j, k] is the inverse of R + p Q'Q at (row + j, row + k).
    inverse = np.zeros((len(penalties), order + 1, order + 1))
    trace = np.zeros(len(penalties))
    for row in range(size - 1, -1, -1):
        inverse[:, 1:, 1:] = inverse[:, :-1, :-1].copy()
        column = below[:, :, row]
        inverse[:, 0, 1:] = -np.einsum("pj,pjk->pk", column, inverse[:, 1:, 1:])
        inverse[:, 1:, 0] = inverse[:, 0, 1:]
        inverse[:, 0, 0] = 1 / pivots[:, row] - np.einsum("pj,pj->p", column, inverse[:, 0, 1:])
        trace += inverse[:, 0, :] @ weights
    left: FloatArray = size - trace
    left.flags.writeable = False
    return left


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
