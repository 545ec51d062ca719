"""A skeleton from the distances of unlabelled markers."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton.distances import (
    MOST_MARKERS,
    PairDistances,
    measure_distances,
)
from mocapmend_algorithms.skeleton.model import Bone, Segment, Skeleton
from mocapmend_algorithms.skeleton.segments import find_segments

SPREAD_FLOOR_MM = 0.6
LENGTH_POWER = 1.5
LOOSEST = 0.1
"""Spread of a bone between two segments, as a share of its length."""
LONGEST_MM = 700.0
MOST_BONES = 3
CLOSING_REACH = 1.6
"""A further bone is at most so much longer than the longest of the tree at either end."""


def skeleton_from_distances(recording: Recording, progress: Progress) -> Skeleton:
    """Find segments, and bones within and between them.

    Within a segment, the shortest and most rigid pairs that join all of its markers, and further
    ones near by, up to three bones per marker. Between segments, a minimum spanning tree: each is
    joined to a neighbour by one bone, if that nearly keeps its length. So several bodies, or a
    body and an object, stay apart.

    Parameters
    ----------
    recording : Recording
        About 300 of its frames are looked at.
    progress : Progress
        Called once per marker.

    Returns
    -------
    Skeleton
        Without bones, and source "none", where nothing keeps its distance or there are more than
        1000 markers. Markers that are hardly seen get no bone.
    """
    if recording.markers > MOST_MARKERS:
        return Skeleton("", (), "none")
    distances = measure_distances(recording, progress)
    segments = find_segments(distances)
    home = {marker: number for number, part in enumerate(segments) for marker in part.markers}
    pairs = _by_cost(distances)
    within = [(a, b) for a, b in pairs if home[a] == home[b]]
    between = [(a, b) for a, b in pairs if home[a] != home[b] and _keeps_length(distances, (a, b))]
    bones = _spanning_tree(within, {marker: marker for marker in home})
    bones += _closing(bones, within, distances)
    bones += _spanning_tree(between, home)
    ordered = tuple(sorted(bones))
    return Skeleton("", ordered, "distances" if ordered else "none", segments)


def joining_bones(distances: PairDistances) -> tuple[list[Bone], list[Bone]]:
    """Join all markers to one tree, and name the rigid pairs beside it.

    Parameters
    ----------
    distances : PairDistances
        Of all pairs.

    Returns
    -------
    tree : list of Bone
        A minimum spanning tree: short and rigid pairs first, and loose ones where nothing else
        joins two groups. One tree for each group of markers that is never seen with the others.
    rigid : list of Bone
        Further pairs within the segments, up to three bones per marker.
    """
    segments = find_segments(distances)
    home = {marker: number for number, part in enumerate(segments) for marker in part.markers}
    pairs = _by_cost(distances)
    tree = _spanning_tree(pairs, {marker: marker for marker in home})
    within = [(a, b) for a, b in pairs if home[a] == home[b]]
    return tree, _closing(tree, within, distances)


def segments_from_distances(recording: Recording, progress: Progress) -> tuple[Segment, ...]:
    """Find the segments alone; none where there are more than 1000 markers."""
    if recording.markers > MOST_MARKERS:
        return ()
    return find_segments(measure_distances(recording, progress))


def _by_cost(distances: PairDistances) -> list[Bone]:
    """Order all pairs: short and rigid ones first."""
    first, second = np.nonzero(np.triu(distances.known))
    cost = _cost(distances.length[first, second], distances.spread[first, second])
    order = np.argsort(cost, kind="stable")
    return list(zip(first[order].tolist(), second[order].tolist(), strict=True))


def _cost(length: FloatArray, spread: FloatArray) -> FloatArray:
    cost: FloatArray = (spread + SPREAD_FLOOR_MM) * length**LENGTH_POWER
    return cost


def _keeps_length(distances: PairDistances, pair: Bone) -> bool:
    length, spread = distances.length[pair], distances.spread[pair]
    return bool(0 < length <= LONGEST_MM and spread <= LOOSEST * length)


def _spanning_tree(pairs: Sequence[Bone], groups: dict[int, int]) -> list[Bone]:
    """Kruskal's tree (forest) over groups of markers: pairs in ascending order of cost."""
    parent = {group: group for group in groups.values()}

    def root(marker: int) -> int:
        group = groups[marker]
        while parent[group] != group:
            parent[group] = parent[parent[group]]
            group = parent[group]
        return group

    tree = []
    for pair in pairs:
        a, b = root(pair[0]), root(pair[1])
        if a != b:
            parent[a] = b
            tree.append(pair)
    return tree


def _closing(tree: Sequence[Bone], pairs: Sequence[Bone], distances: PairDistances) -> list[Bone]:
    """Choose further pairs as long as one of the two markers has few bones, and none too long."""
    degree: dict[int, int] = {}
    reach: dict[int, float] = {}
    for pair in tree:
        for marker in pair:
            degree[marker] = degree.get(marker, 0) + 1
            reach[marker] = max(reach.get(marker, 0.0), CLOSING_REACH * distances.length[pair])
    taken = set(tree)
    extra = []
    for a, b in pairs:
        if (
            (a, b) not in taken
            and min(degree[a], degree[b]) < MOST_BONES
            and distances.length[a, b] <= min(reach[a], reach[b])
        ):
            extra.append((a, b))
            degree[a] += 1
            degree[b] += 1
    return extra
