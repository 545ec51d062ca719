"""Steps in a trajectory: what its smooth continuation does not explain."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.problems.levels import running_level

BREAK = 4.0
"""Times the level around it that a step has where a trajectory breaks."""
CLEAR_BREAK = 8.0
ECHO = 0.7
"""Of a step: the third difference has half of it at the frames on both sides."""
NEXT = 4
OPPOSITE = 0.35
"""Of the larger of two steps: what is left where one takes the other back."""


def step_vectors(points: FloatArray) -> FloatArray:
    """Measure the steps in a trajectory.

    Parameters
    ----------
    points : ndarray, shape (frames, ...)
        One trajectory, or several measures of it; NaN = missing.

    Returns
    -------
    ndarray, shape (frames, ...)
        At t the step between t - 1 and t, from the third difference: one of size 1 makes it 2 (and
        3 beside a single sample). NaN where one of two samples on either side is missing.
    """
    step = np.full(points.shape, np.nan)
    third = points[3:] - 3.0 * points[2:-1] + 3.0 * points[1:-2] - points[:-3]
    step[2:-1] = third / -2.0
    return step


def step_sizes(points: FloatArray) -> FloatArray:
    """Return the lengths of `step_vectors` of one trajectory, shape (frames,)."""
    step = step_vectors(points)
    sizes: FloatArray = np.sqrt(np.einsum("tk,tk->t", step, step))
    return sizes


class Excursion(NamedTuple):
    """A piece of a trajectory between a step and one that takes it back."""

    start: int
    stop: int
    size: float


def excursions(points: FloatArray, rate: float, least: float, longest: int) -> list[Excursion]:
    """Find pieces of a trajectory that lie between two opposite steps.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        One trajectory, NaN = missing.
    rate : float
        Frames per second.
    least : float
        The smallest step.
    longest : int
        Frames of the longest piece.

    Returns
    -------
    list of Excursion
        Ordered by start; they do not overlap.
    """
    step = step_vectors(points)
    size = np.sqrt(np.einsum("tk,tk->t", step, step))
    with np.errstate(invalid="ignore"):
        broken = size > np.maximum(least, CLEAR_BREAK * running_level(size, rate))
        broken[1:] &= size[1:] >= ECHO * size[:-1]
        broken[:-1] &= size[:-1] >= ECHO * size[1:]
    edges = np.flatnonzero(broken).tolist()
    found: list[Excursion] = []
    for at, start in enumerate(edges):
        if found and start <= found[-1].stop:
            continue
        for stop in edges[at + 1 : at + 1 + NEXT]:
            larger = float(max(size[start], size[stop]))
            left = float(np.linalg.norm(step[start] + step[stop]))
            if stop - start <= longest and left <= OPPOSITE * larger:
                found.append(Excursion(start, stop, larger))
                break
    return found
