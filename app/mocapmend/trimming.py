"""The ragged ends of a gap: measured samples beside it that a repair shall replace."""

import numpy as np

from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap


def hidden(document: Document, gap: Gap) -> tuple[int, int]:
    """Return how many measured samples the ends of a gap cover, at its start and at its end."""
    there = document.base.present[gap.start : gap.stop, gap.marker]
    gone = np.flatnonzero(~there)
    return (int(gone[0]), gap.length - 1 - int(gone[-1])) if gone.size else (0, 0)


def widened(document: Document, gap: Gap, frames: int) -> Gap:
    """Return an open gap with other ends.

    Parameters
    ----------
    document : Document
        The recording.
    gap : Gap
        One of its open gaps.
    frames : int
        How far each end moves outwards. It stops while two measured samples are left beside it;
        negative numbers move it back, until it would uncover a missing sample.
    """
    before, after = hidden(document, gap)
    back = max(0, -frames)
    start, stop = gap.start + min(before, back), gap.stop - min(after, back)
    measured = document.state[:, gap.marker] == SampleState.MEASURED
    for _ in range(frames):
        if start >= 2 and measured[start - 2 : start].all():
            start -= 1
        if stop + 2 <= len(measured) and measured[stop : stop + 2].all():
            stop += 1
    return Gap(gap.marker, start, stop)


def resized(document: Document, gap: Gap, wanted: Gap) -> Edit:
    """Return the edit that gives an open gap the ends that `widened` has found."""
    start, stop = min(gap.start, wanted.start), max(gap.stop, wanted.stop)
    inside = slice(wanted.start - start, wanted.stop - start)
    values = document.base.points[start:stop, gap.marker].copy()
    values[inside] = np.nan
    states = np.full(stop - start, SampleState.MEASURED, np.uint8)
    states[inside] = SampleState.MISSING
    return Edit(Gap(gap.marker, start, stop), values, states)
