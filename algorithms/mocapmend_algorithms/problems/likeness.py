"""Which of two labels two trajectories are more like, by the distances to their neighbours."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.problems.mates import nearest_mates
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import PairDistances

SPREAD_FLOOR_MM = 4.0
MOST_SQUARE = 25.0
"""Of one distance: a mate that is wrong itself must not decide alone."""


class Likeness:
    """Compares trajectories with labels.

    Parameters
    ----------
    recording : Recording
        Whose markers.
    distances : PairDistances
        What is usual of all pairs of its markers.
    """

    def __init__(self, recording: Recording, distances: PairDistances) -> None:
        self._recording = recording
        self._length = distances.length
        self._spread = np.hypot(distances.spread, SPREAD_FLOOR_MM)
        self.mates = nearest_mates(distances, recording.markers)

    def swapped(self, first: int, second: int, frames: IntArray) -> FloatArray:
        """Say how much more like each other's labels two markers are than like their own.

        Parameters
        ----------
        first, second : int
            The markers.
        frames : ndarray of int, shape (n,)
            Where.

        Returns
        -------
        ndarray, shape (n,)
            Difference of squared deviations in standard deviations, summed over the distances that
            can be measured and divided by the root of their number, as they are not independent;
            above 0 where the labels are swapped, 0 where nothing is known.
        """
        mates = [
            mate
            for mate in dict.fromkeys((*self.mates[first], *self.mates[second]))
            if mate not in (first, second)
            and not np.isnan(self._length[[first, second], mate]).any()
        ]
        if not mates:
            return np.zeros(len(frames))
        millimetres = self._recording.mm
        around = self._recording.points[frames[:, None], mates] * millimetres
        total, count = np.zeros((2, len(frames)))
        for stored, label in ((first, second), (second, first)):
            apart = around - self._recording.points[frames, stored][:, None] * millimetres
            away = np.sqrt(np.einsum("nmk,nmk->nm", apart, apart))
            more = self._squares(away, stored, mates) - self._squares(away, label, mates)
            known = ~np.isnan(more)
            total += np.where(known, more, 0.0).sum(axis=1)
            count += known.sum(axis=1)
        return total / np.sqrt(np.maximum(count, 1.0))

    def _squares(self, away: FloatArray, label: int, mates: list[int]) -> FloatArray:
        """Return twice the negative log likelihoods: a wide label does not fit all for nothing."""
        spread = self._spread[label, mates]
        off = (away - self._length[label, mates]) / spread
        return np.minimum(off**2, MOST_SQUARE) + 2.0 * np.log(spread)
