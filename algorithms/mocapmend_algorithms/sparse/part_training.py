"""Training of the dictionaries of the parts of a skeleton (W18, section 2.2; see `part_codes`)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.sparse.body import Body
from mocapmend_algorithms.sparse.bone_codes import Problem
from mocapmend_algorithms.sparse.bone_space import signed_squares, with_lengths
from mocapmend_algorithms.sparse.part_rows import SPAN, PartDictionary, PartRows
from mocapmend_algorithms.sparse.training import Trained, begin, train

LOST_SHARE = 0.4
"""Of the training windows that are masked."""
COMPONENTS = 20
"""Of the coarse completion."""
MOST_FOR_COMPONENTS = 2000


@dataclass(frozen=True)
class PartSettings:
    """How the parts' dictionaries are trained.

    Attributes
    ----------
    atoms : int
        Of each part, K.
    rounds : int
        Most rounds.
    seed : int
        Of the masks.
    """

    atoms: int = 1000
    rounds: int = 10
    seed: int = 0


def standard_lengths(motions: Sequence[FloatArray], body: Body) -> FloatArray:
    """Return the mean length of each bone of the tree over motions, in mm, shape (edges,)."""
    edges = body.edges
    means = [
        np.linalg.norm(motion[:, edges[:, 0]] - motion[:, edges[:, 1]], axis=2).mean(axis=0)
        for motion in motions
    ]
    lengths: FloatArray = np.mean(means, axis=0)
    return lengths


def train_part(
    motions: Sequence[FloatArray],
    body: Body,
    at: int,
    settings: PartSettings,
    progress: Progress,
    earlier: Trained | None = None,
) -> Trained:
    """Train one part's dictionary on motions with standard lengths.

    Parameters
    ----------
    motions : sequence of ndarray, shape (frames, markers, 3)
        In mm.
    body : Body
        The tree and its parts.
    at : int
        Which part.
    settings : PartSettings
        How.
    progress : Progress
        Called often.
    earlier : Trained, optional
        The state of an earlier call with the same motions and settings, to go on from.

    Returns
    -------
    Trained
        The state, whose dictionary `assemble_part` completes.
    """
    rows, away, scale = _training_rows(motions, body, at)
    seen = _masks(rows, body, away.shape[1], np.random.default_rng(settings.seed))
    problem = rows.problem(away, seen, np.sign(away), scale, np.float32)
    state = earlier or begin(_full(problem, away, scale), settings.atoms)
    return train(problem, state, rounds=settings.rounds, progress=progress)


def assemble_part(
    motions: Sequence[FloatArray], body: Body, at: int, atoms: FloatArray
) -> PartDictionary:
    """Put a part's trained atoms together with what else it needs of the training motions.

    Parameters
    ----------
    motions, body, at
        As they were in `train_part`.
    atoms : ndarray, shape (rows, atoms)
        What that gave.
    """
    rows, away, scale = _training_rows(motions, body, at)
    mean = away.mean(axis=1)
    thinned = away[:, :: max(1, away.shape[1] // MOST_FOR_COMPONENTS)] - mean[:, None]
    left, size, _ = np.linalg.svd(thinned, full_matrices=False)
    kept = left[:, :COMPONENTS] * (size[:COMPONENTS] / np.sqrt(thinned.shape[1]))
    return PartDictionary(rows, atoms.astype(np.float64), scale, mean, kept)


def _training_rows(
    motions: Sequence[FloatArray], body: Body, at: int
) -> tuple[PartRows, FloatArray, float]:
    """Return a part's rows, F1 of all windows with standard lengths, and the scale of F2."""
    standard = standard_lengths(motions, body)
    rows = PartRows.of(body, at, standard)
    columns = [
        rows.differences(with_lengths(motion, body, standard), SPAN.inside(0, len(motion)))
        for motion in motions
        if len(motion) >= SPAN.reach
    ]
    away = np.concatenate(columns, axis=1)
    return rows, away, float(np.mean(away**4)) ** 0.5


def _full(problem: Problem, away: FloatArray, scale: float) -> Problem:
    """Return the same problem with the windows as they are behind the masks, for first atoms."""
    targets = (signed_squares(away) / scale).astype(problem.targets.dtype)
    return replace(problem, targets=targets)


def _masks(rows: PartRows, body: Body, windows: int, random: np.random.Generator) -> BoolArray:
    """Hide 3 or 6 neighbouring markers in 40 % of the windows, as in W18's experiment."""
    seen = np.ones((len(rows.pairs), windows), dtype=np.bool_)
    inside = np.unique(rows.pairs)
    edges = body.edges[np.isin(body.edges, inside).all(axis=1)]
    for column in np.flatnonzero(random.random(windows) < LOST_SHARE).tolist():
        hidden = [int(random.choice(inside))]
        for _ in range(int(random.choice([2, 5]))):
            at = np.isin(edges, hidden)
            beside = np.unique(edges[at.any(axis=1) & ~at.all(axis=1)])
            beside = np.setdiff1d(beside, hidden)
            if beside.size:
                hidden.append(int(random.choice(beside)))
        seen[:, column] = ~np.isin(rows.pairs, hidden).any(axis=1)
    return np.tile(seen, (len(SPAN.offsets), 1))
