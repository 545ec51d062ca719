"""The body: sticks, segments and markers."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from mocapmend.state import SampleState
from mocapmend.views.engine_texts import segment_name
from mocapmend.views.painters.hull import hull
from mocapmend.views.painters.shot import Shot
from mocapmend_algorithms import Gap
from mocapmend_algorithms.skeleton import Segment

translate = QCoreApplication.translate

SEGMENT_WIDTH = 15.0
"""Of the shape around a segment's markers, in pixels."""
TINT = 0.28
"""Share of the segment's colour in what its shape is painted with."""


def paint_sticks(shot: Shot, bones: NDArray[np.intp]) -> None:
    """Join the ends of bones, shape (bones, 2)."""
    shot.pen(shot.theme.bone, 1.5)
    shot.pairs(shot.pixels[bones].reshape(-1, 2))


def paint_segments(shot: Shot, segments: Sequence[Segment]) -> None:
    """Put a shape around the markers of each segment that are seen."""
    painter = shot.painter
    # The tint is faint: smooth edges would hardly be seen, and take a third of a frame's time.
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
    for number, segment in _of_several(segments):
        pixels = shot.pixels[list(segment.markers)]
        pixels = pixels[np.isfinite(pixels[:, 0])]
        colour = shot.tint(shot.curve_colour(number - 1), TINT)
        painter.setPen(
            QPen(
                colour,
                SEGMENT_WIDTH,
                Qt.PenStyle.SolidLine,
                Qt.PenCapStyle.RoundCap,
                Qt.PenJoinStyle.RoundJoin,
            )
        )
        painter.setBrush(colour)
        corners = [QPointF(*pixel) for pixel in hull(pixels)]
        if len(corners) > 2:
            painter.drawPolygon(QPolygonF(corners))
        elif corners:
            painter.drawLine(corners[0], corners[-1])
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)


def paint_segment_names(shot: Shot, segments: Sequence[Segment]) -> list[QRectF]:
    """Write each segment's name, or its number where it has none, into its middle.

    One that would lie over another is written above or below it. Returns their places.
    """
    metrics = shot.painter.fontMetrics()
    found: list[QRectF] = []
    for number, segment in _of_several(segments):
        pixels = shot.pixels[list(segment.markers)]
        pixels = pixels[np.isfinite(pixels[:, 0])]
        if len(pixels):
            name = segment_name(segment.name) or translate("Scene", "segment {0}").format(number)
            x, y = (pixels.min(axis=0) + pixels.max(axis=0)) / 2.0
            box = QRectF(0, 0, metrics.horizontalAdvance(name), metrics.height())
            box.moveCenter(QPointF(x, y))
            line = metrics.height()
            boxes = [box.translated(0, shift) for shift in (0, line, -line)]
            free = (each for each in boxes if not any(map(each.intersects, found)))
            found.append(next(free, box))
            shot.pen(shot.theme.text)
            shot.painter.drawText(found[-1].topLeft() + QPointF(0, metrics.ascent()), name)
    return found


def paint_markers(shot: Shot, suspects: Collection[int]) -> None:
    """Paint markers as circles, filled ones as squares and bad ones as crosses.

    Parameters
    ----------
    shot : Shot
        The frame.
    suspects : collection of int
        Markers that are there in this frame and held for bad.
    """
    states = shot.document.state[shot.view.frame]
    drawn = np.isfinite(shot.pixels[:, 0])
    measured, smoothed, filled = (
        shot.pixels[drawn & (states == state)]
        for state in (SampleState.MEASURED, SampleState.SMOOTHED, SampleState.FILLED)
    )
    shot.dots(measured, shot.theme.marker, 6.0)
    shot.dots(smoothed, shot.theme.state_colour(SampleState.SMOOTHED), 6.0)
    ink, wrong = map(shot.theme.state_colour, (SampleState.FILLED, SampleState.BAD))
    shot.dots(filled, ink, 6.5, Qt.PenCapStyle.SquareCap)
    held = [marker for marker in suspects if drawn[marker]]
    shot.dots(shot.pixels[held], wrong, 8.0)
    shot.pen(wrong, 2.0)
    shot.crosses(shot.project(_set_aside(shot)), 4.0)
    for order, marker in enumerate(shot.view.selection):
        if drawn[marker]:
            shot.pen(shot.curve_colour(order), 2)
            shot.painter.drawEllipse(QPointF(*shot.pixels[marker]), 7.0, 7.0)


def _set_aside(shot: Shot) -> NDArray[np.float64]:
    """Return where the markers were measured that are set aside in this frame, shape (n, 3)."""
    document, frame = shot.document, shot.view.frame
    bad = np.flatnonzero(document.state[frame] == SampleState.BAD).tolist()
    places = [document.stored(Gap(marker, frame, frame + 1)) for marker in bad]
    return np.concatenate(places) if places else np.empty((0, 3))


def _of_several(segments: Sequence[Segment]) -> list[tuple[int, Segment]]:
    """Return the segments of more than one marker, numbered from 1."""
    several = [segment for segment in segments if len(segment.markers) > 1]
    return list(enumerate(several, start=1))
