"""Ragged ends: samples just before or after a gap that bend away.

A marker that is about to be hidden is seen by few cameras, or only in part. The samples beside a
gap are compared with a parabola through those before them, and that with what it would be wrong by
further away from the gap.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.mates import MOST_MATES, mates_of
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

LONGEST_S = 0.04
LEAST_LONGEST, MOST_LONGEST = 5, 20
MORE = 3
"""Samples more than the longest tail that the parabola goes through."""
COMPARED, MORE_COMPARED = 10, 30
"""Places further from the gap that tell how wrong a parabola is there, and more if there are."""
FLOOR_MM = 0.5
LEAST_SHARE, INNER = 0.1, 1.5
"""What the inner samples are off: a share of the outermost one, and times the usual."""
BATCH = 256
"""Ends that are judged at once."""


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
        3.0,
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
        Called often.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. The ends of the recording are no ragged ones: nothing is lost
        there.
    """
    del skeleton
    longest = int(np.clip(round(LONGEST_S * recording.rate), LEAST_LONGEST, MOST_LONGEST))
    batches = _batches(recording, 3 * longest + MORE + COMPARED)
    if not batches:
        return []
    mates = _table(mates_of(recording, part(progress, 0.0, 0.3)))
    found = []
    for at, (samples, ends) in enumerate(batches):
        progress(0.3 + 0.7 * at / len(batches))
        away = _quietest(_views(recording, mates, ends, samples), longest)
        for end, bent in zip(ends, _bent(away, longest, params), strict=True):
            if bent.size:
                found.append(_described(recording, end, bent))
    progress(1.0)
    return sorted(found, key=lambda run: (run.marker, run.start))


def _batches(recording: Recording, least: int) -> list[tuple[int, list[_End]]]:
    """List the ends of the stretches that are long enough to judge, by the samples looked at."""
    by_samples: dict[int, list[_End]] = {}
    for marker in np.flatnonzero(~recording.present.all(axis=0)).tolist():
        for start, stop in runs(recording.present[:, marker]):
            if stop - start < least:
                continue
            ends = by_samples.setdefault(min(stop - start, least + MORE_COMPARED), [])
            if start > 0:
                ends.append(_End(marker, start, 1))
            if stop < recording.frames:
                ends.append(_End(marker, stop - 1, -1))
    return [
        (samples, ends[first : first + BATCH])
        for samples, ends in sorted(by_samples.items())
        for first in range(0, len(ends), BATCH)
    ]


def _table(mates: list[list[int]]) -> IntArray:
    """Return the mates of each marker, shape (markers, mates); -1 where it has fewer."""
    table = np.full((len(mates), MOST_MATES), -1, dtype=np.int64)
    for marker, each in enumerate(mates):
        table[marker, : len(each)] = each
    return table


def _views(
    recording: Recording, mates: IntArray, ends: Sequence[_End], samples: int
) -> tuple[FloatArray, FloatArray]:
    """Return the samples at some ends in mm, the outermost last, shape (ends, samples, 3).

    Also as they are seen from the neighbours; NaN where fewer than two are there all the time.
    """
    markers, edges, directions = np.array(ends).T
    inward = np.arange(samples - 1, -1, -1)
    frames = edges[:, None] + directions[:, None] * inward
    points: FloatArray = recording.points[frames, markers[:, None]] * recording.mm
    beside = mates[markers]
    around = recording.points[frames[:, None], beside[:, :, None]] * recording.mm
    gone = (beside < 0) | np.isnan(around).any(axis=(2, 3))
    around[gone] = np.nan
    around.sort(axis=1)  # NaN last
    count = (~gone).sum(axis=1)
    low, high = (
        np.take_along_axis(around, np.maximum(at, 0)[:, None, None, None], axis=1)[:, 0]
        for at in ((count - 1) // 2, count // 2)
    )
    middle = (low + high) / 2.0
    middle[count < 2] = np.nan
    return points, points - middle


def _quietest(views: tuple[FloatArray, FloatArray], longest: int) -> FloatArray:
    """Return `_carried_on` of the view of each end in which it is told best where samples lead."""
    away, away_beside = (_carried_on(view, longest + MORE, longest) for view in views)
    places = away.shape[1] - 2 * longest + 1
    unrest, unrest_beside = (
        np.median(each[:, :places, -1], axis=1) for each in (away, away_beside)
    )
    with np.errstate(invalid="ignore"):
        return np.where((unrest_beside < unrest)[:, None, None], away_beside, away)


def _bent(away: FloatArray, longest: int, params: TailsParams) -> list[FloatArray]:
    """Return how far each of the samples at some ends that bend away is off; none where none do.

    Of all lengths that the tail may have, the one is taken at which its outermost sample is the
    furthest from where the samples before it lead, against what is usual.
    """
    lengths = np.arange(1, longest + 1)
    last = away.shape[1] - lengths
    # By length and sample of the tail; what is beyond the length is not looked at.
    tail = away[:, last]
    usual = np.maximum.accumulate(away, axis=1)[:, last - longest] + FLOOR_MM
    outermost = tail[:, lengths - 1, lengths - 1]
    ratio = outermost / usual[:, lengths - 1, lengths - 1]
    ratio[outermost < params.least_mm] = 0.0
    best = np.argmax(ratio, axis=1)
    bent = []
    for end, at in enumerate(best.tolist()):
        own, floor = tail[end, at, : at + 1], INNER * usual[end, at, : at + 1]
        right = np.flatnonzero(own < np.maximum(LEAST_SHARE * own[-1], floor))
        first = int(right[-1]) + 1 if right.size else 0
        bent.append(own[first:] if ratio[end, at] > params.times_usual else own[:0])
    return bent


def _carried_on(points: FloatArray, base: int, length: int) -> FloatArray:
    """Return how far samples are from a parabola through those before them.

    Parameters
    ----------
    points : ndarray, shape (ends, samples, 3)
        In their order.
    base, length : int
        Samples that the parabola goes through, and samples after them that are compared.

    Returns
    -------
    ndarray, shape (ends, places, length)
        At every place with a sample to compare; NaN beyond the last one.
    """
    beyond = np.full((len(points), length - 1, 3), np.nan)
    windows = np.lib.stride_tricks.sliding_window_view(
        np.concatenate((points, beyond), axis=1), base + length, axis=1
    )
    lead = np.tensordot(windows[..., :base], _weights(base, length), axes=(-1, 1))
    apart = windows[..., base:] - lead
    away: FloatArray = np.sqrt(np.einsum("epkt,epkt->ept", apart, apart))
    return away


@lru_cache(maxsize=64)
def _weights(base: int, length: int) -> FloatArray:
    """Return what carries a parabola through some samples on to the next ones."""
    powers = np.power((np.arange(base + length) / (base + length))[:, None], np.arange(3))
    weights: FloatArray = powers[base:] @ np.linalg.pinv(powers[:base])
    return weights


def _described(recording: Recording, end: _End, away: FloatArray) -> BadRun:
    count = len(away)
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
