"""Moving missing points so that bones keep their lengths, and nothing else moves.

W18's recovery meets bone lengths to some 1e-4 cm by its dictionary; here the last step meets them
to rounding. Points move as little as they can, in a measure that may say which of them are known
better: Gauss-Newton steps with Levenberg's damping on the missing points of each frame, all frames
at once (in one frame it is what position-based dynamics call a projection, Müller et al. 2007).
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray

ROUNDS = 60
DONE = 1e-12
"""Share of the longest bone that lengths may miss."""
FIRST_DAMPING = 1e-6
LEAST_DAMPING = 1e-12
MOST_DAMPING = 1e6


@dataclass(frozen=True, eq=False)
class BoneConstraints:
    """The bones that are to keep their lengths.

    Attributes
    ----------
    bones : ndarray of int, shape (bones, 2)
        Markers at the two ends; at least one of them may move.
    lengths : ndarray, shape (bones,)
        In the unit of the points.
    """

    bones: IntArray
    lengths: FloatArray


def project_bones(
    points: FloatArray,
    movable: IntArray,
    constraints: BoneConstraints,
    covariance: FloatArray | None = None,
) -> FloatArray:
    """Move some markers so that bones have their lengths.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Places; not changed. Bones with an end that is missing (NaN) do not count there.
    movable : ndarray of int
        The markers that may move.
    constraints : BoneConstraints
        The bones.
    covariance : ndarray, shape (movable, movable), optional
        How unsure a coordinate of each marker is, and how alike: what is less sure moves further,
        and what errs together moves together. All alike by default.

    Returns
    -------
    ndarray, shape (frames, movable, 3)
        Where lengths contradict each other (an end out of reach, noise at several fixed ends) the
        squares of what they miss are least.
    """
    movable = np.asarray(movable, dtype=np.int64)
    if covariance is None:
        covariance = np.eye(movable.size)
    metric: FloatArray = np.kron(covariance / np.trace(covariance) * movable.size, np.eye(3))
    return _Projection(points, movable, constraints, metric).solve()


class _Projection:
    """The frames that are not done, and where their points are."""

    def __init__(
        self,
        points: FloatArray,
        movable: IntArray,
        constraints: BoneConstraints,
        metric: FloatArray,
    ) -> None:
        self._points = points.copy()
        self._movable, self._metric = movable, metric
        self._bones, self._lengths = constraints.bones, constraints.lengths
        ends = self._bones[:, :, None] == movable
        self._signs = ends[:, 0].astype(np.float64) - ends[:, 1]

    def solve(self) -> FloatArray:
        frames = np.arange(len(self._points))
        damping = np.full(frames.size, FIRST_DAMPING)
        tolerance = DONE * float(self._lengths.max(initial=0.0))
        miss, along = self._missed(frames)
        for _ in range(ROUNDS):
            open_ = np.abs(miss).max(axis=1, initial=0.0) > tolerance
            open_ &= damping < MOST_DAMPING
            if not open_.any():
                break
            frames, damping, miss, along = frames[open_], damping[open_], miss[open_], along[open_]
            before = self._points[np.ix_(frames, self._movable)]
            self._set(frames, before + self._step(miss, along, damping))
            now, turned = self._missed(frames)
            better = np.sum(now**2, axis=1) < np.sum(miss**2, axis=1)
            self._set(frames[~better], before[~better])
            damping = np.where(better, np.maximum(damping / 10, LEAST_DAMPING), damping * 10)
            miss = np.where(better[:, None], now, miss)
            along = np.where(better[:, None, None], turned, along)
        return self._points[:, self._movable]

    def _set(self, frames: IntArray, places: FloatArray) -> None:
        self._points[np.ix_(frames, self._movable)] = places

    def _missed(self, frames: IntArray) -> tuple[FloatArray, FloatArray]:
        """Return by how much each bone is too long, and its direction."""
        ends = self._points[frames][:, self._bones]
        away = ends[:, :, 0] - ends[:, :, 1]
        length = np.sqrt(np.einsum("fbi,fbi->fb", away, away))
        there: BoolArray = np.asarray(length > 0)
        along = np.where(there[..., None], away / np.where(there, length, 1.0)[..., None], 0.0)
        return np.where(there, length - self._lengths, 0.0), along

    def _step(self, miss: FloatArray, along: FloatArray, damping: FloatArray) -> FloatArray:
        frames, bones = miss.shape
        slope = (self._signs[None, :, :, None] * along[:, :, None, :]).reshape(frames, bones, -1)
        moved = slope @ self._metric
        system = moved @ slope.swapaxes(1, 2) + damping[:, None, None] * np.eye(bones)
        force = np.linalg.solve(system, miss[..., None])
        step: FloatArray = -(moved.swapaxes(1, 2) @ force).reshape(frames, -1, 3)
        return step
