"""Missing runs of a marker."""

from collections.abc import Iterable
from typing import Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

GapKind = Literal["interior", "leading", "trailing", "whole"]


class Gap(NamedTuple):
    """A maximal run of missing frames of one marker: frames start to stop - 1, counted from 0."""

    marker: int
    start: int
    stop: int

    @property
    def length(self) -> int:
        """Number of missing frames."""
        return self.stop - self.start

    def kind(self, frames: int) -> GapKind:
        """Where the gap lies in a recording of `frames` frames."""
        if self.start == 0:
            return "whole" if self.stop == frames else "leading"
        return "trailing" if self.stop == frames else "interior"


class Frames(Protocol):
    """Anything that has frames: start to stop - 1."""

    @property
    def start(self) -> int:
        """The first."""

    @property
    def stop(self) -> int:
        """The one after the last."""


def overlap(one: Frames, other: Frames) -> bool:
    """Say whether two runs have frames in common."""
    return one.start < other.stop and other.start < one.stop


def runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the half-open (start, stop) runs of True in a one-dimensional mask."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False])).astype(np.int8)))
    return [(int(a), int(b)) for a, b in edges.reshape(-1, 2)]


def find_gaps(present: NDArray[np.bool_]) -> list[Gap]:
    """Find the gaps of every marker.

    Parameters
    ----------
    present : ndarray of bool, shape (frames, markers)
        Whether each sample is there.

    Returns
    -------
    list of Gap
        Ordered by marker, then by start.
    """
    return [
        Gap(marker, start, stop)
        for marker in np.flatnonzero(~present.all(axis=0)).tolist()
        for start, stop in runs(~present[:, marker])
    ]


def seen_outside(present: NDArray[np.bool_], gaps: Iterable[Gap]) -> NDArray[np.bool_]:
    """Return which samples a fill of some gaps may look at.

    Parameters
    ----------
    present : ndarray of bool, shape (frames, markers)
        Whether each sample is there; not changed.
    gaps : iterable of Gap
        To be filled: what a recording holds inside them is not to be looked at.

    Returns
    -------
    ndarray of bool, shape (frames, markers)
    """
    seen = present.copy()
    for gap in gaps:
        seen[gap.start : gap.stop, gap.marker] = False
    return seen


def count_gaps(present: NDArray[np.bool_]) -> tuple[list[int], list[int]]:
    """Count the gaps of every marker.

    Parameters
    ----------
    present : ndarray of bool, shape (frames, markers)
        Whether each sample is there.

    Returns
    -------
    counts, longest : list of int
        Number of gaps and length of the longest, per marker; 0 without gaps.
    """
    counts, longest = [0] * present.shape[1], [0] * present.shape[1]
    for gap in find_gaps(present):
        counts[gap.marker] += 1
        longest[gap.marker] = max(longest[gap.marker], gap.length)
    return counts, longest
