"""Sparse codes over atoms that are much alike, by Newton steps.

Each column y of the targets gets the code w over the dictionary D that minimises

    1/2 |y - D w|^2 + penalty * |w|_1.

The poses of a recording are so alike that gradient steps (Beck and Teboulle 2009, FISTA) need
thousands of rounds where the penalty is small. Here it is the semismooth Newton augmented
Lagrangian method (Li, Sun and Toh 2018, SIAM Journal on Optimization 28(1):433-458): the residual r
is the point nearest to y with |D^T r| <= penalty everywhere, w are the multipliers of these bounds,
and each Newton step solves a system no larger than the rows of D or the atoms in use, whichever are
fewer. All columns step together. A column is done when its duality gap says that it is as near to
its minimum as was asked.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.progress import Progress, no_progress, part

COLUMNS = 64
"""At a time: so that little memory is needed."""
SMALLEST = 1e-8
"""Share of the squared size of a dictionary in directions that are left out."""
FIRST_STIFFNESS, GROWTH = 1e4, 5.0
MOST_ROUNDS, MOST_STEPS, MOST_HALVINGS = 25, 60, 25
EXACTNESS = 1e-2
"""Share of a target at which the first round's residual is near enough; each halves it."""
DOWNHILL = 1e-4
ROUNDING = 1e-14
TINY = float(np.finfo(np.float64).tiny)


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


@dataclass(frozen=True, eq=False)
class Coder:
    """A dictionary, turned so that it has no more rows than directions.

    Attributes
    ----------
    atoms : ndarray, shape (directions, atoms)
        The turned dictionary.
    turn : ndarray, shape (directions, rows)
        What turns a target alike.
    """

    atoms: FloatArray
    turn: FloatArray

    @classmethod
    def of(cls, dictionary: FloatArray) -> "Coder":
        """Prepare a dictionary, shape (rows, atoms); atoms of about unit length do best."""
        turn, size, atoms = np.linalg.svd(dictionary, full_matrices=False)
        left = np.cumsum(size[::-1] ** 2)[::-1]
        kept = left > SMALLEST * left.max(initial=0.0)
        return cls(size[kept, None] * atoms[kept], np.ascontiguousarray(turn[:, kept].T))

    def encode(
        self,
        targets: FloatArray,
        penalty: float,
        *,
        tolerance: float = 1e-3,
        progress: Progress = no_progress,
    ) -> Codes:
        """Find the sparse codes of many columns.

        Parameters
        ----------
        targets : ndarray, shape (rows, columns)
            What is to be coded, of about unit length.
        penalty : float
            Above 0: the larger, the fewer atoms are used.
        tolerance : float
            Duality gap, relative to the minimum itself, at which a column is done.
        progress : Progress
            Called every few steps.

        Returns
        -------
        Codes
            Columns that were not done in time are as good as they got; their `gap` says so.

        Raises
        ------
        ValueError
            If the penalty is not above 0.
        """
        if not penalty > 0:
            raise ValueError(f"the penalty must be above 0, not {penalty}")
        turned = self.turn @ targets
        columns = targets.shape[1]
        weights, gap, steps = np.zeros((self.atoms.shape[1], columns)), np.zeros(columns), 0
        for first in range(0, columns, COLUMNS):
            batch = slice(first, min(first + COLUMNS, columns))
            share = part(progress, batch.start / columns, batch.stop / columns)
            weights[:, batch], gap[batch], taken = _solve(
                self.atoms, turned[:, batch], penalty, tolerance, share
            )
            steps += taken
        progress(1.0)
        energy = np.einsum("rc,rc->c", targets, targets)
        return Codes(weights, gap / np.maximum(energy / 2, TINY), steps)


def _solve(
    atoms: FloatArray, targets: FloatArray, penalty: float, tolerance: float, progress: Progress
) -> tuple[FloatArray, FloatArray, int]:
    """Return weights, by how much each column may exceed its minimum, and the steps taken."""
    columns = targets.shape[1]
    best = np.zeros((atoms.shape[1], columns))
    least, floor = np.sum(targets**2, axis=0) / 2, np.zeros(columns)
    weights, residual = best.copy(), np.zeros_like(targets)
    stiffness, steps = np.full(columns, FIRST_STIFFNESS), 0
    todo = np.flatnonzero(least > 0)
    for done in range(MOST_ROUNDS):
        if not todo.size:
            break
        progress(done / MOST_ROUNDS)
        near = EXACTNESS * 0.5**done * np.sqrt(2 * least[todo])
        inner = _Inner(atoms, targets[:, todo], weights[:, todo], stiffness[todo], penalty)
        residual[:, todo], found, converged = inner.solve(residual[:, todo], near)
        steps += inner.steps
        value, dual = _bounds(atoms, targets[:, todo], found, penalty)
        better = value < least[todo]
        best[:, todo[better]], least[todo[better]] = found[:, better], value[better]
        floor[todo] = np.maximum(floor[todo], dual)
        weights[:, todo[converged]] = found[:, converged]
        stiffness[todo] *= np.where(converged, GROWTH, 1 / GROWTH)
        todo = todo[least[todo] - floor[todo] > tolerance * least[todo]]
    return best, np.maximum(least - floor, 0.0), steps


def _bounds(
    atoms: FloatArray, targets: FloatArray, weights: FloatArray, penalty: float
) -> tuple[FloatArray, FloatArray]:
    """Return the value of weights, and what no weights can go below."""
    left = targets - atoms @ weights
    value = np.sum(left**2, axis=0) / 2 + penalty * np.abs(weights).sum(axis=0)
    steepest = np.abs(atoms.T @ left).max(axis=0, initial=0.0)
    left *= np.minimum(penalty / np.maximum(steepest, TINY), 1.0)
    return value, np.sum(left * (targets - left / 2), axis=0)


class _Inner:
    """Finds residuals that keep their bounds softly: each round's task."""

    def __init__(
        self,
        atoms: FloatArray,
        targets: FloatArray,
        weights: FloatArray,
        stiffness: FloatArray,
        penalty: float,
    ) -> None:
        self.atoms, self.targets, self.weights = atoms, targets, weights
        self.stiffness, self.threshold = stiffness, stiffness * penalty
        self.steps = 0

    def solve(
        self, residual: FloatArray, near: FloatArray
    ) -> tuple[FloatArray, FloatArray, BoolArray]:
        """Return residuals, the weights that go with them, and which columns are near enough."""
        residual = residual.copy()
        pull = self.weights + self.stiffness * (self.atoms.T @ residual)
        todo = np.arange(residual.shape[1])
        for _ in range(MOST_STEPS):
            at, within = pull[:, todo], self.threshold[todo]
            weights = at - np.clip(at, -within, within)
            slope = residual[:, todo] - self.targets[:, todo] + self.atoms @ weights
            unfinished = np.linalg.norm(slope, axis=0) > near[todo]
            todo = todo[unfinished]
            if not todo.size:
                break
            slope, used = slope[:, unfinished], weights[:, unfinished] != 0
            step = self._newton(slope, used, self.stiffness[todo])
            along = self.stiffness[todo] * (self.atoms.T @ step)
            length = self._length(todo, residual[:, todo], pull[:, todo], slope, step, along)
            residual[:, todo] += length * step
            pull[:, todo] += length * along
            self.steps += 1
        converged = np.ones(residual.shape[1], dtype=np.bool_)
        converged[todo] = False
        return residual, pull - np.clip(pull, -self.threshold, self.threshold), converged

    def _newton(self, slope: FloatArray, used: BoolArray, stiffness: FloatArray) -> FloatArray:
        """Solve (1 + stiffness * sum of a a^T over the atoms a in use) step = -slope."""
        rows, most = slope.shape[0], int(used.sum(axis=0).max())
        chosen = np.argsort(~used, axis=0, kind="stable")[:most].T
        inside = np.take_along_axis(used.T, chosen, axis=1)
        few = self.atoms.T[chosen] * inside[..., None]
        if most >= rows:
            normal = (few * stiffness[:, None, None]).swapaxes(1, 2) @ few + np.eye(rows)
            whole = np.linalg.solve(normal, -slope.T[..., None])[..., 0].T
            return np.asarray(whole, dtype=np.float64)
        # With fewer atoms than rows, the smaller system of the Woodbury identity.
        system = few @ few.swapaxes(1, 2) + np.eye(most) / stiffness[:, None, None]
        share = np.linalg.solve(system, few @ slope.T[..., None])
        across: FloatArray = (few.swapaxes(1, 2) @ share)[..., 0].T - slope
        return across

    def _length(
        self,
        todo: IntArray,
        residual: FloatArray,
        pull: FloatArray,
        slope: FloatArray,
        step: FloatArray,
        along: FloatArray,
    ) -> FloatArray:
        """Halve steps until they lead downhill (Armijo)."""
        targets, within = self.targets[:, todo], self.threshold[todo]
        soft = 2 * self.stiffness[todo]

        def height(length: FloatArray) -> FloatArray:
            there = pull + length * along
            over = there - np.clip(there, -within, within)
            away = residual + length * step - targets
            total: FloatArray = np.sum(away**2, axis=0) / 2 + np.sum(over**2, axis=0) / soft
            return total

        length = np.ones(todo.size)
        start, fall = height(0 * length), np.sum(slope * step, axis=0)
        for _ in range(MOST_HALVINGS):
            short = height(length) > start * (1 + ROUNDING) + DOWNHILL * length * fall
            if not short.any():
                break
            length[short] /= 2
        return length
