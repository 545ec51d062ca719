"""The model brought to the body that is recorded, once most of it is labelled."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.labelling.around import COMPANIONS, companions
from mocapmend_algorithms.labelling.learning import mean_shapes, measure
from mocapmend_algorithms.labelling.model import LabelModel

BELIEVED_FRAMES = 30.0
"""So many frames of the recording weigh as much as the model does."""


def adapted(model: LabelModel, places: FloatArray, scale: float) -> LabelModel:
    """Return the model with the distances and shapes of the body at hand.

    Where markers sit differs from one session to the next by more than skin moves. The more frames
    show two markers together, the more their own distance counts; how much it varies is taken to
    be between what it does here and what it did in the model, for the labels may be wrong.

    Parameters
    ----------
    model : LabelModel
        In its own size.
    places : ndarray, shape (frames, labels, 3)
        Where the labels are believed to be, in mm; NaN unknown.
    scale : float
        Size of the body beside the model's.
    """
    length, spread = measure(places)
    seen = ~np.isnan(places[:, :, 0])
    together = seen.astype(np.float64).T @ seen.astype(np.float64)
    share = together / (together + BELIEVED_FRAMES)
    length = _mixed(length, scale * model.length, share)
    spread = np.sqrt(_mixed(spread**2, (scale * model.spread) ** 2, 0.5 * share))
    company = companions(length, spread, COMPANIONS)
    shapes, wander = mean_shapes(places, company, scale * model.poses[0])
    shapes = np.where(np.isnan(shapes), scale * model.shapes, shapes)
    own = np.diag(share)
    wander = np.sqrt(_mixed(wander**2, (scale * model.wander) ** 2, own))
    poses = scale * model.poses
    return LabelModel(model.labels, length, spread, shapes, wander, poses, model.segments)


def _mixed(own: FloatArray, model: FloatArray, share: FloatArray) -> FloatArray:
    """Average what is known of both; what is known of one alone is that."""
    mixed = share * own + (1.0 - share) * model
    return np.where(np.isnan(own), model, np.where(np.isnan(model), own, mixed))
