"""A blend of candidates whose weights are measured on trials.

Stacked regressions (Breiman 1996): weights that are not negative and sum to one minimise the
squared error on what was left out. A plain inverse-error blend over many candidates is no better
than its best member; pulling the weights towards prior ones keeps few trials from deciding.
"""

from collections.abc import Sequence

import numpy as np
from scipy.optimize import nnls

from mocapmend_algorithms.arrays import FloatArray

SUM_WEIGHT = 1e4


def stack(errors: Sequence[Sequence[FloatArray]], prior: FloatArray, pull: float) -> FloatArray:
    """Return the weights of candidates.

    Parameters
    ----------
    errors : sequence over trials of sequence over candidates of ndarray, shape (samples, 3)
        What each candidate leaves over; trials count alike, however hard they are.
    prior : ndarray, shape (candidates,)
        Weights without any trial, summing to one.
    pull : float
        How strongly the weights are pulled towards them.

    Returns
    -------
    ndarray, shape (candidates,)
        Not negative, summing to one.
    """
    count = prior.size
    gram = pull * np.eye(count)
    wanted = pull * prior
    for trial in errors:
        flat = np.stack([candidate.ravel() for candidate in trial])
        products = flat @ flat.T
        typical = float(np.median(np.diagonal(products)))
        if typical > 0:
            gram += products / (typical * len(errors))
    # Least squares of the square root, with the sum as one more, heavy equation.
    root = np.linalg.cholesky(gram)
    equations = np.vstack((root.T, np.full(count, SUM_WEIGHT)))
    right = np.append(np.linalg.solve(root, wanted), SUM_WEIGHT)
    weights, _ = nnls(equations, right)
    total: FloatArray = weights / weights.sum()
    return total


def leave_one_out(
    errors: Sequence[Sequence[FloatArray]], prior: FloatArray, pull: float
) -> list[FloatArray]:
    """Return what a blend leaves over in each trial, with the weights that the others give.

    Parameters
    ----------
    errors, prior, pull
        As in `stack`.

    Returns
    -------
    list of ndarray, shape (samples, 3)
        Per trial.
    """
    left = []
    for trial in range(len(errors)):
        weights = stack([*errors[:trial], *errors[trial + 1 :]], prior, pull)
        left.append(blend(errors[trial], weights))
    return left


def blend(parts: Sequence[FloatArray], weights: FloatArray) -> FloatArray:
    """Return the weighted sum of arrays of the same shape."""
    total: FloatArray = np.tensordot(weights, np.stack(parts), axes=1)
    return total
