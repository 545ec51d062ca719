"""Sparse codes whose reconstruction keeps bone lengths (W18, eqs. 17-33).

W18 = Wang, Lu, Han 2018, Computer Systems & Applications 27(5):17-25. In signed squares the squared
length of a bone is a sum of three numbers with known signs. So a column y (a window of F2) with the
dictionary D gets the code w that minimises

    1/2 |A (y - D w)|^2 + lambda1 |w|_1 + lambda2/2 |B (l - T D w)|^2,

A choosing the rows that are seen, T adding up each bone with its signs, B choosing the bones with
rows that are not seen. This one objective is what `Problem.objective` returns, what the codes and,
in `training`, the dictionary are made to lower, and what never rises. W18 minimises eq. 15 in words
and eq. 20 in formulas, which leave the masks out or in; eq. 26 drops A; the threshold of eq. 32 is
t lambda1 and not 2 t lambda1; eq. 33 lacks a square, and alpha and beta, which are 2 and 1/2 here.
A column whose step would not lower its objective stays and halves its step.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.progress import Progress, no_progress

GROW, SHRINK = 2.0, 0.5
"""alpha and beta of eq. 33."""
CHECK_EVERY = 10


@dataclass(frozen=True, eq=False)
class Problem:
    """Columns to be coded.

    Attributes
    ----------
    targets : ndarray, shape (rows, columns)
        F2, scaled; rows that are not seen may hold anything finite.
    seen : ndarray of bool, shape (rows, columns)
        A.
    signs : ndarray, shape (rows, columns)
        1, 0 or -1: the signs of the rows, of those that are not seen as far as they can be told.
        0 for rows that belong to no bone (W18's anchors).
    squares : ndarray, shape (bones, columns)
        l: squared lengths, scaled alike. Bone b has the rows 3b, 3b + 1 and 3b + 2.
    held : ndarray of bool, shape (bones, columns)
        B.
    penalty, bone_weight : float
        lambda1 and lambda2.
    """

    targets: FloatArray
    seen: BoolArray
    signs: FloatArray
    squares: FloatArray
    held: BoolArray
    penalty: float
    bone_weight: float

    def smooth(self, image: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the smooth part of the objective and its slope.

        Parameters
        ----------
        image : ndarray, shape (rows, columns)
            D w.

        Returns
        -------
        value : ndarray, shape (columns,)
        slope : ndarray, shape (rows, columns)
            By the image.
        """
        slope = np.where(self.seen, image - self.targets, 0)
        value = np.einsum("rc,rc->c", slope, slope) / 2
        if self.bone_weight > 0:
            bones = (self.signs * image).reshape(-1, 3, image.shape[1]).sum(axis=1)
            miss = np.where(self.held, bones - self.squares, 0)
            value += self.bone_weight / 2 * np.einsum("bc,bc->c", miss, miss)
            slope += self.bone_weight * self.signs * np.repeat(miss, 3, axis=0)
        return value, slope

    def objective(self, dictionary: FloatArray, weights: FloatArray) -> float:
        """Return the objective, summed over the columns."""
        value, _ = self.smooth(dictionary @ weights)
        return float(value.sum(dtype=np.float64) + self.penalty * _size(weights).sum())


def encode_bones(
    dictionary: FloatArray,
    problem: Problem,
    weights: FloatArray,
    *,
    iterations: int,
    tolerance: float = 1e-4,
    progress: Progress = no_progress,
) -> FloatArray:
    """Lower the objective by the codes, with proximal gradient steps (W18, eqs. 28-33).

    Parameters
    ----------
    dictionary : ndarray, shape (rows, atoms)
        D.
    problem : Problem
        The columns.
    weights : ndarray, shape (atoms, columns)
        Where to begin; not changed.
    iterations : int
        Most steps.
    tolerance : float
        Stop when ten steps lower the whole objective by less than this share.
    progress : Progress
        Called often.

    Returns
    -------
    ndarray, shape (atoms, columns)
        No column's objective is higher than at the beginning.
    """
    # Begin below the inverse of the largest curvature there can be.
    most = float(np.linalg.norm(dictionary, 2)) ** 2 * (1 + 3 * problem.bone_weight)
    step = np.full(weights.shape[1], 1 / max(most, 1e-30), dtype=weights.dtype)
    value, outer = problem.smooth(dictionary @ weights)
    cost = value + problem.penalty * _size(weights)
    slope = dictionary.T @ outer
    checked = float(cost.sum(dtype=np.float64))
    for iteration in range(iterations):
        progress(iteration / iterations)
        threshold = step * problem.penalty
        moved = weights - step * slope
        moved -= np.clip(moved, -threshold, threshold)
        value, outer = problem.smooth(dictionary @ moved)
        new_cost = value + problem.penalty * _size(moved)
        better = new_cost <= cost
        new_slope = dictionary.T @ outer
        change, bend = moved - weights, new_slope - slope
        curve = np.abs(np.einsum("ac,ac->c", change, bend))
        length = np.einsum("ac,ac->c", change, change) / (2 * np.maximum(curve, 1e-30))
        grown = np.minimum(GROW * step, np.maximum(SHRINK * step, length))
        step = np.where(better & (curve > 0), grown, SHRINK * step).astype(step.dtype)
        weights = np.where(better, moved, weights)
        slope = np.where(better, new_slope, slope)
        cost = np.where(better, new_cost, cost)
        if iteration % CHECK_EVERY == CHECK_EVERY - 1:
            total = float(cost.sum(dtype=np.float64))
            if checked - total <= tolerance * checked:
                break
            checked = total
    progress(1.0)
    return weights


def _size(weights: FloatArray) -> FloatArray:
    size: FloatArray = np.abs(weights).sum(axis=0)
    return size
