"""The trajectory plots: x, y and z of the selected markers, the gaps shaded."""

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from mocapmend.document import Document
from mocapmend.theme import Theme
from mocapmend.views.labels import elided
from mocapmend.views.lane import Curve, Frame, Lane, LanePainter, ticks
from mocapmend.views.time_axis import TimeAxis
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap

LEFT = 58
RIGHT = 8
TOP = 22
BOTTOM = 20
SPACE = 6
LEAST_LANE = 44
"""Height below which a plot cannot be read."""


class Trajectories(QWidget):
    """Plots that are painted once and kept: moving the playhead draws one line over the picture."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._painter = LanePainter(document, theme)
        self._picture: QPixmap | None = None
        self._frames: list[tuple[Lane, Frame]] = []
        self._separate = False
        self._axis = TimeAxis(view, LEFT, lambda: self.width() - LEFT - RIGHT)
        self.setMinimumSize(QSize(260, 160))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("Trajectory plots"))
        view.frame_changed.connect(self.update)
        for signal in (view.selection_changed, view.preview_changed, view.range_changed):
            signal.connect(self._repaint)
        document.samples_changed.connect(self._forget)

    @property
    def _theme(self) -> Theme:
        return self._painter.theme

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._painter.theme = theme
        self._repaint()

    def set_separate(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Give every selected marker its own three plots, or overlay them."""
        self._separate = on
        self._repaint()

    def lanes(self) -> list[Lane]:
        """Return the plots for the present selection, from top to bottom.

        Of separate plots only as many as can be read; the markers selected last come first.
        """
        colours = self._theme.curves
        curves = tuple(
            Curve(marker, colours[order % len(colours)])
            for order, marker in enumerate(self._view.selection)
        )
        if not self._separate:
            return [Lane(axis, curves) for axis in range(3)] if curves else []
        room = max(1, (self.height() - TOP - BOTTOM) // (3 * LEAST_LANE))
        return [Lane(axis, (curve,)) for curve in curves[-room:] for axis in range(3)]

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._axis.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._axis.drag(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        marker = self._view.marker
        if marker is None:
            return
        gap = self._document.gap_near(marker, self._axis.frame_at(event.position().x()))
        if gap is not None:
            self._view.go_to(gap)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._axis.wheel(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._picture = None
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._picture = None
        super().changeEvent(event)

    # --- painting ----------------------------------------------------------------------------

    def _forget(self, gaps: tuple[Gap, ...]) -> None:
        self._painter.forget({gap.marker for gap in gaps})
        self._repaint()

    def _repaint(self) -> None:
        self._picture = None
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._picture is None or self._picture.devicePixelRatioF() != self.devicePixelRatioF():
            self._picture = self._paint_picture()
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._picture)
        if self._frames:
            self._paint_values(painter)
            self._paint_playhead(painter)
        painter.end()

    def _paint_picture(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(QColor(self._theme.window))
        painter = QPainter(picture)
        painter.setFont(self.font())
        lanes = self.lanes()
        self._frames = []
        if not lanes:
            self._paint_hint(painter)
        else:
            height = (self.height() - TOP - BOTTOM + SPACE) / len(lanes)
            for row, lane in enumerate(lanes):
                top = round(TOP + row * height)
                rect = QRectF(LEFT, top, self._axis.width, max(8, round(height - SPACE)))
                frame = self._painter.paint(
                    painter, lane, rect, self._view.visible, self._view.preview
                )
                self._frames.append((lane, frame))
                if self._separate and lane.axis == 0:
                    self._paint_marker(painter, lane.curves[0], rect)
            self._paint_time_axis(painter)
        painter.end()
        return picture

    def _paint_marker(self, painter: QPainter, curve: Curve, rect: QRectF) -> None:
        painter.setPen(QColor(curve.colour))
        place = rect.adjusted(20, 2, -4, 0)
        painter.drawText(place, Qt.AlignmentFlag.AlignLeft, self._document.names[curve.marker])

    def _paint_hint(self, painter: QPainter) -> None:
        painter.setPen(QColor(self._theme.dim))
        painter.drawText(
            self.rect(),
            Qt.AlignmentFlag.AlignCenter,
            self.tr("Select a marker to see its trajectory"),
        )

    def _paint_time_axis(self, painter: QPainter) -> None:
        frame = self._frames[-1][1]
        first = self._document.original.first_frame
        painter.setPen(QColor(self._theme.dim))
        marks, _ = ticks(frame.start + first, frame.stop + first, max(2, self._axis.width // 60))
        for mark in marks:
            if mark != round(mark):
                continue
            x = float(frame.x(mark - first))
            if frame.rect.left() + 10 <= x <= frame.rect.right() - 10:
                place = QRectF(x - 40, self.height() - BOTTOM + 2, 80, 16)
                painter.drawText(place, Qt.AlignmentFlag.AlignCenter, f"{mark:.0f}")

    def _paint_playhead(self, painter: QPainter) -> None:
        frame = self._frames[0][1]
        x = float(frame.x(self._view.frame))
        if frame.rect.left() <= x <= frame.rect.right():
            painter.setPen(QPen(QColor(self._theme.playhead), 1))
            painter.drawLine(QPointF(x, TOP - 4), QPointF(x, self.height() - BOTTOM))

    def _paint_values(self, painter: QPainter) -> None:
        """Write the names and places of the selected markers above the plots, the current first."""
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        x, colours = float(LEFT), self._theme.curves
        for done, (order, marker) in enumerate(reversed(list(enumerate(self._view.selection)))):
            name, value = self._document.names[marker], f"  {self._value(marker)}"
            more = f"+{len(self._view.selection) - done}"
            room = self.width() - RIGHT - x - metrics.horizontalAdvance(value)
            if done and room < metrics.horizontalAdvance(name + more) + 18:
                painter.setPen(QColor(self._theme.dim))
                painter.drawText(QPointF(x, TOP - 7), more)
                return
            text = elided(name, metrics, int(room)) + value
            painter.setPen(QColor(colours[order % len(colours)]))
            painter.drawText(QPointF(x, TOP - 7), text)
            x += metrics.horizontalAdvance(text) + 18

    def _value(self, marker: int) -> str:
        place = self._document.points[self._view.frame, marker]
        if np.isnan(place[0]):
            return self.tr("missing")
        unit = self._document.original.unit
        decimals = {"m": 4, "cm": 2}.get(unit, 1)
        return "  ".join(f"{value:.{decimals}f}" for value in place) + f" {unit}"
