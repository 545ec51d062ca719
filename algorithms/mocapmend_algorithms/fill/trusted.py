"""The samples of a recording that a fill may look at."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, IntArray
from mocapmend_algorithms.detection import jump_threshold, wrong_samples
from mocapmend_algorithms.fill.neighbours import Neighbourhood, measure_neighbourhood
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.recording import Recording

LONGEST_WRONG_S = 0.1


class TrustedSamples:
    """Those that are there, are not in a gap to be filled, and not marked as wrong.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to be filled: samples inside them are never looked at.
    jump_mm : float or None
        The step between two frames (mm) above which a marker was lost; see
        `detection.wrong_samples`. None: estimated for each marker.
    """

    def __init__(self, recording: Recording, gaps: Sequence[Gap], jump_mm: float | None) -> None:
        self._recording = recording
        self._jump = None if jump_mm is None else jump_mm / recording.mm
        self._observed = seen_outside(recording.present, gaps)
        self._trusted: dict[int, BoolArray] = {}
        self._near: dict[int, Neighbourhood] = {}

    def seen(self, marker: int) -> BoolArray:
        """Return whether each sample of a marker is trusted, shape (frames,)."""
        if marker not in self._trusted:
            observed = self._observed[:, marker, None]
            points = np.where(observed[:, :, None], self._recording.points[:, [marker]], np.nan)
            delta = jump_threshold(points) if self._jump is None else self._jump
            longest = max(1, round(LONGEST_WRONG_S * self._recording.rate))
            self._trusted[marker] = (observed & ~wrong_samples(points, delta, longest))[:, 0]
        return self._trusted[marker]

    def wrong(self, marker: int) -> IntArray:
        """Return the frames in which a marker is there and not trusted."""
        return np.flatnonzero(self._observed[:, marker] & ~self.seen(marker))

    def near(self, marker: int) -> Neighbourhood:
        """Return the distances of the other markers to one."""
        if marker not in self._near:
            self._near[marker] = measure_neighbourhood(
                self._recording.points, self._observed, marker
            )
        return self._near[marker]

    def window(self, gap: Gap, reach: int) -> IntArray:
        """Return the frames of the nearest trusted samples on both sides, at most `reach` each."""
        frames = np.flatnonzero(self.seen(gap.marker))
        middle = int(np.searchsorted(frames, gap.start))
        return frames[max(middle - reach, 0) : middle + reach]
