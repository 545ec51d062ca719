"""A first guess of the samples that donors lack, so that they can teach all the same.

Where 30 % of the samples are missing, hardly a frame has all donors. A donor's short gaps are
bridged with the rigid motion of its own neighbours; that is good to some millimetres, and what is
learned from it is tested like all else.
"""

import numpy as np

from mocapmend_algorithms.alignment import align
from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.fill.donors import DonorDistances, edges_seen
from mocapmend_algorithms.gaps import Gap, runs

LONGEST_S = 1.0
NEIGHBOURS = 4
NEARNESS = 0.02


class Completion:
    """Bridges the gaps of donors.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        In mm; the bridges are written into it.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    distances : DonorDistances
        How the markers move with each other.
    rate : float
        Frames per second (Hz).
    """

    def __init__(
        self, points: FloatArray, observed: BoolArray, distances: DonorDistances, rate: float
    ) -> None:
        self._points = points
        self._observed = observed
        self._distances = distances
        self._longest = max(1, round(LONGEST_S * rate))
        self._gaps: dict[int, list[Gap]] = {}
        self._done: set[int] = set()

    def known(self, marker: int) -> BoolArray:
        """Return the frames in which a marker is seen, or missing for a second at most."""
        known = self._observed[:, marker].copy()
        for gap in self._bridged(marker):
            known[gap.start : gap.stop] = True
        return known

    def complete(self, marker: int) -> None:
        """Write bridges into all gaps of a marker that are short enough."""
        if marker in self._done:
            return
        self._done.add(marker)
        for gap in self._bridged(marker):
            self._points[gap.start : gap.stop, marker] = self._bridge(gap)

    def _bridged(self, marker: int) -> list[Gap]:
        if marker not in self._gaps:
            frames = self._observed.shape[0]
            gaps = [Gap(marker, *run) for run in runs(~self._observed[:, marker])]
            self._gaps[marker] = [
                gap
                for gap in gaps
                if gap.length <= self._longest and gap.kind(frames) == "interior"
            ]
        return self._gaps[marker]

    def _bridge(self, gap: Gap) -> FloatArray:
        around = slice(gap.start - 1, gap.stop + 1)
        known = self._distances.to(gap.marker)
        seen = np.logical_and.reduce(self._observed[around][:, known.markers])
        known = known[seen & edges_seen(self._observed, gap)[known.markers]]
        share = (np.arange(1, gap.length + 1) / (gap.length + 1))[:, None]
        ends = self._points[[gap.start - 1, gap.stop], gap.marker]
        if not len(known):
            straight: FloatArray = (1 - share) * ends[0] + share * ends[1]
            return straight
        best = known.best(NEIGHBOURS, NEARNESS)
        donors = self._points[around][:, known.markers[best]]
        frame = align(donors, donors[0], 1 / (known.spread[best] ** 2 + 1))
        first, last = frame[:1].to_local(ends[:1]), frame[-1:].to_local(ends[1:])
        return frame[1:-1].to_world((1 - share) * first + share * last)
