"""Heading: how far a body is turned about the vertical.

The same step to the north and to the east is one motion to learn from, not two.
"""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.training_set import up_vector

ROUNDS = 3


def headings(poses: FloatArray, reference: FloatArray, up: UpAxis) -> FloatArray:
    """Find by how much poses are turned about the vertical from a reference, least squares.

    Parameters
    ----------
    poses : ndarray, shape (frames, markers, 3)
        Complete.
    reference : ndarray, shape (markers, 3)
        The pose that has heading 0.
    up : str
        The vertical axis.

    Returns
    -------
    ndarray, shape (frames,)
        Angles in radians.
    """
    vertical = up_vector(up)
    around = poses - poses.mean(axis=1, keepdims=True)
    centred = reference - reference.mean(axis=0)
    flat = centred - np.outer(centred @ vertical, vertical)
    cosine = np.einsum("fmi,mi->f", around, flat)
    sine = np.einsum("fmi,mi->f", around, np.cross(vertical, flat))
    angles: FloatArray = np.arctan2(sine, cosine)
    return angles


def turned(points: FloatArray, angles: FloatArray, up: UpAxis) -> FloatArray:
    """Turn points about the vertical.

    Parameters
    ----------
    points : ndarray, shape (frames, ..., 3)
        Or vectors.
    angles : ndarray, shape (frames,)
        In radians.
    up : str
        The vertical axis.

    Returns
    -------
    ndarray, shape (frames, ..., 3)
    """
    vertical = up_vector(up)
    cosine, sine = np.cos(angles), np.sin(angles)
    skew = np.cross(vertical, np.eye(3)).T
    upright = np.outer(vertical, vertical)
    rotation = cosine[:, None, None] * (np.eye(3) - upright) + sine[:, None, None] * skew + upright
    rows = points.reshape(points.shape[0], -1, 3) @ rotation.swapaxes(1, 2)
    result: FloatArray = rows.reshape(points.shape)
    return result


def mean_pose(poses: FloatArray, up: UpAxis) -> FloatArray:
    """Average poses whatever their place and heading.

    Parameters
    ----------
    poses : ndarray, shape (frames, markers, 3)
        Complete, at least one.
    up : str
        The vertical axis.

    Returns
    -------
    ndarray, shape (markers, 3)
        Around its centroid, with the heading of the middle pose.
    """
    around = poses - poses.mean(axis=1, keepdims=True)
    mean: FloatArray = around[len(around) // 2]
    for _ in range(ROUNDS):
        mean = turned(around, -headings(around, mean, up), up).mean(axis=0)
    return mean
