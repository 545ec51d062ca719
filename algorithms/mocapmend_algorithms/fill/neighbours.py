"""The neighbours of a marker: markers whose distance to it varies little."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.donors import Seen

MOST_FRAMES = 100
LEAST_TOGETHER = 10
DONORS = 4
LEAST_DONORS = 3
"""Fewer have no rotation."""
LOOSEST = 0.1
CENTRAL = (0.05, 0.5, 0.95)
WIDTH_PER_SD = 3.29
"""Width of the central 90 % of a normal distribution in standard deviations."""


@dataclass(frozen=True, eq=False)
class Neighbourhood:
    """How far the other markers are from one, as a measure of which are rigidly joined to it.

    It is measured before wrong samples are known, and markers are admitted by it or not: so it is
    robust, the median and the width of the central 90 %, which jumps of a marker in up to 5 % of
    the frames leave alone. About 100 frames are enough for that, and quick.

    Attributes
    ----------
    length : ndarray, shape (markers,)
        Median distance in the recording's unit; NaN for the marker itself and those that are
        hardly ever seen together with it.
    spread : ndarray, shape (markers,)
        Robust standard deviation of the distance; infinite where `length` is NaN.
    """

    length: FloatArray
    spread: FloatArray

    def rigid(self, looseness: float) -> IntArray:
        """Return the markers whose spread is at most this share of their distance, best first."""
        order = np.argsort(self.spread, kind="stable")
        return order[self.spread[order] <= looseness * self.length[order]]


def measure_neighbourhood(points: FloatArray, observed: BoolArray, marker: int) -> Neighbourhood:
    """Measure the distances of all markers to one.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates; about 100 of the frames are looked at.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    marker : int
        The one.

    Returns
    -------
    Neighbourhood
    """
    step = max(1, points.shape[0] // MOST_FRAMES)
    together = observed[::step] & observed[::step, [marker]]
    away = points[::step] - points[::step, [marker]]
    apart = np.sqrt(np.einsum("tmk,tmk->tm", away, away))
    apart = np.sort(np.where(together, apart, np.inf), axis=0)
    count = together.sum(axis=0)
    known = count >= min(LEAST_TOGETHER, apart.shape[0])
    known[marker] = False
    at = np.clip(np.multiply.outer(CENTRAL, count - 1).round(), 0, None).astype(np.int64)
    low, middle, high = np.take_along_axis(apart, at, axis=0)
    length, spread = np.full(known.size, np.nan), np.full(known.size, np.inf)
    length[known] = middle[known]
    spread[known] = (high[known] - low[known]) / WIDTH_PER_SD
    return Neighbourhood(length, spread)


def choose_donors(near: Neighbourhood, needed: IntArray, seen: Seen) -> tuple[int, ...]:
    """Choose the markers that keep their distance to one best.

    Parameters
    ----------
    near : Neighbourhood
        Of that marker.
    needed : ndarray of int
        Frames in which every donor must be seen.
    seen : callable
        See `Seen`.

    Returns
    -------
    tuple of int
        Four markers whose distance varies by at most 10 % (standard deviation), or three; none
        where there are fewer.
    """
    chosen: list[int] = []
    for other in near.rigid(LOOSEST).tolist():
        if seen(other)[needed].all():
            chosen.append(other)
        if len(chosen) == DONORS:
            break
    return tuple(chosen) if len(chosen) >= LEAST_DONORS else ()
