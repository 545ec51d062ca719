"""A labelled recording made into what a system without labels delivers, with the truth kept."""

from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.names import without_subject

OCCLUSIONS_PER_SECOND = 0.25
"""Of each marker."""
MEDIAN_OCCLUSION = 0.15
LENGTH_SPREAD = 1.0
"""Of the logarithm of an occlusion's seconds."""
TOGETHER = 0.2
"""Share of the occlusions that take some neighbours of the marker along."""
NEIGHBOURS = 3
HIDDEN_WHOLE = 0.5
"""Share of the recordings in which a marker is never seen."""
SAME_POINT = 0.4
"""Share of the pieces that are stored in a point that held another marker before."""
APART_SECONDS = 0.1
"""Between two markers in the same point."""
GHOSTS_PER_SECOND = 0.5
GHOST_SECONDS = 0.4
NEAR_MM = (30.0, 200.0)
"""How far a reflection is from the marker that it goes with."""
STATIC_GHOSTS = 2
GHOST = -2
NOTHING = -1


@dataclass(frozen=True, eq=False)
class Scrambled:
    """A recording without labels.

    Attributes
    ----------
    recording : Recording
        The points, called *0, *1, ...
    truth : ndarray of int, shape (frames, points)
        Index of each sample's marker in `labels`; -1 where nothing is seen, -2 for ghosts.
    labels : tuple of str
        Of the original recording, without the subject.
    """

    recording: Recording
    truth: IntArray
    labels: tuple[str, ...]

    @property
    def pieces(self) -> int:
        """How many unbroken stretches of one marker or ghost there are."""
        return sum(
            1 + int(np.count_nonzero(np.diff(self.truth[a:b, point])))
            for point in range(self.truth.shape[1])
            for a, b in runs(self.truth[:, point] != NOTHING)
        )


def scramble(
    recording: Recording, seed: int, *, ghosts: bool = True, keep: float = 0.0
) -> Scrambled:
    """Take the labels of a recording away, break its trajectories and add ghosts.

    Parameters
    ----------
    recording : Recording
        Labelled.
    seed : int
        Of everything that is random.
    ghosts : bool
        Whether there are points that are no marker.
    keep : float
        Share of the markers that keep their label, and all that is seen of them in one point.

    Returns
    -------
    Scrambled
        Turned about the vertical and moved as well.
    """
    rng = np.random.default_rng(seed)
    points = _moved(recording, rng)
    kept = rng.random(recording.markers) < keep
    hidden = _occlusions(points * recording.mm, recording.rate, rng)
    if rng.random() < HIDDEN_WHOLE:
        hidden[:, rng.choice(np.flatnonzero(~kept))] = True
    seen = ~hidden & ~np.isnan(points[:, :, 0])
    stretches = [
        (marker, start, stop)
        for marker in range(recording.markers)
        for start, stop in runs(seen[:, marker])
    ]
    whole = np.flatnonzero(kept).tolist()
    columns = [[stretch for stretch in stretches if stretch[0] == marker] for marker in whole]
    names = [recording.labels[marker] for marker in whole]
    stretches = [stretch for stretch in stretches if not kept[stretch[0]]]
    columns += _stored(stretches, round(APART_SECONDS * recording.rate), rng)
    truth = np.full((recording.frames, len(columns)), NOTHING, np.int64)
    stored = np.full((recording.frames, len(columns), 3), np.nan)
    for column, content in enumerate(columns):
        for marker, start, stop in content:
            truth[start:stop, column] = marker
            stored[start:stop, column] = points[start:stop, marker]
    if ghosts:
        extra = _ghosts(points, recording, rng)
        stored = np.concatenate([stored, extra], axis=1)
        more = np.where(np.isnan(extra[:, :, 0]), NOTHING, GHOST)
        truth = np.concatenate([truth, more], axis=1)
    order = rng.permutation(stored.shape[1])
    labels = [*names, *(f"*{k}" for k in range(stored.shape[1] - len(names)))]
    made = replace(recording, points=stored[:, order], labels=tuple(labels[k] for k in order))
    return Scrambled(made, truth[:, order], tuple(map(without_subject, recording.labels)))


def _moved(recording: Recording, rng: np.random.Generator) -> FloatArray:
    """Turn a recording about its vertical axis and shift it on the floor."""
    up = "xyz".index(recording.up[1])
    flat = [axis for axis in range(3) if axis != up]
    angle = rng.uniform(0.0, 2 * np.pi)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    moved: FloatArray = recording.points.copy()
    moved[:, :, flat] = moved[:, :, flat] @ turn.T + rng.normal(0.0, 2000.0, 2) / recording.mm
    return moved


def _occlusions(points: FloatArray, rate: float, rng: np.random.Generator) -> BoolArray:
    """Choose when markers are not seen; `points` in mm."""
    frames, markers = points.shape[:2]
    hidden = np.zeros((frames, markers), np.bool_)
    for marker in range(markers):
        for start in rng.integers(frames, size=rng.poisson(OCCLUSIONS_PER_SECOND * frames / rate)):
            seconds = MEDIAN_OCCLUSION * np.exp(LENGTH_SPREAD * rng.standard_normal())
            stop = start + max(1, round(seconds * rate))
            taken = [marker]
            if rng.random() < TOGETHER:
                away = np.linalg.norm(points[start] - points[start, marker], axis=1)
                taken = np.argsort(away)[: 1 + rng.integers(1, NEIGHBOURS + 1)].tolist()
            hidden[start:stop, taken] = True
    return hidden


def _stored(
    stretches: list[tuple[int, int, int]], apart: int, rng: np.random.Generator
) -> list[list[tuple[int, int, int]]]:
    """Give each stretch a point, some of them one that is free again."""
    columns: list[list[tuple[int, int, int]]] = []
    for stretch in sorted(stretches, key=lambda each: each[1]):
        free = [column for column in columns if column[-1][2] + apart <= stretch[1]]
        if free and rng.random() < SAME_POINT:
            free[rng.integers(len(free))].append(stretch)
        else:
            columns.append([stretch])
    return columns


def _ghosts(points: FloatArray, recording: Recording, rng: np.random.Generator) -> FloatArray:
    """Make points that are no marker: reflections beside markers, and lamps that stand still."""
    frames, markers = points.shape[:2]
    made = []
    for _ in range(rng.poisson(GHOSTS_PER_SECOND * frames / recording.rate)):
        start = int(rng.integers(frames))
        stop = start + max(1, round(GHOST_SECONDS * recording.rate * rng.exponential()))
        aside = rng.standard_normal(3)
        aside *= rng.uniform(*NEAR_MM) / recording.mm / np.linalg.norm(aside)
        ghost = np.full((frames, 3), np.nan)
        ghost[start:stop] = points[start:stop, rng.integers(markers)] + aside
        made.append(ghost)
    low, high = np.nanmin(points, axis=(0, 1)), np.nanmax(points, axis=(0, 1))
    for _ in range(STATIC_GHOSTS):
        ghost = np.full((frames, 3), np.nan)
        start, stop = sorted(rng.integers(0, frames + 1, 2).tolist())
        ghost[start:stop] = rng.uniform(low, high)
        made.append(ghost)
    return np.stack(made, axis=1)
