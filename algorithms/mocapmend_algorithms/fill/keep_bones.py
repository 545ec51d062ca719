"""Bone lengths of what was filled: exact in a skeleton, as sure as they are between markers."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, add_ridge
from mocapmend_algorithms.fill.bones import Bones, pull
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.edges import Doubt
from mocapmend_algorithms.gaps import Gap, find_gaps
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton.projection import project_bones
from mocapmend_algorithms.sparse.body import LEAST_SPREAD_MM, Body

LEAST_DOUBT = 1e-3
"""Of each marker, relative to the mean: what errs little in the examples is not fixed."""
PULL_MM = 10.0
"""How unsure a told place is, to weigh it against bone lengths that are measured on skin."""


def joined_by_bones(observed: BoolArray, gaps: Sequence[Gap], body: Body) -> list[Gap]:
    """Add to gaps those that share frames and a bone with them, and so on.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gaps : sequence of Gap
        The gaps asked for.
    body : Body
        The bones.

    Returns
    -------
    list of Gap
        Ordered.
    """
    everyone: dict[int, list[Gap]] = {}
    for gap in find_gaps(observed):
        everyone.setdefault(gap.marker, []).append(gap)
    chosen, todo = set(gaps), list(gaps)
    while todo:
        gap = todo.pop()
        at = body.bones[(body.bones == gap.marker).any(axis=1)]
        for marker in np.setdiff1d(at, [gap.marker]).tolist():
            for other in everyone.get(marker, []):
                if other not in chosen and other.start < gap.stop and gap.start < other.stop:
                    chosen.add(other)
                    todo.append(other)
    return sorted(chosen)


def only(filled: FillResult, gaps: Sequence[Gap]) -> FillResult:
    """Leave out the gaps that were filled for the sake of their neighbours.

    Parameters
    ----------
    filled : FillResult
        Of `joined_by_bones`.
    gaps : sequence of Gap
        Those asked for.

    Returns
    -------
    FillResult
        In the order of the gaps.
    """
    order = {gap: at for at, gap in enumerate(gaps)}
    patches = [patch for patch in filled.patches if patch.gap in order]
    unfilled = [one for one in filled.unfilled if one.gap in order]
    return replace(
        filled,
        patches=tuple(sorted(patches, key=lambda patch: order[patch.gap])),
        unfilled=tuple(sorted(unfilled, key=lambda one: order[one.gap])),
        notes={gap: note for gap, note in filled.notes.items() if gap in order},
    )


def projected(
    recording: Recording,
    observed: BoolArray,
    filled: FillResult,
    body: Body,
    doubts: Mapping[Gap, Doubt | None],
) -> FillResult:
    """Give the bones of a skeleton their lengths, all filled points of a frame together.

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used; they do not move.
    filled : FillResult
        Whose patches are to be moved.
    body : Body
        The bones.
    doubts : mapping of Gap to Doubt
        What is less sure moves further; all alike where there is none.

    Returns
    -------
    FillResult
        Bones with an end that is missing all the same do not count.
    """
    points = np.where(observed[..., None], recording.points, np.nan)
    patch_at = np.full(observed.shape, -1)
    for number, patch in enumerate(filled.patches):
        gap = patch.gap
        points[gap.start : gap.stop, gap.marker] = patch.values
        patch_at[gap.start : gap.stop, gap.marker] = number
    for frames, movable in _alike(patch_at):
        bones = body.constraints(movable, recording.mm)
        gaps = [filled.patches[number].gap for number in patch_at[frames[0], movable]]
        covariance = _covariance(movable, [doubts.get(gap) for gap in gaps])
        points[np.ix_(frames, movable)] = project_bones(points[frames], movable, bones, covariance)
    patches = [
        replace(patch, values=points[patch.gap.start : patch.gap.stop, patch.gap.marker].copy())
        for patch in filled.patches
    ]
    return replace(filled, patches=tuple(patches))


def _alike(patch_at: IntArray) -> Iterator[tuple[IntArray, IntArray]]:
    """Group the frames in which the same patches are."""
    frames = np.flatnonzero((patch_at >= 0).any(axis=1))
    kinds, which = np.unique(patch_at[frames], axis=0, return_inverse=True)
    for at, kind in enumerate(kinds):
        yield frames[which.ravel() == at], np.flatnonzero(kind >= 0)


def _covariance(markers: IntArray, doubts: Sequence[Doubt | None]) -> FloatArray | None:
    """Say how unsure markers are together; those that were not told together err apart."""
    covariance = np.zeros((markers.size, markers.size))
    left: BoolArray = np.ones(markers.size, dtype=np.bool_)
    for at, doubt in enumerate(doubts):
        if left[at] and doubt is not None:
            here = np.flatnonzero(left & np.isin(markers, doubt.markers))
            there = np.searchsorted(doubt.markers, markers[here])
            covariance[np.ix_(here, here)] = doubt.covariance[np.ix_(there, there)]
            left[here] = False
    if left.all():
        return None
    usual = float(np.diagonal(covariance)[~left].mean())
    covariance[left, left] = usual
    add_ridge(covariance, LEAST_DOUBT)
    return covariance if usual > 0 else None


def pulled(recording: Recording, observed: BoolArray, filled: FillResult, body: Body) -> FillResult:
    """Pull each filled point to the lengths of its bones to markers that are seen.

    Parameters
    ----------
    recording, observed, filled, body
        See `projected`.

    Returns
    -------
    FillResult
    """
    return replace(
        filled,
        patches=tuple(_pulled_patch(recording, observed, p, body) for p in filled.patches),
    )


def _pulled_patch(recording: Recording, observed: BoolArray, patch: Patch, body: Body) -> Patch:
    gap = patch.gap
    mine = (body.bones == gap.marker).any(axis=1)
    if not mine.any():
        return patch
    ends = body.bones[mine].sum(axis=1) - gap.marker
    frames = slice(gap.start, gap.stop)
    there = observed[frames, ends][..., None]
    bones = Bones(
        np.where(there, recording.points[frames, ends], np.nan) * recording.mm,
        body.lengths[mine],
        np.maximum(body.spreads[mine], LEAST_SPREAD_MM),
    )
    doubt: FloatArray = np.full(gap.length, PULL_MM)
    values, _ = pull(patch.values * recording.mm, doubt, bones)
    return replace(patch, values=values / recording.mm)
