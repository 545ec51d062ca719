"""Samples of many runs at once: a loop over ten thousand runs would be felt. No Qt."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from mocapmend.files import SampleRun
from mocapmend_algorithms import Gap

Places = tuple[NDArray[np.int64], NDArray[np.int64]]
"""Frames and markers of samples, each of shape (n,): the index into an array of samples."""


def places_of(runs: Iterable[Gap]) -> Places:
    """Return where the samples of some runs are, one run after another."""
    corners = np.array([(run.marker, run.start, run.stop) for run in runs], np.int64)
    marker, start, stop = corners.reshape(-1, 3).T
    lengths = stop - start
    begins = np.cumsum(lengths) - lengths
    frames = np.arange(lengths.sum()) + np.repeat(start - begins, lengths)
    return frames, np.repeat(marker, lengths)


def shares_of(runs: Sequence[Gap]) -> Iterator[slice]:
    """Yield the part of these samples that each run has."""
    start = 0
    for run in runs:
        yield slice(start, start + run.length)
        start += run.length


def differing(points: NDArray[np.float64], stored: NDArray[np.float64], places: Places) -> Places:
    """Return those places at which two recordings differ in any bit: NaN is not equal to itself.

    Parameters
    ----------
    points, stored : ndarray, shape (frames, markers, 3)
        The recordings.
    places : Places
        Where to look.
    """
    differs = (points[places].view(np.int64) != stored[places].view(np.int64)).any(axis=1)
    frames, markers = places
    return frames[differs], markers[differs]


def differing_runs(
    points: NDArray[np.float64], stored: NDArray[np.float64], places: Places
) -> Iterator[SampleRun]:
    """Yield the runs in which two recordings differ.

    Parameters
    ----------
    points, stored : ndarray, shape (frames, markers, 3)
        The recordings; the runs hold the samples of the first.
    places : Places
        Where to look.

    Yields
    ------
    SampleRun
        As long as can be; by marker and start.
    """
    frames, markers = differing(points, stored, places)
    # The end of one marker and the start of the next are no neighbours.
    row = len(points) + 1
    order = np.unique(markers * row + frames)
    if not order.size:
        return
    for run in np.split(order, np.flatnonzero(np.diff(order) != 1) + 1):
        marker, start = divmod(int(run[0]), row)
        yield SampleRun(marker, start, points[start : start + len(run), marker].copy())
