"""What simple thresholds find, each with the threshold that suits the very same errors best."""

from collections.abc import Callable

import numpy as np

from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray

MM = 1000.0


def speed(recording: Recording) -> FloatArray:
    """Return the smaller speed into and out of each sample in m/s, shape (frames, markers)."""
    points = recording.points * recording.mm / MM
    steps = np.linalg.norm(np.diff(points, axis=0), axis=2) * recording.rate
    smaller = np.zeros(points.shape[:2])
    if len(steps) > 1:
        smaller[1:-1] = np.fmin(steps[1:], steps[:-1])
    return np.nan_to_num(smaller)


def acceleration(recording: Recording) -> FloatArray:
    """Return the acceleration at each sample in m/s^2, shape (frames, markers)."""
    points = recording.points * recording.mm / MM
    size = np.zeros(points.shape[:2])
    if recording.frames > 2:
        size[1:-1] = np.linalg.norm(np.diff(points, n=2, axis=0), axis=2) * recording.rate**2
    return np.nan_to_num(size)


RIVALS: dict[str, tuple[Callable[[Recording], FloatArray], str]] = {
    "velocity threshold": (speed, "m/s"),
    "acceleration threshold": (acceleration, "m/s^2"),
}


def best_threshold(sizes: FloatArray, truth: FloatArray) -> float:
    """Return the threshold above which the sizes give the best F1.

    Parameters
    ----------
    sizes, truth : ndarray, shape (samples,)
        Of each sample, and whether it is bad.
    """
    order = np.argsort(-sizes, kind="stable")
    right = np.cumsum(truth[order])
    f1 = 2 * right / (np.arange(1, len(order) + 1) + truth.sum())
    return float(sizes[order[int(np.argmax(f1))]])
