"""A missing marker from the sparse code of a pose over known poses (X13: see `fill.pose_code`)."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.newton import Coder
from mocapmend_algorithms.sparse.poses import Frame, stance, usual_pose

FAINTEST = 1e-3
"""Weight of a marker that is far away: it still says where the body is."""


@dataclass(frozen=True, eq=False)
class Reading:
    """How poses are made comparable.

    Attributes
    ----------
    up : str
        The vertical axis.
    frame : str
        What poses are relative to.
    centred : bool
        Whether the mean pose is taken out.
    reach : float
        Distance from the missing marker at which the others count for 61 %, in the unit of the
        poses; twice as far away, for 14 %.
    least : float
        Poses that differ by less than this are the same.
    """

    up: UpAxis
    frame: Frame
    centred: bool
    reach: float
    least: float


@dataclass(frozen=True, eq=False)
class PoseDictionary:
    """Known poses, split into the markers that are seen and the one that is missing.

    Attributes
    ----------
    reading : Reading
        How poses are made comparable.
    reference : ndarray, shape (seen, 3)
        The pose that all face as.
    coder : Coder
        Of the seen parts, weighted and scaled.
    missing : ndarray, shape (3, poses)
        The missing parts.
    seen_mean, missing_mean : ndarray, shape (3 seen,) and (3,)
        What is taken out: the mean pose, or nothing.
    scale : ndarray, shape (3 seen,)
        What the seen coordinates are multiplied by.
    """

    reading: Reading
    reference: FloatArray
    coder: Coder
    missing: FloatArray
    seen_mean: FloatArray
    missing_mean: FloatArray
    scale: FloatArray

    @classmethod
    def of(cls, seen: FloatArray, missing: FloatArray, reading: Reading) -> "PoseDictionary":
        """Make poses comparable by the markers that are seen.

        Parameters
        ----------
        seen : ndarray, shape (poses, seen, 3)
            The known poses' markers that will be seen.
        missing : ndarray, shape (poses, 3)
            Their marker that will be missing.
        reading : Reading
            See there.

        Returns
        -------
        PoseDictionary
            Scaled so that the weighted seen parts have a mean square of 1: a penalty means the
            same in any unit, and for any number of markers.
        """
        reference = usual_pose(seen, reading.up, reading.frame)
        stances = stance(seen, reference, reading.up, reading.frame)
        around = stances.to_body(seen).reshape(seen.shape[0], -1)
        there = stances.to_body(missing[:, None])[:, 0]
        around_mean, there_mean = np.zeros(around.shape[1]), np.zeros(3)
        if reading.centred:
            around_mean, there_mean = around.mean(axis=0), there.mean(axis=0)
        away = np.linalg.norm(seen - missing[:, None], axis=2).mean(axis=0)
        weights = np.exp(-0.5 * (away / reading.reach) ** 2) + FAINTEST
        around = (around - around_mean) * np.repeat(weights, 3)
        size = np.sqrt(np.mean(np.sum(around**2, axis=1)))
        size = max(float(size), reading.least)
        return cls(
            reading,
            reference,
            Coder.of(around.T / size),
            (there - there_mean).T,
            around_mean,
            there_mean,
            np.repeat(weights / size, 3),
        )

    def find(
        self, points: FloatArray, keys: IntArray, penalty: float, progress: Progress
    ) -> tuple[FloatArray, float]:
        """Say where the missing marker is.

        Parameters
        ----------
        points : ndarray, shape (frames, seen, 3)
            The markers that are seen, in the world.
        keys : ndarray of int
            Frames in which the code is found, the first and the last among them; between them, the
            place beside the body is on a cubic spline.
        penalty : float
            Of the sum of the absolute weights.
        progress : Progress
            Called often.

        Returns
        -------
        places : ndarray, shape (frames, 3)
            In the world.
        used : float
            Known poses in the code of a frame, on average.
        """
        stances = stance(points, self.reference, self.reading.up, self.reading.frame)
        around = stances.to_body(points)[keys].reshape(keys.size, -1)
        targets = ((around - self.seen_mean) * self.scale).T
        codes = self.coder.encode(np.ascontiguousarray(targets), penalty, progress=progress)
        there = (self.missing @ codes.weights).T + self.missing_mean
        used = float(np.count_nonzero(codes.weights) / max(keys.size, 1))
        if keys.size < points.shape[0]:
            from scipy.interpolate import CubicSpline

            there = CubicSpline(keys, there)(np.arange(points.shape[0]))
        return stances.to_world(there[:, None])[:, 0], used
