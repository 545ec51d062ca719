"""What labelling without segments and without time makes of a recording: a rival."""

import numpy as np

from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling import LabelModel
from mocapmend_algorithms.labelling.upright import upright

HEADINGS = 16


def label_naively(recording: Recording, model: LabelModel) -> IntArray:
    """Label each frame by itself: the model's usual pose, centred, turned and laid over it.

    Parameters
    ----------
    recording : Recording
        Without labels.
    model : LabelModel
        Its first pose, which is the most usual one, is what points are compared with.

    Returns
    -------
    ndarray of int, shape (frames, points)
        The nearest marker of the pose, in the heading of least cost (Hungarian method); -1 for
        points that are left over.
    """
    points = upright(recording)
    labels = np.full(points.shape[:2], -1, np.int64)
    poses = [_turned(model.poses[0], heading) for heading in range(HEADINGS)]
    for frame in range(len(points)):
        seen = np.flatnonzero(~np.isnan(points[frame, :, 0]))
        if seen.size:
            there = points[frame, seen]
            rows, columns = _best(there - there.mean(axis=0), poses)
            labels[frame, seen[rows]] = columns
    return labels


def _turned(pose: FloatArray, heading: int) -> FloatArray:
    angle = 2 * np.pi * heading / HEADINGS
    turn = np.eye(3)
    turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    turned: FloatArray = (pose - np.nanmean(pose, axis=0)) @ turn.T
    return turned


def _best(points: FloatArray, poses: list[FloatArray]) -> tuple[IntArray, IntArray]:
    from scipy.optimize import linear_sum_assignment

    found = []
    for pose in poses:
        away = np.linalg.norm(points[:, None] - np.nan_to_num(pose), axis=2)
        rows, columns = linear_sum_assignment(away)
        found.append((float(away[rows, columns].sum()), rows, columns))
    return min(found, key=lambda each: each[0])[1:]
