"""Ridge regression from joints to markers, frame by frame: what a network is held against."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.preparing import headings, turned
from mocapmend_algorithms.refine.profile import Profile

PENALTY = 1.0
"""Square millimetres per frame: little beside the variance of joints."""


class Ridge:
    """An affine map of poses that face the same way.

    Parameters
    ----------
    joints : sequence of ndarray, shape (frames, inputs, 3)
        In mm relative to the root, z up, one array per recording.
    markers : sequence of ndarray, shape (frames, outputs, 3)
        What they should become; frames with a missing marker (NaN) are left out.
    profile : Profile
        Says what is left and right.
    """

    def __init__(
        self, joints: Sequence[FloatArray], markers: Sequence[FloatArray], profile: Profile
    ) -> None:
        self._profile = profile
        rows, targets = [], []
        for one, wanted in zip(joints, markers, strict=True):
            angle = -headings(one[None], profile)
            rows.append(_rows(turned(one[None], angle)[0]))
            targets.append(turned(wanted[None], angle)[0].reshape(len(wanted), -1))
        matrix, target = np.concatenate(rows), np.concatenate(targets)
        known = ~np.isnan(target).any(axis=1)
        matrix, target = matrix[known], target[known]
        gram = matrix.T @ matrix
        gram[np.diag_indices(len(gram) - 1)] += PENALTY * len(matrix)
        self._map: FloatArray = np.linalg.solve(gram, matrix.T @ target)

    def __call__(self, joints: FloatArray) -> FloatArray:
        """Return the markers of a recording, shape (frames, outputs, 3)."""
        angle = headings(joints[None], self._profile)
        rows = _rows(turned(joints[None], -angle)[0])
        poses: FloatArray = turned((rows @ self._map).reshape(1, len(joints), -1, 3), angle)[0]
        return poses


def _rows(joints: FloatArray) -> FloatArray:
    return np.column_stack([joints.reshape(len(joints), -1), np.ones(len(joints))])
