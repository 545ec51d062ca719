"""Bringing two recordings of one movement to the same time and axes."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.alignment import turns
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.preparing import RATE, RefineError

LONGEST_LAG = 1.0
"""Seconds by which one recording may have begun before the other."""
LEAST_SHARED = 30
"""Frames in common, half a second."""


@dataclass(frozen=True, eq=False)
class Alignment:
    """How a reference lies to a recording.

    Attributes
    ----------
    lag : int
        Frames; what the reference shows in frame f, the recording shows in frame f + lag.
    rotation : ndarray, shape (3, 3)
        Turns vectors of the recording into those of the reference.
    rms : float
        Distance that remains between the points, root mean square, after a shift that they have
        in common.
    """

    lag: int
    rotation: FloatArray
    rms: float

    @property
    def seconds(self) -> float:
        """The lag in seconds."""
        return self.lag / RATE


def align_in_time(points: FloatArray, reference: FloatArray) -> Alignment:
    """Find the lag and the rotation with which a recording fits a reference best.

    For each lag up to a second either way the rotation of least squares (Kabsch 1976) is found.

    Parameters
    ----------
    points : ndarray, shape (frames, points, 3)
        Of the recording, complete, relative to its root, at 60 frames per second.
    reference : ndarray, shape (other frames, points, 3)
        The same points of the reference; NaN where missing.

    Raises
    ------
    RefineError
        If they have less than half a second in common.
    """
    longest = round(LONGEST_LAG * RATE)
    fits = [_fit(points, reference, lag) for lag in range(-longest, longest + 1)]
    known = [fit for fit in fits if fit is not None]
    if not known:
        raise RefineError("recording and reference have less than half a second in common")
    return min(known, key=lambda fit: fit.rms)


def in_common(lag: int, frames: int, others: int) -> tuple[slice, slice]:
    """Return which frames of a recording, and of a reference, show the same.

    Parameters
    ----------
    lag : int
        As `Alignment.lag`.
    frames, others : int
        How many the recording and the reference have.
    """
    first, last = max(0, lag), min(frames, others + lag)
    return slice(first, last), slice(first - lag, last - lag)


def _fit(points: FloatArray, reference: FloatArray, lag: int) -> Alignment | None:
    ours, theirs = in_common(lag, len(points), len(reference))
    if ours.stop - ours.start < LEAST_SHARED:
        return None
    seen = reference[theirs]
    there = ~np.isnan(seen).any(axis=(1, 2))
    if np.count_nonzero(there) < LEAST_SHARED:
        return None
    own, other = points[ours][there].reshape(-1, 3), seen[there].reshape(-1, 3)
    own, other = own - own.mean(axis=0), other - other.mean(axis=0)
    rotation = turns(other.T @ own)
    rest = other - own @ rotation.T
    return Alignment(lag, rotation, float(np.sqrt((rest**2).sum(axis=1).mean())))
