"""A soft pull of predicted points to the bone lengths (L21: the skeleton's topology).

A bone is a pair of markers with nearly constant distance. Each missing point p is moved to the
least of |p - f|^2 / sigma^2 + sum_b (|p - x_b| - l_b)^2 / s_b^2, where f and sigma are the
filter's, x_b the other end of a bone where it is seen, l_b its length and s_b the measured spread
of that. Skin moves by millimetres, so the lengths are not met exactly; and the bones of one marker
share its skin, so that s_b^2 is multiplied by their number: n of them count as one.
"""

from dataclasses import dataclass, replace

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

ROUNDS = 8
HALVINGS = 6
NEAREST = 1e-9


@dataclass(frozen=True, eq=False)
class Bones:
    """The bones of one marker in some frames.

    Attributes
    ----------
    ends : ndarray, shape (frames, bones, 3)
        Where the other ends are; NaN where one is not seen.
    length, spread : ndarray, shape (bones,)
        Length and its measured standard deviation, above 0.
    """

    ends: FloatArray
    length: FloatArray
    spread: FloatArray


def pull(values: FloatArray, sigma: FloatArray, bones: Bones) -> tuple[FloatArray, FloatArray]:
    """Pull predicted points to the bone lengths, by Gauss-Newton steps that only lower the cost.

    Parameters
    ----------
    values : ndarray, shape (frames, 3)
        The filter's prediction.
    sigma : ndarray, shape (frames,)
        Its standard deviation per axis.
    bones : Bones
        In the same frames.

    Returns
    -------
    pulled : ndarray, shape (frames, 3)
        The points.
    share : ndarray, shape (frames,)
        By what the standard deviation shrinks, from 0 to 1.
    """
    bones = replace(bones, spread=bones.spread * np.sqrt(bones.spread.size))
    doubt = np.maximum(sigma, 1e-12 * max(float(np.abs(sigma).max()), NEAREST))[:, None]
    points = values.copy()
    cost = _cost(points, values, doubt, bones)
    for _ in range(ROUNDS):
        information, residual, along = _linear(points, doubt, bones)
        gradient = (values - points) / doubt**2 - np.einsum("tb,tbk->tk", residual, along)
        step = np.linalg.solve(information, gradient[:, :, None])[:, :, 0]
        for _ in range(HALVINGS):
            tried = _cost(points + step, values, doubt, bones)
            better = tried < cost
            step = np.where(better[:, None], step, step / 2)
            if better.all():
                break
        points = np.where(better[:, None], points + step, points)
        cost = np.where(better, tried, cost)
        if not better.any():
            break
    information, _, _ = _linear(points, doubt, bones)
    variance = np.trace(np.linalg.inv(information), axis1=1, axis2=2) / 3
    return points, np.minimum(np.sqrt(variance) / doubt[:, 0], 1.0)


def _cost(points: FloatArray, values: FloatArray, doubt: FloatArray, bones: Bones) -> FloatArray:
    away = np.sum(((points - values) / doubt) ** 2, axis=1)
    off = (np.linalg.norm(points[:, None] - bones.ends, axis=2) - bones.length) / bones.spread
    cost: FloatArray = away + np.nansum(off**2, axis=1)
    return cost


def _linear(
    points: FloatArray, doubt: FloatArray, bones: Bones
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Linearise: information (frames, 3, 3), weighted residuals and directions of the bones."""
    away = points[:, None] - bones.ends
    distance = np.linalg.norm(away, axis=2)
    seen = distance > NEAREST
    along = np.where(seen[:, :, None], away / np.where(seen, distance, 1.0)[:, :, None], 0.0)
    weight = np.where(seen, 1.0, 0.0) / bones.spread**2
    residual = np.where(seen, distance - bones.length, 0.0) * weight
    information = np.einsum("tb,tbi,tbj->tij", weight, along, along)
    return information + np.eye(3) / doubt[:, :, None] ** 2, residual, along
