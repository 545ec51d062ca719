"""Wrong samples put right without new values: exchanged between markers, or set aside.

Three layers make what a repair is computed from: the samples as they were stored, the marker that
each of them belongs to, and the samples that nobody shall believe. Exchanging two markers is its
own inverse, so that un-swapping, merging the pieces of a trajectory and giving a piece to another
marker are one thing: a sample that is missing is exchanged like any other.
"""

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms.gaps import Gap, runs
from mocapmend_algorithms.recording import Recording


class Exchange(NamedTuple):
    """What two markers hold in the frames start to stop - 1 is exchanged; frames count from 0."""

    first: int
    second: int
    start: int
    stop: int


class Move(NamedTuple):
    """A marker holds in frames start to stop - 1 what was stored as another one, `origin`."""

    marker: int
    start: int
    stop: int
    origin: int

    @property
    def run(self) -> Gap:
        """Where it is."""
        return Gap(self.marker, self.start, self.stop)


def stored_places(shape: tuple[int, int]) -> NDArray[np.int32]:
    """Return the origins of samples that nobody has exchanged: each marker its own.

    Parameters
    ----------
    shape : tuple of int
        Frames and markers.

    Returns
    -------
    ndarray of int32, shape (frames, markers)
        For each sample the marker that it was stored as.
    """
    return np.tile(np.arange(shape[1], dtype=np.int32), (shape[0], 1))


def exchange(origins: NDArray[np.int32], exchanges: Iterable[Exchange]) -> None:
    """Exchange samples, in place and in the given order.

    Parameters
    ----------
    origins : ndarray of int32, shape (frames, markers)
        See `stored_places`; changed.
    exchanges : iterable of Exchange
        What to do.

    Raises
    ------
    ValueError
        If one is of a marker with itself, or outside the recording.
    """
    frames, markers = origins.shape
    for first, second, start, stop in exchanges:
        if not (0 <= first < markers and 0 <= second < markers and first != second):
            raise ValueError(
                f"markers {first} and {second} cannot be exchanged: there are {markers}"
            )
        if not 0 <= start < stop <= frames:
            raise ValueError(f"frames {start} to {stop - 1} are not all in {frames} frames")
        pair = [first, second]
        origins[start:stop, pair] = origins[start:stop, pair[::-1]]


def exchanges_between(now: NDArray[np.int32], wanted: NDArray[np.int32]) -> list[Exchange]:
    """Return exchanges that turn origins into others, by start.

    Parameters
    ----------
    now, wanted : ndarray of int32, shape (frames, markers)
        See `stored_places`.
    """
    made: list[Exchange] = []
    for start, stop in runs((now != wanted).any(axis=1)):
        part = slice(start, stop)
        changes = (np.diff(now[part], axis=0) != 0) | (np.diff(wanted[part], axis=0) != 0)
        cuts = start + 1 + np.flatnonzero(changes.any(axis=1))
        for a, b in pairwise((start, *cuts.tolist(), stop)):
            row, goal = now[a].copy(), wanted[a]
            for marker in np.flatnonzero(row != goal).tolist():
                holder = int(np.flatnonzero(row == goal[marker])[0])
                if holder != marker:
                    made.append(Exchange(marker, holder, a, b))
                    row[[marker, holder]] = row[[holder, marker]]
    return made


def moves(origins: NDArray[np.int32]) -> list[Move]:
    """Return what is not where it was stored, as runs by marker and start.

    Parameters
    ----------
    origins : ndarray of int32, shape (frames, markers)
        See `stored_places`.
    """
    found = []
    own = np.arange(origins.shape[1])
    for marker in np.flatnonzero((origins != own).any(axis=0)).tolist():
        there = origins[:, marker]
        for start, stop in runs(there != marker):
            cuts = start + 1 + np.flatnonzero(np.diff(there[start:stop]))
            ends = [start, *cuts.tolist(), stop]
            found += [Move(marker, a, b, int(there[a])) for a, b in pairwise(ends)]
    return found


def moved(origins: NDArray[np.int32], given: Iterable[Move]) -> None:
    """Write moves into origins, in place; the inverse of `moves`.

    Parameters
    ----------
    origins : ndarray of int32, shape (frames, markers)
        Those of samples that nobody has exchanged, see `stored_places`; changed.
    given : iterable of Move
        What is not where it was stored.

    Raises
    ------
    ValueError
        If one lies outside the recording, or if a sample would be in two places or in none.
    """
    frames, markers = origins.shape
    touched = np.zeros(frames, np.bool_)
    for move in given:
        inside = 0 <= move.start < move.stop <= frames
        if not (inside and 0 <= move.marker < markers and 0 <= move.origin < markers):
            raise ValueError(f"{move} is not in {frames} frames of {markers} markers")
        origins[move.start : move.stop, move.marker] = move.origin
        touched[move.start : move.stop] = True
    rows = np.sort(origins[touched], axis=1)
    if (rows != np.arange(markers)).any():
        raise ValueError("a sample would be in two places, or in none")


def places_now(origins: NDArray[np.int32]) -> NDArray[np.int32]:
    """Return the inverse of origins: for each stored sample the marker that holds it now."""
    now: NDArray[np.int32] = np.argsort(origins, axis=1).astype(np.int32)
    return now


def corrected(
    recording: Recording, exchanges: Iterable[Exchange], set_aside: Iterable[Gap]
) -> Recording:
    """Return a recording with samples exchanged, and then some missing.

    Parameters
    ----------
    recording : Recording
        As it was stored; not changed.
    exchanges : iterable of Exchange
        In this order.
    set_aside : iterable of Gap
        Runs that hold bad samples after that.

    Raises
    ------
    ValueError
        See `exchange`.
    """
    points = recording.points.copy()
    origins = stored_places(points.shape[:2])
    exchange(origins, exchanges)
    for move in moves(origins):
        part = slice(move.start, move.stop)
        points[part, move.marker] = recording.points[part, move.origin]
    for run in set_aside:
        points[run.start : run.stop, run.marker] = np.nan
    return recording.with_points(points)


def merged_runs(some: Iterable[Gap]) -> Iterator[Gap]:
    """Yield runs by marker and start, those that touch or overlap as one."""
    last: Gap | None = None
    for run in sorted(some):
        if last is not None and run.marker == last.marker and run.start <= last.stop:
            last = Gap(last.marker, last.start, max(last.stop, run.stop))
            continue
        if last is not None:
            yield last
        last = run
    if last is not None:
        yield last
