"""What a gap is filled from: the frames around it, in the world or in its neighbours' frame.

The first marker of an excerpt is the one with the gap; where that is seen too little to test a
method on it, a few others follow. In the neighbours' frame their common rigid motion is
taken out ("first analyse the distribution of the markers that are present to exclude non-linear
motion", L21) and put back afterwards.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.alignment import Alignment, align, mean_shape
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.donors import Seen
from mocapmend_algorithms.fill.neighbours import Neighbourhood
from mocapmend_algorithms.gaps import Gap, runs
from mocapmend_algorithms.recording import Recording

FRAMES = 1000
LENGTHS = 6
STAND_INS = 8
ENOUGH_PLACES = 12
SHAPE_FRAMES = 60
LEAST_SPREAD = 0.2


@dataclass(frozen=True, eq=False)
class Excerpt:
    """A gap and what it is filled from.

    Attributes
    ----------
    recording : Recording
        The marker with the gap, then any stand-ins.
    gap : Gap
        In that recording.
    alignment : Alignment or None
        Of the missing frames, where the excerpt is not in the world.
    """

    recording: Recording
    gap: Gap
    alignment: Alignment | None

    def without(self, frames: IntArray) -> "Excerpt":
        """Return the same without the marker's samples in these frames."""
        points = self.recording.points.copy()
        points[frames, 0] = np.nan
        return replace(self, recording=self.recording.with_points(points))

    def to_world(self, values: FloatArray) -> FloatArray:
        """Put the filled samples, shape (length, 3), back into the world."""
        return values if self.alignment is None else self.alignment.to_world(values)


def excerpt_frames(gap: Gap, knots: IntArray, frames: int) -> slice:
    """Choose the frames around a gap.

    Parameters
    ----------
    gap : Gap
        The gap.
    knots : ndarray of int
        Frames of the samples beside it, ascending; where one side has none, the frames reach to
        that end of the recording, so that this can be told.
    frames : int
        Of the recording.

    Returns
    -------
    slice
        At least 1000 frames and six times the gap on each side, as far as there are any.
    """
    around = FRAMES + LENGTHS * gap.length
    start = min(gap.start - around, int(knots[0])) if (knots < gap.start).any() else 0
    stop = max(gap.stop + around, int(knots[-1]) + 1) if (knots >= gap.stop).any() else frames
    return slice(max(start, 0), min(stop, frames))


def cut(
    recording: Recording,
    seen: Seen,
    gap: Gap,
    frames: slice,
    span: int,
    near: Callable[[], Neighbourhood],
    donors: Sequence[int] = (),
) -> Excerpt:
    """Cut an excerpt.

    Parameters
    ----------
    recording : Recording
        Not changed.
    seen : callable
        The samples of a marker that may be used.
    gap : Gap
        The gap.
    frames : slice
        See `excerpt_frames`.
    span : int
        How many frames a window covers.
    near : callable
        Measures the distances from the gap's marker, where they are needed.
    donors : sequence of int, optional
        Seen together in the missing frames; the excerpt is in their frame. Without them it is in
        the world.

    Returns
    -------
    Excerpt
    """
    markers = [gap.marker]
    if _places(seen(gap.marker)[frames], span) < ENOUGH_PLACES:
        markers += _stand_ins(near(), gap.marker, donors)
    points = _seen_points(recording, seen, frames, markers)
    missing = slice(gap.start - frames.start, gap.stop - frames.start)
    alignment = None
    if donors:
        group = _seen_points(recording, seen, frames, donors)
        frame = _align(group, near().spread[list(donors)])
        points = frame.to_local(points)
        alignment = frame[missing]
    labels = tuple(recording.labels[marker] for marker in markers)
    part = Recording(
        points,
        labels,
        recording.rate,
        recording.unit,
        recording.up,
        recording.first_frame + frames.start,
    )
    return Excerpt(part, Gap(0, missing.start, missing.stop), alignment)


def _places(seen: BoolArray, span: int) -> int:
    """Count the windows without a missing sample that do not overlap."""
    return sum((stop - start) // span for start, stop in runs(seen))


def _stand_ins(near: Neighbourhood, marker: int, donors: Sequence[int]) -> list[int]:
    taken = {marker, *donors}
    order = np.argsort(near.spread, kind="stable").tolist()
    return [other for other in order if other not in taken][:STAND_INS]


def _seen_points(
    recording: Recording, seen: Seen, frames: slice, markers: Sequence[int]
) -> FloatArray:
    mask = np.stack([seen(marker)[frames] for marker in markers], axis=1)
    return np.where(mask[:, :, None], recording.points[frames][:, list(markers)], np.nan)


def _align(group: FloatArray, spread: FloatArray) -> Alignment:
    """Align the donors; those that keep their distance to the marker count most."""
    typical = float(np.median(spread))
    weights = np.ones_like(spread)
    if 0 < typical < np.inf:
        weights = 1 / (spread / typical + LEAST_SPREAD) ** 2
    complete = np.flatnonzero(np.isfinite(group).all(axis=(1, 2)))
    some = complete[:: max(1, complete.size // SHAPE_FRAMES)]
    return align(group, mean_shape(group[some], weights), weights)
