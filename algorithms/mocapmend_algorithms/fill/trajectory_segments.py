"""The matrix of trajectory segments around a gap, and what it says once it is completed.

For the reference and the steps see `tsmc`.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.fill.company import mean_distances, seen_together
from mocapmend_algorithms.fill.edges import Modelled, with_edges
from mocapmend_algorithms.fill.punch import Window
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.nuclear_norm import complete_rows, row_weights

LEAST_HELPERS = 3
LEAST_WEIGHT = 0.01
"""Markers that count less are left out."""
MOST_ROWS = 1500
"""Frames of the matrix in the gap, and on each side of it, evenly spread."""
TOLERANCE = 1e-3
"""Relative change of the missing rows at which the matrix is complete."""
CHUNK = 4096
"""Frames completed at a time, so that long gaps need little memory."""


@dataclass(frozen=True, eq=False)
class Segments:
    """Which markers and frames make up the matrix of a gap.

    Attributes
    ----------
    helpers : ndarray of int
        Markers that are seen throughout the gap, ascending.
    missing : ndarray of int
        Those that have this very gap, ascending.
    start, stop : int
        Frames of the gap and the samples beside it: they are completed.
    rows : ndarray of int
        The frames around it, all complete.
    complete : int
        How many frames of the recording are complete.
    """

    helpers: IntArray
    missing: IntArray
    start: int
    stop: int
    rows: IntArray
    complete: int

    @classmethod
    def around(cls, observed: BoolArray, gap: Gap, *, around: int) -> "Segments":
        """Choose markers and frames.

        Parameters
        ----------
        observed : ndarray of bool, shape (frames, markers)
            The samples that may be used.
        gap : Gap
            Of a marker that is seen at least once.
        around : int
            Complete frames on each side of it; where the gap is longer, as many as it has.

        Returns
        -------
        Segments
        """
        start, stop = with_edges(observed, gap)
        helps: BoolArray = np.asarray(observed[start:stop].all(axis=0))
        missing = Window.of(observed, gap).alike(observed)
        together, frames = seen_together(observed, np.flatnonzero(helps | missing), gap.marker)
        sides = frames[frames < start], frames[frames >= stop]
        most = max(around, gap.length)
        rows = [evenly(side, MOST_ROWS) for side in (sides[0][-most:], sides[1][:most])]
        helpers, others = together[helps[together]], together[missing[together]]
        return cls(helpers, others, start, stop, np.concatenate(rows), frames.size)

    @property
    def key(self) -> tuple[int, int, bytes, bytes]:
        """Equal for gaps that the same matrix fills."""
        return self.start, self.stop, self.helpers.tobytes(), self.missing.tobytes()

    def say(
        self,
        recording: Recording,
        observed: BoolArray,
        gaps: Sequence[Gap],
        *,
        weight_scale_mm: float,
        missing_weight: float,
        threshold: float,
        progress: Progress,
    ) -> dict[Gap, Modelled]:
        """Complete the matrix and say where markers are in their gaps and beside them.

        Parameters
        ----------
        recording : Recording
            Not changed.
        observed : ndarray of bool, shape (frames, markers)
            The samples that may be used.
        gaps : sequence of Gap
            Of markers that are missing here.
        weight_scale_mm : float
            The distance s in step 2.
        missing_weight : float
            The missing markers' own weight.
        threshold : float
            Share of the largest singular value below which singular values are noise.
        progress : Progress
            Called often.

        Returns
        -------
        dict of Gap to Modelled
        """
        near, nearness = self._nearest(recording, observed, weight_scale_mm)
        columns = np.concatenate((near, self.missing))
        weights = np.append(nearness, np.full(self.missing.size, missing_weight))
        weights = np.repeat(weights, 3)
        seen = np.arange(weights.size) < 3 * near.size
        rows, _ = self._relative(recording, self.rows, columns)
        mean = rows.mean(axis=0)
        inside = evenly(np.arange(self.start, self.stop), MOST_ROWS)
        gap_rows, _ = self._relative(recording, inside, columns)
        known = np.ones((rows.shape[0] + inside.size, weights.size), dtype=np.bool_)
        known[rows.shape[0] :] = seen
        matrix = (np.concatenate((rows, gap_rows)) - mean) * weights
        learned = row_weights(
            matrix, known, threshold=threshold, tolerance=TOLERANCE, progress=progress
        )
        values = np.empty((self.stop - self.start, self.missing.size, 3))
        for first in range(self.start, self.stop, CHUNK):
            frames = np.arange(first, min(first + CHUNK, self.stop))
            one, centre = self._relative(recording, frames, columns)
            full = complete_rows((one - mean) * weights, np.tile(seen, (frames.size, 1)), learned)
            found = (full / weights + mean)[:, ~seen]
            values[frames - self.start] = found.reshape(frames.size, -1, 3) + centre
        notes = {"helpers": near.size, "complete_frames": self.rows.size}
        at = np.searchsorted(self.missing, [gap.marker for gap in gaps]).tolist()
        return {
            gap: Modelled(values[:, column], notes) for gap, column in zip(gaps, at, strict=True)
        }

    def _nearest(
        self, recording: Recording, observed: BoolArray, scale_mm: float
    ) -> tuple[IntArray, FloatArray]:
        """Return the helpers that count, and how much."""
        away = [mean_distances(recording, observed, marker) for marker in self.missing.tolist()]
        distances = np.min(away, axis=0)[self.helpers] * recording.mm
        weights = np.exp((distances.min() ** 2 - distances**2) / (2 * scale_mm**2))
        counts = weights >= LEAST_WEIGHT
        counts[np.argsort(distances, kind="stable")[:LEAST_HELPERS]] = True
        return self.helpers[counts], np.maximum(weights[counts], LEAST_WEIGHT)

    def _relative(
        self, recording: Recording, frames: IntArray, columns: IntArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return coordinates relative to the helpers' centre, and that, frame by frame."""
        centre = recording.points[np.ix_(frames, self.helpers)].mean(axis=1, keepdims=True)
        points = recording.points[np.ix_(frames, columns)] - centre
        return points.reshape(frames.size, -1), centre
