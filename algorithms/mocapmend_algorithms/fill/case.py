"""One gap, and all that a donor method looks at to fill it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mocapmend_algorithms.alignment import Alignment, align, mean_shape
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.completion import Completion
from mocapmend_algorithms.fill.donors import Donors
from mocapmend_algorithms.fill.gaussian import Times
from mocapmend_algorithms.fill.lessons import Lesson
from mocapmend_algorithms.gaps import Gap


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
    seen : ndarray of bool, shape (frames of the recording,)
        Where the marker is seen.
    track : ndarray, shape (frames of the recording, 3)
        The marker's trajectory, NaN where it is not seen.
    completion : Completion
        Tells the samples of the donors.
    """

    gap: Gap
    rate: float
    up: FloatArray
    lesson: Lesson
    frames: IntArray
    donors: Donors
    target: FloatArray
    seen: BoolArray
    track: FloatArray
    completion: Completion

    @property
    def samples(self) -> int:
        """Number of frames to learn from."""
        return int(self.lesson.frames.size)

    @cached_property
    def times(self) -> Times:
        """The frames as a regression sees them; each trial is left out as a whole."""
        return Times(
            self.lesson.frames,
            self.frames[self.samples :],
            self.rate,
            [trial.hidden for trial in self.lesson.trials],
        )

    def at(self, donors: IntArray, shift: int = 0) -> FloatArray:
        """Return some of the donors at the frames, or some frames away from them, in mm."""
        if not shift:
            return self._here.take(donors, axis=1)
        frames = np.clip(self.frames + shift, 0, self.seen.size - 1)
        return self.completion.at(frames, self.donors.markers[donors])

    @cached_property
    def _here(self) -> FloatArray:
        """All donors at the frames: every view looks at them again."""
        return self.completion.at(self.frames, self.donors.markers)

    def elapsed(self, step: int) -> FloatArray:
        """Return how many frames `at` has between `-step` and `step`, shape (frames,)."""
        last = self.seen.size - 1
        frames = np.minimum(self.frames + step, last) - np.maximum(self.frames - step, 0)
        elapsed: FloatArray = np.maximum(frames, 1).astype(np.float64)
        return elapsed

    def moved(self, donors: IntArray) -> Alignment:
        """Return how the mean of some of the donors moves at the frames, without any turn."""
        mean = self.at(donors).mean(axis=1, keepdims=True)
        return align(mean, mean[0], np.ones(1))

    def aligned(self, donors: IntArray, weights: FloatArray) -> Alignment:
        """Return the motion of some of the donors at the frames."""
        points = self.at(donors)
        return align(points, mean_shape(points[: self.samples], weights), weights)
