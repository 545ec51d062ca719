"""Which labels could be taken for each other: neighbours, parts of a segment, left and right."""

import re
from collections.abc import Sequence
from itertools import permutations

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.around import companions
from mocapmend_algorithms.labelling.model import LabelModel

NEAR = 6
"""Neighbours of a label that it could be taken for."""
PART = 4
"""Labels that go with each other, of which all 24 orders are tried."""
SIDES = tuple(
    (re.compile(left), re.compile(right))
    for left, right in (("^L", "^R"), ("L$", "R$"), ("LEFT", "RIGHT"))
)
"""How left and right are written; of several that fit, the last one that another label has."""
MIRROR_ROUNDS = 20
FIRST_STAYS_MM, STAYS_MM = 60.0, 10.0
"""A label is its own mirror image, if all others are this much less like it on average; at first
much more, or all would be."""


def likenesses(model: LabelModel) -> list[IntArray]:
    """Return orders of the labels that a body might be labelled in by mistake.

    Returns
    -------
    list of ndarray of int, shape (labels,)
        Each says which label is taken for each label. The whole body's mirror image, limbs in each
        other's place, segments turned, and neighbours exchanged; none is the right order.
    """
    count = len(model.labels)
    found: dict[bytes, IntArray] = {}
    mirror = mirror_by_names(model.labels)
    if (mirror == np.arange(count)).all():
        mirror = mirror_image(model.length)
    for order in [mirror, *_limbs(model, mirror), *_parts(model), *_pairs(model)]:
        if (order != np.arange(count)).any():
            found.setdefault(order.tobytes(), order)
    return list(found.values())


def mirror_by_names(labels: Sequence[str]) -> IntArray:
    """Return for each label the one that is called left where it is called right, or itself."""
    index = {label.upper(): k for k, label in enumerate(labels)}
    order = np.arange(len(labels))
    for k, label in enumerate(labels):
        for left, right in SIDES:
            for own, other in ((left, right), (right, left)):
                if own.search(label.upper()):
                    there = index.get(own.sub(other.pattern.strip("^$"), label.upper(), count=1))
                    if there is not None:
                        order[k] = there
    return np.where(order[order] == np.arange(len(labels)), order, np.arange(len(labels)))


def mirror_image(length: FloatArray) -> IntArray:
    """Return for each label the one at its place in the mirror, by distances alone.

    First the labels whose distances to all others are alike, whatever the order; then, by turns,
    those whose distances to each label are the other's distances to that label's mirror image.

    Parameters
    ----------
    length : ndarray, shape (labels, labels)
        Median distances in mm; NaN unknown.

    Returns
    -------
    ndarray of int, shape (labels,)
        A label in the middle is its own; so are all where a body has no mirror image.
    """
    from scipy.optimize import linear_sum_assignment

    count = len(length)
    known = np.where(np.isnan(length), np.nanmedian(length) if count > 1 else 0.0, length)
    profile = np.sort(known, axis=1)
    cost = np.abs(profile[:, None] - profile).mean(axis=2)
    cost[np.diag_indices(count)] += FIRST_STAYS_MM
    order: IntArray = linear_sum_assignment(cost + cost.T)[1]
    for _ in range(MIRROR_ROUNDS):
        cost = np.abs(known[:, None, :] - known[:, order][None]).mean(axis=2)
        cost[np.diag_indices(count)] += STAYS_MM
        new = linear_sum_assignment(cost + cost.T)[1]
        if np.array_equal(new, order):
            break
        order = new
    paired = order[order] == np.arange(count)
    return np.where(paired, order, np.arange(count))


def _limbs(model: LabelModel, mirror: IntArray) -> list[IntArray]:
    """Exchange each branch of the tree of nearest labels with its mirror image."""
    from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

    weight = np.nan_to_num(model.length + 5 * model.spread, nan=0.0)
    tree = minimum_spanning_tree(weight).toarray()
    orders = []
    for a, b in np.argwhere(tree > 0).tolist():
        cut = tree.copy()
        cut[a, b] = 0.0
        side = connected_components(cut, directed=False)[1]
        for end in (a, b):
            branch = np.flatnonzero(side == side[end])
            other = mirror[branch]
            if not set(branch.tolist()) & set(other.tolist()):
                order = np.arange(len(mirror))
                order[branch], order[other] = other, branch
                orders.append(order)
    return orders


def _parts(model: LabelModel) -> list[IntArray]:
    """Turn each small segment, and each label with those that it goes with, in all ways."""
    company = companions(model.length, model.spread, PART - 1).markers
    groups = {tuple(sorted((label, *near))) for label, near in enumerate(company.tolist())}
    groups |= {tuple(sorted(part)) for part in model.segments if len(part) <= PART}
    orders = []
    for group in sorted(groups):
        for turned in permutations(group):
            order = np.arange(len(model.labels))
            order[list(group)] = turned
            orders.append(order)
    return orders


def _pairs(model: LabelModel) -> list[IntArray]:
    away = np.where(np.isnan(model.length), np.inf, model.length)
    orders = []
    for a, near in enumerate(np.argsort(away, axis=1, kind="stable")[:, : NEAR + 1].tolist()):
        for b in near:
            if a != b:
                order = np.arange(len(away))
                order[[a, b]] = order[[b, a]]
                orders.append(order)
    return orders
