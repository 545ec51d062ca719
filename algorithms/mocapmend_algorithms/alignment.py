"""The rigid motion of a group of markers: a frame of reference that moves with them."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

LEAST_FOR_ROTATION = 3
IN_LINE = 1e-6
SHAPE_ROUNDS = 2
SHAPE_FRAMES = 100


@dataclass(frozen=True, eq=False)
class Alignment:
    """Where a group of markers is and how it is turned, frame by frame.

    Attributes
    ----------
    rotation : ndarray, shape (frames, 3, 3)
        From local to world coordinates; NaN where a marker of the group is missing.
    centre : ndarray, shape (frames, 3)
        Weighted mean of the group.
    origin : ndarray, shape (3,)
        The same of its template.
    """

    rotation: FloatArray
    centre: FloatArray
    origin: FloatArray

    def to_local(self, points: FloatArray) -> FloatArray:
        """Express points, shape (frames, ..., 3), in the group's frame."""
        rows = points.reshape(points.shape[0], -1, 3) - self.centre[:, None]
        local: FloatArray = (rows @ self.rotation).reshape(points.shape) + self.origin
        return local

    def to_world(self, points: FloatArray) -> FloatArray:
        """Put points of the group's frame, shape (frames, 3), back into the world."""
        turned: FloatArray = (self.rotation @ (points - self.origin)[..., None])[..., 0]
        return turned + self.centre

    def __getitem__(self, frames: slice) -> "Alignment":
        """Return the alignment of some of the frames."""
        return Alignment(self.rotation[frames], self.centre[frames], self.origin)


def align(points: FloatArray, template: FloatArray, weights: FloatArray) -> Alignment:
    """Fit a template to a group of markers in each frame, least squares (Kabsch 1976, 1978).

    Parameters
    ----------
    points : ndarray, shape (frames, group, 3)
        The group; a frame in which one of it is missing gets no alignment.
    template : ndarray, shape (group, 3)
        Its shape. Fewer than three markers have no rotation: they are only moved. Those in one line
        turn as little as they can.
    weights : ndarray, shape (group,)
        How much each marker counts, not negative, with a positive sum.

    Returns
    -------
    Alignment
    """
    share = weights / weights.sum()
    origin: FloatArray = share @ template
    centre: FloatArray = np.einsum("fgi,g->fi", points, share)
    rotation = np.full((points.shape[0], 3, 3), np.nan)
    seen = np.isfinite(centre).all(axis=1)
    if template.shape[0] < LEAST_FOR_ROTATION:
        rotation[seen] = np.eye(3)
        return Alignment(rotation, centre, origin)
    around = points[seen] - centre[seen, None]
    weighted = share[:, None] * (template - origin)
    rotation[seen] = turns(around.swapaxes(1, 2) @ weighted)
    return Alignment(rotation, centre, origin)


def turns(product: FloatArray) -> FloatArray:
    """Return the rotations nearest to sums of products of a group's and its template's places.

    Parameters
    ----------
    product : ndarray, shape (..., 3, 3)

    Returns
    -------
    ndarray, shape (..., 3, 3)
        Those of markers in one line turn as little as they can.
    """
    left, size, right = np.linalg.svd(product)
    line = size[..., 1] <= IN_LINE * size[..., 0]
    if line.any():
        steadied = product[line] + IN_LINE * size[line, 0, None, None] * np.eye(3)
        left[line], _, right[line] = np.linalg.svd(steadied)
    left[..., :, 2] *= np.sign(np.linalg.det(left @ right))[..., None]
    rotation: FloatArray = left @ right
    return rotation


def mean_shape(points: FloatArray, weights: FloatArray) -> FloatArray:
    """Return the mean shape of a group of markers.

    Parameters
    ----------
    points : ndarray, shape (frames, group, 3)
        Complete frames, at least one.
    weights : ndarray, shape (group,)
        How much each marker counts in the alignment.

    Returns
    -------
    ndarray, shape (group, 3)
        About a hundred of the frames, aligned to each other (the middle one first) and averaged.
    """
    points = points[:: -(-points.shape[0] // SHAPE_FRAMES)]
    shape: FloatArray = points[points.shape[0] // 2]
    for _ in range(SHAPE_ROUNDS):
        shape = align(points, shape, weights).to_local(points).mean(axis=0)
    return shape
