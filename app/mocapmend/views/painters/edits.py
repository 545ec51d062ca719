"""Before and after: what the file had beside what is there now."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QPointF, Qt

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.views.painters.shot import Array, Shot

translate = QCoreApplication.translate

OLD = 4.0
NEW = 7.5


@dataclass(frozen=True, eq=False)
class FrameEdits:
    """The markers that a frame's edits have changed.

    Attributes
    ----------
    filled, moved, removed : ndarray of int
        Markers that were missing and are there, that are elsewhere now, and that are there no more.
    """

    filled: NDArray[np.intp]
    moved: NDArray[np.intp]
    removed: NDArray[np.intp]


def edits_in(document: Document, frame: int) -> FrameEdits:
    """Compare a frame with what was measured there."""
    before, now = document.original.points[frame], document.points[frame]
    had, has = ~np.isnan(before[:, 0]), ~np.isnan(now[:, 0])
    other = (before != now).any(axis=1)
    return FrameEdits(
        np.flatnonzero(~had & has), np.flatnonzero(had & has & other), np.flatnonzero(had & ~has)
    )


def measured_edges(document: Document, marker: int, frame: int) -> Array:
    """Return where a filled marker was last measured and where it is measured next.

    Parameters
    ----------
    document : Document
        The recording.
    marker, frame : int
        A sample that was missing.

    Returns
    -------
    ndarray, shape (2, 3)
        In the file's axes; NaN where there is no fill, or no measured sample beside it.
    """
    runs = document.runs(marker, SampleState.FILLED)
    edges = np.full((2, 3), np.nan)
    around = runs[(runs[:, 0] <= frame) & (frame < runs[:, 1])]
    if not len(around):
        return edges
    start, stop = around[0]
    measured = document.original.points[:, marker]
    if start > 0:
        edges[0] = measured[start - 1]
    if stop < len(measured):
        edges[1] = measured[stop]
    return edges


def paint_edits(shot: Shot) -> None:
    """Mark the edited markers of the frame, and join them to what was measured.

    A filled marker has a diamond, and thin lines to where it was measured last and next; one that
    has been moved has a line from a circle, its old place; a circle with a cross was removed.
    """
    document, frame = shot.document, shot.view.frame
    edits = edits_in(document, frame)
    colour = shot.theme.state_colour(SampleState.FILLED)
    filled = edits.filled[np.isfinite(shot.pixels[edits.filled, 0])]
    if len(filled):
        edges = [measured_edges(document, int(marker), frame) for marker in filled]
        places = shot.project(np.concatenate(edges))
        lines = np.stack((places, np.repeat(shot.pixels[filled], 2, axis=0)), axis=1)
        shot.pen(colour, 1.0, Qt.PenStyle.DotLine)
        shot.pairs(lines.reshape(-1, 2))
        shot.pen(colour, 1.2)
        _circles(shot, places, 2.5)
    for marker in filled:
        shot.diamond(shot.pixels[marker], NEW)
    old = shot.project(document.original.points[frame])
    shot.pen(shot.theme.state_colour(SampleState.BAD), 1.5)
    shot.pairs(np.stack((old, shot.pixels), axis=1)[edits.moved].reshape(-1, 2))
    _circles(shot, old[np.concatenate((edits.moved, edits.removed))], OLD)
    shot.crosses(old[edits.removed], OLD)


def edits_text(document: Document, frame: int) -> str:
    """Say how much of a frame was edited."""
    edits = edits_in(document, frame)
    counts = [len(edits.filled), len(edits.moved), len(edits.removed)]
    if not any(counts):
        return translate("Scene", "Before and after: no edits in this frame")
    text = translate("Scene", "Before and after: {0} filled, {1} moved, {2} removed")
    return text.format(*counts)


def _circles(shot: Shot, pixels: Array, radius: float) -> None:
    for pixel in pixels[np.isfinite(pixels[:, 0])]:
        shot.painter.drawEllipse(QPointF(*pixel), radius, radius)
