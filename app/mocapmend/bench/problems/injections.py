"""The errors that are put into recordings; each maker returns what puts one in."""

import numpy as np

from mocapmend.bench.problems.corruption import Canvas, Corrupt, Injected
from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray

NEAREST = 3
"""So many neighbours a marker is swapped with."""


def spike(least_mm: float, most_mm: float, shortest: int, longest: int) -> Corrupt:
    """Make spikes: an offset of a random size and direction, which shakes by a tenth.

    There are two samples among the four on either side: at the ends of gaps it would be a tail.
    """

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        marker, start = _place(canvas, rng, length)
        stop = start + length
        if not (canvas.seen(marker, start, stop) and canvas.held(marker, start, stop)):
            return False
        offset = _vector(canvas, rng, least_mm, most_mm)
        shake = 0.1 * np.linalg.norm(offset) / np.sqrt(3) * rng.normal(size=(length, 3))
        canvas.points[start:stop, marker] += offset + (shake if length > 1 else 0.0)
        canvas.add(Injected((marker,), start, stop))
        return True

    return corrupt


def swap(least_mm: float, most_mm: float, longest: int, *, hidden: bool = False) -> Corrupt:
    """Exchange a marker with one of its three nearest, for 1 to so many frames, gaps and all.

    It lasts for at most a third of the frames in which either is seen: where it was most of the
    time, nobody could tell which labels are right. Where it is to be hidden, both are missing for
    3 to 30 frames at one end or at both.
    """

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = round(float(np.exp(rng.uniform(0.0, np.log(longest)))))
        first, start = _place(canvas, rng, length)
        stop = start + length
        away = _distances(canvas.source, first, start, stop)
        near = [k for k in np.argsort(away)[:NEAREST].tolist() if least_mm <= away[k] < most_mm]
        if not near or not length:
            return False
        second = int(rng.choice(near))
        pair = [first, second]
        if length > (~canvas.missing[:, pair]).sum(axis=0).min() // 3:
            return False
        if not all(canvas.free(marker, start, stop) for marker in pair):
            return False
        canvas.points[start:stop, pair] = canvas.points[start:stop, pair[::-1]]
        if hidden:
            for edge in rng.permutation([start, stop])[: rng.integers(1, 3)].tolist():
                low, high = edge - int(rng.integers(1, 16)), edge + int(rng.integers(2, 16))
                canvas.points[max(0, low) : high, pair] = np.nan
        error = Injected((first, second), start, stop)
        if np.isnan(canvas.points[start:stop, pair]).all():
            return False
        canvas.add(error)
        return True

    return corrupt


def fragment(shortest: int, longest: int) -> Corrupt:
    """Cut a piece out of a trajectory and store it as a point without a label."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        marker, start = _place(canvas, rng, length)
        stop = start + length
        if not canvas.seen(marker, start, stop) or stop > canvas.source.frames:
            return False
        piece = np.full((canvas.source.frames, 1, 3), np.nan)
        piece[start:stop, 0] = canvas.points[start:stop, marker]
        canvas.points[start:stop, marker] = np.nan
        canvas.points = np.concatenate((canvas.points, piece), axis=1)
        new = canvas.points.shape[1] - 1
        canvas.used = np.concatenate((canvas.used, np.ones_like(canvas.used[:, :1])), axis=1)
        canvas.add(Injected((new,), start, stop, belongs_to=marker))
        canvas.used[max(0, start - 6) : stop + 6, marker] = True
        return True

    return corrupt


def freeze(least_mm: float, shortest: int, longest: int) -> Corrupt:
    """Hold the coordinates while the marker goes on by a distance."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        marker, start = _place(canvas, rng, length)
        stop = start + length
        if start < 1 or stop >= canvas.source.frames:
            return False
        if not canvas.seen(marker, start - 1, stop + 1):
            return False
        held = canvas.points[start - 1, marker]
        gone = np.linalg.norm(canvas.source.points[stop, marker] - held) * canvas.source.mm
        if gone < least_mm:
            return False
        canvas.points[start:stop, marker] = held
        canvas.add(Injected((marker,), start, stop))
        return True

    return corrupt


def ragged(least_mm: float, most_mm: float) -> Corrupt:
    """Bend a trajectory away in the last 2 to 5 frames beside a new gap of 10 to 60."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        gap, length = int(rng.integers(10, 61)), int(rng.integers(2, 6))
        marker, start = _place(canvas, rng, gap)
        stop = start + gap
        if start < 30 or stop > canvas.source.frames - 30:
            return False
        if not canvas.seen(marker, start - 30, stop + 30):
            return False
        canvas.points[start:stop, marker] = np.nan
        bend = np.arange(1, length + 1)[:, None] / length * _vector(canvas, rng, least_mm, most_mm)
        after = bool(rng.integers(2))
        first = stop if after else start - length
        canvas.points[first : first + length, marker] += bend[::-1] if after else bend
        canvas.add(Injected((marker,), first, first + length))
        return True

    return corrupt


def shift(least_mm: float, most_mm: float, shortest: int, longest: int) -> Corrupt:
    """Move a marker by a constant offset for some frames."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        marker, start = _place(canvas, rng, length)
        stop = start + length
        if not canvas.seen(marker, start, stop) or stop > canvas.source.frames:
            return False
        canvas.points[start:stop, marker] += _vector(canvas, rng, least_mm, most_mm)
        canvas.add(Injected((marker,), start, stop))
        return True

    return corrupt


def coincide(within_mm: float, shortest: int, longest: int) -> Corrupt:
    """Put a marker in the place of one of its nearest for some frames."""

    def corrupt(canvas: Canvas, rng: np.random.Generator) -> bool:
        length = int(rng.integers(shortest, longest + 1))
        marker, start = _place(canvas, rng, length)
        stop = start + length
        away = _distances(canvas.source, marker, start, stop)
        other = int(rng.choice(np.argsort(away)[:NEAREST]))
        if stop > canvas.source.frames or not 50 <= away[other] < np.inf:
            return False
        if not (canvas.seen(marker, start, stop) and canvas.seen(other, start, stop)):
            return False
        near = within_mm / np.sqrt(3) / 2 / canvas.source.mm * rng.uniform(-1, 1, (length, 3))
        canvas.points[start:stop, marker] = canvas.points[start:stop, other] + near
        canvas.add(Injected((marker,), start, stop))
        return True

    return corrupt


def _place(canvas: Canvas, rng: np.random.Generator, length: int) -> tuple[int, int]:
    marker = int(rng.integers(canvas.source.markers))
    return marker, int(rng.integers(0, max(1, canvas.source.frames - length + 1)))


def _vector(
    canvas: Canvas, rng: np.random.Generator, least_mm: float, most_mm: float
) -> FloatArray:
    """Return an offset in any direction, its length spread evenly in the logarithm."""
    size = float(np.exp(rng.uniform(np.log(least_mm), np.log(most_mm)))) / canvas.source.mm
    direction = rng.normal(size=3)
    offset: FloatArray = size * direction / np.linalg.norm(direction)
    return offset


def _distances(recording: Recording, marker: int, start: int, stop: int) -> FloatArray:
    """Return the smallest distance of each other marker over some frames in mm."""
    points = recording.points[start:stop]
    apart = np.linalg.norm(points - points[:, [marker]], axis=2) * recording.mm
    away: FloatArray = np.min(np.where(np.isnan(apart), np.inf, apart), axis=0, initial=np.inf)
    away[marker] = np.inf
    return away
