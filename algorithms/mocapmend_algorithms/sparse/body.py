"""The bones that sparse recovery works with: a tree over all markers, its parts, its lengths.

W18 = Wang, Lu, Han 2018, Computer Systems & Applications 27(5):17-25. Its body has the 31 joints of
the CMU database, five chains of bones (its figure 2) and five parts, each of which is recovered
from a triple of parts (its tables 1 and 2). What its print gets wrong is set right here:

- the predecessor in a chain is not always the parent: the thumbs hang from the wrists, both hips
  and the lower back from the root, both clavicles from the thorax;
- table 1 lists the right arm without its joint 28 (the right wrist): by symmetry its bones are
  those of the left arm;
- in table 2 the triples of the right arm and the left leg lack their own part: each triple is the
  part itself, the trunk and one more.

In other recordings a minimum spanning tree over all markers stands for the chains, with further
rigid pairs beside it, and the tree's branches for the parts.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.progress import no_progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import joining_bones, measure_distances
from mocapmend_algorithms.skeleton.distances import MOST_MARKERS
from mocapmend_algorithms.skeleton.projection import BoneConstraints

TRUNK = ("root", "lowerback", "upperback", "thorax", "lowerneck", "upperneck", "head")
LEFT_LEG = ("lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes")
LEFT_ARM = ("lclavicle", "lhumerus", "lradius", "lwrist", "lhand", "lfingers", "lthumb")
RIGHT_LEG = tuple("r" + name[1:] for name in LEFT_LEG)
RIGHT_ARM = tuple("r" + name[1:] for name in LEFT_ARM)
PARTS = (TRUNK, LEFT_ARM, RIGHT_ARM, LEFT_LEG, RIGHT_LEG)
HANGS_FROM = {
    "lhipjoint": "root",
    "rhipjoint": "root",
    "lclavicle": "thorax",
    "rclavicle": "thorax",
    "lthumb": "lwrist",
    "rthumb": "rwrist",
}
"""Joints whose parent is not the one before them in their part."""
TRIPLES = ((1, 0, 3), (1, 0, 2), (2, 0, 1), (3, 0, 2), (4, 0, 3))
"""For each part the parts that it is recovered from: itself, the trunk and one more."""
LEAST_SPREAD_MM = 0.5
EXACT_MM = 0.05
"""Bones whose length varies by less are those of a skeleton, and not between markers on skin."""


@dataclass(frozen=True, eq=False)
class Body:
    """Bones over the markers of a recording.

    Attributes
    ----------
    parents : ndarray of int, shape (markers,)
        The marker that each hangs from; -1 where it hangs from none.
    bones : ndarray of int, shape (bones, 2)
        Pairs that are to keep their length: those of the tree that do, and further rigid ones.
    lengths, spreads : ndarray, shape (bones,)
        Median and robust standard deviation of their length, in mm.
    exact : bool
        Whether the bones are those of a skeleton, which keep their length exactly.
    parts : tuple of ndarray of int
        Markers of the parts, the trunk first; together all markers of the tree.
    triples : tuple of tuple of int
        The parts that each part is recovered from.
    """

    parents: IntArray
    bones: IntArray
    lengths: FloatArray
    spreads: FloatArray
    exact: bool
    parts: tuple[IntArray, ...]
    triples: tuple[tuple[int, ...], ...]

    @property
    def edges(self) -> IntArray:
        """The bones of the tree as (child, parent), shape (edges, 2)."""
        children = np.flatnonzero(self.parents >= 0)
        return np.stack([children, self.parents[children]], axis=1)

    @property
    def edge_lengths(self) -> FloatArray:
        """The lengths of the tree's bones in mm, shape (edges,); NaN for those that vary."""
        at = {
            frozenset(bone): length
            for bone, length in zip(self.bones.tolist(), self.lengths, strict=True)
        }
        return np.array([at.get(frozenset(edge), np.nan) for edge in self.edges.tolist()])

    @property
    def depths(self) -> IntArray:
        """How many bones lie between each marker and its root, shape (markers,)."""
        depths = np.zeros(self.parents.size, dtype=np.int64)
        above = self.parents
        while (above >= 0).any():
            depths += above >= 0
            above = np.where(above >= 0, self.parents[above], -1)
        return depths

    def constraints(self, markers: IntArray, mm: float) -> BoneConstraints:
        """Return the bones that touch some markers, with lengths in a unit of so many mm."""
        touching = np.isin(self.bones, markers).any(axis=1)
        return BoneConstraints(self.bones[touching], self.lengths[touching] / mm)

    def helpers_of(self, marker: int) -> IntArray:
        """Return the markers of the triple of parts that a marker's part is recovered from."""
        part = next((at for at, part in enumerate(self.parts) if marker in part), None)
        if part is None:
            return np.arange(self.parents.size)
        return np.unique(np.concatenate([self.parts[other] for other in self.triples[part]]))


def find_body(recording: Recording, seen: BoolArray) -> Body:
    """Find the bones of a recording: those of the 31 joints by name, else by constant distances.

    Parameters
    ----------
    recording : Recording
        Not changed. Markers that are hardly seen get no bone.
    seen : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.

    Returns
    -------
    Body
        Without bones where there are more than 1000 markers.
    """
    recording = recording.with_points(np.where(seen[..., None], recording.points, np.nan))
    names = [label.rpartition(":")[2].strip().lower() for label in recording.labels]
    wanted = [name for part in PARTS for name in part]
    if all(names.count(name) == 1 for name in wanted):
        return _joints(recording, names)
    return _found(recording)


def with_own_lengths(body: Body, recording: Recording) -> Body:
    """Return the same bones with the lengths that another recording of the same markers has."""
    lengths, spreads = _measure(recording, body.bones)
    return replace(body, lengths=lengths, spreads=spreads)


def _joints(recording: Recording, names: Sequence[str]) -> Body:
    parents = np.full(recording.markers, -1)
    for part in PARTS:
        for before, name in zip((None, *part), part, strict=False):
            parent = HANGS_FROM.get(name, before)
            if parent is not None:
                parents[names.index(name)] = names.index(parent)
    parts = tuple(np.array([names.index(name) for name in part]) for part in PARTS)
    children = np.flatnonzero(parents >= 0)
    bones = np.stack([children, parents[children]], axis=1)
    lengths, spreads = _measure(recording, bones)
    return Body(parents, bones, lengths, spreads, exact=True, parts=parts, triples=TRIPLES)


def _found(recording: Recording) -> Body:
    if recording.markers > MOST_MARKERS:
        nothing = np.zeros(0)
        alone = np.full(recording.markers, -1)
        pairs = np.zeros((0, 2), dtype=np.int64)
        return Body(alone, pairs, nothing, nothing, exact=False, parts=(), triples=())
    distances = measure_distances(recording, no_progress)
    tree, rigid = joining_bones(distances)
    parents = np.full(recording.markers, -1)
    near: dict[int, list[int]] = {}
    for a, b in tree:
        near.setdefault(a, []).append(b)
        near.setdefault(b, []).append(a)
    parts, triples = _branches(parents, near)
    pairs = np.array([*tree, *rigid], dtype=np.int64).reshape(-1, 2)
    lengths, spreads = _measure(recording, pairs)
    exact = bool(pairs.size and (spreads[: len(tree)] <= EXACT_MM).all())
    keeps = np.isfinite(lengths) & (exact | (spreads <= _loosest(lengths)))
    return Body(parents, pairs[keeps], lengths[keeps], spreads[keeps], exact, parts, triples)


def _loosest(lengths: FloatArray) -> FloatArray:
    """How much a pair's distance may vary to count as a bone: 8 % of it, but at most 10 mm."""
    loosest: FloatArray = np.minimum(10.0, 0.08 * lengths)
    return loosest


def _measure(recording: Recording, pairs: IntArray) -> tuple[FloatArray, FloatArray]:
    """Return the median, and half the width of the central 68 %, of the distances of pairs."""
    points = recording.points
    lengths, spreads = np.full((2, len(pairs)), np.nan)
    for at, (a, b) in enumerate(pairs.tolist()):
        both = recording.present[:, a] & recording.present[:, b]
        if both.any():
            away = np.linalg.norm(points[both, a] - points[both, b], axis=1) * recording.mm
            low, lengths[at], high = np.quantile(away, [0.16, 0.5, 0.84])
            spreads[at] = (high - low) / 2
    return lengths, spreads


def _branches(
    parents: IntArray, near: dict[int, list[int]]
) -> tuple[tuple[IntArray, ...], tuple[tuple[int, ...], ...]]:
    """Hang each tree from its middle and divide it there; fill in the parents.

    The middle is the marker whose removal leaves the smallest largest branch. It and its nearest
    markers are the trunk, the branches beyond are the other parts.
    """
    parts: list[IntArray] = []
    triples: list[tuple[int, ...]] = []
    for tree in _trees(near):
        middle = min(tree, key=lambda marker: (max(_sizes(near, marker), default=0), marker))
        for parent, child in _walk(near, middle):
            parents[child] = parent
        trunk = [middle, *near[middle]]
        branches = [
            [child for _, child in _walk(near, marker, middle)]
            for marker in near[middle]
            if len(near[marker]) > 1
        ]
        first = len(parts)
        parts += [np.array(sorted(part)) for part in (trunk, *branches)]
        own = list(range(first, len(parts)))
        for part in own:
            others = [other for other in own if other != part]
            triples.append((part, *others[:2]))
    return tuple(parts), tuple(triples)


def _trees(near: dict[int, list[int]]) -> list[list[int]]:
    left, trees = set(near), []
    while left:
        start = min(left)
        tree = [start, *(child for _, child in _walk(near, start))]
        left -= set(tree)
        trees.append(sorted(tree))
    return trees


def _sizes(near: dict[int, list[int]], marker: int) -> list[int]:
    return [1 + len(_walk(near, branch, marker)) for branch in near[marker]]


def _walk(near: dict[int, list[int]], start: int, barred: int = -1) -> list[tuple[int, int]]:
    """Return all (parent, child) beyond a marker, parents first, not passing the barred one."""
    steps: list[tuple[int, int]] = []
    todo = [(start, barred)]
    while todo:
        marker, before = todo.pop()
        for other in near[marker]:
            if other != before:
                steps.append((marker, other))
                todo.append((other, marker))
    return steps
