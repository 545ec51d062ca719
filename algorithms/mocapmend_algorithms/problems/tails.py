"""Ragged ends: samples just before or after a gap that bend away.

A marker that is about to be hidden is seen by few cameras, or only in part. The samples beside a
gap are compared with a parabola through those before them, and that with what it would be wrong by
further away from the gap.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.mates import common_offset, mates_of
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

LONGEST_S = 0.04
LEAST_LONGEST, MOST_LONGEST = 5, 20
MORE = 3
"""Samples more than the longest tail that the parabola goes through."""
COMPARED = 10
"""Places further from the gap that tell how wrong a parabola is there."""
FLOOR_MM = 0.5


@dataclass(frozen=True)
class TailsParams:
    """Parameters of `tails`."""

    least_mm: float = option(
        5.0,
        label="Smallest deviation",
        text="Ends that bend away by less are left alone.",
        minimum=0.1,
        unit="mm",
    )
    times_usual: float = option(
        5.0,
        label="Times the usual",
        text="By how much more an end bends than the samples further from the gap.",
        minimum=1.5,
    )


class _End(NamedTuple):
    """Of a marker: the first sample outside is `edge`, and the stretch goes on in `direction`."""

    marker: int
    edge: int
    direction: int


def tails(
    recording: Recording, skeleton: Skeleton, params: TailsParams, progress: Progress
) -> list[BadRun]:
    """Find samples just before and after gaps that bend away.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Not used: the neighbours are those that stay close.
    params : TailsParams
        The thresholds.
    progress : Progress
        Called once per marker.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. The ends of the recording are no ragged ones: nothing is lost
        there.
    """
    del skeleton
    longest = int(np.clip(round(LONGEST_S * recording.rate), LEAST_LONGEST, MOST_LONGEST))
    mates: list[list[int]] | None = None
    found = []
    for marker in range(recording.markers):
        done = marker / recording.markers
        progress(done)
        ends = _ends(recording, marker, 2 * longest + MORE + COMPARED)
        for end, offsets, usual in _judged(recording, ends, longest):
            count = _bent(offsets, usual, params)
            if not count:
                continue
            if mates is None:
                mates = mates_of(recording, part(progress, done, done))
            offsets = _relative(recording, mates[marker], end, offsets, longest)  # noqa: PLW2901
            count = _bent(offsets, usual, params)
            if count:
                found.append(_described(recording, end, offsets[longest - count :], count))
    return found


def _ends(recording: Recording, marker: int, least: int) -> list[_End]:
    """List the ends of the stretches that are long enough to judge."""
    return [
        end
        for start, stop in runs(recording.present[:, marker])
        if stop - start >= least
        for end in (_End(marker, start, 1), _End(marker, stop - 1, -1))
        if 0 < end.edge < recording.frames - 1
    ]


def _judged(
    recording: Recording, ends: list[_End], longest: int
) -> list[tuple[_End, FloatArray, FloatArray]]:
    """Return for each end the offsets of its samples, the outermost last, and what is usual."""
    if not ends:
        return []
    edge = np.array([end.edge for end in ends])
    direction = np.array([end.direction for end in ends])
    # The outermost sample is the last one.
    inward = np.arange(2 * longest + MORE + COMPARED - 1, -1, -1)
    frames = edge[:, None] + direction[:, None] * inward
    points = recording.points[frames, ends[0].marker] * recording.mm
    offsets = _extrapolated(points, longest, 0)
    shifted = np.stack([_away(_extrapolated(points, longest, k)) for k in range(2, COMPARED + 1)])
    usual = np.sort(shifted, axis=0)[3 * len(shifted) // 4]
    return list(zip(ends, offsets, usual, strict=True))


def _extrapolated(points: FloatArray, longest: int, shift: int) -> FloatArray:
    """Return how far the last samples are from a parabola through those before them.

    Parameters
    ----------
    points : ndarray, shape (ends, samples, 3)
        In their order.
    longest : int
        Samples that are compared.
    shift : int
        Samples at the end that are left out.

    Returns
    -------
    ndarray, shape (ends, longest, 3)
    """
    stop = points.shape[1] - shift
    base = longest + MORE
    powers = (np.arange(base + longest) / (base + longest))[:, None] ** np.arange(3)
    weights = powers[base:] @ np.linalg.pinv(powers[:base])
    before = points[:, stop - longest - base : stop - longest]
    offsets: FloatArray = points[:, stop - longest : stop] - weights @ before
    return offsets


def _away(offsets: FloatArray) -> FloatArray:
    away: FloatArray = np.sqrt(np.einsum("...k,...k->...", offsets, offsets))
    return away


def _bent(offsets: FloatArray, usual: FloatArray, params: TailsParams) -> int:
    """Return how many samples at the end bend away."""
    away = _away(offsets)
    wrong = away > np.maximum(params.least_mm, params.times_usual * (usual + FLOOR_MM))
    right = np.flatnonzero(~wrong)
    return len(wrong) - 1 - int(right[-1]) if right.size else len(wrong)


def _relative(
    recording: Recording, mates: list[int], end: _End, offsets: FloatArray, longest: int
) -> FloatArray:
    """Return the offsets without what the neighbours do at the same time, where that is less."""
    inward = np.arange(2 * longest + MORE + COMPARED - 1, -1, -1)
    frames: IntArray = end.edge + end.direction * inward
    others = [
        _extrapolated(recording.points[frames, mate][None] * recording.mm, longest, 0)[0]
        for mate in mates
    ]
    common = common_offset(others)
    if common is None:
        return offsets
    less = np.linalg.norm(offsets - common, axis=1) < np.linalg.norm(offsets, axis=1)
    return np.where(less[:, None], offsets - common, offsets)


def _described(recording: Recording, end: _End, offsets: FloatArray, count: int) -> BadRun:
    away = _away(offsets)
    start = end.edge if end.direction > 0 else end.edge - count + 1
    side = "after" if end.direction > 0 else "before"
    what = "sample" if count == 1 else f"{count} samples"
    bend = "bends" if count == 1 else "bend"
    return BadRun(
        kind="tails",
        marker=end.marker,
        start=start,
        stop=start + count,
        score=float(1.0 - 0.5 * np.exp(-away.max() / 20.0)),
        deviation=float(away.mean()) / recording.mm,
        reason=f"The {what} {side} a gap {bend} away from the trajectory, by up to "
        f"{away.max():.0f} mm.",
    )
