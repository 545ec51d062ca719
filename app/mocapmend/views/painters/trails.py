"""Where markers come from and go to."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.views.lane import thin
from mocapmend.views.painters.shot import Array, Shot
from mocapmend_algorithms import Gap

MOST_VERTICES = 4000
"""Of all trails together; with more, frames are left out between the corners of a trail."""
FINE = 12
"""So many trails have smooth lines; with more, those would take longer than the rest together."""
SOLID, DOTTED, DASHED, BROKEN = range(4)
STYLES = {
    SOLID: Qt.PenStyle.SolidLine,
    DOTTED: Qt.PenStyle.DotLine,
    DASHED: Qt.PenStyle.DashLine,
}
_STYLE_OF = np.full(256, SOLID, np.uint8)
_STYLE_OF[SampleState.BAD] = DOTTED
_STYLE_OF[SampleState.FILLED] = DASHED
_STYLE_OF[SampleState.MISSING] = BROKEN


@dataclass(frozen=True, eq=False)
class Trails:
    """The trails of some markers around a frame.

    Attributes
    ----------
    points : ndarray, shape (corners, markers, 3)
        In the file's axes.
    styles : ndarray of uint8, shape (corners - 1, markers)
        Of the lines from each corner to the next: the least certain sample between them decides.
    """

    points: Array
    styles: NDArray[np.uint8]


def trails_around(document: Document, frame: int, reach: int, markers: NDArray[np.intp]) -> Trails:
    """Return the trails of markers from `reach` frames before a frame to as many after it."""
    step = max(1, -(-2 * reach * len(markers) // MOST_VERTICES))
    # Corners are counted from the frame, so that the trail goes through the marker.
    before = min(reach, frame) // step
    after = min(reach, len(document.points) - 1 - frame) // step
    first, last = frame - before * step, frame + after * step
    points = document.points[first : last + 1 : step][:, markers]
    bad = document.state[first : last + 1 : step][:, markers] == SampleState.BAD
    for row in np.flatnonzero(bad.any(axis=0)).tolist():
        stored = document.stored(Gap(int(markers[row]), first, last + 1))[::step]
        points[bad[:, row], row] = stored[bad[:, row]]
    certain = _STYLE_OF[document.state[first : last + 1][:, markers]]
    between = certain[:-1].reshape(before + after, step, len(markers)).max(axis=1)
    return Trails(points, np.maximum(between, certain[step::step]))


def paint_trails(shot: Shot, seconds: float, *, all_markers: bool) -> None:
    """Paint the trails of the selection or of all markers, `seconds` each way.

    They break at gaps; filled parts are dashed and bad ones dotted.
    """
    document, selection = shot.document, shot.view.selection
    reach = max(1, round(seconds * document.original.rate))
    chosen = range(document.original.markers) if all_markers else selection
    markers = np.array(chosen, dtype=np.intp)
    if not markers.size:
        return
    trails = trails_around(document, shot.view.frame, reach, markers)
    flat = trails.points.transpose(1, 0, 2).reshape(-1, 3)
    pixels = shot.project(flat).reshape(len(markers), -1, 2)
    unseen = np.isnan(pixels[:, :, 0])
    # A line from the last corner of a trail would lead into the next marker's trail.
    styles = np.full(unseen.shape, BROKEN, np.uint8)
    styles[:, :-1] = trails.styles.T
    styles[unseen] = BROKEN
    styles[:, :-1][unseen[:, 1:]] = BROKEN
    fine = len(markers) <= FINE
    shot.painter.setRenderHint(QPainter.RenderHint.Antialiasing, fine)
    for colour, rows in _inks(shot, markers):
        colour.setAlpha(150 if fine else 255)
        for style, line in STYLES.items():
            shot.pen(colour, 1.5 if fine else thin(shot.painter, colour).widthF(), line)
            shot.chain(pixels[rows].reshape(-1, 2), styles[rows].reshape(-1) == style)
    shot.painter.setRenderHint(QPainter.RenderHint.Antialiasing)


def _inks(shot: Shot, markers: NDArray[np.intp]) -> Iterator[tuple[QColor, list[int]]]:
    """Yield colour and rows of the trails that are painted alike."""
    rows = {marker: row for row, marker in enumerate(markers.tolist())}
    colours = len(shot.theme.curves)
    chosen: list[list[int]] = [[] for _ in range(colours)]
    for order, marker in enumerate(shot.view.selection):
        chosen[order % colours].append(rows.pop(marker))
    if rows:
        yield QColor(shot.theme.bone), list(rows.values())
    for order, of_colour in enumerate(filter(None, chosen)):
        yield shot.curve_colour(order), of_colour
