"""Ragged ends: samples just before or after a gap that bend away.

A marker that is about to be hidden is seen by few cameras, or only in part. The samples beside a
gap are compared with a parabola through those before them, and that with what it would be wrong by
further away from the gap.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.mates import mates_of
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
REPORTED = 32
"""Ends between two reports of progress."""


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
    samples: int
    """That are looked at."""


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
    ends = _ends(recording, _window(longest))
    if not ends:
        return []
    mates = mates_of(recording, part(progress, 0.0, 0.3))
    found = []
    for at, end in enumerate(ends):
        if at % REPORTED == 0:
            progress(0.3 + 0.7 * at / len(ends))
        views = _views(recording, mates[end.marker], end)
        away = _bent(_quietest(views, longest), longest, params)
        if away.size:
            found.append(_described(recording, end, away))
    return found


def _window(longest: int) -> int:
    """Return how many samples from the end are looked at, at least."""
    return 3 * longest + MORE + COMPARED


def _ends(recording: Recording, least: int) -> list[_End]:
    """List the ends of the stretches that are long enough to judge."""
    return [
        end
        for marker in np.flatnonzero(~recording.present.all(axis=0)).tolist()
        for start, stop in runs(recording.present[:, marker])
        if stop - start >= least
        for samples in (min(stop - start, least + MORE_COMPARED),)
        for end in (_End(marker, start, 1, samples), _End(marker, stop - 1, -1, samples))
        if 0 < end.edge < recording.frames - 1
    ]


def _views(recording: Recording, mates: list[int], end: _End) -> list[FloatArray]:
    """Return the samples at an end in mm, the outermost last, shape (samples, 3).

    Also as they are seen from the neighbours, where two or more are there all the time.
    """
    inward = np.arange(end.samples - 1, -1, -1)
    frames: IntArray = end.edge + end.direction * inward
    points: FloatArray = recording.points[frames, end.marker] * recording.mm
    around = recording.points[frames][:, mates] * recording.mm
    around = around[:, ~np.isnan(around).any(axis=(0, 2))]
    return [points, points - np.median(around, axis=1)] if around.shape[1] >= 2 else [points]


def _quietest(views: list[FloatArray], longest: int) -> FloatArray:
    """Return the view in which it can be told the best where the samples lead."""

    def unrest(points: FloatArray) -> float:
        return float(np.median(_carried_on(points, longest + MORE, longest)[:-longest, -1]))

    return min(views, key=unrest)


def _bent(points: FloatArray, longest: int, params: TailsParams) -> FloatArray:
    """Return how far each of the samples at the end that bend away is off; none where none do.

    Of all lengths that the tail may have, the one is taken at which its outermost sample is the
    furthest from where the samples before it lead, against what is usual.
    """
    best, bent = params.times_usual, np.zeros(0)
    for length in range(1, longest + 1):
        away = _carried_on(points, longest + MORE, length)
        usual = away[:-longest].max(axis=0) + FLOOR_MM
        ratio = float(away[-1, -1] / usual[-1])
        if ratio <= best or away[-1, -1] < params.least_mm:
            continue
        wrong = away[-1] >= np.maximum(LEAST_SHARE * away[-1, -1], INNER * usual)
        right = np.flatnonzero(~wrong)
        best, bent = ratio, away[-1, int(right[-1]) + 1 if right.size else 0 :]
    return bent


def _carried_on(points: FloatArray, base: int, length: int) -> FloatArray:
    """Return how far samples are from a parabola through those before them.

    Parameters
    ----------
    points : ndarray, shape (samples, 3)
        In their order.
    base, length : int
        Samples that the parabola goes through, and samples after them that are compared.

    Returns
    -------
    ndarray, shape (places, length)
        At every place where there is room, the last one at the end.
    """
    windows = np.lib.stride_tricks.sliding_window_view(points, base + length, axis=0)
    apart = windows[:, :, base:] - windows[:, :, :base] @ _weights(base, length).T
    away: FloatArray = np.sqrt(np.einsum("pkt,pkt->pt", apart, apart))
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
