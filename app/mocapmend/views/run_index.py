"""Runs of many markers at once: which lanes and columns they touch, how much is missing. No Qt."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


class RunIndex:
    """The runs of all markers, end to end: one search serves all lanes of a picture.

    Parameters
    ----------
    runs : sequence of ndarray, each of shape (n, 2)
        Of each marker the disjoint half-open (start, stop) runs in ascending order.
    """

    def __init__(self, runs: Sequence[NDArray[np.int64]]) -> None:
        spans = np.concatenate(runs) if len(runs) else np.empty((0, 2), np.int64)
        self._markers = np.repeat(np.arange(len(runs)), [len(part) for part in runs])
        self._starts = np.ascontiguousarray(spans[:, 0])
        self._stops = np.ascontiguousarray(spans[:, 1])

    def cells(self, row_of: NDArray[np.intp], edges: NDArray[np.int64]) -> NDArray[np.intp]:
        """Return the cells of a picture that runs touch; what `columns_with` flags, for many rows.

        Parameters
        ----------
        row_of : ndarray, shape (markers,)
            The row of each marker's lane, negative where it is not shown.
        edges : ndarray, shape (width + 1,)
            As `column_edges` returns them.

        Returns
        -------
        ndarray
            Places in the flattened picture of shape (rows, width); two runs may share one.
        """
        first, end = edges[:-1], np.maximum(edges[1:], edges[:-1] + 1)
        rows = row_of[self._markers]
        seen = np.flatnonzero((rows >= 0) & (self._stops > first[0]) & (self._starts < end[-1]))
        begin = np.searchsorted(end, self._starts[seen], side="right")
        over = np.searchsorted(first, self._stops[seen], side="left")
        lengths = over - begin
        before = np.cumsum(lengths) - lengths
        places = rows[seen] * len(first) + begin - before
        return np.asarray(np.repeat(places, lengths) + np.arange(lengths.sum()))


def missing_share(
    runs: Sequence[NDArray[np.int64]], frames: int, edges: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return which share of the markers' samples is missing between each two edges.

    It costs as much as there are runs and edges, however many frames they span. Markers that are
    never seen do not count.

    Parameters
    ----------
    runs : sequence of ndarray, each of shape (n, 2)
        Of each marker the runs that are missing.
    frames : int
        Length of the recording.
    edges : ndarray, shape (width + 1,)
        Ascending, in frames; columns may be narrower than a frame.

    Returns
    -------
    ndarray, shape (width,)
    """
    seen = [part for part in runs if not (len(part) == 1 and part[0, 1] - part[0, 0] >= frames)]
    if not seen:
        return np.zeros(len(edges) - 1)
    starts, stops = np.sort(np.concatenate(seen), axis=0).T
    missing = _passed(starts, edges) - _passed(stops, edges)
    return np.diff(missing) / (np.diff(edges) * len(seen))


def _passed(ordered: NDArray[np.int64], edges: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the sum, over all places before each edge, of their distance to it."""
    sums = np.concatenate(([0], np.cumsum(ordered)))
    before = np.searchsorted(ordered, edges)
    return np.asarray(before * edges - sums[before])
