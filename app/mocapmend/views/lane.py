"""One plot of the trajectory view: a coordinate of some markers over time."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath, arrayToQPolygonF
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.theme import AXIS_COLOURS, Theme
from mocapmend.views.columns import Envelope, column_edges, columns_with
from mocapmend.viewstate import Preview

FILL_OVERLAY_FRAMES = 20_000
"""Above this many visible frames the fills are told by their shade alone."""
BAND_SIGMAS = 1.6449
"""Half-width of the band in standard deviations per axis: 90 %."""


@dataclass(frozen=True)
class Curve:
    """A marker in a lane and the colour that it has there."""

    marker: int
    colour: str


@dataclass(frozen=True)
class Lane:
    """A plot: which coordinate of which markers; the last curve is the one worked on."""

    axis: int
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Frame:
    """Where a lane is painted and what its axes span."""

    rect: QRectF
    start: float
    stop: float
    low: float
    high: float

    def x(self, frame: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Return the picture's x of a frame (the middle of its time)."""
        scale = self.rect.width() / (self.stop - self.start)
        return np.asarray(self.rect.left() + (np.asarray(frame) + 0.5 - self.start) * scale)

    def y(self, value: NDArray[np.float64] | float) -> NDArray[np.float64]:
        """Return the picture's y of a coordinate."""
        scale = self.rect.height() / (self.high - self.low)
        return np.asarray(self.rect.bottom() - (np.asarray(value) - self.low) * scale)


LEAST_SPAN = 1e-5
"""Of values about 1, in the recording's unit; greater values have more."""


def value_range(lines: Sequence[NDArray[np.float64]]) -> tuple[float, float]:
    """Return the span of the lines with a margin, never empty."""
    values = np.concatenate([line[:, 1] for line in lines]) if lines else np.empty(0)
    values = values[np.isfinite(values)]
    if not values.size:
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    # What varies less than this is constant: numbers at its axis would be of too many digits.
    constant = high - low <= LEAST_SPAN * max(1.0, abs(low), abs(high))
    margin = max(1e-3 * abs(high), 1e-2) if constant else 0.08 * (high - low)
    return low - margin, high + margin


def ticks(low: float, high: float, about: int) -> tuple[NDArray[np.float64], int]:
    """Return round numbers inside a span, and how many decimals they need."""
    step = (high - low) / max(1, about)
    power = 10.0 ** np.floor(np.log10(step))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= step)
    decimals = max(0, -int(np.floor(np.log10(step) + 1e-9)))
    first, last = np.ceil(low / step), np.floor(high / step)
    # Adding zero turns a negative zero into a plain one.
    return np.arange(first, last + 1) * step + 0.0, decimals


def alone_in(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Say which values have no finite neighbour: a line through them is nothing to see."""
    known = np.concatenate(([False], np.isfinite(values), [False]))
    return np.asarray(known[1:-1] & ~known[:-2] & ~known[2:])


class LanePainter:
    """Paints lanes of a document into a picture.

    Parameters
    ----------
    document : Document
        Its samples are painted.
    theme : Theme
        The colours.
    """

    def __init__(self, document: Document, theme: Theme) -> None:
        self.theme = theme
        self._document = document
        self._envelopes: dict[int, Envelope] = {}

    def forget(self, markers: set[int]) -> None:
        """Drop what was computed for markers whose samples have changed."""
        for marker in markers:
            self._envelopes.pop(marker, None)

    def paint(
        self,
        painter: QPainter,
        lane: Lane,
        rect: QRectF,
        visible: tuple[float, float],
        preview: Preview | None,
    ) -> Frame:
        """Paint a lane and return the frame that it was painted in."""
        width = max(1, int(rect.width()))
        lines = [self._envelope(c.marker).line(lane.axis, *visible, width) for c in lane.curves]
        markers = {curve.marker for curve in lane.curves}
        shown = preview if preview is not None and preview.gap.marker in markers else None
        spans = list(lines)
        if shown is not None and shown.patch is not None:
            inside = self._preview_line(shown, lane.axis)
            seen = (inside[:, 0] >= visible[0]) & (inside[:, 0] <= visible[1])
            spans.append(inside[seen])
        frame = Frame(rect, *visible, *value_range(spans))
        painter.fillRect(rect, QColor(self.theme.base))
        self._paint_grid(painter, frame)
        painter.setClipRect(rect)
        if lane.curves:
            self._paint_shades(painter, frame, lane.curves[-1].marker)
        for curve, line in zip(lane.curves, lines, strict=True):
            colour = QColor(curve.colour)
            colour.setAlpha(255 if curve is lane.curves[-1] else 170)
            self._paint_line(painter, frame, line, QPen(colour, 1))
            self._paint_fills(painter, frame, curve.marker, lane.axis)
        if shown is not None and shown.patch is not None:
            self._paint_preview(painter, frame, shown, lane.axis)
        painter.setClipping(False)
        self._paint_name(painter, rect, lane.axis)
        return frame

    def _envelope(self, marker: int) -> Envelope:
        if marker not in self._envelopes:
            values = np.ascontiguousarray(self._document.points[:, marker])
            self._envelopes[marker] = Envelope(values)
        return self._envelopes[marker]

    def _paint_grid(self, painter: QPainter, frame: Frame) -> None:
        rect = frame.rect
        marks, decimals = ticks(frame.low, frame.high, max(1, int(rect.height() / 28)))
        for mark in marks:
            y = float(frame.y(mark))
            painter.setPen(QPen(QColor(self.theme.raised), 1))
            painter.drawLine(QPointF(rect.left(), y), QPointF(rect.right(), y))
            if rect.top() + 6 <= y <= rect.bottom() - 4:
                painter.setPen(QColor(self.theme.dim))
                place = QRectF(0, y - 8, rect.left() - 6, 16)
                painter.drawText(
                    place,
                    Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                    f"{mark:.{decimals}f}",
                )
        painter.setPen(QPen(QColor(self.theme.line), 1))
        painter.drawRect(rect)

    def _paint_name(self, painter: QPainter, rect: QRectF, axis: int) -> None:
        painter.setPen(QColor(AXIS_COLOURS[axis]))
        place = QRectF(rect.left() + 5, rect.top() + 2, 14, 16)
        painter.drawText(place, Qt.AlignmentFlag.AlignLeft, "XYZ"[axis])

    def _paint_shades(self, painter: QPainter, frame: Frame, marker: int) -> None:
        rect = frame.rect
        edges = column_edges(frame.start, frame.stop, max(1, int(rect.width())))
        for state, colour in (
            (SampleState.MISSING, self.theme.gap_shade),
            (SampleState.FILLED, self.theme.fill_shade),
        ):
            flags = columns_with(self._document.runs(marker, state), edges)
            bounds = np.flatnonzero(np.diff(np.concatenate(([False], flags, [False]))))
            for left, right in bounds.reshape(-1, 2).tolist():
                place = QRectF(rect.left() + left, rect.top(), right - left, rect.height())
                painter.fillRect(place, QColor(colour))

    def _paint_fills(self, painter: QPainter, frame: Frame, marker: int, axis: int) -> None:
        if frame.stop - frame.start > FILL_OVERLAY_FRAMES:
            return
        runs = self._document.runs(marker, SampleState.FILLED)
        runs = runs[(runs[:, 1] > frame.start) & (runs[:, 0] < frame.stop)]
        pen = QPen(QColor(self.theme.state_colour(SampleState.FILLED)), 2, Qt.PenStyle.DashLine)
        for start, stop in runs.tolist():
            # With the neighbours, so that the dashes join the measured curve.
            rows = np.arange(max(0, start - 1), min(self._document.original.frames, stop + 1))
            values = self._document.points[rows, marker, axis]
            self._paint_line(painter, frame, np.stack((rows, values), axis=1), pen)

    def _preview_line(self, preview: Preview, axis: int) -> NDArray[np.float64]:
        assert preview.patch is not None
        gap = preview.gap
        rows = np.arange(gap.start - 1, gap.stop + 1)
        values = np.full(len(rows), np.nan)
        values[1:-1] = preview.patch.values[:, axis]
        for end in (0, -1):
            if 0 <= rows[end] < self._document.original.frames:
                values[end] = self._document.points[rows[end], gap.marker, axis]
        return np.stack((rows, values), axis=1)

    def _paint_preview(self, painter: QPainter, frame: Frame, preview: Preview, axis: int) -> None:
        patch = preview.patch
        assert patch is not None
        colour = QColor(self.theme.preview)
        half = BAND_SIGMAS * patch.sigma
        if np.isfinite(half).all():
            rows = np.arange(preview.gap.start, preview.gap.stop)
            x = np.concatenate((rows, rows[::-1])).astype(float)
            middle = patch.values[:, axis]
            y = np.concatenate((middle + half, (middle - half)[::-1]))
            band = QColor(colour)
            band.setAlpha(60)
            painter.setBrush(band)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.drawPath(arrayToQPath(frame.x(x), frame.y(y), connect="all"))
            painter.setBrush(Qt.BrushStyle.NoBrush)
        self._paint_line(painter, frame, self._preview_line(preview, axis), QPen(colour, 2))

    @staticmethod
    def _paint_line(painter: QPainter, frame: Frame, line: NDArray[np.float64], pen: QPen) -> None:
        painter.setPen(pen)
        x, y = frame.x(line[:, 0]), frame.y(line[:, 1])
        painter.drawPath(arrayToQPath(x, y, connect="finite"))
        alone = alone_in(y)
        if alone.any():
            painter.setPen(QPen(pen.color(), 3))
            painter.drawPoints(arrayToQPolygonF(x[alone], y[alone]))
