"""What neighbouring cycles of periodic motion say about missing frames."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, running_count

CYCLES_PER_SIDE = 2
MOST_TRIED = 12
TOLERANCE = 0.1
"""By how much a cycle may be longer or shorter than the period, as a share of it."""


@dataclass(frozen=True, eq=False)
class Place:
    """A gap, or a stretch that is hidden like one, and the frames beside it.

    Attributes
    ----------
    start, length : int
        The missing frames.
    beside : ndarray of int
        Observed frames near it, counted from its start, ascending.
    """

    start: int
    length: int
    beside: IntArray

    @property
    def edges(self) -> list[int]:
        """The last frame before and the first after it, as indices into `beside`."""
        after = int(np.searchsorted(self.beside, 0))
        return [i for i in (after - 1, after) if 0 <= i < self.beside.size]


def from_cycles(
    points: FloatArray, seen: BoolArray, place: Place, period: float
) -> tuple[FloatArray, list[int], float] | None:
    """Fill missing frames with the mean of neighbouring cycles.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        Trajectory of the marker.
    seen : ndarray of bool, shape (frames,)
        The samples that may be used.
    place : Place
        What is missing.
    period : float
        In frames.

    Returns
    -------
    values : ndarray, shape (length, 3)
        The mean of up to two cycles on either side, of the nearest twelve.
    lags : list of int
        By how many frames they lie later.
    misfit : float
        RMS distance between the marker and the cycles beside the gap, in the recording's unit.
        The result is None where no cycle is complete.
    """
    first = max(1, int(place.length / ((1 + TOLERANCE) * period)))
    reach = int(TOLERANCE * period)
    nearest_first = np.array(sorted(range(-reach, reach + 1), key=abs))
    counts = running_count(seen)
    found = []
    for direction in (-1, 1):
        wanted = direction * period * np.arange(first, first + MOST_TRIED)
        lags = wanted.round().astype(np.int64)[:, None] + nearest_first
        complete = _complete(counts, place, lags)
        # What is cut off at the very lag of a period would be matched at a wrong one.
        nearest = np.flatnonzero(complete[:, 0])[:CYCLES_PER_SIDE]
        found += [_fitted(points, place, lags[number, complete[number]]) for number in nearest]
    if not found:
        return None
    values = np.mean([values for values, _, _ in found], axis=0)
    misfit = float(np.sqrt(np.mean([square for _, _, square in found])))
    return values, [lag for _, lag, _ in found], misfit


def _complete(counts: IntArray, place: Place, lags: IntArray) -> BoolArray:
    """Say at which lags all is seen from the first to the last frame that a place needs."""
    first = place.start + min(0, int(place.beside[0]))
    stop = place.start + max(place.length, int(place.beside[-1]) + 1)
    inside = (lags + first >= 0) & (lags + stop < counts.size)
    inside[inside] = counts[lags[inside] + stop] - counts[lags[inside] + first] == stop - first
    complete: BoolArray = inside
    return complete


def _fitted(points: FloatArray, place: Place, lags: IntArray) -> tuple[FloatArray, int, float]:
    """Return the best cycle fitted into a place, its lag and its mean squared misfit beside it."""
    beside = place.start + place.beside
    left_over = points[beside] - points[lags[:, None] + beside]
    unexplained = left_over - left_over.mean(axis=1, keepdims=True)
    two_sided = len(place.edges) == 2
    if two_sided:
        slope = place.beside - place.beside.mean()
        slope = slope / np.linalg.norm(slope)
        unexplained -= slope[:, None] * np.einsum("c,lci->li", slope, unexplained)[:, None]
    misfit = np.mean(np.sum(unexplained**2, axis=2), axis=1)
    best = int(np.argmin(misfit))
    moved: FloatArray = points[place.start + lags[best] + np.arange(place.length)]
    residual = left_over[best, place.edges]
    if two_sided:
        first, last = place.beside[place.edges]
        share = ((np.arange(place.length) - first) / (last - first))[:, None]
        residual = (1 - share) * residual[0] + share * residual[1]
    return moved + residual, int(lags[best]), float(misfit[best])
