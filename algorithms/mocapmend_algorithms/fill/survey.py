"""A recording as its gaps share it: who helps to fill a gap, and which frames teach how."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.completion import Completion
from mocapmend_algorithms.fill.donors import (
    DonorDistances,
    Donors,
    by_label,
    check_seen,
    edges_seen,
)
from mocapmend_algorithms.fill.each import LeftOpenError
from mocapmend_algorithms.fill.lessons import Size, plan
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.recording import Recording

LEAST_TOGETHER = 0.5
KEPT_SHARE = 0.9
NEARNESS = 0.02
FEW = 12
MOSTLY = 0.7
DOUBT_MM = 20.0


class Survey:
    """A recording as its gaps share it.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        Samples inside them are never looked at.
    """

    def __init__(self, recording: Recording, gaps: Sequence[Gap]) -> None:
        self.recording = recording
        self.observed: BoolArray = seen_outside(recording.present, gaps)

    @cached_property
    def points(self) -> FloatArray:
        """The samples in mm, NaN where they may not be looked at; not to be changed."""
        recording = self.recording
        if recording.mm == 1.0 and np.array_equal(self.observed, recording.present):
            return recording.points
        points = np.where(self.observed[:, :, None], self.recording.points, np.nan)
        points *= self.recording.mm
        return points

    @cached_property
    def distances(self) -> DonorDistances:
        """How the markers move with each other."""
        return DonorDistances(self.points, self.observed)

    @cached_property
    def completion(self) -> Completion:
        """What donors lack."""
        return Completion(self.points, self.observed, self.distances, self.recording.rate)

    def donors(self, gap: Gap, labels: Sequence[str], *, at_edges: bool, enough: int) -> Donors:
        """Choose the donors of a gap.

        Parameters
        ----------
        gap : Gap
            To be filled.
        labels : sequence of str
            Donors that the user names; where there are none, all markers are candidates that are
            seen throughout the gap and often with its marker.
        at_edges : bool
            Whether they must be seen at the frames before and after the gap too.
        enough : int
            Automatic donors that are often missing are left out as long as there are fewer frames
            than this to learn from.

        Returns
        -------
        Donors
            Possibly none.

        Raises
        ------
        LeftOpenError
            If the marker is never seen, or a donor that the user names is missing.
        """
        if not self.observed[:, gap.marker].any():
            raise LeftOpenError("the marker is never seen in this recording")
        known = self.distances.to(gap.marker)
        if labels:
            wanted = by_label(self.recording.labels, labels)
            check_seen(
                self.recording.labels,
                lambda marker: self.observed[:, marker],
                gap,
                wanted,
                at_edges=at_edges,
            )
            for marker in np.setdiff1d(wanted, known.markers).tolist():
                label = self.recording.labels[marker]
                raise LeftOpenError(
                    f"the marker and its donor {label} are hardly ever seen together"
                )
            return known[np.isin(known.markers, wanted)]
        share = self.observed[gap.start : gap.stop].mean(axis=0)[known.markers]
        seen = share == 1.0
        if at_edges:
            seen &= edges_seen(self.observed, gap)[known.markers]
        elif np.count_nonzero(seen) < FEW:
            seen |= (share >= MOSTLY) & self._bridged(gap, known.markers)
            known = Donors(known.markers, known.spread + DOUBT_MM * (1 - share), known.distance)
        return self._together(gap, known[seen], enough)

    def case(self, gap: Gap, donors: Donors, size: Size) -> Case:
        """Collect what a fill of a gap looks at.

        Raises
        ------
        LeftOpenError
            If the marker and its donors are hardly ever seen together.
        """
        usable = self.observed[:, gap.marker].copy()
        for marker in donors.markers.tolist():
            usable &= self.completion.known(marker)
            self.completion.complete(marker)
        lesson = plan(usable, gap, size)
        if lesson.frames.size < 2:
            raise LeftOpenError("the marker and its donors are hardly ever seen together")
        return Case(
            gap=gap,
            rate=self.recording.rate,
            up=_direction(self.recording.up),
            lesson=lesson,
            frames=np.concatenate((lesson.frames, np.arange(gap.start, gap.stop))),
            donors=donors,
            target=self.points[lesson.frames, gap.marker],
            seen=self.observed[:, gap.marker],
            track=self.points[:, gap.marker],
            completion=self.completion,
        )

    def _bridged(self, gap: Gap, markers: IntArray) -> BoolArray:
        """Return which markers are seen or bridged throughout a gap."""
        inside = slice(gap.start, gap.stop)
        return np.array([self.completion.known(m)[inside].all() for m in markers.tolist()], bool)

    def _together(self, gap: Gap, found: Donors, enough: int) -> Donors:
        """Leave out donors without which there are many more frames to learn from."""
        usable = self.observed[:, gap.marker]
        least = LEAST_TOGETHER * np.count_nonzero(usable)
        kept = []
        for place in found.best(len(found), NEARNESS).tolist():
            both = usable & self.completion.known(int(found.markers[place]))
            count = np.count_nonzero(both)
            if count >= min(enough, KEPT_SHARE * np.count_nonzero(usable)) and count >= least:
                usable = both
                kept.append(place)
        return found[np.array(kept, dtype=np.int64)]


def _direction(up: str) -> FloatArray:
    direction = np.zeros(3)
    direction["xyz".index(up[1])] = 1.0 if up[0] == "+" else -1.0
    return direction
