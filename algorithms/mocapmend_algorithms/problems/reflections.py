"""Two points in the same place: one of them is a reflection or was labelled twice."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.rigid_mates import rigid_mates
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances, Skeleton
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

CHUNK = 2048
NEXT = 4
"""Points that are looked at on either side along one axis."""
LEAST_USUAL = 4.0
"""Times the distance at which two points coincide: how far apart they are otherwise."""
MOST_SHARE = 0.3
"""Of the frames with both: two that coincide for longer are two names of one point."""
BRIDGED = 2
"""Frames between two coincidences that belong together."""
LEAST_FRAMES = 2
"""What is together for one frame may be passing by."""


@dataclass(frozen=True)
class ReflectionsParams:
    """Parameters of `reflections`."""

    within_mm: float = option(
        6.0,
        label="Distance",
        text="Two points that are nearer to each other than this are in the same place.",
        minimum=0.0,
        unit="mm",
    )


def reflections(
    recording: Recording, skeleton: Skeleton, params: ReflectionsParams, progress: Progress
) -> list[BadRun]:
    """Find points that coincide with another one from which they are apart otherwise.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Its bones tell which of the two is wrong.
    params : ReflectionsParams
        The thresholds.
    progress : Progress
        Called often.

    Returns
    -------
    list of BadRun
        Ordered by marker and start; `other` is the one that is right.
    """
    if not 2 <= recording.markers <= MOST_MARKERS or not recording.frames:
        return []
    together = _coincidences(recording, params.within_mm, part(progress, 0.0, 0.7))
    if not together:
        return []
    distances = distances_of(recording, part(progress, 0.7, 1.0))
    found = []
    for pair, frames in sorted(together.items()):
        usual = distances.length[pair]
        both = int(recording.present[:, pair].all(axis=1).sum())
        if usual < LEAST_USUAL * params.within_mm or len(frames) > MOST_SHARE * both:
            continue
        found += _of_pair(recording, skeleton, distances, pair, frames)
    return sorted(found, key=lambda run: (run.marker, run.start))


def _coincidences(
    recording: Recording, within: float, progress: Progress
) -> dict[tuple[int, int], IntArray]:
    """Return the frames at which pairs coincide: near along an axis first, then along all."""
    hits = [np.empty((0, 3), dtype=np.int64)]
    axis = int(np.argmax(_extent(recording)))
    for start in range(0, recording.frames, CHUNK):
        progress(start / recording.frames)
        some = recording.points[start : start + CHUNK]
        order = np.argsort(some[:, :, axis], axis=1)
        ranked = np.take_along_axis(some[:, :, axis], order, axis=1) * recording.mm
        for ahead in range(1, min(NEXT, recording.markers - 1) + 1):
            frame, at = np.nonzero(ranked[:, ahead:] - ranked[:, :-ahead] < within)
            pair = np.sort(np.stack((order[frame, at], order[frame, at + ahead])), axis=0)
            apart = (some[frame, pair[1]] - some[frame, pair[0]]) * recording.mm
            near = np.einsum("nk,nk->n", apart, apart) < within**2
            hits.append(np.column_stack((pair.T, frame + start))[near])
    every = np.concatenate(hits)
    every = every[np.lexsort(every.T[::-1])]
    pairs, first = np.unique(every[:, :2], axis=0, return_index=True)
    frames = np.split(every[:, 2], first[1:])
    return {(a, b): own for (a, b), own in zip(pairs.tolist(), frames, strict=bool(len(pairs)))}


def _extent(recording: Recording) -> FloatArray:
    """Return how wide the recording is along each axis, from some of its frames."""
    some = recording.points[:: max(1, recording.frames // 64)].reshape(-1, 3)
    some = some[~np.isnan(some[:, 0])]
    extent: FloatArray = np.ptp(some, axis=0) if len(some) else np.zeros(3)
    return extent


def _of_pair(
    recording: Recording,
    skeleton: Skeleton,
    distances: PairDistances,
    pair: tuple[int, int],
    frames: IntArray,
) -> list[BadRun]:
    mask = np.zeros(recording.frames, dtype=np.bool_)
    mask[frames] = True
    for start, stop in runs(~mask):
        if start > 0 and stop < recording.frames and stop - start <= BRIDGED:
            mask[start:stop] = recording.present[start:stop, pair].all(axis=1)
    found = []
    for start, stop in runs(mask):
        if stop - start < LEAST_FRAMES:
            continue
        misfits = [_misfit(recording, skeleton, distances, m, pair, start, stop) for m in pair]
        wrong = int(misfits[1] >= misfits[0])
        found.append(_described(recording, distances, pair, wrong, misfits, start, stop))
    return found


def _misfit(
    recording: Recording,
    skeleton: Skeleton,
    distances: PairDistances,
    marker: int,
    pair: tuple[int, int],
    start: int,
    stop: int,
) -> float:
    """Return by how much the distances of a marker to its neighbours differ from usual, in mm."""
    mates = rigid_mates(recording, distances, skeleton, marker)
    kept = [at for at, mate in enumerate(mates.markers) if mate not in pair]
    around = recording.points[start:stop][:, [mates.markers[at] for at in kept]]
    apart = (around - recording.points[start:stop, [marker]]) * recording.mm
    off = np.abs(np.sqrt(np.einsum("tmk,tmk->tm", apart, apart)) - mates.length[kept])
    off = off[~np.isnan(off)]
    return float(np.median(off)) if off.size else 0.0


def _described(
    recording: Recording,
    distances: PairDistances,
    pair: tuple[int, int],
    wrong: int,
    misfits: list[float],
    start: int,
    stop: int,
) -> BadRun:
    usual = float(distances.length[pair])
    other = pair[1 - wrong]
    frames = "1 frame" if stop - start == 1 else f"{stop - start} frames"
    surer = abs(misfits[0] - misfits[1])
    return BadRun(
        kind="reflections",
        marker=pair[wrong],
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-surer / 20.0)),
        deviation=usual / recording.mm,
        reason=f"For {frames} it is in the same place as {recording.labels[other]}, from which it "
        f"is {usual:.0f} mm away otherwise.",
        other=other,
    )
