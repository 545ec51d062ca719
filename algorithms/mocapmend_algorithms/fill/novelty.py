"""How far the posture in a frame is from those that a fill can learn from.

What a marker did is learned from the frames in which it is seen. A posture unlike all of those is
filled worse, and the markers that are seen in the gap tell how unlike it is.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.recording import Recording

LEAST_MARKERS = 3
MOST_KNOWN = 2000
MOST_ASKED = 200
NEARLY_ALWAYS = 0.9
SAME = 1e-3
"""Share of the body's size that two views of one posture may differ by."""


@dataclass(frozen=True, eq=False)
class Novelty:
    """Compares postures with those of the frames that show certain markers.

    Attributes
    ----------
    recording : Recording
        The recording.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    members : ndarray of int
        The markers that are to be filled.
    markers : ndarray of int
        The others, by which postures are compared; none where too few are seen.
    known : ndarray of int
        Frames to learn from, ascending.
    """

    recording: Recording
    observed: BoolArray
    members: IntArray
    markers: IntArray
    known: IntArray

    @classmethod
    def of(
        cls, recording: Recording, observed: BoolArray, members: IntArray, start: int, stop: int
    ) -> "Novelty":
        """Prepare the comparison for a gap of some markers."""
        seen = np.flatnonzero(observed[:, members].all(axis=1))
        often = np.count_nonzero(observed[seen], axis=0) >= NEARLY_ALWAYS * max(seen.size, 1)
        helpers = np.flatnonzero(observed[start:stop].all(axis=0) & often)
        markers = np.setdiff1d(helpers, members)
        if markers.size < LEAST_MARKERS:
            markers = markers[:0]
        known = seen[observed[np.ix_(seen, markers)].all(axis=1)]
        return cls(recording, observed, members, markers, known)

    def __call__(self, hidden: BoolArray, start: int, stop: int) -> FloatArray:
        """Return the RMS distance from the nearest known posture, frame by frame.

        Parameters
        ----------
        hidden : ndarray of bool, shape (frames, markers)
            The samples that may be looked at when the frames asked for are filled.
        start, stop : int
            The frames asked for.

        Returns
        -------
        ndarray, shape (stop - start,)
            In the recording's unit; 0 where nothing can be compared.
        """
        known = self.known[hidden[np.ix_(self.known, self.members)].all(axis=1)]
        if not self.markers.size or not known.size:
            return np.zeros(stop - start)
        asked = np.unique(np.linspace(start, stop - 1, MOST_ASKED).round().astype(np.int64))
        # The frames next to the gap are the nearest ones where it is short.
        edge = int(np.searchsorted(known, start))
        beside = known[max(edge - 1, 0) : edge + 1]
        thinned = np.linspace(0, known.size - 1, MOST_KNOWN).round().astype(np.int64)
        known = np.union1d(known[np.unique(thinned)], beside)
        here, there = self._postures(asked), self._postures(known)
        square = np.sum(here**2, axis=1)[:, None] + np.sum(there**2, axis=1) - 2 * here @ there.T
        size = np.mean(np.sum(there**2, axis=1))
        nearest = np.sqrt((square.min(axis=1) + SAME**2 * size) / self.markers.size)
        good = np.isfinite(nearest)
        if not good.any():
            return np.zeros(stop - start)
        novelty: FloatArray = np.interp(np.arange(start, stop), asked[good], nearest[good])
        return novelty

    def _postures(self, frames: IntArray) -> FloatArray:
        points = self.recording.points[np.ix_(frames, self.markers)]
        points = np.where(self.observed[np.ix_(frames, self.markers)][..., None], points, np.nan)
        around: FloatArray = points - points.mean(axis=1, keepdims=True)
        return around.reshape(frames.size, -1)
