"""Markers whose distances to the rest of their segment break for some frames."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.rigid_mates import (
    RigidMates,
    broken_share,
    rigid_mates,
    stretched,
)
from mocapmend_algorithms.problems.steps import excursions
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

CHUNK = 2048
"""Frames that are looked at at once."""
MOST_BROKEN = 0.6
"""Of the distances of a marker: where more are broken, it is this marker that is wrong."""
LARGEST_SHARE = 0.2
"""Of the recording: what is so for longer is no exception."""
SHORTEST, LONGEST_S = 3, 1.0
"""Frames, and seconds, of a piece between two steps; shorter ones are spikes."""
CLEARLY = 2.0
"""Times the smallest break: the steps at the ends of such a piece."""
SEEN_FROM_MATE, SOME_BROKEN = 0.1, 0.3
"""Of such a step, what a mate's distance changes by; and the share of the mates that it does."""
LARGE_MM = 60.0
ABRUPT = 0.5
"""Of the break, the part that comes within two frames: a joint that bends takes longer."""


@dataclass(frozen=True)
class BoneBreaksParams:
    """Parameters of `bone_breaks`."""

    least_mm: float = option(
        15.0,
        label="Smallest break",
        text="Distances that change by less are left alone.",
        minimum=1.0,
        unit="mm",
    )
    times_spread: float = option(
        8.0,
        label="Times the usual change",
        text="By how much more than usual a distance changes where it breaks.",
        minimum=2.0,
    )


def bone_breaks(
    recording: Recording, skeleton: Skeleton, params: BoneBreaksParams, progress: Progress
) -> list[BadRun]:
    """Find markers whose distances to their segment break for some frames.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Its bones count first; pairs that keep their distance are added to them.
    params : BoneBreaksParams
        The thresholds.
    progress : Progress
        Called often.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. A break belongs to the marker most of whose distances break.
    """
    if not 3 <= recording.markers <= MOST_MARKERS or recording.frames < 3:
        return []
    distances = distances_of(recording, part(progress, 0.0, 0.2))
    mates = [
        rigid_mates(recording, distances, skeleton, marker) for marker in range(recording.markers)
    ]
    share, size = _broken(recording, mates, params, part(progress, 0.2, 0.7))
    found = []
    for marker, each in enumerate(mates):
        progress(0.7 + 0.3 * marker / recording.markers)
        if not each.markers:
            continue
        away = _excursions(recording, marker, each, params)
        wrong = share[marker] > MOST_BROKEN
        # Where a mate is even worse off, that is the one that is wrong.
        wrong &= share[marker] >= share[each.markers].max(axis=0)
        for run in away:
            wrong[run.start : run.stop] = False
        found += sorted(
            away + _runs_of(recording, marker, wrong, size[marker]), key=lambda run: run.start
        )
    progress(1.0)
    return found


def _broken(
    recording: Recording,
    mates: Sequence[RigidMates],
    params: BoneBreaksParams,
    progress: Progress,
) -> tuple[FloatArray, FloatArray]:
    """Measure how broken each marker is.

    Returns
    -------
    share : ndarray, shape (markers, frames)
        Of its distances, those that are broken.
    size : ndarray, shape (markers, frames)
        The largest break, in mm.
    """
    share, size = np.zeros((2, recording.markers, recording.frames))
    for start in range(0, recording.frames, CHUNK):
        progress(start / recording.frames)
        some = slice(start, start + CHUNK)
        paths = np.ascontiguousarray(recording.points[some].transpose(1, 2, 0)) * recording.mm
        for marker, each in enumerate(mates):
            if len(each.markers) < 2:
                continue
            stretch = stretched(paths, marker, each)
            gate = np.maximum(params.least_mm, params.times_spread * each.spread)
            share[marker, some] = broken_share(stretch, gate)
            size[marker, some] = np.fmax.reduce(np.abs(stretch), axis=0, initial=0.0)
    return share, size


def _excursions(
    recording: Recording, marker: int, mates: RigidMates, params: BoneBreaksParams
) -> list[BadRun]:
    """Find pieces between two opposite steps that change the distances to most mates."""
    points = recording.points[:, marker] * recording.mm
    longest = round(LONGEST_S * recording.rate)
    found = []
    for piece in excursions(points, recording.rate, CLEARLY * params.least_mm, longest):
        if piece.stop - piece.start < SHORTEST:
            continue
        frames = np.array([piece.start - 1, piece.start, piece.stop - 1, piece.stop])
        around = recording.points[frames[:, None], mates.markers] * recording.mm
        apart = around - points[frames, None]
        before, first, last, after = np.sqrt(np.einsum("tmk,tmk->tm", apart, apart))
        there, back = first - before, after - last
        known = ~np.isnan(there + back)
        broken = np.minimum(np.abs(there), np.abs(back)) >= SEEN_FROM_MATE * piece.size
        broken &= there * back < 0.0
        if known.any() and broken.sum() >= SOME_BROKEN * known.sum():
            away = np.full(piece.stop - piece.start, piece.size)
            found.append(_described(recording, marker, piece.start, piece.stop, away))
    return found


def _runs_of(recording: Recording, marker: int, wrong: BoolArray, size: FloatArray) -> list[BadRun]:
    seen = int(recording.present[:, marker].sum())
    if not wrong.any() or wrong.sum() > LARGEST_SHARE * seen:
        return []
    return [
        _described(recording, marker, start, stop, size[start:stop])
        for start, stop in runs(wrong)
        if _abrupt(recording.present[:, marker], size, start, stop)
    ]


def _abrupt(present: BoolArray, size: FloatArray, start: int, stop: int) -> bool:
    """Whether the break comes and goes within two frames, as far as the marker is seen there.

    Of a large one, either is enough: it may have drifted there.
    """
    usual = float(np.median(size[start:stop]))
    least = ABRUPT * usual
    before, after = start - 2, stop + 1
    seen_before = before >= 0 and bool(present[before])
    seen_after = after < len(size) and bool(present[after])
    comes = not seen_before or size[start] - size[before] >= least
    goes = not seen_after or size[stop - 1] - size[after] >= least
    came, went = bool(comes and seen_before), bool(goes and seen_after)
    return bool(comes and goes and (came or went)) or ((came or went) and usual >= LARGE_MM)


def _described(
    recording: Recording, marker: int, start: int, stop: int, size: FloatArray
) -> BadRun:
    away = float(np.median(size))
    frames = frames_in_words(stop - start)
    return BadRun(
        kind="bone-breaks",
        marker=marker,
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-away / 50.0)),
        deviation=away / recording.mm,
        reason=f"For {frames} its distances to its neighbours differ by {away:.0f} mm from what "
        "they are otherwise.",
    )
