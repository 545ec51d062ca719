"""Errors of known place and size in a recording."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import BoolArray, FloatArray

RATE = 0.001
"""Share of the samples that are made wrong."""
TRIES = 200
APART = 6
"""Frames between two errors of the same markers."""


@dataclass(frozen=True)
class Injected:
    """An error: samples start to stop - 1 of some markers are wrong.

    `belongs_to` is the marker that a fragment is a piece of.
    """

    markers: tuple[int, ...]
    start: int
    stop: int
    belongs_to: int | None = None

    @property
    def samples(self) -> int:
        """How many samples it makes wrong."""
        return len(self.markers) * (self.stop - self.start)


@dataclass(eq=False)
class Canvas:
    """A recording being corrupted.

    Attributes
    ----------
    source : Recording
        As it was.
    points : ndarray, shape (frames, markers, 3)
        As it becomes; markers may be added at the end.
    missing : ndarray of bool, shape (frames, markers)
        Which samples of the source are missing.
    used : ndarray of bool, shape (frames, markers)
        Where another error would be too close.
    errors : list of Injected
        What was done.
    """

    source: Recording
    points: FloatArray
    missing: BoolArray
    used: BoolArray
    errors: list[Injected] = field(default_factory=list)

    @classmethod
    def of(cls, source: Recording) -> "Canvas":
        """Begin with a recording as it is."""
        missing = ~source.present
        return cls(source, source.points.copy(), missing, np.zeros_like(missing))

    def free(self, marker: int, start: int, stop: int) -> bool:
        """Whether no error is near; gaps do not matter."""
        return start >= 0 and stop <= len(self.used) and not self.used[start:stop, marker].any()

    def seen(self, marker: int, start: int, stop: int) -> bool:
        """Whether all the samples are there and no error is near."""
        return self.free(marker, start, stop) and not self.missing[start:stop, marker].any()

    def held(self, marker: int, start: int, stop: int) -> bool:
        """Whether there are two samples among the four on either side."""
        before = self.missing[max(0, start - 4) : start, marker]
        after = self.missing[stop : stop + 4, marker]
        return bool(min((~before).sum(), (~after).sum()) >= 2)

    def add(self, error: Injected) -> None:
        """Remember an error and keep others away from it."""
        low, high = max(0, error.start - APART), error.stop + APART
        for marker in error.markers:
            self.used[low:high, marker] = True
        self.errors.append(error)

    @cached_property
    def recording(self) -> Recording:
        """The corrupted recording."""
        extra = self.points.shape[1] - self.source.markers
        labels = (*self.source.labels, *(f"*{k}" for k in range(extra)))
        return Recording(
            self.points.copy(), labels, self.source.rate, self.source.unit, self.source.up
        )

    def truth(self) -> BoolArray:
        """Return which samples are there and wrong, shape (frames, markers)."""
        wrong = np.zeros(self.points.shape[:2], dtype=np.bool_)
        for error in self.errors:
            wrong[error.start : error.stop, list(error.markers)] = True
        return wrong & ~np.isnan(self.points[:, :, 0])


Corrupt = Callable[[Canvas, np.random.Generator], bool]
"""Puts one error into a canvas; False where there was no room."""


class Corruptor:
    """Corrupts recordings one after the other, so that the rate holds over all of them.

    Parameters
    ----------
    corrupt : Corrupt
        What is done.
    seed : int
        The same seed makes the same errors.
    """

    def __init__(self, corrupt: Corrupt, seed: int) -> None:
        self._corrupt = corrupt
        self._rng = np.random.default_rng(seed)
        self._owed = 0.0

    def corrupted(self, recording: Recording) -> Canvas:
        """Return a recording with as many errors as the rate owes by now.

        What a recording has no room for is put into the next ones.
        """
        canvas = Canvas.of(recording)
        self._owed += RATE * float(np.count_nonzero(recording.present))
        for _ in range(TRIES):
            if self._owed <= 0:
                break
            if self._corrupt(canvas, self._rng):
                self._owed -= canvas.errors[-1].samples
        return canvas
