"""The natural quintic smoothing spline of samples at equal distances, in banded form.

The curve s minimises, with times in frames,

    sum over samples of (y - s)^2  +  p * integral of (s''')^2.

With Q' the third differences of neighbouring samples and R the overlap of the quadratic B-splines
that s''' is made of (its entries are a quintic B-spline at whole numbers),

    y - s = p Q (R + p Q'Q)^-1 Q' y

(Green and Silverman 1994, Nonparametric Regression and Generalized Linear Models, section 2.3, for
cubics; W86 for any order; see `gcv`). Everything is banded, so the work grows with the number of
samples alone. `fill.woltring` has the same spline for a few knots at any distance.
"""

from functools import lru_cache

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

LEAST = 8
"""Samples: W86 asks for twice the order of the penalty; two more leave something to choose by."""
OVERLAP = np.array([66.0, 26.0, 1.0, 0.0]) / 120
SQUARE = np.array([20.0, -15.0, 6.0, -1.0])
"""Diagonals of R and of Q'Q, the main one first."""
LOST = 3
"""Parabolas pass unchanged."""


def penalty(cutoff: float, rate: float) -> float:
    """Return the p of a spline that halves the power at a frequency.

    Far from the ends, a wave of angular frequency w (per frame) is multiplied by about
    1 / (1 + p w^6).

    Parameters
    ----------
    cutoff, rate : float
        In Hz.
    """
    return float((np.sqrt(2) - 1) / (2 * np.pi * cutoff / rate) ** 6)


def residuals(samples: FloatArray, p: float) -> FloatArray:
    """Return what the spline leaves over.

    Parameters
    ----------
    samples : ndarray, shape (samples, columns)
        At least `LEAST`, without a gap.
    p : float
        Weight of the penalty.

    Returns
    -------
    ndarray, shape (samples, columns)
        The samples less the curve.
    """
    from scipy.linalg import solveh_banded

    third = np.diff(samples, n=3, axis=0)
    bent = solveh_banded(_matrix(len(third), p), third, lower=True, check_finite=False)
    left = np.zeros_like(samples)
    for weight, place in zip((-1.0, 3.0, -3.0, 1.0), range(4), strict=True):
        left[place : place + len(bent)] += p * weight * bent
    return left


@lru_cache(maxsize=32)
def degrees_left(samples: int, penalties: tuple[float, ...]) -> FloatArray:
    """Return the trace of what turns samples into residuals, of each p.

    Parameters
    ----------
    samples : int
        How many there are.
    penalties : tuple of float
        The p.

    Returns
    -------
    ndarray, shape (penalties,)
        From 0, nothing smoothed, to `samples` - 3, a parabola. By Hutchinson and de Hoog 1985,
        Smoothing noisy data with spline functions, Numerische Mathematik 47:99-106.
    """
    from scipy.linalg import cholesky_banded

    size = samples - LOST
    factors = np.stack(
        [cholesky_banded(_matrix(size, p), lower=True, check_finite=False) for p in penalties]
    )
    pivots, below = factors[:, 0] ** 2, factors[:, 1:] / factors[:, :1]
    # inverse[:, j, k] is the inverse of R + p Q'Q at (row + j, row + k).
    inverse = np.zeros((len(penalties), 4, 4))
    trace = np.zeros(len(penalties))
    for row in range(size - 1, -1, -1):
        inverse[:, 1:, 1:] = inverse[:, :-1, :-1].copy()
        column = below[:, :, row]
        inverse[:, 0, 1:] = -np.einsum("pj,pjk->pk", column, inverse[:, 1:, 1:])
        inverse[:, 1:, 0] = inverse[:, 0, 1:]
        inverse[:, 0, 0] = 1 / pivots[:, row] - np.einsum("pj,pj->p", column, inverse[:, 0, 1:])
        trace += inverse[:, 0, :] @ (OVERLAP * [1, 2, 2, 2])
    left: FloatArray = size - trace
    left.flags.writeable = False
    return left


def _matrix(size: int, p: float) -> FloatArray:
    """Return the diagonals of R + p Q'Q, the main one first."""
    return np.tile((OVERLAP + p * SQUARE)[:, None], size)
