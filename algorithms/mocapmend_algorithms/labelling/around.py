"""Where a marker should be by those around it: rigid matching with weights and missing markers."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.alignment import turns
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray

COMPANIONS = 8
"""Markers that a frame of reference rests on."""
LEAST_COMPANIONS = 3
SKIN_MM = 8.0
REACH = 0.04
"""Of two equally steady companions, the nearer one turns with a marker even in other motions."""


class Companions(NamedTuple):
    """The markers that each marker goes with, the best first.

    Attributes
    ----------
    markers : ndarray of int, shape (labels, companions)
    weights : ndarray, shape (labels, companions)
        Zero where there is none.
    """

    markers: IntArray
    weights: FloatArray


def companions(length: FloatArray, spread: FloatArray, count: int) -> Companions:
    """Choose the markers that keep their distance to each marker best, and are near.

    Parameters
    ----------
    length, spread : ndarray, shape (labels, labels)
        Median and standard deviation of the distances in mm; NaN unknown.
    count : int
        How many; fewer where there are fewer.
    """
    looseness = spread + REACH * length + SKIN_MM
    np.fill_diagonal(looseness, np.inf)
    looseness[np.isnan(looseness)] = np.inf
    count = min(count, max(len(length) - 1, 0))
    markers = np.argsort(looseness, axis=1, kind="stable")[:, :count]
    weights = np.take_along_axis(looseness, markers, axis=1) ** -2.0
    return Companions(markers, weights)


class Frames(NamedTuple):
    """Frames of reference, one for each label at each frame.

    Attributes
    ----------
    rotation : ndarray, shape (frames, labels, 3, 3)
        From the shape's coordinates to the world's.
    centre, origin : ndarray, shape (frames, labels, 3)
        The same point in the world and in the shape.
    known : ndarray of bool, shape (frames, labels)
        Whether there were enough companions.
    """

    rotation: FloatArray
    centre: FloatArray
    origin: FloatArray
    known: BoolArray

    def place(self, shape_points: FloatArray) -> FloatArray:
        """Return points of the shapes, (labels, 3), in the world, (frames, labels, 3)."""
        away = shape_points - self.origin
        placed: FloatArray = np.einsum("flij,flj->fli", self.rotation, away) + self.centre
        return placed


def frames_around(places: FloatArray, shapes: FloatArray, company: Companions) -> Frames:
    """Fit each label's shape to the places of its companions (Kabsch 1976, weighted).

    Parameters
    ----------
    places : ndarray, shape (frames, labels, 3)
        Where the labels are; NaN unknown.
    shapes : ndarray, shape (labels, labels, 3)
        Of the model.
    company : Companions
        Which of them to look at.
    """
    there = places[:, company.markers]
    form = np.take_along_axis(shapes, company.markers[:, :, None], axis=1)
    seen = ~np.isnan(there[..., 0]) & ~np.isnan(form[..., 0])
    weights = np.where(seen, company.weights, 0.0)
    total = weights.sum(axis=2)
    known = seen.sum(axis=2) >= LEAST_COMPANIONS
    share = weights / np.maximum(total, 1e-12)[:, :, None]
    there, form = np.nan_to_num(there), np.nan_to_num(form)
    centre = np.einsum("flc,flci->fli", share, there)
    origin = np.einsum("flc,lci->fli", share, form)
    product = np.einsum("flc,flci,lcj->flij", share, there, form)
    product -= np.einsum("fli,flj->flij", centre, origin)
    return Frames(turns(product), centre, origin, known)
