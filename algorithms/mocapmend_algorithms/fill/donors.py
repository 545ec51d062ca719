"""Donors: the markers from whose motion a missing marker's place is computed.

A good donor keeps its distance to the marker, is near it, and is seen while the marker is missing.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.each import LeftOpenError
from mocapmend_algorithms.gaps import Gap

MOST_FRAMES = 600
Seen = Callable[[int], BoolArray]
"""Whether each sample of a marker may be looked at, shape (frames,)."""

LEAST_TOGETHER = 3
CLIPPED = (0.01, 0.99)
MOST_CORNERS = 8
FLAT = 0.05
"""Height of a triangle relative to its longest side, below which its corners are in one line."""


@dataclass(frozen=True, eq=False)
class Donors:
    """Markers and how they move with another one.

    Attributes
    ----------
    markers : ndarray of int, shape (donors,)
        Indices of markers.
    spread : ndarray, shape (donors,)
        Standard deviation of the distance to the marker (mm).
    distance : ndarray, shape (donors,)
        Mean distance to the marker (mm).
    """

    markers: IntArray
    spread: FloatArray
    distance: FloatArray

    def __len__(self) -> int:
        return int(self.markers.size)

    def best(self, count: int, nearness: float = 0.0) -> IntArray:
        """Return the places of the best donors in `markers`, best first.

        Parameters
        ----------
        count : int
            How many at most.
        nearness : float
            What a millimetre of distance counts beside one of spread.
        """
        return np.argsort(self.spread + nearness * self.distance, kind="stable")[:count]

    def __getitem__(self, chosen: IntArray | BoolArray) -> "Donors":
        """Return some of the donors."""
        return Donors(self.markers[chosen], self.spread[chosen], self.distance[chosen])


class DonorDistances:
    """How far apart the markers of a recording are, as a measure of how well they are donors.

    Donors are ranked and weighted by it, not admitted: so the spread is a standard deviation, to
    which a swing in a few frames adds its part, with only 1 % clipped off at each end for spikes,
    over up to 600 frames; three frames together are enough, as the fill is tested anyway.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        In mm.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    """

    def __init__(self, points: FloatArray, observed: BoolArray) -> None:
        self._points = points
        self._observed = observed
        self._known: dict[int, Donors] = {}

    def to(self, marker: int) -> Donors:
        """Return all markers that are seen together with one, as its possible donors."""
        if marker not in self._known:
            self._known[marker] = self._measure(marker)
        return self._known[marker]

    def triangle(self, donors: Donors) -> IntArray:
        """Return the places of the best three donors, which show a turn: not those in one line.

        Where all are in one line, they are the best three all the same.
        """
        order = donors.best(MOST_CORNERS)
        corners = sorted(combinations(range(order.size), 3), key=max)
        triples = [order[list(triple)] for triple in corners]
        wide = (triple for triple in triples if not self._in_line(donors.markers[triple]))
        return next(wide, order[:3])

    def _in_line(self, triple: IntArray) -> bool:
        a, b, c = sorted(self._apart(*pair) for pair in combinations(triple.tolist(), 2))
        half = (a + b + c) / 2
        square = half * (half - a) * (half - b) * (half - c)
        height = 2 * math.sqrt(max(square, 0.0)) / (c or 1.0)
        return height <= FLAT * c

    def _apart(self, one: int, other: int) -> float:
        known = self.to(one)
        return float(known.distance[known.markers == other].sum())

    def _measure(self, marker: int) -> Donors:
        frames = np.flatnonzero(self._observed[:, marker])
        frames = frames[np.unique(np.linspace(0, frames.size - 1, MOST_FRAMES).astype(np.int64))]
        seen = self._observed[frames]
        apart = self._points[frames] - self._points[frames, marker][:, None]
        together = seen.sum(axis=0)
        together[marker] = 0
        others = np.flatnonzero(together >= LEAST_TOGETHER)
        square = np.einsum("fmi,fmi->fm", apart[:, others], apart[:, others])
        distance = np.sort(np.where(seen[:, others], np.sqrt(square), np.inf), axis=0)
        count = together[others]
        # Single spikes must not hide that two markers belong together.
        ends = np.round(np.multiply.outer(CLIPPED, count - 1)).astype(np.int64)
        low, high = np.take_along_axis(distance, ends, axis=0)
        real = np.isfinite(distance)
        clipped = np.where(real, np.clip(distance, low, high), 0.0)
        mean = clipped.sum(axis=0) / count
        around = np.where(real, clipped - mean, 0.0)
        return Donors(others, np.sqrt((around**2).sum(axis=0) / count), mean)


def by_label(known: Sequence[str], labels: Sequence[str]) -> IntArray:
    """Find the markers that a user names as donors.

    Parameters
    ----------
    known : sequence of str
        The labels of a recording.
    labels : sequence of str
        Those of the donors; case matters.

    Returns
    -------
    ndarray of int

    Raises
    ------
    LeftOpenError
        If there is no marker of that label, or more than one.
    """
    found = []
    for label in labels:
        count = known.count(label)
        if not count:
            raise LeftOpenError(f"there is no marker {label} to take as a donor")
        if count > 1:
            raise LeftOpenError(f"{count} markers are called {label}: it cannot be a donor")
        found.append(known.index(label))
    return np.array(found, dtype=np.int64)


def check_seen(
    labels: Sequence[str], seen: Seen, gap: Gap, donors: IntArray, *, at_edges: bool
) -> None:
    """Make sure that donors are seen throughout a gap.

    Parameters
    ----------
    labels : sequence of str
        Of all markers.
    seen : callable
        Whether each sample of a marker may be looked at, shape (frames,).
    gap : Gap
        To be filled.
    donors : ndarray of int
        The donors.
    at_edges : bool
        Whether they must be seen at the frames before and after the gap too.

    Raises
    ------
    LeftOpenError
        If one is not, or is the marker itself.
    """
    for marker in donors.tolist():
        label = labels[marker]
        if marker == gap.marker:
            raise LeftOpenError(f"{label} cannot be its own donor")
        there = seen(marker)
        if not there[gap.start : gap.stop].all():
            raise LeftOpenError(f"the donor {label} is missing in the gap too")
        if at_edges and not edges_seen(there, gap):
            raise LeftOpenError(f"the donor {label} is missing at an edge of the gap")


def edges_seen(observed: BoolArray, gap: Gap) -> BoolArray:
    """Return whether a marker, or which of several, are seen just before and after a gap."""
    edges = [frame for frame in (gap.start - 1, gap.stop) if 0 <= frame < observed.shape[0]]
    seen: BoolArray = np.logical_and.reduce(observed[edges])
    return seen
