"""Which markers to join with a stick: from a known label set, or from the recording itself.

A *bone* is a pair of markers whose distance is nearly constant.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

Bone = tuple[int, int]

LEAST_SHARE = 0.8
MOST_FRAMES = 300
LEAST_TOGETHER = 10
LONGEST_MM = 700.0
SPREAD_FLOOR_MM = 2.0
LENGTH_POWER = 1.5
LOOSEST = 0.35
RIGID = 0.06
MOST_BONES = 3
MOST_MARKERS = 1000
"""All pairs are measured: of more markers, which no body wears, memory could run out."""


@dataclass(frozen=True)
class Skeleton:
    """The sticks of a recording.

    Attributes
    ----------
    name : str
        Of the template, or "" where there is none.
    bones : tuple of (int, int)
        Marker indices.
    source : str
        Where they come from.
    """

    name: str
    bones: tuple[Bone, ...]
    source: Literal["file", "template", "distances", "none"]


@dataclass(frozen=True)
class Template:
    """A known label set and its sticks.

    Attributes
    ----------
    name : str
        For the user.
    required : tuple of str
        Labels by which it is recognised.
    bones : tuple of (str, str)
        Pairs of labels; those with a missing end are left out.
    aliases : mapping of str to str
        Other names of its labels.
    """

    name: str
    required: tuple[str, ...]
    bones: tuple[tuple[str, str], ...]
    aliases: Mapping[str, str] = field(default_factory=dict)


def parse_template(data: Mapping[str, Any]) -> Template:
    """Make a template from what a TOML file holds.

    Parameters
    ----------
    data : mapping
        `name`; `required` and `optional`, lists of labels; `chains`, lists of labels to be joined
        one after the other; `aliases`, other names of labels.

    Raises
    ------
    ValueError
        If a key is missing, or a chain or an alias names a label that the template does not have.
    """
    for key in ("name", "required", "chains"):
        if not data.get(key):
            raise ValueError(f"a skeleton template needs {key!r}")
    known = {*data["required"], *data.get("optional", ())}
    aliases = dict(data.get("aliases", {}))
    used = {label for chain in data["chains"] for label in chain} | set(aliases.values())
    if strange := sorted(used - known):
        raise ValueError(f"{data['name']} joins or renames unknown labels: {', '.join(strange)}")
    bones = dict.fromkeys(pair for chain in data["chains"] for pair in pairwise(chain))
    return Template(data["name"], tuple(data["required"]), tuple(bones), aliases)


def match_template(labels: Sequence[str], templates: Iterable[Template]) -> Skeleton | None:
    """Recognise a label set.

    Case and subject prefixes ("Matt:LASI") do not matter; where several subjects are recorded,
    each gets its sticks.

    Parameters
    ----------
    labels : sequence of str
        As the file has them.
    templates : iterable of Template
        The known sets. One fits when at least 80 % of its required labels are there; of those
        that fit, the one with the most labels found wins, then the one with the larger share.

    Returns
    -------
    Skeleton or None
        None where no template fits.
    """
    subjects: dict[str, dict[str, int]] = {}
    for index, label in enumerate(labels):
        subject, _, marker = label.rpartition(":")
        subjects.setdefault(subject, {}).setdefault(marker.strip().upper(), index)
    templates = tuple(templates)
    fits = [fit for found in subjects.values() if (fit := _best_fit(found, templates))]
    if not fits:
        return None
    bones = dict.fromkeys(bone for _, joined in fits for bone in joined)
    return Skeleton(fits[0][0].name, tuple(bones), "template")


def _best_fit(
    found: Mapping[str, int], templates: Sequence[Template]
) -> tuple[Template, list[Bone]] | None:
    best: tuple[int, float] = (0, 0.0)
    chosen: tuple[Template, dict[str, int]] | None = None
    for template in templates:
        aliases = {a.upper(): label.upper() for a, label in template.aliases.items()}
        named = {aliases.get(label, label): index for label, index in found.items()} | dict(found)
        count = sum(label.upper() in named for label in template.required)
        score = count, count / len(template.required)
        if score[1] >= LEAST_SHARE and score > best:
            best, chosen = score, (template, named)
    if chosen is None:
        return None
    template, named = chosen
    ends = [(named.get(a.upper()), named.get(b.upper())) for a, b in template.bones]
    return template, [(a, b) for a, b in ends if a is not None and b is not None]


def skeleton_from_distances(recording: Recording, progress: Progress) -> Skeleton:
    """Find pairs of markers that keep their distance.

    A spanning tree over the pairs with the smallest spread, long ones penalised, so that it looks
    like a body; then the most rigid further pairs, up to three bones per marker.

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
        1000 markers. Markers that are never seen get no bone.
    """
    if recording.markers > MOST_MARKERS:
        return Skeleton("", (), "none")
    step = max(1, recording.frames // MOST_FRAMES)
    length, spread, together = _distances(recording.points[::step] * recording.mm, progress)
    least = max(2, min(LEAST_TOGETHER, -(-recording.frames // step) // 4))
    usable = (together >= least) & (length > 0) & (length <= LONGEST_MM)
    usable &= spread <= LOOSEST * length
    first, second = np.nonzero(usable)
    cost = (spread[usable] + SPREAD_FLOOR_MM) * length[usable] ** LENGTH_POWER
    order = np.argsort(cost, kind="stable")
    pairs = list(zip(first[order].tolist(), second[order].tolist(), strict=True))
    tree = _spanning_tree(pairs, recording.markers)
    rigid = (spread[usable] <= RIGID * length[usable])[order]
    in_tree = set(tree)
    costs = cost[order]
    typical = np.median([c for pair, c in zip(pairs, costs, strict=True) if pair in in_tree] or [0])
    near = rigid & (costs <= typical)
    extra = _closing(tree, [pair for pair, ok in zip(pairs, near, strict=True) if ok])
    bones = tuple(sorted(tree + extra))
    return Skeleton("", bones, "distances" if bones else "none")


def _distances(points: FloatArray, progress: Progress) -> tuple[FloatArray, FloatArray, IntArray]:
    """Measure all pairs: median distance, width of its central 90 %, frames seen together."""
    frames, markers = points.shape[:2]
    length = np.full((markers, markers), np.nan)
    spread = np.full((markers, markers), np.nan)
    together = np.zeros((markers, markers), dtype=np.int64)
    for marker in range(markers - 1):
        progress(marker / markers)
        distance = np.linalg.norm(points[:, marker + 1 :] - points[:, [marker]], axis=2)
        distance.sort(axis=0)  # NaN last
        count = frames - np.isnan(distance).sum(axis=0)
        at = np.clip(np.multiply.outer((0.05, 0.5, 0.95), count - 1).round(), 0, None)
        low, middle, high = np.take_along_axis(distance, at.astype(np.int64), axis=0)
        length[marker, marker + 1 :] = middle
        spread[marker, marker + 1 :] = high - low
        together[marker, marker + 1 :] = count
    progress(1.0)
    return length, spread, together


def _spanning_tree(pairs: Sequence[Bone], markers: int) -> list[Bone]:
    """Kruskal's tree (forest): pairs in ascending order of cost."""
    parent = list(range(markers))

    def root(marker: int) -> int:
        while parent[marker] != marker:
            parent[marker] = parent[parent[marker]]
            marker = parent[marker]
        return marker

    tree = []
    for pair in pairs:
        a, b = root(pair[0]), root(pair[1])
        if a != b:
            parent[a] = b
            tree.append(pair)
    return tree


def _closing(tree: Sequence[Bone], pairs: Sequence[Bone]) -> list[Bone]:
    """Choose further pairs as long as one of the two markers has few bones."""
    bones = dict.fromkeys(marker for pair in tree for marker in pair)
    degree = {marker: sum(marker in pair for pair in tree) for marker in bones}
    extra = []
    taken = set(tree)
    for a, b in pairs:
        if (a, b) not in taken and min(degree[a], degree[b]) < MOST_BONES:
            extra.append((a, b))
            degree[a] += 1
            degree[b] += 1
    return extra
