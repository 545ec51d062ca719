"""How long and how constant the distance of every pair of markers is."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

MOST_FRAMES = 300
LEAST_FRAMES = 40
MOST_MEASURED = 3e7
"""Distances: with many markers fewer frames are looked at, or a crowd would take many seconds."""
LEAST_TOGETHER = 10
MOST_MARKERS = 1000
"""All pairs are measured: of more markers, which no body wears, memory could run out."""
CENTRAL = (0.05, 0.5, 0.95)
WIDTH_IN_SD = 3.29
"""The width of the central 90 % of a normal distribution, in standard deviations."""


@dataclass(frozen=True, eq=False)
class PairDistances:
    """The distances of all pairs of markers, as a measure of which are joined by bones.

    They come from the recording as it is, with markers swapped and jumping: so they are robust,
    the median and the width of the central 90 %. All pairs of all markers are needed at once, so
    the number of frames depends on the number of markers; a short recording must do with fewer
    frames together than elsewhere, as it is to have a skeleton too.

    Attributes
    ----------
    length : ndarray, shape (markers, markers)
        Median distance in mm; NaN where the two were hardly ever seen together.
    spread : ndarray, shape (markers, markers)
        Robust standard deviation of the distance in mm; NaN likewise.
    """

    length: FloatArray
    spread: FloatArray

    @property
    def known(self) -> BoolArray:
        """Whether a pair was seen often enough, shape (markers, markers)."""
        return ~np.isnan(self.length)


def measure_distances(recording: Recording, progress: Progress) -> PairDistances:
    """Measure the distances of all pairs of markers.

    Parameters
    ----------
    recording : Recording
        About 300 of its frames are looked at, evenly spread, fewer where there are more than 300
        markers; and at each pair in those where both are seen.
    progress : Progress
        Called once per marker.

    Returns
    -------
    PairDistances

    Raises
    ------
    ValueError
        If there are more than `MOST_MARKERS`.
    """
    markers = recording.markers
    if markers > MOST_MARKERS:
        raise ValueError(f"the distances of {markers} markers are too many to measure")
    length, spread = np.full((2, markers, markers), np.nan)
    if recording.frames > 1:
        affordable = int(np.clip(MOST_MEASURED / max(markers, 1) ** 2, LEAST_FRAMES, MOST_FRAMES))
        step = max(1, recording.frames // affordable)
        points = recording.points[::step] * recording.mm
        least = max(2, min(LEAST_TOGETHER, points.shape[0] // 4))
        for marker in range(markers - 1):
            progress(marker / markers)
            others = slice(marker + 1, markers)
            middle, width = _measure(points[:, marker], points[:, others], least)
            length[marker, others] = length[others, marker] = middle
            spread[marker, others] = spread[others, marker] = width / WIDTH_IN_SD
    progress(1.0)
    return PairDistances(length, spread)


def _measure(one: FloatArray, others: FloatArray, least: int) -> tuple[FloatArray, FloatArray]:
    """Return the median distance and the width of the central 90 %."""
    distance = np.linalg.norm(others - one[:, None], axis=2)
    distance.sort(axis=0)  # NaN last
    count = distance.shape[0] - np.isnan(distance).sum(axis=0)
    at = np.clip(np.multiply.outer(CENTRAL, count - 1).round(), 0, None)
    low, middle, high = np.take_along_axis(distance, at.astype(np.int64), axis=0)
    enough = count >= least
    return np.where(enough, middle, np.nan), np.where(enough, high - low, np.nan)
