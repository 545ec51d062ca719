"""Two points in the same place: one of them is a reflection or was labelled twice."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.rigid_mates import RigidMates, rigid_mates
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton
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
    distances = distances_of(recording, part(progress, 0.7, 0.9))
    mates_of = cache(partial(rigid_mates, recording, distances, skeleton))
    found = []
    for count, (pair, frames) in enumerate(together.items()):
        progress(0.9 + 0.1 * count / len(together))
        usual = float(distances.length[pair])
        both = int(recording.present[:, pair].all(axis=1).sum())
        # Of two that are hardly ever seen together, nobody knows how far apart they are otherwise.
        if usual >= LEAST_USUAL * params.within_mm and len(frames) <= MOST_SHARE * both:
            found += _of_pair(recording, mates_of, pair, usual, frames)
    return sorted(found, key=lambda run: (run.marker, run.start))


def _coincidences(
    recording: Recording, within: float, progress: Progress
) -> dict[tuple[int, int], IntArray]:
    """Return the frames at which pairs coincide: near along an axis first, then along all."""
    hits = [np.empty((0, 3), dtype=np.int64)]
    axis = int(np.argmax(_extent(recording)))
    for start in range(0, recording.frames, CHUNK):
        progress(start / recording.frames)
        some = recording.points[start : start + CHUNK] * recording.mm
        along = some[:, :, axis].copy()
        order = np.argsort(along, axis=1)
        ranked = np.take_along_axis(along, order, axis=1)
        # As places in all samples of these frames.
        order += recording.markers * np.arange(len(some))[:, None]
        flat = some.reshape(-1, 3)
        for ahead in range(1, min(NEXT, recording.markers - 1) + 1):
            close = ranked[:, ahead:] - ranked[:, :-ahead] < within
            one, other = order[:, :-ahead][close], order[:, ahead:][close]
            apart = flat.take(other, axis=0) - flat.take(one, axis=0)
            near = np.einsum("nk,nk->n", apart, apart) < within**2
            frame, pair = np.divmod(np.stack((one[near], other[near])), recording.markers)
            hits.append(np.column_stack((pair.min(axis=0), pair.max(axis=0), frame[0] + start)))
    return _by_pair(np.concatenate(hits))


def _by_pair(hits: IntArray) -> dict[tuple[int, int], IntArray]:
    """Sort rows of two markers and a frame: return the frames of each pair."""
    hits = hits[np.lexsort(hits.T[::-1])]
    pairs, first = np.unique(hits[:, :2], axis=0, return_index=True)
    edges = [*first.tolist(), len(hits)]
    return {
        (int(one), int(other)): hits[edges[at] : edges[at + 1], 2]
        for at, (one, other) in enumerate(pairs)
    }


def _extent(recording: Recording) -> FloatArray:
    """Return how wide the recording is along each axis, from some of its frames."""
    some = recording.points[:: max(1, recording.frames // 64)].reshape(-1, 3)
    some = some[~np.isnan(some[:, 0])]
    extent: FloatArray = np.ptp(some, axis=0) if len(some) else np.zeros(3)
    return extent


def _of_pair(
    recording: Recording,
    mates_of: Callable[[int], RigidMates],
    pair: tuple[int, int],
    usual: float,
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
        run = slice(start, stop)
        first, second = (_misfit(recording, mates_of(m), m, pair, run) for m in pair)
        wrong, other = pair if first > second else pair[::-1]
        found.append(_described(recording, wrong, other, run, usual, abs(first - second)))
    return found


def _misfit(
    recording: Recording, mates: RigidMates, marker: int, pair: tuple[int, int], run: slice
) -> float:
    """Return by how much the distances of a marker to its neighbours differ from usual, in mm."""
    kept = [at for at, mate in enumerate(mates.markers) if mate not in pair]
    around = recording.points[run][:, [mates.markers[at] for at in kept]]
    apart = (around - recording.points[run, [marker]]) * recording.mm
    off = np.abs(np.sqrt(np.einsum("tmk,tmk->tm", apart, apart)) - mates.length[kept])
    off = off[~np.isnan(off)]
    return float(np.median(off)) if off.size else 0.0


def _described(
    recording: Recording, wrong: int, other: int, run: slice, usual: float, surer: float
) -> BadRun:
    frames = frames_in_words(run.stop - run.start)
    return BadRun(
        kind="reflections",
        marker=wrong,
        start=run.start,
        stop=run.stop,
        score=float(1.0 - 0.5 * np.exp(-surer / 20.0)),
        deviation=usual / recording.mm,
        reason=f"For {frames} it is in the same place as {recording.labels[other]}, from which it "
        f"is {usual:.0f} mm away otherwise.",
        other=other,
    )
