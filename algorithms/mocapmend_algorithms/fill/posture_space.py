"""The low-dimensional space of a recording's postures, and how a posture moves in it (BL16).

For the reference, the steps and where they deviate see `burke_lasenby`; these are 1 and 2.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray, evenly
from mocapmend_algorithms.fill.walk_smoother import Walk
from mocapmend_algorithms.recording import Recording

MOST_FRAMES = 3000
STILL_MM2 = 1e-8
"""Added to the process noise, so that it has an inverse where nothing moves."""


@dataclass(frozen=True, eq=False)
class PostureSpace:
    """The low-dimensional space of a recording, in millimetres.

    Attributes
    ----------
    markers : ndarray of int
        Those that span it, ascending.
    complete : ndarray of int
        Frames that show them all, ascending.
    mean : ndarray, shape (3 markers,)
        Of the complete frames.
    walk : Walk
        The model in it.
    notes : dict
        For the diagnostics.
    """

    markers: IntArray
    complete: IntArray
    mean: FloatArray
    walk: Walk
    notes: dict[str, Any]

    @classmethod
    def learn(
        cls,
        recording: Recording,
        markers: IntArray,
        complete: IntArray,
        *,
        share: float,
        noise_mm: float,
    ) -> "PostureSpace":
        """Find the space.

        Parameters
        ----------
        recording : Recording
            Not changed.
        markers : ndarray of int
            Those that span it, ascending.
        complete : ndarray of int
            Frames that show them all, ascending; at least two of them are consecutive.
        share : float
            Of the sum of the singular values, that the directions kept make up at most.
        noise_mm : float
            Standard deviation of a measured coordinate.

        Returns
        -------
        PostureSpace
        """
        frames = coordinates(recording, evenly(complete, MOST_FRAMES), markers)
        mean = frames.mean(axis=0)
        around = frames - mean
        values, vectors = np.linalg.eigh(around.T @ around / frames.shape[0])
        spreads = np.sqrt(np.clip(values[::-1], 0, None))
        enough = np.cumsum(spreads) <= share * spreads.sum()
        kept = max(int(np.count_nonzero(enough)), 1)
        loadings: FloatArray = vectors[:, ::-1][:, :kept]
        pairs = evenly(complete[:-1][np.diff(complete) == 1], MOST_FRAMES)
        steps = coordinates(recording, pairs + 1, markers) - coordinates(recording, pairs, markers)
        process = (loadings.T * steps.var(axis=0)) @ loadings + STILL_MM2 * np.eye(kept)
        walk = Walk(loadings, process, noise_mm**2, np.diag(spreads[:kept] ** 2))
        return cls(
            markers, complete, mean, walk, {"components": kept, "complete_frames": complete.size}
        )


def coordinates(recording: Recording, frames: IntArray, markers: IntArray) -> FloatArray:
    """Return the coordinates of some markers in some frames, shape (frames, 3 markers), in mm."""
    points: FloatArray = recording.points[np.ix_(frames, markers)] * recording.mm
    return points.reshape(frames.size, -1)
