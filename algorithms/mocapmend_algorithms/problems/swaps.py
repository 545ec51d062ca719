"""Labels of two markers that are exchanged for some time.

Where two trajectories continue each other, and not themselves, their labels change places, and
change back where it happens again. Gaps may hide one of these places, and which side is right is
not told by them: so time is cut at these places and at gaps, and the likeliest course of right and
swapped pieces is found from the distances to the neighbours (Viterbi's algorithm).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.problems.crossings import Crossing, find_crossings, find_jumps
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.likeness import Likeness
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances, Skeleton
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

FRAMES_PER_PIECE = 8
"""At which the distances to the neighbours are measured."""
MOST_LIKE = 8.0
CROSSING_MISSED, HALF_MISSED = 12.0, 4.0
"""Cost of a crossing at which the labels do not change: both seen, and one of them missing."""
UNSEEN_CHANGE, JUMP_CHANGE = 6.0, 3.0
"""Cost of a change in a gap, and at a jump of one marker; anywhere else there is none."""
LEAST_SURE = 5.0
"""How much more it must cost to call a swap right."""
SWAPPED = 1.0
"""Cost of a swap, whatever its length; by its share of the recording up to twice as much."""


@dataclass(frozen=True)
class SwapsParams:
    """Parameters of `swaps`."""

    least_mm: float = option(
        15.0,
        label="Smallest distance",
        text="Markers that are nearer to each other while they are swapped are left alone.",
        minimum=0.0,
        unit="mm",
    )


class _Piece(NamedTuple):
    start: int
    stop: int
    change: float
    """Cost of a change of labels before it."""
    stay: float
    """Cost of none."""


def swaps(
    recording: Recording, skeleton: Skeleton, params: SwapsParams, progress: Progress
) -> list[BadRun]:
    """Find labels of two markers that are exchanged.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Not used: distances to all neighbours tell more than bones.
    params : SwapsParams
        The thresholds.
    progress : Progress
        Called once per marker and per pair.

    Returns
    -------
    list of BadRun
        Ordered by marker and start; `marker` and `other` are to be exchanged. Labels that are
        swapped from the first frame to the last cannot be found.
    """
    del skeleton
    if not 2 <= recording.markers <= MOST_MARKERS or recording.frames < 3:
        return []
    errors, jumps = find_jumps(recording, part(progress, 0.0, 0.3))
    crossings = find_crossings(recording, errors, jumps, part(progress, 0.3, 0.6))
    distances = distances_of(recording, part(progress, 0.6, 0.7))
    likeness = Likeness(recording, distances)
    cuts = [_cuts(jumps[:, m], recording.present[:, m]) for m in range(recording.markers)]
    pairs: dict[tuple[int, int], list[Crossing]] = {
        pair: [] for pair in _neighbours_with_gaps(recording, likeness)
    }
    for crossing in crossings:
        pairs.setdefault((crossing.first, crossing.second), []).append(crossing)
    found = []
    for count, (pair, seen) in enumerate(sorted(pairs.items())):
        progress(0.7 + 0.3 * count / len(pairs))
        pieces = _pieces(recording.frames, [cuts[marker] for marker in pair], seen)
        found += _of_pair(recording, pair, pieces, likeness, distances, params)
    return sorted(
        _likeliest(found, recording.present.shape), key=lambda run: (run.marker, run.start)
    )


def _likeliest(runs: Sequence[BadRun], shape: tuple[int, ...]) -> list[BadRun]:
    """Of swaps that share samples keep the surest: a marker has one label at a time."""
    taken = np.zeros(shape, dtype=np.bool_)
    kept = []
    for run in sorted(runs, key=lambda run: (-run.score, -run.length, run.marker, run.start)):
        assert run.other is not None
        pair = [run.marker, run.other]
        if not taken[run.start : run.stop, pair].any():
            taken[run.start : run.stop, pair] = True
            kept.append(run)
    return kept


def _neighbours_with_gaps(recording: Recording, likeness: Likeness) -> Iterable[tuple[int, int]]:
    """List pairs of neighbours of which a gap may hide that they change places."""
    complete = set(np.flatnonzero(recording.present.all(axis=0)).tolist())
    for marker, mates in enumerate(likeness.mates):
        for mate in mates:
            if not {marker, mate} <= complete:
                yield min(marker, mate), max(marker, mate)


def _of_pair(
    recording: Recording,
    pair: tuple[int, int],
    pieces: Sequence[_Piece],
    likeness: Likeness,
    distances: PairDistances,
    params: SwapsParams,
) -> list[BadRun]:
    costs = _costs(recording, pair, pieces, likeness)
    swapped = _course(pieces, costs)
    if not swapped.any():
        return []
    found = []
    edges = np.flatnonzero(np.diff(np.concatenate(([0], swapped.astype(np.int8), [0]))))
    for first, last in edges.reshape(-1, 2).tolist():
        sure = _certainty(pieces, costs, first, last)
        if sure < LEAST_SURE:
            continue
        run = _described(recording, pair, pieces[first:last], sure, distances)
        if run is not None and run.deviation * recording.mm >= params.least_mm:
            found.append(run)
    return found


def _cuts(jumps: BoolArray, present: BoolArray) -> dict[int, float]:
    """Return what a change of labels costs where a marker jumps, appears or vanishes."""
    changes = np.flatnonzero(present[1:] != present[:-1]) + 1
    costs = dict.fromkeys(np.flatnonzero(jumps).tolist(), JUMP_CHANGE)
    return costs | dict.fromkeys(changes.tolist(), UNSEEN_CHANGE)


def _pieces(
    frames: int, cuts: Sequence[dict[int, float]], crossings: Sequence[Crossing]
) -> list[_Piece]:
    """Cut time where two markers may change places."""
    costs: dict[int, tuple[float, float]] = {}
    for own in cuts:
        for frame, change in own.items():
            costs[frame] = max(change, costs.get(frame, (0.0, 0.0))[0]), 0.0
    for crossing in crossings:
        costs[crossing.frame] = 0.0, CROSSING_MISSED if crossing.both else HALF_MISSED
    starts = sorted(costs)
    stops = [*starts, frames]
    first = _Piece(0, stops[0], 0.0, 0.0)
    rest = [_Piece(at, stop, *costs[at]) for at, stop in zip(starts, stops[1:], strict=True)]
    return [first, *rest]


def _costs(
    recording: Recording,
    pair: tuple[int, int],
    pieces: Sequence[_Piece],
    likeness: Likeness,
) -> FloatArray:
    """Return for each piece what it costs to call it swapped; below 0 where that is likelier."""
    starts = np.array([piece.start for piece in pieces])
    lengths = np.array([piece.stop - piece.start for piece in pieces])
    share = (np.arange(FRAMES_PER_PIECE) + 0.5) / FRAMES_PER_PIECE
    frames: IntArray = starts[:, None] + (lengths[:, None] * share).astype(np.int64)
    like = likeness.swapped(*pair, frames.ravel()).reshape(frames.shape)
    like = np.clip(np.median(like, axis=1), -MOST_LIKE, MOST_LIKE)
    # Neither appears nor vanishes within a piece.
    any_seen = recording.present[starts][:, pair].any(axis=1)
    weight = 1.0 + np.log10(lengths)
    rare = SWAPPED * lengths / recording.frames
    costs: FloatArray = np.where(any_seen, -like * weight + rare, 0.0)
    return costs


def _course(pieces: Sequence[_Piece], costs: FloatArray) -> BoolArray:
    """Find the cheapest course of right and swapped pieces (Viterbi)."""
    right, swapped = 0.0, float(costs[0]) + SWAPPED
    came = []
    for piece, cost in zip(pieces[1:], costs[1:].tolist(), strict=True):
        to_right = right + piece.stay, swapped + piece.change
        to_swapped = right + piece.change + SWAPPED, swapped + piece.stay
        came.append((to_right[1] < to_right[0], to_swapped[1] <= to_swapped[0]))
        right, swapped = min(to_right), min(to_swapped) + cost
    state = swapped < right
    course = [state]
    for from_right, from_swapped in reversed(came):
        state = from_swapped if state else from_right
        course.append(state)
    return np.array(course[::-1], dtype=np.bool_)


def _certainty(pieces: Sequence[_Piece], costs: FloatArray, first: int, last: int) -> float:
    """Return how much more it would cost to call these pieces right."""
    edges = [pieces[at] for at in (first, last) if 0 < at < len(pieces)]
    return float(sum(piece.stay - piece.change for piece in edges) - costs[first:last].sum())


def _described(
    recording: Recording,
    pair: tuple[int, int],
    pieces: Sequence[_Piece],
    sure: float,
    distances: PairDistances,
) -> BadRun | None:
    """Describe a swap over some pieces, without the frames at its ends in which nothing is seen."""
    start, stop = pieces[0].start, pieces[-1].stop
    seen = np.flatnonzero(recording.present[start:stop, pair].any(axis=1))
    if not seen.size:
        return None
    start, stop = start + int(seen[0]), start + int(seen[-1]) + 1
    apart = recording.points[start:stop, pair[0]] - recording.points[start:stop, pair[1]]
    length = np.sqrt(np.einsum("tk,tk->t", apart, apart))
    known = length[~np.isnan(length)]
    away = float(np.median(known)) if known.size else distances.length[pair] / recording.mm
    labels = recording.labels
    frames = frames_in_words(stop - start)
    return BadRun(
        kind="swaps",
        marker=pair[0],
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-max(sure, 0.0) / 6.0)),
        deviation=away,
        reason=f"For {frames} {labels[pair[0]]} and {labels[pair[1]]}, "
        f"{away * recording.mm:.0f} mm apart, each continue the other's trajectory.",
        other=pair[1],
    )
