"""Points without a label, and labels that come twice: pieces of a marker's trajectory, or ghosts.

A piece fits into a gap of a marker: its distances to the neighbours are those of the marker, and
it goes on where the marker was lost.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.names import is_unlabelled
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.problems.rigid_mates import RigidMates, rigid_mates
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

MOST_OVERLAP = 0.1
"""Of a piece: the frames in which the marker is seen elsewhere."""
LOOKED_AT = 16
FLOOR_MM = 6.0
"""A distance may be wrong by so much whatever it usually is."""
MOST_OFF = 3.0
CLEARLY = 0.5
"""By how much worse the second best marker fits."""
NEAR_FRAMES = 30
"""Frames over which a trajectory can be carried on."""
START_MM, START_PER_FRAME = 8.0, 0.5
"""How wrong that is: at first, and more by a part of each further frame's step."""
MOST_UNNAMED = 0.6
"""Of the points: where more have no label, there is nothing that they could belong to."""


@dataclass(frozen=True)
class FragmentsParams:
    """Parameters of `fragments`."""

    ghosts: bool = option(
        default=True,
        label="List ghosts",
        text="Also list points without a label that fit no marker.",
    )


class _Candidate(NamedTuple):
    off: float
    marker: int


def fragments(
    recording: Recording, skeleton: Skeleton, params: FragmentsParams, progress: Progress
) -> list[BadRun]:
    """Find points without a label, or with one that another has, that are pieces of a marker.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Its bones count first.
    params : FragmentsParams
        Whether ghosts are listed.
    progress : Progress
        Called once per point without a label.

    Returns
    -------
    list of BadRun
        Ordered by marker and start; `other` is the marker that the piece belongs to, None for a
        ghost. How far a piece is from the truth is not known.
    """
    pieces = _pieces_of(recording)
    named = [m for m in np.flatnonzero(recording.present.any(axis=0)).tolist() if m not in pieces]
    progress(0.0)
    if not 0 < len(pieces) <= MOST_UNNAMED * recording.markers <= MOST_UNNAMED * MOST_MARKERS:
        return []
    distances = distances_of(recording, part(progress, 0.0, 0.3))
    mates = {marker: rigid_mates(recording, distances, skeleton, marker) for marker in named}
    mates = {marker: _named_only(each, pieces) for marker, each in mates.items()}
    found = []
    for count, piece in enumerate(pieces):
        progress(0.3 + 0.7 * count / len(pieces))
        for start, stop in runs(recording.present[:, piece]):
            ranked = _ranked(recording, mates, piece, start, stop)
            run = _described(recording, piece, start, stop, ranked)
            if run.other is not None or (params.ghosts and is_unlabelled(recording.labels[piece])):
                found.append(run)
    return found


def _pieces_of(recording: Recording) -> list[int]:
    """List the points without a label, and of those with the same one all but the most seen."""
    seen = recording.present.sum(axis=0)
    best: dict[str, int] = {}
    for marker, label in enumerate(recording.labels):
        if not is_unlabelled(label) and seen[marker] > seen[best.get(label, marker)]:
            best[label] = marker
        best.setdefault(label, marker)
    return [
        marker
        for marker, label in enumerate(recording.labels)
        if seen[marker] and (is_unlabelled(label) or best[label] != marker)
    ]


def _named_only(mates: RigidMates, pieces: Sequence[int]) -> RigidMates:
    kept = [at for at, mate in enumerate(mates.markers) if mate not in pieces]
    return RigidMates([mates.markers[at] for at in kept], mates.length[kept], mates.spread[kept])


def _ranked(
    recording: Recording, mates: dict[int, RigidMates], piece: int, start: int, stop: int
) -> list[_Candidate]:
    """Rank the markers that miss these frames by how badly the piece fits."""
    share = recording.present[start:stop].mean(axis=0)
    frames = np.unique(np.linspace(start, stop - 1, LOOKED_AT).round().astype(np.int64))
    candidates = []
    for marker, each in mates.items():
        if share[marker] > MOST_OVERLAP:
            continue
        off = _off(recording, each, recording.points[frames, piece], frames)
        carried = [
            _carried_off(recording, marker, piece, start, -1),
            _carried_off(recording, marker, piece, stop - 1, 1),
        ]
        parts = [value for value in (off, *carried) if not np.isnan(value)]
        if parts:
            candidates.append(_Candidate(float(np.mean(parts)), marker))
    return sorted(candidates)


def _off(recording: Recording, mates: RigidMates, own: FloatArray, frames: IntArray) -> float:
    """Return by how much the distances to a marker's neighbours are off, in usual deviations."""
    around = recording.points[frames[:, None], mates.markers]
    apart = (around - own[:, None]) * recording.mm
    length = np.sqrt(np.einsum("nmk,nmk->nm", apart, apart))
    off = np.abs(length - mates.length) / np.hypot(mates.spread, FLOOR_MM)
    off = off[~np.isnan(off)]
    return float(np.minimum(off, 20.0).mean()) if off.size else float("nan")


def _carried_off(recording: Recording, marker: int, piece: int, end: int, direction: int) -> float:
    """Return how far one end of a piece is from where the marker was lost, in usual deviations."""
    reach = end + direction * np.arange(1, NEAR_FRAMES + 1)
    reach = reach[(reach >= 0) & (reach < recording.frames)]
    seen = np.flatnonzero(recording.present[reach, marker])
    if not seen.size:
        return float("nan")
    away = int(seen[0]) + 1
    there = recording.points[reach[seen[0]], marker] * recording.mm
    here = recording.points[end, piece] * recording.mm
    inside = min(max(end - direction, 0), recording.frames - 1)
    step = here - recording.points[inside, piece] * recording.mm
    step = np.zeros(3) if np.isnan(step).any() else step
    error = float(np.linalg.norm(here + away * step - there))
    usual = START_MM + START_PER_FRAME * (away - 1) * (float(np.linalg.norm(step)) + 1.0)
    return min(error / usual, 20.0)


def _described(
    recording: Recording, piece: int, start: int, stop: int, ranked: Sequence[_Candidate]
) -> BadRun:
    margin = ranked[1].off - ranked[0].off if len(ranked) > 1 else MOST_OFF
    fits = bool(ranked) and ranked[0].off <= MOST_OFF and margin >= CLEARLY
    frames = frames_in_words(stop - start)
    if not fits:
        sure = min(ranked[0].off / MOST_OFF, 2.0) / 2.0 if ranked else 1.0
        reason = f"It is seen for {frames} and {_why_not(recording, ranked)}."
        return BadRun("fragments", piece, start, stop, 0.5 * sure, float("nan"), reason)
    label = recording.labels[ranked[0].marker]
    rest = f"the next marker by {ranked[1].off:.1f}" if len(ranked) > 1 else "no other is missing"
    return BadRun(
        kind="fragments",
        marker=piece,
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-margin)),
        deviation=float("nan"),
        reason=f"For {frames} it fits into a gap of {label}: it is off by {ranked[0].off:.1f} "
        f"times what is usual, {rest}.",
        other=ranked[0].marker,
    )


def _why_not(recording: Recording, ranked: Sequence[_Candidate]) -> str:
    if not ranked:
        return "no marker is missing there that it could be"
    first = recording.labels[ranked[0].marker]
    if ranked[0].off > MOST_OFF:
        return f"fits no marker: {first} comes nearest, off by {ranked[0].off:.1f} times the usual"
    second = recording.labels[ranked[1].marker]
    return f"may be {first} or {second}: it fits both about as well"
