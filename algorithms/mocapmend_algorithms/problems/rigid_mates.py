"""The markers that keep their distance to a marker the best, and how well they keep it now."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances, Skeleton

MOST = 5
FURTHEST_MM = 600.0
FLOOR_MM = 2.0
CANDIDATES = 12
"""The nearest markers, of which the most rigid are taken."""
ENOUGH, TIGHT = 2, 0.06
"""Of more than two, only those are taken whose looseness is no more than 6 % of the distance."""
BONE = 0.5
"""Of the looseness of other pairs, that of bones."""
MOST_FRAMES = 400
QUARTILES_IN_SD = 1.349
"""The distance of the quartiles of a normal distribution, in standard deviations."""


class RigidMates(NamedTuple):
    """The other markers that a marker has constant distances to.

    Attributes
    ----------
    markers : list of int
        The most rigid first.
    length, spread : ndarray, shape (mates,)
        Median and robust standard deviation of the distances, in mm.
    """

    markers: list[int]
    length: FloatArray
    spread: FloatArray


def rigid_mates(
    recording: Recording, distances: PairDistances, skeleton: Skeleton, marker: int
) -> RigidMates:
    """Return the markers that a marker keeps its distance to: those at its bones, and rigid ones.

    Parameters
    ----------
    recording : Recording
        What to look at.
    distances : PairDistances
        Of all pairs: only near ones are measured more closely.
    skeleton : Skeleton
        Whose bones count as more rigid than other pairs.
    marker : int
        The marker.

    Returns
    -------
    RigidMates
        At most five, none further than 600 mm.
    """
    near = np.where(distances.length[marker] > 0, distances.length[marker], np.inf)
    near[marker] = np.inf
    near[near > FURTHEST_MM] = np.inf
    joined = [bone[1 - bone.index(marker)] for bone in skeleton.bones if marker in bone]
    others = dict.fromkeys((*joined, *np.argsort(near, kind="stable")[:CANDIDATES].tolist()))
    kept = [other for other in others if np.isfinite(near[other])]
    length, spread = _measured(recording, marker, kept)
    share = (spread + FLOOR_MM) / np.maximum(length, 1.0)
    share[[other in joined for other in kept]] *= BONE
    order = np.argsort(share, kind="stable")[:MOST]
    order = order[np.isfinite(share[order])]
    if len(order) > ENOUGH:
        order = order[share[order] <= max(TIGHT, share[order[ENOUGH - 1]])]
    return RigidMates([kept[at] for at in order], length[order], spread[order])


def _measured(
    recording: Recording, marker: int, others: list[int]
) -> tuple[FloatArray, FloatArray]:
    """Return median and robust deviation of distances, which a quarter of bad frames spares."""
    step = max(1, recording.frames // MOST_FRAMES)
    points = recording.points[::step] * recording.mm
    apart = points[:, others] - points[:, [marker]]
    length = np.sort(np.sqrt(np.einsum("tmk,tmk->tm", apart, apart)), axis=0)  # NaN last
    last = np.maximum(np.count_nonzero(~np.isnan(length), axis=0) - 1, 0)
    low, middle, high = (
        length[np.round(share * last).astype(np.int64), np.arange(len(others))]
        for share in (0.25, 0.5, 0.75)
    )
    return middle, (high - low) / QUARTILES_IN_SD


def stretched(paths: FloatArray, marker: int, mates: RigidMates) -> FloatArray:
    """Measure by how much each distance of a marker is longer than usual.

    Parameters
    ----------
    paths : ndarray, shape (markers, 3, frames)
        Of all markers, in mm.
    marker : int
        The marker.
    mates : RigidMates
        Its mates.

    Returns
    -------
    ndarray, shape (mates, frames)
        In mm; NaN where one of the two is missing.
    """
    apart = paths[mates.markers] - paths[marker]
    length: FloatArray = np.sqrt(np.einsum("mkt,mkt->mt", apart, apart))
    return length - mates.length[:, None]


def broken_share(stretch: FloatArray, gate: FloatArray) -> FloatArray:
    """Return the share of the known distances beyond their gates; 0 where fewer than two are known.

    Parameters
    ----------
    stretch : ndarray, shape (mates, frames)
        See `stretched`.
    gate : ndarray, shape (mates,)
        In mm.

    Returns
    -------
    ndarray, shape (frames,)
    """
    with np.errstate(invalid="ignore"):
        broken = np.abs(stretch) > gate[:, None]
    count = (~np.isnan(stretch)).sum(axis=0)
    share: FloatArray = broken.sum(axis=0) / np.maximum(count, 1)
    share[count < 2] = 0.0
    return share
