"""From gap to gap, in the order of time. No Qt."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.limits import default_frames


def in_time_order(gaps: Iterable[Gap], frames: int) -> list[Gap]:
    """Return the gaps by start, then marker; markers that are never seen have no place in it."""
    seen = (gap for gap in gaps if gap.length < frames)
    return sorted(seen, key=lambda gap: (gap.start, gap.marker))


def place(current: Gap | None, frame: int) -> tuple[int, int]:
    """Return start and marker that a step begins at: of the gap that the playhead is in, if any."""
    if current is not None and current.start <= frame < current.stop:
        return current.start, current.marker
    return frame, -1


def neighbour(ordered: list[Gap], start: int, marker: int, step: int) -> Gap | None:
    """Return the next (step 1) or previous (step -1) gap from a place, around the end if need be.

    Parameters
    ----------
    ordered : list of Gap
        As `in_time_order` returns them.
    start, marker : int
        The place, as `place` returns it.
    step : int
        1 or -1.

    Returns
    -------
    Gap or None
        None when there is no gap at all.
    """
    if not ordered:
        return None
    keys = [(gap.start, gap.marker) for gap in ordered]
    place = (start, marker)
    if step > 0:
        return ordered[bisect_right(keys, place) % len(ordered)]
    return ordered[bisect_left(keys, place) - 1]


def neighbour_frame(ordered: Sequence[int], frame: int, step: int) -> int | None:
    """Return the next (step 1) or previous (step -1) of some frames, around the end if need be.

    Parameters
    ----------
    ordered : sequence of int
        Frames in ascending order.
    frame : int
        Where to start.
    step : int
        1 or -1.

    Returns
    -------
    int or None
        None when there are none.
    """
    if not ordered:
        return None
    if step > 0:
        return ordered[bisect_right(ordered, frame) % len(ordered)]
    return ordered[bisect_left(ordered, frame) - 1]


def place_to_begin(recording: Recording, corners: NDArray[np.int64]) -> Gap | None:
    """Return the longest of the short gaps, in a frame and of a marker that show something.

    Fragments of trajectories and frames without a body are no place to begin.

    Parameters
    ----------
    recording : Recording
        What is shown.
    corners : ndarray, shape (gaps, 3)
        Marker, start and stop of its gaps.
    """
    marker, start, stop = corners.T
    length = stop - start
    fit = (length <= default_frames(recording.rate)) & (start > 0) & (stop < recording.frames)
    places = np.flatnonzero(fit)
    order = np.lexsort((marker[places], start[places], -length[places]))
    ordered = (Gap(*corners[place].tolist()) for place in places[order].tolist())
    good = (
        gap
        for gap in ordered
        if not recording.labels[gap.marker].startswith("*")
        and recording.present[:, gap.marker].mean() > 0.5
        and recording.present[gap.start].mean() > 0.5
    )
    return next(good, None)
