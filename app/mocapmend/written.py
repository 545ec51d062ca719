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


def differing_runs(
    values: NDArray[np.float64], stored: NDArray[np.float64], places: Places
) -> Iterator[SampleRun]:
    """Yield the runs in which samples differ from those of a recording.

    Parameters
    ----------
    values : ndarray, shape (n, 3)
        The samples; the runs hold them.
    stored : ndarray, shape (frames, markers, 3)
        The recording.
    places : Places
        Where the samples are; a place that is there twice has the same twice.

    Yields
    ------
    SampleRun
        As long as can be; by marker and start.
    """
    differs = _differ(values, stored[places])
    frames, markers = (part[differs] for part in places)
    # The end of one marker and the start of the next are no neighbours.
    row = len(stored) + 1
    order, first = np.unique(markers * row + frames, return_index=True)
    if not order.size:
        return
    samples = values[differs][first]
    begins = np.concatenate(([0], np.flatnonzero(np.diff(order) != 1) + 1))
    ends = np.append(begins[1:], len(order))
    for begin, end in zip(begins.tolist(), ends.tolist(), strict=True):
        marker, start = divmod(int(order[begin]), row)
        yield SampleRun(marker, start, samples[begin:end])


def _differ(some: NDArray[np.float64], others: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Say which of some samples, shape (n, 3), differ in any bit from others."""
    x, y, z = (some.view(np.int64) != others.view(np.int64)).T
    return np.asarray(x | y | z)
