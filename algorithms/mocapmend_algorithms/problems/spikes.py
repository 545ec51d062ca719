"""Samples that leave the trajectory for one or a few frames.

Candidates are pairs of breaks: places where the third difference of the trajectory, which is the
step that its smooth continuation does not explain, is many times what it is around. What lies
between two breaks is a spike if it is far from where the samples on both sides lead, and if these
agree with each other. Shocks that the neighbouring markers feel too are no spikes.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, running_count
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.problems.blocks import SIDE, Fits, block_offsets, fit_blocks, usual_away
from mocapmend_algorithms.problems.levels import running_level
from mocapmend_algorithms.problems.mates import common_offset, mates_of
from mocapmend_algorithms.problems.steps import BREAK, step_sizes
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

FLOOR_MM = 0.3
"""What no system measures better: in simulated motion the noise is 0."""
SHARP = 0.4
"""Of the deviation, the step at either end: what goes out and comes back by degrees is motion."""
SHARP_LONG = 0.6
"""The same of spikes of more than five frames, in which much can happen."""
LEAST_SHARE = 0.15
"""Of the deviation, that of the best sample of a spike."""
SMALL_MM, LARGE_MM = 12.0, 50.0
"""What is smaller than the one must be surer; motion is no excuse for more than the other."""
PER_FRAME = 0.12
NEXT_BREAKS = 6
LEAST_LONGEST = 5
UNUSUAL, VERY_UNUSUAL = 3.0, 10.0
"""Times what blocks of the same length around it are away from where their sides lead."""
CERTAIN, CERTAIN_MM = 40.0, 50.0
"""Times the noise, and deviation, of what need not begin and end in steps: it is very unusual."""
PASSES = 3
UNMISTAKABLE = 30.0
"""Times the noise: so far, neighbours that jump as well are no excuse."""


@dataclass(frozen=True)
class SpikesParams:
    """Parameters of `spikes`."""

    least_mm: float = option(
        15.0,
        label="Smallest deviation",
        text="Spikes nearer to where the marker should be are left alone. Down to 5 mm they are "
        "found well in clean recordings; jittery ones have very many.",
        minimum=0.1,
        unit="mm",
    )
    longest_ms: float = option(
        100.0,
        label="Longest spike",
        text="What is away for longer may be anything; but up to 5 frames are always looked at.",
        minimum=0.0,
        maximum=500.0,
        unit="ms",
    )
    times_noise: float = option(
        6.0,
        label="Times the noise",
        text="How far out a spike is, against how well the samples beside it agree.",
        minimum=2.0,
    )


class _Found(NamedTuple):
    start: int
    length: int
    away: float
    ratio: float


def spikes(
    recording: Recording, skeleton: Skeleton, params: SpikesParams, progress: Progress
) -> list[BadRun]:
    """Find samples that leave the trajectory for one or a few frames.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Not used: the neighbours are those that stay close.
    params : SpikesParams
        The thresholds.
    progress : Progress
        Called once per marker.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. There are two samples or more on either side of each: of the
        first and the last two samples of a recording, large errors are broken bones.
    """
    del skeleton
    longest = max(LEAST_LONGEST, round(params.longest_ms * recording.rate / 1000))
    found = []
    for marker in range(recording.markers):
        progress(0.8 * marker / recording.markers)
        points = recording.points[:, marker] * recording.mm
        found.append(_of_one(points, recording.rate, longest, params))
    kept = _without_shocks(recording, found, params, part(progress, 0.8, 1.0))
    return [
        _described(recording, marker, spike, params)
        for marker, spikes_found in enumerate(kept)
        for spike in sorted(spikes_found)
    ]


def _of_one(points: FloatArray, rate: float, longest: int, params: SpikesParams) -> list[_Found]:
    """Find the spikes of one trajectory; those found first are mended to see the others."""
    if len(points) < 2 * SIDE:
        return []
    points = points.copy()
    found: list[_Found] = []
    for _ in range(PASSES):
        new = _pass(points, rate, longest, params)
        if not new:
            break
        for spike in new:
            points[spike.start : spike.start + spike.length] = np.nan
        found += new
    return found


def _pass(points: FloatArray, rate: float, longest: int, params: SpikesParams) -> list[_Found]:
    step = step_sizes(points)
    level = running_level(step, rate)
    with np.errstate(invalid="ignore"):
        broken = step > np.maximum(SHARP * params.least_mm, BREAK * level)
    start, stop = _pairs(
        points, np.flatnonzero(np.append(broken, False) | _beside_gaps(points)), longest
    )
    candidates: list[_Found] = []
    for length in np.unique(stop - start).tolist():
        first = start[stop - start == length]
        fits = fit_blocks(points, first, length)
        noise = np.sqrt(fits.misfit**2 + level[first] ** 2 + FLOOR_MM**2)
        ratio = fits.away / noise
        with np.errstate(invalid="ignore"):
            good = (fits.away >= params.least_mm) & (ratio >= _needed(fits.away, length, params))
            good &= fits.least >= np.maximum(LEAST_SHARE * fits.away, 2.0 * noise)
            certain = (ratio >= CERTAIN) & (fits.away >= CERTAIN_MM)
            good &= certain | _sharp(step, first, length, fits)
        if not good.any():
            continue
        times = np.where(certain, VERY_UNUSUAL, UNUSUAL)[good]
        good[good] = fits.away[good] >= times * usual_away(points, first[good], length)
        candidates += [
            _Found(int(first[at]), length, float(fits.away[at]), float(ratio[at]))
            for at in np.flatnonzero(good)
        ]
    return _apart(candidates)


def _needed(away: FloatArray, length: int, params: SpikesParams) -> FloatArray:
    """Ask for more certainty where less is at stake, and where motion has more time."""
    away = np.maximum(away, 1e-9)
    longer = 1.0 + PER_FRAME * (length - 1) * np.minimum(1.0, LARGE_MM / away)
    needed: FloatArray = params.times_noise * longer * np.maximum(1.0, SMALL_MM / away)
    return needed


def _sharp(step: FloatArray, first: IntArray, length: int, fits: Fits) -> BoolArray:
    """Whether both ends are steps."""
    step = np.append(step, np.nan)
    into, back = step[first], step[first + length]
    # Beside a gap it cannot be told.
    into = np.where(np.isnan(into), fits.first, into)
    back = np.where(np.isnan(back), fits.last, back)
    enough: BoolArray = np.maximum(into, back) >= SHARP * fits.away
    if length > LEAST_LONGEST:
        enough = np.minimum(into, back) >= SHARP_LONG * fits.away
    return enough & (into >= SHARP * fits.first) & (back >= SHARP * fits.last)


def _beside_gaps(points: FloatArray) -> BoolArray:
    """Mark the frames where a seen stretch begins or has just ended, and those next to them."""
    seen = np.concatenate(([False], ~np.isnan(points[:, 0]), [False]))
    beside = seen[1:] != seen[:-1]
    near: BoolArray = beside.copy()
    near[1:] |= beside[:-1]
    near[:-1] |= beside[1:]
    return near


def _pairs(points: FloatArray, edges: IntArray, longest: int) -> tuple[IntArray, IntArray]:
    """Pair each edge with the next few, as first and last of what lies between and is seen."""
    missing = running_count(np.isnan(points[:, 0]))
    starts, stops = [], []
    for ahead in range(1, NEXT_BREAKS + 1):
        a, b = edges[:-ahead], edges[ahead:]
        near = (b - a <= longest) & (missing[b] == missing[a])
        starts.append(a[near])
        stops.append(b[near])
    return np.concatenate(starts), np.concatenate(stops)


def _apart(candidates: Sequence[_Found]) -> list[_Found]:
    """Of candidates that touch each other keep the one that is the furthest out and short."""
    taken: list[_Found] = []
    used: set[int] = set()
    for each in sorted(candidates, key=lambda c: (-c.ratio / c.length, c.start)):
        reach = range(each.start - 1, each.start + each.length + 1)
        if used.isdisjoint(reach):
            taken.append(each)
            used.update(range(each.start, each.start + each.length))
    return taken


def _without_shocks(
    recording: Recording,
    found: Sequence[list[_Found]],
    params: SpikesParams,
    progress: Progress,
) -> list[list[_Found]]:
    """Leave out what the neighbours do at the same time."""
    if not any(found):
        return list(found)
    mates = mates_of(recording, progress)
    return [
        [spike for spike in each if _stands_out(recording, mates[marker], marker, spike, params)]
        for marker, each in enumerate(found)
    ]


def _stands_out(
    recording: Recording,
    mates: Sequence[int],
    marker: int,
    spike: _Found,
    params: SpikesParams,
) -> bool:
    if spike.ratio >= UNMISTAKABLE:
        return True

    def offsets(of: int) -> FloatArray:
        low = max(0, spike.start - SIDE)
        some = recording.points[low : spike.start + spike.length + SIDE, of] * recording.mm
        return block_offsets(some, spike.start - low, spike.length)

    common = common_offset([offsets(mate) for mate in mates])
    own = offsets(marker)
    if common is None or np.isnan(own).any():
        return True
    apart = float(np.sqrt(np.mean(np.sum((own - common) ** 2, axis=1))))
    return apart >= params.least_mm and spike.ratio * apart / spike.away >= float(
        _needed(np.array(apart), spike.length, params)
    )


def _described(recording: Recording, marker: int, spike: _Found, params: SpikesParams) -> BadRun:
    frames = frames_in_words(spike.length)
    return BadRun(
        kind="spikes",
        marker=marker,
        start=spike.start,
        stop=spike.start + spike.length,
        score=1.0 - 0.5 * min(1.0, params.times_noise / spike.ratio),
        deviation=spike.away / recording.mm,
        reason=f"For {frames} it is {spike.away:.0f} mm from where the frames before and after "
        f"lead, {spike.ratio:.0f} times the noise there.",
    )
