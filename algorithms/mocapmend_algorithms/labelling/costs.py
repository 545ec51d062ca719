"""How badly each point fits each label, by where the labels are that are known already.

Two kinds of evidence, both as negative logarithms of densities with heavy tails (Student's t), so
that a wrong neighbour counts little:

- distances to other labels, compared with the model's, as rigid segments are matched by most
  labelling programs (Meyer, Kuderer, Müller, Burgard 2014, IEEE ICRA, 5652-5657, Online marker
  labeling for fully automatic skeleton tracking in optical motion capture);
- the place in a frame of reference that moves with a label's companions, which tells left from
  right, as distances do not.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.around import (
    COMPANIONS,
    Companions,
    Frames,
    companions,
    frames_around,
)
from mocapmend_algorithms.labelling.model import LabelModel

PARTNERS = 14
"""Labels that a distance is measured to."""
FREEDOM = 2.0
"""Of Student's t."""
LOCAL_SHARE = 0.5
"""Of the place in a frame of reference, beside the distances."""
NOWHERE = 7.2
"""Cost of a point that is no label: the logarithm of about a metre, as everywhere is as likely."""
FEW = 2.0
"""So many neighbours of no opinion are added to those that have one."""
FARTHEST = 1e8
"""Squared deviation that is as bad as any larger one: products of them stay finite."""
UNKNOWN_MM = 100.0
"""How far a marker strays of which nothing is known."""


@dataclass(frozen=True)
class Tolerance:
    """How far the body may be from the model's.

    Attributes
    ----------
    share : float
        Of a distance.
    mm : float
        Of a marker's place.
    loose : float
        How many times the model's spread a loose distance may vary by.
    """

    share: float
    mm: float
    loose: float


@dataclass(frozen=True, eq=False)
class Expectation:
    """A model made ready for comparing.

    Attributes
    ----------
    partners : Companions
        Labels that distances are measured to.
    lengths, widths : ndarray, shape (labels, partners)
        Expected distance, and the scale of its deviation, in mm.
    company : Companions
        Labels that a frame of reference rests on.
    shapes : ndarray, shape (labels, labels, 3)
        See `LabelModel`.
    own : ndarray, shape (labels, 3)
        Each label's own place in its shape.
    wander : ndarray, shape (labels,)
        Scale of the deviation from that place, in mm.
    """

    partners: Companions
    lengths: FloatArray
    widths: FloatArray
    company: Companions
    shapes: FloatArray
    own: FloatArray
    wander: FloatArray

    @classmethod
    def of(cls, model: LabelModel, scale: float, tolerance: Tolerance) -> "Expectation":
        """Expect a model in another size, within a tolerance."""
        partners = companions(model.length, model.spread, PARTNERS)
        lengths = scale * np.take_along_axis(model.length, partners.markers, axis=1)
        spread = scale * np.take_along_axis(model.spread, partners.markers, axis=1)
        partners.weights[np.isnan(lengths)] = 0.0
        lengths, spread = np.nan_to_num(lengths), np.nan_to_num(spread)
        squares = (tolerance.loose * spread) ** 2 + (tolerance.share * lengths) ** 2
        wander = tolerance.loose * scale * np.nan_to_num(model.wander, nan=UNKNOWN_MM)
        shapes = scale * model.shapes
        label = np.arange(len(model.labels))
        return cls(
            partners,
            lengths,
            np.sqrt(squares + tolerance.mm**2),
            companions(model.length, model.spread, COMPANIONS),
            shapes,
            shapes[label, label],
            np.sqrt(wander**2 + tolerance.mm**2),
        )

    def of_labels(self, some: IntArray) -> "Expectation":
        """Return what is expected of some of the labels, by all of them."""
        return Expectation(
            Companions(self.partners.markers[some], self.partners.weights[some]),
            self.lengths[some],
            self.widths[some],
            Companions(self.company.markers[some], self.company.weights[some]),
            self.shapes[some],
            self.own[some],
            self.wander[some],
        )

    def frames(self, places: FloatArray) -> Frames:
        """Fit each label's frame of reference to where its companions are."""
        return frames_around(places, self.shapes, self.company)


def costs(expected: Expectation, points: FloatArray, labels: IntArray) -> FloatArray:
    """Return what it costs to give each point each label.

    Parameters
    ----------
    expected : Expectation
        Of a model.
    points : ndarray, shape (frames, points, 3)
        In mm, z up; NaN = missing.
    labels : ndarray of int, shape (frames, points)
        What they are taken to be so far; -1 for none.

    Returns
    -------
    ndarray, shape (frames, points, labels)
        Mean negative logarithm of the density per dimension; NaN where a point is missing.
    """
    places = label_places(points, labels, len(expected.wander))
    far = _distance_costs(expected, points, labels, places)
    frames = expected.frames(places)
    where = frames.place(expected.own)
    where[~frames.known] = np.nan
    return _both(far, _place_costs(expected, points[:, :, None] - where[:, None]))


def own_costs(expected: Expectation, places: FloatArray, some: IntArray) -> FloatArray:
    """Return what labels cost where they are.

    Parameters
    ----------
    expected : Expectation
        Of some of the labels; see `of_labels`.
    places : ndarray, shape (frames, labels, 3)
        Where all labels are; NaN unknown.
    some : ndarray of int, shape (some,)
        Which labels.

    Returns
    -------
    ndarray, shape (frames, some)
        As of `costs`; `NOWHERE` where a label is not seen, and at most that.
    """
    own = places[:, some]
    apart = np.linalg.norm(own[:, :, None] - places[:, expected.partners.markers], axis=3)
    away = (apart - expected.lengths) / expected.widths
    used = ~np.isnan(away) & (expected.partners.weights > 0)
    factor = np.where(used, 1.0 + np.minimum(away**2, FARTHEST) / FREEDOM, 1.0)
    found = np.where(used, np.log(expected.widths), 0.0).sum(axis=2)
    found += 0.5 * (FREEDOM + 1) * np.log(factor.prod(axis=2))
    far = (found + FEW * NOWHERE) / (used.sum(axis=2) + FEW)
    frames = expected.frames(places)
    where = frames.place(expected.own)
    where[~frames.known] = np.nan
    both = _both(far, _place_costs(expected, own - where))
    both[np.isnan(own[:, :, 0])] = NOWHERE
    return np.minimum(both, NOWHERE)


def label_places(points: FloatArray, labels: IntArray, count: int) -> FloatArray:
    """Return where each label is, shape (frames, labels, 3); NaN where no point has it."""
    places = np.full((len(points), count, 3), np.nan)
    frame, point = np.nonzero(labels >= 0)
    places[frame, labels[frame, point]] = points[frame, point]
    return places


def _distance_costs(
    expected: Expectation, points: FloatArray, labels: IntArray, places: FloatArray
) -> FloatArray:
    partners = expected.partners.markers
    apart = np.linalg.norm(points[:, :, None] - places[:, None], axis=3)
    # A point is no evidence about itself.
    frame, point = np.nonzero(labels >= 0)
    apart[frame, point, labels[frame, point]] = np.nan
    logs = np.log(expected.widths)
    found = np.zeros((*points.shape[:2], len(partners)))
    product = np.ones_like(found)
    number = np.zeros_like(found)
    for k in range(partners.shape[1]):
        away = (apart[:, :, partners[:, k]] - expected.lengths[:, k]) / expected.widths[:, k]
        used = ~np.isnan(away) & (expected.partners.weights[:, k] > 0)
        # One logarithm of a product: logarithms take most of the time.
        product *= np.where(used, 1.0 + np.minimum(away**2, FARTHEST) / FREEDOM, 1.0)
        found += np.where(used, logs[:, k], 0.0)
        number += used
    found += 0.5 * (FREEDOM + 1) * np.log(product)
    mean: FloatArray = (found + FEW * NOWHERE) / (number + FEW)
    mean[np.isnan(points[:, :, 0])] = np.nan
    return mean


def _place_costs(expected: Expectation, away: FloatArray) -> FloatArray:
    square = np.sum(away**2, axis=-1) / expected.wander**2
    cost: FloatArray = np.log(expected.wander) + (FREEDOM + 3) / 6 * np.log1p(square / FREEDOM)
    return cost


def _both(far: FloatArray, near: FloatArray) -> FloatArray:
    return np.where(np.isnan(near), far, (1 - LOCAL_SHARE) * far + LOCAL_SHARE * near)
