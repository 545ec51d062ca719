"""How badly each point fits each label, by where the labels are that are known already.

Two kinds of evidence, both as negative logarithms of densities with heavy tails (Student's t), so
that a wrong neighbour counts little:

- distances to other labels, compared with the model's (as rigid segments are matched by most
  labelling programs; Meyer, Kuderer, Müller, Burgard 2014, IEEE ICRA, Online marker labeling for
  fully automatic skeleton tracking in optical motion capture);
- the place in a frame of reference that moves with a label's companions, which tells left from
  right, as distances do not.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.around import Companions, companions, frames_around
from mocapmend_algorithms.labelling.around import COMPANIONS
from mocapmend_algorithms.labelling.model import LabelModel

PARTNERS = 14
"""Labels that a distance is measured to."""
FREEDOM = 2.0
"""Of Student's t."""
LOCAL_SHARE = 0.5
NOWHERE = 7.2
"""Cost of a point that is no label: the logarithm of about a metre, as everywhere is as likely."""
FARTHEST = 1e8
FEW = 2.0
"""So many neighbours of no opinion are added to those that have one."""


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
    wander : ndarray, shape (labels,)
        Scale of the deviation from the place in that frame, in mm.
    """

    partners: Companions
    lengths: FloatArray
    widths: FloatArray
    company: Companions
    shapes: FloatArray
    wander: FloatArray

    @classmethod
    def of(cls, model: LabelModel, scale: float, tolerance: Tolerance) -> "Expectation":
        """Expect a model in another size, within a tolerance."""
        partners = companions(model.length, model.spread, PARTNERS)
        lengths = scale * np.take_along_axis(model.length, partners.markers, axis=1)
        spread = scale * np.take_along_axis(model.spread, partners.markers, axis=1)
        unknown = np.isnan(lengths)
        lengths, spread = np.nan_to_num(lengths), np.nan_to_num(spread)
        widths = np.sqrt(
            (tolerance.loose * spread) ** 2 + (tolerance.share * lengths) ** 2 + tolerance.mm**2
        )
        partners.weights[unknown] = 0.0
        company = companions(model.length, model.spread, COMPANIONS)
        wander = np.sqrt((tolerance.loose * scale * np.nan_to_num(model.wander, nan=100.0)) ** 2
                         + tolerance.mm**2)
        return cls(partners, lengths, widths, company, scale * model.shapes, wander)


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
    count = len(expected.wander)
    places = label_places(points, labels, count)
    far = _distance_costs(expected, points, labels, places)
    local = _local_costs(expected, points, places)
    return np.where(np.isnan(local), far, (1 - LOCAL_SHARE) * far + LOCAL_SHARE * local)


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


def _local_costs(expected: Expectation, points: FloatArray, places: FloatArray) -> FloatArray:
    frames = frames_around(places, expected.shapes, expected.company, 1.0)
    own = np.arange(len(expected.wander))
    where = frames.place(expected.shapes[own, own])
    where[~frames.known] = np.nan
    square = np.sum((points[:, :, None] - where[:, None]) ** 2, axis=3) / expected.wander**2
    cost: FloatArray = np.log(expected.wander) + (FREEDOM + 3) / 6 * np.log1p(square / FREEDOM)
    return cost
