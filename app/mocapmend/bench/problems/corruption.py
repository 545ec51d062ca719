"""Errors of known place and size in a recording."""

from collections.abc import Callable
from dataclasses import dataclass, field

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
    """An error: samples start to stop - 1 of some markers are wrong."""

    markers: tuple[int, ...]
    start: int
    stop: int

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
        Of the source.
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

    @property
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


def spike(least_mm: float, most_mm: float, shortest: int, longest: int) -> Corrupt:
    """Make spikes: an offset of a random size and direction, which shakes by a tenth."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        size = float(np.exp(rng.uniform(np.log(least_mm), np.log(most_mm)))) / canvas.source.mm
        direction = rng.normal(size=3)
        direction /= np.linalg.norm(direction)
        marker, start = _place(canvas, rng, length)
        stop = start + length
        if not (canvas.seen(marker, start, stop) and canvas.held(marker, start, stop)):
            return False
        shake = 0.1 * size / np.sqrt(3) * rng.normal(size=(length, 3)) if length > 1 else 0.0
        canvas.points[start:stop, marker] += size * direction + shake
        canvas.add(Injected((marker,), start, stop))
        return True

    return corrupt


def swap(least_mm: float, most_mm: float, longest: int) -> Corrupt:
    """Exchange a marker with one of its three nearest, for 1 to so many frames, gaps and all."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = round(float(np.exp(rng.uniform(0.0, np.log(longest)))))
        length = min(length, canvas.source.frames // 3)
        first, start = _place(canvas, rng, length)
        stop = start + length
        away = _distances(canvas.source, first, start, stop)
        near = [k for k in np.argsort(away)[:3].tolist() if least_mm <= away[k] < most_mm]
        if not near or not length:
            return False
        second = int(rng.choice(near))
        if not (canvas.free(first, start, stop) and canvas.free(second, start, stop)):
            return False
        canvas.points[start:stop, [first, second]] = canvas.points[start:stop, [second, first]]
        canvas.add(Injected((first, second), start, stop))
        return True

    return corrupt


def _distances(recording: Recording, marker: int, start: int, stop: int) -> FloatArray:
    """Return the smallest distance of each other marker over some frames in mm."""
    points = recording.points[start:stop]
    apart = np.linalg.norm(points - points[:, [marker]], axis=2) * recording.mm
    away = np.min(np.where(np.isnan(apart), np.inf, apart), axis=0, initial=np.inf)
    away[marker] = np.inf
    return away


def _place(canvas: Canvas, rng: np.random.Generator, length: int) -> tuple[int, int]:
    marker = int(rng.integers(canvas.source.markers))
    return marker, int(rng.integers(0, max(1, canvas.source.frames - length + 1)))


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
        """Return a recording with as many errors as the rate owes by now."""
        canvas = Canvas.of(recording)
        self._owed += RATE * float(np.count_nonzero(recording.present))
        for _ in range(TRIES):
            if self._owed <= 0:
                break
            if self._corrupt(canvas, self._rng):
                self._owed -= canvas.errors[-1].samples
        return canvas
