"""Groups of markers that move as one."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.skeleton.distances import PairDistances
from mocapmend_algorithms.skeleton.model import Segment

MOST_SPREAD_MM = 10.0
"""Skin slides on a bone by some millimetres, however far apart two markers are."""
MOST_SPREAD = 0.08
"""Of the distance, for markers close together."""
FAR_MM = 300.0
"""Further apart, less is allowed: an arm and a leg may keep their distance through a whole walk."""


def looseness(distances: PairDistances) -> FloatArray:
    """Say how far each pair of markers is from being rigid.

    Parameters
    ----------
    distances : PairDistances
        Of all pairs.

    Returns
    -------
    ndarray, shape (markers, markers)
        The spread as a share of what a rigid pair may have: 8 % of its length, but at most 10 mm,
        and beyond 300 mm less in proportion. Rigid up to 1, infinite where unknown.
    """
    known = distances.known
    far = np.minimum(1.0, FAR_MM / np.maximum(distances.length, 1.0))
    allowed = np.minimum(MOST_SPREAD_MM * far, MOST_SPREAD * distances.length)
    share: FloatArray = np.full(known.shape, np.inf)
    # Two labels of the same place are rigid.
    share[known] = distances.spread[known] / np.maximum(allowed[known], 1e-9)
    np.fill_diagonal(share, 0.0)
    return share


def find_segments(distances: PairDistances) -> tuple[Segment, ...]:
    """Gather markers that are all rigid to each other.

    Clusters of complete linkage: the two groups whose loosest pair is the most rigid are joined,
    again and again, while that pair is rigid.

    Parameters
    ----------
    distances : PairDistances
        Of all pairs. Markers that have none are in no segment.

    Returns
    -------
    tuple of Segment
        Ordered by their first marker. A recording without motion is one segment: nothing in it
        tells one limb from the next.
    """
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import squareform

    markers = np.flatnonzero(distances.known.any(axis=1))
    if not markers.size:
        return ()
    share = looseness(distances)[np.ix_(markers, markers)]
    tree = linkage(squareform(np.minimum(share, 1e6), checks=False), "complete")
    cluster = fcluster(tree, 1.0, "distance")
    groups: dict[int, list[int]] = {}
    for marker, number in zip(markers.tolist(), cluster.tolist(), strict=True):
        groups.setdefault(number, []).append(marker)
    return tuple(Segment(tuple(group)) for group in sorted(groups.values()))


@dataclass(frozen=True)
class Mate:
    """Another marker of the same segment.

    Attributes
    ----------
    marker : int
        Its index.
    length, spread : float
        Median and robust standard deviation of the distance to it, in mm.
    """

    marker: int
    length: float
    spread: float


def segment_mates(
    distances: PairDistances, segments: Sequence[Segment]
) -> dict[int, tuple[Mate, ...]]:
    """List the other markers of each marker's segment, the most rigid first.

    Parameters
    ----------
    distances : PairDistances
        Of all pairs.
    segments : sequence of Segment
        Found from these distances or a template's.

    Returns
    -------
    dict of int to tuple of Mate
        One entry for each marker that is in a segment. Mates never seen together are left out.
    """
    mates = {}
    for segment in segments:
        for marker in segment.markers:
            others = [
                Mate(other, distances.length[marker, other], distances.spread[marker, other])
                for other in segment.markers
                if other != marker and distances.known[marker, other]
            ]
            mates[marker] = tuple(sorted(others, key=lambda mate: (mate.spread, mate.marker)))
    return mates
