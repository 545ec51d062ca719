"""The markers that keep their distance to a marker the best, and how well they keep it now."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances, Skeleton

MOST = 5
FURTHEST_MM = 600.0
FLOOR_MM = 2.0


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


def rigid_mates(distances: PairDistances, skeleton: Skeleton, marker: int) -> RigidMates:
    """Return the markers that a marker keeps its distance to: those at its bones, and rigid ones.

    Parameters
    ----------
    distances : PairDistances
        Of all pairs.
    skeleton : Skeleton
        Whose bones count as more rigid than other pairs.
    marker : int
        The marker.

    Returns
    -------
    RigidMates
        At most five, none further than 600 mm.
    """
    length, spread = distances.length[marker], distances.spread[marker]
    share = (spread + FLOOR_MM) / np.maximum(length, 1.0)
    for bone in skeleton.bones:
        if marker in bone and max(bone) < len(share):
            share[bone[0] if bone[1] == marker else bone[1]] *= 0.5
    share[np.isnan(share) | (length > FURTHEST_MM) | (length <= 0)] = np.inf
    share[marker] = np.inf
    order = [int(k) for k in np.argsort(share, kind="stable")[:MOST] if np.isfinite(share[k])]
    return RigidMates(order, length[order], spread[order])


def stretched(recording: Recording, marker: int, mates: RigidMates) -> FloatArray:
    """Return by how much each distance is longer than usual in mm, shape (frames, mates).

    NaN where one of the two is missing.
    """
    own = recording.points[:, marker] * recording.mm
    stretch = np.empty((recording.frames, len(mates.markers)))
    for at, mate in enumerate(mates.markers):
        apart = recording.points[:, mate] * recording.mm - own
        stretch[:, at] = np.sqrt(np.einsum("tk,tk->t", apart, apart)) - mates.length[at]
    return stretch


def broken_share(stretch: FloatArray, gate: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Return the share of the known distances beyond their gates, and where two are known."""
    known = ~np.isnan(stretch)
    with np.errstate(invalid="ignore"):
        broken = np.abs(stretch) > gate
    count = known.sum(axis=1)
    share: FloatArray = broken.sum(axis=1) / np.maximum(count, 1)
    return share, count >= 2
