"""Markers whose distances to the rest of their segment break for some frames."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.rigid_mates import broken_share, rigid_mates, stretched
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton, measure_distances
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

MOST_BROKEN = 0.6
"""Of the distances of a marker: where more are broken, it is this marker that is wrong."""
LARGEST_SHARE = 0.2
"""Of the recording: what is so for longer is no exception."""
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
        Called once per marker.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. A break belongs to the marker most of whose distances break.
    """
    if not 3 <= recording.markers <= MOST_MARKERS or recording.frames < 3:
        return []
    distances = measure_distances(recording, part(progress, 0.0, 0.2))
    wide = (recording.frames, recording.markers)
    share, size = np.zeros(wide), np.zeros(wide)
    mates = [rigid_mates(distances, skeleton, marker) for marker in range(recording.markers)]
    for marker, each in enumerate(mates):
        progress(0.2 + 0.7 * marker / recording.markers)
        if len(each.markers) < 2:
            continue
        stretch = stretched(recording, marker, each)
        gate = np.maximum(params.least_mm, params.times_spread * each.spread)
        part_broken, known = broken_share(stretch, gate)
        share[:, marker] = np.where(known, part_broken, 0.0)
        size[:, marker] = np.nanmax(np.where(np.isnan(stretch), 0.0, np.abs(stretch)), axis=1)
    found = []
    for marker, each in enumerate(mates):
        wrong = share[:, marker] > MOST_BROKEN
        if wrong.any() and len(each.markers) >= 2:
            # Where a mate is even worse off, that is the one that is wrong.
            wrong &= share[:, marker] >= share[:, each.markers].max(axis=1)
        found += _runs_of(recording, marker, wrong, size[:, marker])
    progress(1.0)
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
    """Whether the break comes or goes within two frames."""
    least = ABRUPT * float(np.median(size[start:stop]))
    before, after = max(0, start - 2), min(len(size) - 1, stop + 1)
    came = start > 0 and bool(present[before]) and size[start] - size[before] >= least
    went = stop < len(size) and bool(present[after]) and size[stop - 1] - size[after] >= least
    return bool(came or went)


def _described(
    recording: Recording, marker: int, start: int, stop: int, size: FloatArray
) -> BadRun:
    away = float(np.median(size))
    frames = "1 frame" if stop - start == 1 else f"{stop - start} frames"
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
