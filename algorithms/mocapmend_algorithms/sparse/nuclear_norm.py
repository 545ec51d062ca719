"""Completion of a matrix by the smallest nuclear norm.

Of all matrices Z with the known entries of X, the one is sought whose singular values have the
smallest sum:

    min |Z|_*  subject to  Z = X where X is known.

Singular value thresholding (Cai, Candes and Shen 2010, SIAM J. Optim. 20(4):1956-1982) comes to the
same Z where its threshold is large, by thousands of singular value decompositions of the matrix.
Here it takes tens of eigenvalue problems of the small Gram matrix (Mohan and Fazel 2012, "Iterative
reweighted algorithms for matrix rank minimization", JMLR 13:3441-3473, with p = 1). With
W = (Z^T Z + e^2)^(-1/2), the unknown entries m of a row z are those that make z W z^T smallest,

    z_m = - W_mm^(-1) W_mo z_o ,

and e falls to a small share of the largest singular value. For a fixed e, such a step never
increases the sum of sqrt(s^2 + e^2) over the singular values s, which is convex. The steps have
momentum, and start anew where it points uphill (O'Donoghue and Candes 2015): without it, they stop
far from the optimum where a whole block is unknown.
"""

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.progress import Progress, no_progress

FIRST = 0.1
"""Share of the largest singular value that e begins with."""
FALL = 0.8
"""By which e falls at each step: where it falls faster, small singular values get stuck."""


def complete(
    matrix: FloatArray,
    known: BoolArray,
    *,
    threshold: float = 1e-6,
    tolerance: float = 1e-6,
    most_iterations: int = 300,
    progress: Progress = no_progress,
) -> FloatArray:
    """Complete a matrix.

    Parameters
    ----------
    matrix : ndarray, shape (rows, columns)
        Not changed; what it holds at unknown entries is not looked at.
    known : ndarray of bool, shape (rows, columns)
        Which entries are known.
    threshold : float
        Share of the largest singular value, above 0, below which singular values hardly count.
    tolerance : float
        Relative change of the incomplete rows in a step at which the matrix is done.
    most_iterations : int
        Where it is not done by then, it is returned as it is.
    progress : Progress
        Called at every step.

    Returns
    -------
    ndarray, shape (rows, columns)
        The known entries as they are; rows and columns without any known entry are zero.
    """
    wide = matrix.shape[0] < matrix.shape[1]
    if wide:
        matrix, known = matrix.T, known.T
    weights = row_weights(
        matrix,
        known,
        threshold=threshold,
        tolerance=tolerance,
        most_iterations=most_iterations,
        progress=progress,
    )
    completed = complete_rows(matrix, known, weights)
    return completed.T if wide else completed


def row_weights(
    matrix: FloatArray,
    known: BoolArray,
    *,
    threshold: float,
    tolerance: float,
    most_iterations: int = 300,
    progress: Progress = no_progress,
) -> FloatArray:
    """Find the weights W by which the rows of a matrix are completed.

    Parameters
    ----------
    matrix, known, threshold, tolerance, most_iterations, progress
        See `complete`. The matrix should not have many more columns than rows.

    Returns
    -------
    ndarray, shape (columns, columns)
        Symmetric and positive definite.
    """
    complete_ones = known.all(axis=1)
    gram = matrix[complete_ones].T @ matrix[complete_ones]
    rows = np.where(known, matrix, 0.0)[~complete_ones]
    patterns = _patterns(known[~complete_ones])
    largest = np.sqrt(max(np.linalg.eigvalsh(gram + rows.T @ rows)[-1], 0.0))
    least = threshold * largest if largest > 0 else 1.0
    floor = max(FIRST * largest, least)
    ahead, momentum = rows, 1.0
    for step in range(most_iterations):
        progress(step / most_iterations)
        new = ahead.copy()
        _least_squares(new, patterns, _weights(gram + ahead.T @ ahead, floor))
        change = new - rows
        if np.sum((ahead - new) * change) > 0:
            momentum = 1.0
        after = (1 + np.sqrt(1 + 4 * momentum**2)) / 2
        ahead, rows = new + (momentum - 1) / after * change, new
        momentum = after
        if floor <= least and np.linalg.norm(change) <= tolerance * np.linalg.norm(rows):
            break
        floor = max(FALL * floor, least)
    progress(1.0)
    return _weights(gram + rows.T @ rows, floor)


def complete_rows(matrix: FloatArray, known: BoolArray, weights: FloatArray) -> FloatArray:
    """Complete the rows of a matrix, each by itself.

    Parameters
    ----------
    matrix : ndarray, shape (rows, columns)
        Not changed.
    known : ndarray of bool, shape (rows, columns)
        Which entries are known.
    weights : ndarray, shape (columns, columns)
        As of `row_weights`, of this matrix or of one like it.

    Returns
    -------
    ndarray, shape (rows, columns)
    """
    rows: FloatArray = np.where(known, matrix, 0.0)
    _least_squares(rows, _patterns(known), weights)
    return rows


_Pattern = tuple[IntArray, IntArray, IntArray]
"""Rows, and the columns in which they are known and unknown."""


def _patterns(known: BoolArray) -> list[_Pattern]:
    rows: dict[bytes, list[int]] = {}
    for row in np.flatnonzero(~known.all(axis=1)).tolist():
        rows.setdefault(known[row].tobytes(), []).append(row)
    return [
        (np.array(alike), np.flatnonzero(known[alike[0]]), np.flatnonzero(~known[alike[0]]))
        for alike in rows.values()
    ]


def _least_squares(rows: FloatArray, patterns: list[_Pattern], weights: FloatArray) -> None:
    """Write into the unknown entries what makes each row's weighted square smallest."""
    for alike, there, missing in patterns:
        pull = weights[np.ix_(missing, there)] @ rows[np.ix_(alike, there)].T
        rows[np.ix_(alike, missing)] = -np.linalg.solve(weights[np.ix_(missing, missing)], pull).T


def _weights(gram: FloatArray, floor: float) -> FloatArray:
    values, vectors = np.linalg.eigh(gram)
    weights: FloatArray = (vectors / np.sqrt(np.maximum(values, 0.0) + floor**2)) @ vectors.T
    return weights
