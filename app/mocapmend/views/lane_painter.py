"""The plots of markers: curves with their gaps, fills and previews."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.theme import AXIS_COLOURS, Theme
from mocapmend.views.bad_painter import BadPainter
from mocapmend.views.columns import Floats, column_edges, columns_with
from mocapmend.views.companion_painter import CompanionPainter
from mocapmend.views.lane import (
    Frame,
    mixed,
    paint_grid,
    paint_line,
    paint_message,
    paint_on_ground,
    thin,
    value_range,
)
from mocapmend.views.quantities import Curve, Quantity, Series
from mocapmend.viewstate import Preview
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.smooth.contract import SmoothedRun

FILL_OVERLAY_FRAMES = 20_000
"""Above this many visible frames the fills are told by their shade alone."""
BAND_SIGMAS = 1.6449
"""Half-width of the band in standard deviations per axis: 90 %."""
BAND, OTHER_BAND = 60, 18
"""Opacity of the band of a preview, and of the other candidates, of 255."""
WIDEST_VALUE = "00000 "
LEAST_NUMBERED = 70.0
"""Pixels that a gap takes before the candidates have their numbers: else they lie in a heap."""
DASHES = ([6, 3], [2, 3], [9, 3, 2, 3], [4, 2], [12, 4], [2, 2, 6, 2], [1, 3], [8, 2])
"""Of the candidates by their numbers."""
SMOOTHING_DASHES = [3.0, 4.0]
BEHIND = 0.67
"""Share of the colours of the curves that are not worked on."""

RAIL = 3
"""Height of the line at the foot of what is smoothed, in pixels."""

Pixels = NDArray[np.uint32]
Candidates = Sequence[tuple[int, Preview]]
"""Repairs of a gap with their numbers."""


@dataclass(frozen=True)
class Lane:
    """A plot: which quantity of which markers; the last curve is the one worked on."""

    quantity: Quantity
    curves: tuple[Curve, ...]


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
        self.series = Series(document)
        self._document = document
        self._strips: dict[tuple[int, ...], tuple[Pixels, Pixels]] = {}
        self.bad = BadPainter(document, self.series)
        self.companion = CompanionPainter()

    def title(self, lane: Lane) -> str:
        """Return what a plot is called, with the unit where it is not that of the recording."""
        unit, names = self._document.original.unit, self._document.names
        translate = QCoreApplication.translate
        if lane.quantity is Quantity.SPEED:
            return translate("LanePainter", "Speed ({0}/s)").format(unit)
        if lane.quantity is Quantity.ACCELERATION:
            return translate("LanePainter", "Acceleration ({0}/s²)").format(unit)
        if lane.quantity is Quantity.RESIDUAL:
            return translate("LanePainter", "Residual ({0})").format(unit)
        if lane.quantity is Quantity.BONE:
            ends = [names[marker] for curve in lane.curves for marker in curve.markers]
            text = translate("LanePainter", "Length {0} ({1})")
            return text.format(" – ".join(ends), unit)
        return lane.quantity.name

    def paint(
        self,
        painter: QPainter,
        lanes: Sequence[tuple[Lane, QRectF]],
        visible: tuple[float, float],
        preview: Preview | None,
        others: Candidates = (),
        *,
        suspect: BadRun | None = None,
        exchange: Exchange | None = None,
        smoothing: Sequence[SmoothedRun] = (),
        same_scale: bool = False,
    ) -> list[Frame]:
        """Paint lanes and return the frames that they were painted in.

        Other candidates are drawn behind the preview, each with its number, as far as they fit. A
        suspect that is set aside is in view; what is to be exchanged is drawn as it would be.
        Runs that are not smoothed yet are drawn as they would be, over what they are.
        With the same scale for x, y and z their units are equally high in all lanes.
        """
        self._strips.clear()
        spans = [self._span(lane, rect, visible, preview, suspect) for lane, rect in lanes]
        if same_scale:
            places = [i for i, (lane, _) in enumerate(lanes) if lane.quantity.kind == "position"]
            half = max((spans[i][1] - spans[i][0] for i in places), default=0.0) / 2
            for i in places:
                middle = sum(spans[i]) / 2
                spans[i] = middle - half, middle + half
        frames = []
        for (lane, rect), span in zip(lanes, spans, strict=True):
            frame = Frame(rect, *visible, *span)
            frames.append(frame)
            self._paint_lane(painter, frame, lane, preview, others, exchange)
            self._paint_smoothing(painter, frame, lane, smoothing)
        return frames

    def _span(
        self,
        lane: Lane,
        rect: QRectF,
        visible: tuple[float, float],
        preview: Preview | None,
        suspect: BadRun | None,
    ) -> tuple[float, float]:
        """Return the values that a lane has to show."""
        width = int(rect.width())
        values = [self.series.line(lane.quantity, c, visible, width)[1] for c in lane.curves]
        values += self.companion.values(lane.quantity, lane.curves, visible, width)
        frames, inside = self._preview_line(preview, lane)
        values.append(inside[(frames >= visible[0]) & (frames <= visible[1])])
        if suspect is not None:
            values += self.bad.stored(lane.quantity, lane.curves, suspect)
        return value_range(values)

    def _paint_lane(
        self,
        painter: QPainter,
        frame: Frame,
        lane: Lane,
        preview: Preview | None,
        others: Candidates,
        exchange: Exchange | None,
    ) -> None:
        rect, quantity = frame.rect, lane.quantity
        message = self._message(lane)
        self._paint_background(painter, frame, lane)
        if message:
            painter.setPen(thin(painter, self.theme.line))
            painter.drawRect(rect)
            paint_message(painter, rect, message, self.theme)
        else:
            paint_grid(painter, frame, self.theme)
        painter.setClipRect(rect)
        visible, width = (frame.start, frame.stop), int(rect.width())
        self.companion.paint(painter, frame, quantity, lane.curves, self.theme)
        for curve in lane.curves:
            share = 1.0 if curve is lane.curves[-1] else BEHIND
            pen = thin(painter, mixed(self.theme.base, curve.colour, share))
            paint_line(painter, frame, *self.series.line(quantity, curve, visible, width), pen)
            self._paint_fills(painter, frame, quantity, curve)
            self.bad.paint(painter, frame, quantity, curve, self.theme)
        if exchange is not None:
            self.bad.paint_exchange(painter, frame, quantity, lane.curves, exchange)
        for number, other in others:
            self._paint_candidate(painter, frame, lane, number, other)
        self._paint_preview(painter, frame, lane, preview)
        painter.setClipping(False)
        self._paint_title(painter, rect, lane)

    def _message(self, lane: Lane) -> str:
        """Say why a lane is empty; "" where it is not."""
        translate = QCoreApplication.translate
        if lane.quantity is Quantity.RESIDUAL and not self.series.has_residuals:
            return translate("LanePainter", "This file has no residuals")
        if not lane.curves:
            return translate("LanePainter", "Select two markers to see how far they are apart")
        return ""

    def _paint_title(self, painter: QPainter, rect: QRectF, lane: Lane) -> None:
        is_place = lane.quantity.kind == "position"
        painter.setPen(QColor(AXIS_COLOURS[lane.quantity.row] if is_place else self.theme.dim))
        metrics = painter.fontMetrics()
        place = QPointF(rect.left() + 5, rect.top() + 2 + metrics.ascent())
        # The value at the playhead stands at the right.
        room = rect.width() - 10 - (0 if is_place else metrics.horizontalAdvance(WIDEST_VALUE))
        title = metrics.elidedText(self.title(lane), Qt.TextElideMode.ElideRight, int(room))
        paint_on_ground(painter, place, title, self.theme)

    def _paint_background(self, painter: QPainter, frame: Frame, lane: Lane) -> None:
        """Fill a lane, shaded where the marker worked on is missing, filled or smoothed."""
        rect = frame.rect
        markers = lane.curves[-1].markers if lane.curves else ()
        if markers not in self._strips:
            self._strips[markers] = self._strip(markers, frame, int(rect.width()))
        shade, rail = self._strips[markers]
        pixels = np.repeat(shade[None], int(rect.height()), axis=0)
        # A shape besides the shade: at the foot of what is smoothed there is a line.
        pixels[-RAIL:] = rail
        height, width = pixels.shape
        image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
        painter.drawImage(rect, image)

    def _strip(self, markers: tuple[int, ...], frame: Frame, width: int) -> tuple[Pixels, Pixels]:
        """Return the background of each column and that of its foot, each of shape (width,)."""
        edges = column_edges(frame.start, frame.stop, width)
        ground, gap_shade = self.theme.base, self.theme.gap_shade
        strip = np.full(width, mixed(ground, gap_shade, 0.0).rgb(), np.uint32)
        # Missing last: a gap must show even where it shares its column with a fill.
        for state, shade in (
            (SampleState.SMOOTHED, self.theme.smooth_shade),
            (SampleState.FILLED, self.theme.fill_shade),
            (SampleState.NEVER, gap_shade),
            (SampleState.BAD, gap_shade),
            (SampleState.MISSING, gap_shade),
        ):
            for marker in markers:
                runs = self._document.runs(marker, state)
                if len(runs):
                    strip[columns_with(runs, edges)] = mixed(ground, shade).rgb()
        foot = strip.copy()
        for marker in markers:
            runs = self._document.runs(marker, SampleState.SMOOTHED)
            if len(runs):
                colour = QColor(self.theme.state_colour(SampleState.SMOOTHED))
                foot[columns_with(runs, edges)] = colour.rgb()
        return strip, foot

    def _paint_fills(
        self, painter: QPainter, frame: Frame, quantity: Quantity, curve: Curve
    ) -> None:
        if frame.stop - frame.start > FILL_OVERLAY_FRAMES:
            return
        pen = QPen(QColor(self.theme.state_colour(SampleState.FILLED)), 2, Qt.PenStyle.DashLine)
        values = self.series.rows(quantity, curve)
        for marker in curve.markers:
            runs = self._document.runs(marker, SampleState.FILLED)
            runs = runs[(runs[:, 1] > frame.start) & (runs[:, 0] < frame.stop)]
            for start, stop in runs.tolist():
                # With the neighbours, so that the dashes join the measured curve.
                frames = np.arange(max(0, start - 1), min(len(values), stop + 1))
                paint_line(painter, frame, frames, values[frames], pen)

    def _paint_smoothing(
        self, painter: QPainter, frame: Frame, lane: Lane, smoothing: Sequence[SmoothedRun]
    ) -> None:
        """Draw runs as they would be when they are smoothed, dashed."""
        painter.setClipRect(frame.rect)
        # What is measured is seen between the dashes.
        pen = QPen(QColor(self.theme.preview), 2)
        pen.setDashPattern(SMOOTHING_DASHES)
        for done in smoothing:
            curve = next((c for c in lane.curves if done.run.marker in c.markers), None)
            # Of what is seen alone: a recording may have a million frames.
            start = max(done.run.start, int(frame.start) - 2)
            stop = min(done.run.stop, int(frame.stop) + 3)
            if curve is None or stop <= start or stop - start > FILL_OVERLAY_FRAMES:
                continue
            seen = Gap(done.run.marker, start, stop)
            values = done.values[start - done.run.start : stop - done.run.start]
            paint_line(
                painter, frame, *self.series.patched(lane.quantity, curve, seen, values), pen
            )
        painter.setClipping(False)

    def _preview_line(self, preview: Preview | None, lane: Lane) -> tuple[Floats, Floats]:
        """Return frames and values of a lane as a preview would make them; empty without one."""
        if preview is None or preview.patch is None:
            return np.empty(0), np.empty(0)
        marker = preview.gap.marker
        curve = next((curve for curve in lane.curves if marker in curve.markers), None)
        if curve is None:
            return np.empty(0), np.empty(0)
        return self.series.patched(lane.quantity, curve, preview.gap, preview.patch.values)

    def _paint_candidate(
        self, painter: QPainter, frame: Frame, lane: Lane, number: int, candidate: Preview
    ) -> None:
        """Draw another repair: a thin line with dashes of its own, its band and its number."""
        frames, values = self._preview_line(candidate, lane)
        if not len(frames):
            return
        colour = QColor(self.theme.candidate)
        self._paint_band(painter, frame, lane, candidate, colour, OTHER_BAND)
        pen = thin(painter, colour)
        pen.setDashPattern(DASHES[(number - 1) % len(DASHES)])
        paint_line(painter, frame, frames, values, pen)
        # Curves that coincide have their numbers side by side.
        at = round((0.05 + 0.1 * number) * (len(frames) - 1))
        place = QPointF(float(frame.x(frames[at])), float(frame.y(values[at])))
        across = float(frame.x(frames[-1]) - frame.x(frames[0]))
        if across > LEAST_NUMBERED and np.isfinite(values[at]) and frame.rect.contains(place):
            painter.setPen(colour)
            painter.drawText(place + QPointF(2, -2), str(number))

    def _paint_preview(
        self, painter: QPainter, frame: Frame, lane: Lane, preview: Preview | None
    ) -> None:
        """Draw the line of a preview, for coordinates with its band."""
        frames, values = self._preview_line(preview, lane)
        if preview is None or not len(frames):
            return
        colour = QColor(self.theme.preview)
        self._paint_band(painter, frame, lane, preview, colour, BAND)
        paint_line(painter, frame, frames, values, QPen(colour, 2))

    @staticmethod
    def _paint_band(
        painter: QPainter, frame: Frame, lane: Lane, preview: Preview, colour: QColor, alpha: int
    ) -> None:
        # What is derived from coordinates has no band: errors of neighbours depend on each other.
        if preview.patch is None or lane.quantity.kind != "position":
            return
        half = BAND_SIGMAS * preview.patch.sigma
        if not np.isfinite(half).all():
            return
        rows = np.arange(preview.gap.start, preview.gap.stop)
        middle = preview.patch.values[:, lane.quantity.row]
        x = np.concatenate((rows, rows[::-1])).astype(float)
        y = np.concatenate((middle + half, (middle - half)[::-1]))
        band = QColor(colour)
        band.setAlpha(alpha)
        painter.setBrush(band)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawPath(arrayToQPath(frame.x(x), frame.y(y), connect="all"))
        painter.setBrush(Qt.BrushStyle.NoBrush)
