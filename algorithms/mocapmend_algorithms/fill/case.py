"""One gap, and all that a donor method looks at to fill it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mocapmend_algorithms.alignment import Alignment, align, mean_shape, standing
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.donors import Distances, Donors, NoDonorsError
from mocapmend_algorithms.fill.lessons import Lesson, Size, plan
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.recording import Recording

LEAST_TOGETHER = 0.5
KEPT_SHARE = 0.9
NEARNESS = 0.02
SHAPE_FRAMES = 600


@dataclass(frozen=True, eq=False)
class Case:
    """What there is to learn from, and where values are wanted. Lengths are in mm.

    Attributes
    ----------
    gap : Gap
        To be filled.
    rate : float
        Frames per second (Hz).
    up : ndarray, shape (3,)
        The direction that is up.
    lesson : Lesson
        Frames to learn from, and trials.
    frames : ndarray of int, shape (samples + length,)
        The lesson's and the gap's.
    donors : Donors
        Seen at all of these frames.
    target : ndarray, shape (samples, 3)
        The marker.
    points : ndarray, shape (frames, markers, 3)
        The recording.
    """

    gap: Gap
    rate: float
    up: FloatArray
    lesson: Lesson
    frames: IntArray
    donors: Donors
    target: FloatArray
    points: FloatArray

    @property
    def samples(self) -> int:
        """Number of frames to learn from."""
        return int(self.lesson.frames.size)

    def at(self, donors: IntArray, shift: int = 0) -> FloatArray:
        """Return some of the donors at the frames, or some frames away from them, in mm."""
        frames = np.clip(self.frames + shift, 0, self.points.shape[0] - 1)
        chosen: FloatArray = self.points[frames[:, None], self.donors.markers[donors]]
        return chosen

    def elapsed(self, step: int) -> FloatArray:
        """Return how many frames `at` has between `-step` and `step`, shape (frames,)."""
        last = self.points.shape[0] - 1
        frames = np.minimum(self.frames + step, last) - np.maximum(self.frames - step, 0)
        elapsed: FloatArray = np.maximum(frames, 1).astype(np.float64)
        return elapsed

    def aligned(self, donors: IntArray, weights: FloatArray) -> Alignment:
        """Return the motion of some of the donors at the frames."""
        if not donors.size:
            return standing(self.frames.size)
        points = self.at(donors)
        return align(points, mean_shape(points[: self.samples], weights), weights)


class Survey:
    """A recording as its gaps share it.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        Samples inside them are never looked at.
    """

    def __init__(self, recording: Recording, gaps: Sequence[Gap]) -> None:
        self.recording = recording
        self.observed: BoolArray = recording.present.copy()
        for gap in gaps:
            self.observed[gap.start : gap.stop, gap.marker] = False

    @cached_property
    def points(self) -> FloatArray:
        """The samples in mm, NaN where they may not be looked at."""
        points = np.where(self.observed[:, :, None], self.recording.points, np.nan)
        points *= self.recording.mm
        return points

    @cached_property
    def distances(self) -> Distances:
        """How the markers move with each other."""
        return Distances(self.points, self.observed)

    def case(self, gap: Gap, donors: Donors, size: Size) -> Case:
        """Collect what a fill of a gap looks at.

        Raises
        ------
        NoDonorsError
            If there are too few frames in which the marker and its donors are seen.
        """
        usable = self.observed[:, gap.marker] & self.observed[:, donors.markers].all(axis=1)
        lesson = plan(usable, gap, size)
        if lesson.frames.size < 2:
            raise NoDonorsError("the marker and its donors are hardly ever seen together")
        frames = np.concatenate((lesson.frames, np.arange(gap.start, gap.stop)))
        return Case(
            gap=gap,
            rate=self.recording.rate,
            up=_direction(self.recording.up),
            lesson=lesson,
            frames=frames,
            donors=donors,
            target=self.points[lesson.frames, gap.marker],
            points=self.points,
        )

    def candidates(self, gap: Gap) -> Donors:
        """Return the markers that are seen throughout a gap and often with its marker."""
        known = self.distances.to(gap.marker)
        seen = np.logical_and.reduce(self.observed[gap.start : gap.stop, known.markers])
        return known[seen]

    def together(self, gap: Gap, donors: Donors, most: int) -> Donors:
        """Leave out donors without which there are many more frames to learn from.

        Parameters
        ----------
        gap : Gap
            To be filled.
        donors : Donors
            Candidates.
        most : int
            So many frames are enough.
        """
        usable = self.observed[:, gap.marker]
        least = LEAST_TOGETHER * np.count_nonzero(usable)
        kept = []
        for place in donors.best(len(donors), NEARNESS).tolist():
            both = usable & self.observed[:, donors.markers[place]]
            count = np.count_nonzero(both)
            if count >= min(most, KEPT_SHARE * np.count_nonzero(usable)) and count >= least:
                usable = both
                kept.append(place)
        return donors[np.array(kept, dtype=np.int64)]


def _direction(up: str) -> FloatArray:
    direction = np.zeros(3)
    direction["xyz".index(up[1])] = 1.0 if up[0] == "+" else -1.0
    return direction
