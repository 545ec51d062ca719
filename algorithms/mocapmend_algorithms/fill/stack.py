"""A blend of candidates whose weights are measured on trials.

Stacked regressions (Breiman 1996): weights that are not negative and sum to one minimise the
squared error on what was left out. A plain inverse-error blend over many candidates is no better
than its best member; pulling the weights towards prior ones keeps few trials from deciding.
"""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

SUM_WEIGHT = 1e4
MOST_TYPICAL = 1e4
LEAST_MM = 1e-9
"""No candidate is taken to be more exact: numbers are not."""


class Stack:
    """Weights of candidates, measured on trials.

    Parameters
    ----------
    errors : sequence over trials of sequence over candidates of ndarray, shape (samples, 3)
        What each candidate leaves over. Trials count alike, however hard they are.
    prior : ndarray, shape (candidates,)
        Weights without any trial, summing to one.
    pull : float
        How strongly the weights are pulled towards them.
    """

    def __init__(
        self, errors: Sequence[Sequence[FloatArray]], prior: FloatArray, pull: float
    ) -> None:
        self._errors = errors
        self._prior = prior
        self._pull = pull
        self._grams = [_gram(trial) for trial in errors]

    def weights(self) -> FloatArray:
        """Return the weights, shape (candidates,): not negative, summing to one."""
        return self._solve(sum(self._grams, np.zeros((self._prior.size,) * 2)), len(self._grams))

    def left_out(self) -> list[FloatArray]:
        """Return what the blend leaves over in each trial with the weights of all the others."""
        total = sum(self._grams, np.zeros((self._prior.size,) * 2))
        return [
            blend(trial, self._solve(total - gram, len(self._grams) - 1))
            for trial, gram in zip(self._errors, self._grams, strict=True)
        ]

    def _solve(self, total: FloatArray, trials: int) -> FloatArray:
        from scipy.optimize import nnls

        # Least squares of the square root, with the sum as one more, heavy equation.
        gram = total / max(trials, 1) + self._pull * np.eye(self._prior.size)
        root = np.linalg.cholesky(gram)
        equations = np.vstack((root.T, np.full(self._prior.size, SUM_WEIGHT)))
        wanted = np.append(np.linalg.solve(root, self._pull * self._prior), SUM_WEIGHT)
        weights, _ = nnls(equations, wanted)
        normalised: FloatArray = weights / weights.sum()
        return normalised


def blend(parts: Sequence[FloatArray], weights: FloatArray) -> FloatArray:
    """Return the weighted sum of arrays of the same shape."""
    total: FloatArray = np.tensordot(weights, np.stack(parts), axes=1)
    return total


def _gram(trial: Sequence[FloatArray]) -> FloatArray:
    """Return the products of the candidates' errors, relative to a typical square."""
    flat = np.stack([errors.ravel() for errors in trial])
    products: FloatArray = flat @ flat.T
    size = np.diagonal(products)
    typical = max(float(np.median(size)), LEAST_MM**2)
    # A candidate that fails altogether would drown the differences between the others.
    bound = np.minimum(1.0, MOST_TYPICAL * np.sqrt(typical / np.maximum(size, typical)))
    bounded: FloatArray = products / typical * np.outer(bound, bound)
    return bounded
