"""Windows of motion as rows: what is learned from, and what is asked."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.heading import headings, mean_pose, turned
from mocapmend_algorithms.sparse.rows import Rows, differences
from mocapmend_algorithms.sparse.windows import Span

OWN_SHARE = 0.5
"""Most of the examples that the recording itself gives where a training set has others."""


@dataclass(frozen=True, eq=False)
class Motion:
    """A stretch of motion to learn from.

    Attributes
    ----------
    points : ndarray, shape (frames, markers, 3)
        In mm, NaN = missing.
    seen : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    """

    points: FloatArray
    seen: BoolArray


@dataclass(frozen=True, eq=False)
class View:
    """How windows become rows.

    Attributes
    ----------
    rows : Rows
        The pairs of markers.
    span : Span
        The frames of a window.
    up : str
        The vertical axis.
    reference : ndarray, shape (helpers, 3), or None
        The pose that has heading 0; None leaves the heading as it is.
    """

    rows: Rows
    span: Span
    up: UpAxis
    reference: FloatArray | None

    def known(self, motion: Motion, places: IntArray) -> tuple[FloatArray, FloatArray]:
        """Return the known rows of windows, and the windows' headings.

        Returns
        -------
        known : ndarray, shape (places, frames of a window * known * 3)
        angles : ndarray, shape (places,)
            In radians.
        """
        angles = self._angles(motion, places)
        return self._rows(motion, places, self.rows.known, angles), angles

    def lost(self, motion: Motion, places: IntArray, angles: FloatArray) -> FloatArray:
        """Return the lost rows of windows that show them."""
        return self._rows(motion, places, self.rows.lost, angles)

    def both(self, chosen: Sequence[tuple[Motion, IntArray]]) -> tuple[FloatArray, FloatArray]:
        """Return the known and the lost rows of windows of motions that show both."""
        known, lost = [], []
        for motion, places in chosen:
            some, angles = self.known(motion, places)
            known.append(some)
            lost.append(self.lost(motion, places, angles))
        return np.concatenate(known), np.concatenate(lost)

    def told(self, lost: FloatArray, angles: FloatArray) -> FloatArray:
        """Turn lost rows back to differences, shape (places, frames of a window, lost, 3)."""
        away = lost.reshape(len(lost), len(self.span.offsets), -1, 3)
        return turned(away, angles, self.up)

    def _angles(self, motion: Motion, places: IntArray) -> FloatArray:
        if self.reference is None:
            return np.zeros(places.size)
        poses = motion.points[places + self.span.middle][:, self.rows.helpers]
        return headings(poses, self.reference, self.up)

    def _rows(
        self, motion: Motion, places: IntArray, pairs: IntArray, angles: FloatArray
    ) -> FloatArray:
        points = motion.points[self.span.frames(places)]
        return turned(differences(points, pairs), -angles, self.up).reshape(places.size, -1)


def complete_places(motion: Motion, markers: IntArray, span: Span) -> IntArray:
    """Return the places of the windows that show some markers in all their frames."""
    shown: BoolArray = np.asarray(motion.seen[:, markers].all(axis=1))
    places = span.inside(0, len(shown))
    chosen: IntArray = places[shown[span.frames(places)].all(axis=1)]
    return chosen


def choose_places(
    own: Motion, others: Sequence[Motion], markers: IntArray, span: Span, most: int
) -> list[tuple[Motion, IntArray]]:
    """Choose windows to learn from, evenly spread.

    Parameters
    ----------
    own : Motion
        The recording itself.
    others : sequence of Motion
        The training set.
    markers : ndarray of int
        What a window must show.
    span : Span
        The frames of a window.
    most : int
        Windows in all; half of them at most are the recording's own where there are others.

    Returns
    -------
    list of (Motion, ndarray of int)
        Windows of each motion.
    """
    found = [complete_places(motion, markers, span) for motion in others]
    total = sum(places.size for places in found)
    mine = complete_places(own, markers, span)
    mine = evenly(mine, max(most - total, int(OWN_SHARE * most)))
    chosen = evenly(np.arange(total), most - mine.size)
    ends = np.cumsum([0, *(places.size for places in found)])
    pairs = [(own, mine)]
    for motion, places, a, b in zip(others, found, ends[:-1], ends[1:], strict=True):
        pairs.append((motion, places[chosen[(chosen >= a) & (chosen < b)] - a]))
    return [(motion, places) for motion, places in pairs if places.size]


def reference_pose(
    chosen: Sequence[tuple[Motion, IntArray]], helpers: IntArray, span: Span, up: UpAxis, most: int
) -> FloatArray:
    """Return the mean pose of the helpers in some windows, shape (helpers, 3)."""
    poses = [
        motion.points[evenly(places, most) + span.middle][:, helpers] for motion, places in chosen
    ]
    return mean_pose(np.concatenate(poses), up)
