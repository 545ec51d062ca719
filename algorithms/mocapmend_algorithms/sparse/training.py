"""Training of a dictionary on masked windows, with bones (W18, section 2.2).

Codes and dictionary are bettered in turn; both lower the one objective of `bone_codes`, so it never
rises. The masks differ from column to column, so W18's Lagrange dual does not apply to the
dictionary: its step is a projected gradient step of the same objective, with atoms of length 1 at
most. An atom that no column uses is replaced by the column that is reconstructed worst: that
changes nothing in the objective.
"""

from dataclasses import dataclass, field

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress, no_progress, part
from mocapmend_algorithms.sparse.bone_codes import Problem, encode_bones

DICTIONARY_STEPS = 5


@dataclass(frozen=True, eq=False)
class Trained:
    """A dictionary in training.

    Attributes
    ----------
    dictionary : ndarray, shape (rows, atoms)
        No atom is longer than 1.
    weights : ndarray, shape (atoms, columns)
        The codes of the training windows.
    objectives : tuple of float
        After each round, the start among them.
    done : bool
        Whether a criterion to stop was met before the rounds ran out.
    """

    dictionary: FloatArray
    weights: FloatArray
    objectives: tuple[float, ...] = field(default=())
    done: bool = False


def begin(problem: Problem, atoms: int) -> Trained:
    """Start with windows as atoms, evenly spread, and empty codes.

    Parameters
    ----------
    problem : Problem
        The training windows.
    atoms : int
        How many; not more than there are windows.
    """
    columns = problem.targets.shape[1]
    chosen = np.linspace(0, columns - 1, min(atoms, columns)).round().astype(np.int64)
    dictionary = _shortened(problem.targets[:, chosen], least=True)
    weights = np.zeros((dictionary.shape[1], columns), dtype=dictionary.dtype)
    return Trained(dictionary, weights, (problem.objective(dictionary, weights),))


def train(
    problem: Problem,
    start: Trained,
    *,
    rounds: int,
    code_steps: int = 20,
    tolerance: float = 1e-3,
    progress: Progress = no_progress,
) -> Trained:
    """Better a dictionary for some rounds, or until a round hardly lowers the objective.

    Parameters
    ----------
    problem : Problem
        The training windows; all arrays of one precision.
    start : Trained
        Where to go on: of `begin`, or of an earlier call.
    rounds : int
        Most rounds.
    code_steps : int
        Most steps of the codes per round.
    tolerance : float
        Stop when a round lowers the objective by less than this share.
    progress : Progress
        Called often; an exception from it ends the training, and `start` is as it was.

    Returns
    -------
    Trained
    """
    now = start
    for done in range(rounds):
        share = part(progress, done / rounds, (done + 1) / rounds)
        weights = encode_bones(
            now.dictionary,
            problem,
            now.weights,
            iterations=code_steps,
            tolerance=tolerance / 10,
            progress=part(share, 0.0, 0.8),
        )
        dictionary = _better(now.dictionary, problem, weights, part(share, 0.8, 1.0))
        objective = problem.objective(dictionary, weights)
        stop = now.objectives[-1] - objective <= tolerance * now.objectives[-1]
        now = Trained(dictionary, weights, (*now.objectives, objective), done=stop)
        if stop:
            break
    progress(1.0)
    return now


def _better(
    dictionary: FloatArray, problem: Problem, weights: FloatArray, progress: Progress
) -> FloatArray:
    """Take projected gradient steps of the dictionary, as long as they lower the objective."""
    step = 1 / (_largest(weights) * (1 + 3 * problem.bone_weight))
    value, outer = problem.smooth(dictionary @ weights)
    cost = float(value.sum(dtype=np.float64))
    for done in range(DICTIONARY_STEPS):
        progress(done / DICTIONARY_STEPS)
        moved = _shortened(dictionary - step * (outer @ weights.T))
        value, after = problem.smooth(moved @ weights)
        new_cost = float(value.sum(dtype=np.float64))
        if new_cost > cost:
            break
        dictionary, outer, cost = moved, after, new_cost
    unused = ~weights.any(axis=1)
    worst = np.argsort(-value, kind="stable")[: np.count_nonzero(unused)]
    if unused.any():
        dictionary = dictionary.copy()
        dictionary[:, np.flatnonzero(unused)[: worst.size]] = _shortened(
            problem.targets[:, worst], least=True
        )
    progress(1.0)
    return dictionary


def _shortened(atoms: FloatArray, *, least: bool = False) -> FloatArray:
    """Shorten atoms to length 1 that are longer; with `least`, lengthen shorter ones too."""
    size = np.sqrt(np.einsum("ra,ra->a", atoms, atoms))
    size = np.where(size > 0, size, 1) if least else np.maximum(size, 1)
    shortened: FloatArray = atoms / size
    return shortened


def _largest(weights: FloatArray) -> float:
    """Bound the largest eigenvalue of the codes' Gram matrix from above."""
    gram = (weights @ weights.T).astype(np.float64)
    return max(float(np.linalg.norm(gram, 2)), 1e-30)
