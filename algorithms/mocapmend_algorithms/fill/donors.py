"""Donors: the markers from whose motion a missing marker's place is computed.

A good donor keeps its distance to the marker, is near it, and is seen while the marker is missing.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.gaps import Gap

MOST_FRAMES = 600
LEAST_TOGETHER = 3
MOST_CORNERS = 8
FLAT = 0.05
"""Height of a triangle relative to its longest side, below which its corners are in one line."""


class NoDonorsError(ValueError):
    """No donors for a gap; the message says why, in words a user understands."""


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


class Distances:
    """Distances between the markers of a recording, measured on up to 600 of its frames.

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
        sides = sorted(self._apart(*pair) for pair in combinations(triple.tolist(), 2))
        half = sum(sides) / 2
        square = half * math.prod(half - side for side in sides)
        height = 2 * math.sqrt(max(square, 0.0)) / (sides[-1] or 1.0)
        return height <= FLAT * sides[-1]

    def _apart(self, one: int, other: int) -> float:
        known = self.to(one)
        return float(known.distance[known.markers == other].sum())

    def _measure(self, marker: int) -> Donors:
        frames = np.flatnonzero(self._observed[:, marker])
        frames = frames[np.unique(np.linspace(0, frames.size - 1, MOST_FRAMES).astype(np.int64))]
        seen = self._observed[frames]
        apart = self._points[frames] - self._points[frames, marker][:, None]
        distance = np.where(seen, np.sqrt(np.einsum("fmi,fmi->fm", apart, apart)), 0.0)
        together = seen.sum(axis=0)
        together[marker] = 0
        others = np.flatnonzero(together >= LEAST_TOGETHER)
        count = together[others]
        mean = distance[:, others].sum(axis=0) / count
        around = np.where(seen[:, others], distance[:, others] - mean, 0.0)
        spread = np.sqrt((around**2).sum(axis=0) / count)
        return Donors(others, spread, mean)


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
    NoDonorsError
        If there is no marker of that label, or more than one.
    """
    found = []
    for label in labels:
        count = known.count(label)
        if not count:
            raise NoDonorsError(f"there is no marker {label} to take as a donor")
        if count > 1:
            raise NoDonorsError(f"{count} markers are called {label}: it cannot be a donor")
        found.append(known.index(label))
    return np.array(found, dtype=np.int64)


def check_seen(
    labels: Sequence[str], observed: BoolArray, gap: Gap, donors: IntArray, *, at_edges: bool
) -> None:
    """Make sure that donors are seen throughout a gap.

    Parameters
    ----------
    labels : sequence of str
        Of all markers.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    gap : Gap
        To be filled.
    donors : ndarray of int
        The donors.
    at_edges : bool
        Whether they must be seen at the frames before and after the gap too.

    Raises
    ------
    NoDonorsError
        If one is not, or is the marker itself.
    """
    for marker in donors.tolist():
        label = labels[marker]
        if marker == gap.marker:
            raise NoDonorsError(f"{label} cannot be its own donor")
        if not observed[gap.start : gap.stop, marker].all():
            raise NoDonorsError(f"the donor {label} is missing in the gap too")
        if at_edges and not edges_seen(observed, gap)[marker]:
            raise NoDonorsError(f"the donor {label} is missing at an edge of the gap")


def edges_seen(observed: BoolArray, gap: Gap) -> BoolArray:
    """Return which markers are seen at the frames before and after a gap."""
    edges = [frame for frame in (gap.start - 1, gap.stop) if 0 <= frame < observed.shape[0]]
    seen: BoolArray = np.logical_and.reduce(observed[edges])
    return seen
