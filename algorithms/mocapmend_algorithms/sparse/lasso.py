"""Sparse codes of many columns over one dictionary, with a certificate.

Each column y of the targets gets the code w that minimises

    1/2 |y - D w|^2 + penalty * |w|_1

by accelerated proximal gradient steps (Beck and Teboulle 2009, FISTA) that start anew where the
momentum points uphill (O'Donoghue and Candes 2015). All columns share one Gram matrix, so a step is
one product of matrices. A column is done when its duality gap (as in Kim et al. 2007, section 3)
says that it is as near to its optimum as was asked.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.progress import Progress, no_progress

CHECK_EVERY = 10


@dataclass(frozen=True, eq=False)
class Codes:
    """Sparse codes and how good they are.

    Attributes
    ----------
    weights : ndarray, shape (atoms, columns)
        The codes.
    gap : ndarray, shape (columns,)
        By how much each may miss its optimum, relative to half the squared length of its target.
    iterations : int
        Steps taken.
    """

    weights: FloatArray
    gap: FloatArray
    iterations: int


def encode(
    dictionary: FloatArray,
    targets: FloatArray,
    penalty: float,
    *,
    tolerance: float = 1e-3,
    most_iterations: int = 500,
    start: FloatArray | None = None,
    progress: Progress = no_progress,
) -> Codes:
    """Find the sparse codes of many columns.

    Parameters
    ----------
    dictionary : ndarray, shape (rows, atoms)
        Atoms as columns.
    targets : ndarray, shape (rows, columns)
        What is to be coded.
    penalty : float
        Above 0: the larger, the fewer atoms are used.
    tolerance : float
        Relative duality gap at which a column is done.
    most_iterations : int
        Columns that are not done by then are returned as they are; `Codes.gap` says so.
    start : ndarray, shape (atoms, columns), optional
        Where to begin; at zero by default.
    progress : Progress
        Called every few steps.

    Returns
    -------
    Codes

    Raises
    ------
    ValueError
        If the penalty is not above 0, or the shapes contradict each other.
    """
    if dictionary.shape[0] != targets.shape[0]:
        raise ValueError(f"atoms have {dictionary.shape[0]} rows, targets {targets.shape[0]}")
    gram, correlation = dictionary.T @ dictionary, dictionary.T @ targets
    return encode_gram(
        gram,
        correlation,
        np.einsum("rc,rc->c", targets, targets),
        penalty,
        tolerance=tolerance,
        most_iterations=most_iterations,
        start=start,
        progress=progress,
    )


def encode_gram(
    gram: FloatArray,
    correlation: FloatArray,
    energy: FloatArray,
    penalty: float,
    *,
    tolerance: float = 1e-3,
    most_iterations: int = 500,
    start: FloatArray | None = None,
    progress: Progress = no_progress,
) -> Codes:
    """Find the sparse codes of many columns from products that are known already.

    Parameters
    ----------
    gram : ndarray, shape (atoms, atoms)
        D^T D.
    correlation : ndarray, shape (atoms, columns)
        D^T y of each column.
    energy : ndarray, shape (columns,)
        |y|^2 of each column.
    penalty, tolerance, most_iterations, start, progress
        See `encode`.

    Returns
    -------
    Codes

    Raises
    ------
    ValueError
        If the penalty is not above 0.
    """
    if not penalty > 0:
        raise ValueError(f"the penalty must be above 0, not {penalty}")
    step = 1.0 / max(_largest_eigenvalue(gram), np.finfo(np.float64).tiny)
    weights = np.zeros_like(correlation) if start is None else start.copy()
    gap = np.full(energy.size, np.inf)
    todo = np.arange(energy.size)
    state = _Descent(weights, correlation)
    iterations = 0
    while todo.size and iterations < most_iterations:
        if iterations % CHECK_EVERY == 0:
            progress(iterations / most_iterations)
            gap[todo] = _gap(gram, state.correlation, energy[todo], state.weights, penalty)
            unfinished = gap[todo] > tolerance
            weights[:, todo] = state.weights
            todo = todo[unfinished]
            state.keep(unfinished)
        state.advance(gram, step, penalty)
        iterations += 1
    weights[:, todo] = state.weights
    if todo.size:
        gap[todo] = _gap(gram, state.correlation, energy[todo], state.weights, penalty)
    progress(1.0)
    return Codes(weights, gap, iterations)


class _Descent:
    """The columns that are not done yet, with their momentum."""

    def __init__(self, weights: FloatArray, correlation: FloatArray) -> None:
        self.weights, self.correlation = weights.copy(), correlation
        self._ahead = self.weights
        self._momentum = np.ones(weights.shape[1])

    def keep(self, chosen: BoolArray) -> None:
        if chosen.all():
            return
        self.weights, self.correlation = self.weights[:, chosen], self.correlation[:, chosen]
        self._ahead, self._momentum = self._ahead[:, chosen], self._momentum[chosen]

    def advance(self, gram: FloatArray, step: float, penalty: float) -> None:
        moved = self._ahead - step * (gram @ self._ahead - self.correlation)
        threshold = step * penalty
        new = moved - np.clip(moved, -threshold, threshold)
        change = new - self.weights
        uphill = np.einsum("ac,ac->c", self._ahead - new, change) > 0
        self._momentum[uphill] = 1.0
        after = (1 + np.sqrt(1 + 4 * self._momentum**2)) / 2
        self._ahead = new + np.where(uphill, 0.0, (self._momentum - 1) / after) * change
        self._momentum, self.weights = after, new


def _gap(
    gram: FloatArray,
    correlation: FloatArray,
    energy: FloatArray,
    weights: FloatArray,
    penalty: float,
) -> FloatArray:
    """Return the relative duality gap of each column."""
    image = gram @ weights
    inside = np.einsum("ac,ac->c", weights, correlation)
    residual = np.maximum(energy - 2 * inside + np.einsum("ac,ac->c", weights, image), 0.0)
    primal = residual / 2 + penalty * np.abs(weights).sum(axis=0)
    steepest = np.abs(correlation - image).max(axis=0, initial=0.0)
    shrink = penalty / np.maximum(steepest, penalty)
    dual = shrink * (energy - inside) - shrink**2 * residual / 2
    scale = np.maximum(energy / 2, np.finfo(np.float64).tiny)
    gap: FloatArray = np.maximum(primal - dual, 0.0) / scale
    return gap


def _largest_eigenvalue(gram: FloatArray) -> float:
    from scipy.linalg import eigh

    last = gram.shape[0] - 1
    return float(eigh(gram, eigvals_only=True, subset_by_index=[last, last])[0])
