"""A first guess of the samples that donors lack, so that they can teach all the same.

Where 30 % of the samples are missing, hardly a frame has all donors. A donor's short gaps are
bridged with the rigid motion of its own neighbours; that is good to some millimetres, and what is
learned from it is tested like all else.
"""

from collections.abc import Iterator

import numpy as np

from mocapmend_algorithms.alignment import LEAST_FOR_ROTATION, turns
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.donors import DonorDistances
from mocapmend_algorithms.gaps import Gap, runs

LONGEST_S = 1.0
NEIGHBOURS = 4
NEARNESS = 0.02


class Completion:
    """Bridges the gaps of donors.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        In mm; not changed.
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
        self._known: dict[int, BoolArray] = {}
        self._bridges: dict[int, tuple[IntArray, FloatArray]] = {}
        """Of a marker that is complete: the frames that are bridged, ascending, and values there.

        A copy of a long recording would take much more.
        """

    def known(self, marker: int) -> BoolArray:
        """Return the frames in which a marker is seen, or missing for a second at most."""
        if marker not in self._known:
            known = self._observed[:, marker].copy()
            for gap in self._bridged(marker):
                known[gap.start : gap.stop] = True
            known.flags.writeable = False
            self._known[marker] = known
        return self._known[marker]

    def complete(self, marker: int) -> None:
        """Make bridges for all gaps of a marker that are short enough."""
        if marker in self._bridges:
            return
        starts = np.array([gap.start for gap in self._bridged(marker)], dtype=np.int64)
        lengths = np.array([gap.length for gap in self._bridged(marker)], dtype=np.int64)
        frames, values = [np.empty(0, np.int64)], [np.empty((0, 3))]
        for length in np.unique(lengths).tolist():
            for where, bridged in self._bridge(marker, starts[lengths == length], length):
                frames.append(where.ravel())
                values.append(bridged.reshape(-1, 3))
        order = np.argsort(np.concatenate(frames))
        self._bridges[marker] = np.concatenate(frames)[order], np.concatenate(values)[order]

    def at(self, frames: IntArray, markers: IntArray) -> FloatArray:
        """Return samples, with the bridges of those markers that are complete.

        Parameters
        ----------
        frames : ndarray of int, shape (n,)
            In any order.
        markers : ndarray of int, shape (m,)
            Indices of markers.

        Returns
        -------
        ndarray, shape (n, m, 3)
            In mm.
        """
        values: FloatArray = self._points[frames[:, None], markers]
        for column, marker in enumerate(markers.tolist()):
            bridged, bridges = self._bridges.get(marker, (frames[:0], values[:0, column]))
            if not bridged.size:
                continue
            place = np.minimum(np.searchsorted(bridged, frames), bridged.size - 1)
            there = bridged[place] == frames
            values[there, column] = bridges[place[there]]
        return values

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

    def _bridge(
        self, marker: int, starts: IntArray, length: int
    ) -> Iterator[tuple[IntArray, FloatArray]]:
        """Yield frames and values of gaps of the same length, by how many neighbours are seen."""
        around = starts[:, None] + np.arange(-1, length + 1)
        known = self._distances.to(marker)
        known = known[known.best(len(known), NEARNESS)]
        seen = self._observed[around][:, :, known.markers].all(axis=1)
        chosen = seen & (np.cumsum(seen, axis=1) <= NEIGHBOURS)
        count = chosen.sum(axis=1)
        for neighbours in np.unique(count).tolist():
            alike = count == neighbours
            frames = around[alike]
            best = np.nonzero(chosen[alike])[1].reshape(frames.shape[0], neighbours)
            donors = self._points[frames[:, :, None], known.markers[best][:, None]]
            ends = self._points[frames[:, [0, -1]], marker]
            weights = 1 / (known.spread[best] ** 2 + 1)
            yield frames[:, 1:-1], _moved(ends, donors, weights)


def _moved(ends: FloatArray, donors: FloatArray, weights: FloatArray) -> FloatArray:
    """Move markers with donors, shape (gaps, frames, donors, 3), between the first and last frame.

    In the frame of reference of the donors, if any, they move straight.
    """
    gaps, frames, count, _ = donors.shape
    centre = np.zeros((gaps, frames, 3))
    turn = np.broadcast_to(np.eye(3), (gaps, frames, 3, 3))
    if count:
        share = weights / weights.sum(axis=1, keepdims=True)
        centre = np.einsum("gfdi,gd->gfi", donors, share)
    if count >= LEAST_FOR_ROTATION:
        around = donors - centre[:, :, None]
        turn = turns(np.einsum("gfdi,gd,gdj->gfij", around, share, around[:, 0]))
    local = np.einsum("gfi,gfij->gfj", ends - centre[:, [0, -1]], turn[:, [0, -1]])
    part = np.linspace(0, 1, frames)[1:-1, None]
    between = (1 - part) * local[:, :1] + part * local[:, 1:]
    moved: FloatArray = np.einsum("gfij,gfj->gfi", turn[:, 1:-1], between) + centre[:, 1:-1]
    return moved
