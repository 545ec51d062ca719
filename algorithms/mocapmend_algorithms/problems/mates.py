"""Which markers move with a marker, and what they do in some frames."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.problems.distances import distances_of
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS

MOST_MATES = 4
FURTHEST_MM = 500.0


def nearest_mates(distances: PairDistances | None, markers: int) -> list[list[int]]:
    """List for each marker up to four others that stay the closest to it, the closest first.

    Parameters
    ----------
    distances : PairDistances or None
        Of all pairs; None where there are too many markers to measure.
    markers : int
        Number of markers.

    Returns
    -------
    list of list of int
        None is further than 500 mm.
    """
    if distances is None:
        return [[] for _ in range(markers)]
    cost = distances.length + 4.0 * distances.spread
    cost[np.isnan(cost) | (distances.length > FURTHEST_MM)] = np.inf
    np.fill_diagonal(cost, np.inf)
    order = np.argsort(cost, axis=1, kind="stable")[:, :MOST_MATES]
    return [
        [int(other) for other in order[marker] if np.isfinite(cost[marker, other])]
        for marker in range(markers)
    ]


def mates_of(recording: Recording, progress: Progress) -> list[list[int]]:
    """Measure the distances of all markers and list the nearest mates of each.

    There are none where there are too many markers to measure.
    """
    if recording.markers > MOST_MARKERS:
        return nearest_mates(None, recording.markers)
    return nearest_mates(distances_of(recording, progress), recording.markers)


def common_offset(offsets: list[FloatArray]) -> FloatArray | None:
    """Return the median of what mates do at the same time, per frame and axis.

    Parameters
    ----------
    offsets : list of ndarray, shape (frames, 3)
        Of each mate, NaN = unknown.

    Returns
    -------
    ndarray, shape (frames, 3) or None
        None where fewer than two of them are known throughout.
    """
    known = [offset for offset in offsets if not np.isnan(offset).any()]
    if len(known) < 2:
        return None
    middle: FloatArray = np.median(np.stack(known), axis=0)
    return middle
