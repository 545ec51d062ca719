"""The timeline: one lane per marker, what is missing or repaired, and the playhead."""

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QHelpEvent,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractScrollArea, QToolTip, QWidget

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.columns import column_edges, columns_with
from mocapmend.views.labels import elided
from mocapmend.views.lane import ticks
from mocapmend.views.time_axis import TimeAxis
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap

GUTTER = 116
RULER = 20
NAME_MARGIN = 5
"""Room above the first and below the last lane for their names, which are taller than lanes."""
LANES_TOP = RULER + NAME_MARGIN
LANE_MIN = 5
LANE_MAX = 16
NO_LANE = len(SampleState)
"""Colour index of the space between lanes."""


class Timeline(QAbstractScrollArea):
    """Lanes of all markers over the visible frames; a click scrubs, a wheel zooms."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._theme = theme
        self._picture: QPixmap | None = None
        self.axis = TimeAxis(view, GUTTER, lambda: self.viewport().width() - GUTTER - 1)
        self.setMinimumHeight(90)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAccessibleName(self.tr("Timeline"))
        self.viewport().setMouseTracking(True)
        self.verticalScrollBar().valueChanged.connect(self._repaint)
        view.frame_changed.connect(self.viewport().update)
        for signal in (
            view.range_changed,
            view.selection_changed,
            view.gap_changed,
            document.samples_changed,
        ):
            signal.connect(self._repaint)
        view.selection_changed.connect(self._show_lane)

    def sizeHint(self) -> QSize:
        return QSize(800, LANES_TOP + min(24, self._document.original.markers) * 6 + 16)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self._repaint()

    # --- where things are --------------------------------------------------------------------

    def _lane_height(self) -> int:
        """Lanes share the height, within what can be read and hit."""
        count = max(1, self._document.original.markers)
        return max(
            LANE_MIN, min(LANE_MAX, (self.viewport().height() - LANES_TOP - NAME_MARGIN) // count)
        )

    def marker_at(self, y: float) -> int | None:
        """Return the marker whose lane is at a vertical place of the viewport."""
        row = int((y - LANES_TOP + self.verticalScrollBar().value()) // self._lane_height())
        return row if y >= LANES_TOP and 0 <= row < self._document.original.markers else None

    def lane_top(self, marker: int) -> int:
        """Return the vertical place of a marker's lane in the viewport."""
        return LANES_TOP + marker * self._lane_height() - self.verticalScrollBar().value()

    def _lanes_in_view(self) -> range:
        """Return the markers whose lanes can be seen, in part at least."""
        height, above = self._lane_height(), self.verticalScrollBar().value()
        below = above + self.viewport().height() - LANES_TOP
        # One more below: its name stands out above its lane.
        last = min(self._document.original.markers, below // height + 2)
        return range(max(0, (above - NAME_MARGIN) // height), max(0, last))

    def gap_at(self, position: QPointF) -> Gap | None:
        """Return the gap under a place of the viewport; two pixels of tolerance."""
        marker = self.marker_at(position.y())
        if marker is None:
            return None
        reach = 2.0 * self.axis.frames_per_pixel
        return self._document.gap_near(marker, self.axis.frame_at(position.x()), reach)

    def _show_lane(self) -> None:
        marker = self._view.marker
        if marker is None:
            return
        bar, height = self.verticalScrollBar(), self._lane_height()
        page = self.viewport().height() - LANES_TOP - NAME_MARGIN
        bottom = (marker + 1) * height - page
        bar.setValue(max(bottom, min(bar.value(), marker * height)))

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._select_at(event)
        self.axis.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self.axis.drag(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        gap = self.gap_at(event.position())
        if gap is not None:
            self._view.go_to(gap)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            super().wheelEvent(event)
        else:
            self.axis.wheel(event)

    def viewportEvent(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            self._show_tip(event.pos(), event.globalPos())
            return True
        return super().viewportEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._repaint()
        self._show_lane()
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._picture = None
        super().changeEvent(event)

    def _select_at(self, event: QMouseEvent) -> None:
        marker = self.marker_at(event.position().y())
        if marker is None:
            return
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self._view.toggle(marker)
        elif marker != self._view.marker:
            self._view.select((marker,))
        gap = self.gap_at(event.position())
        if gap is not None and marker in self._view.selection:
            self._view.set_gap(gap)

    def _show_tip(self, place: QPoint, on_screen: QPoint) -> None:
        marker = self.marker_at(place.y())
        if marker is None:
            QToolTip.hideText()
            return
        original = self._document.original
        text = original.labels[marker]
        gap = self.gap_at(QPointF(place))
        if gap is not None and gap in self._document.repairs:
            text += self.tr(": repaired, frames {0} to {1}").format(
                gap.start + original.first_frame, gap.stop - 1 + original.first_frame
            )
        elif gap is not None:
            text += self.tr(": missing from frame {0} to {1}, {2} frames ({3} ms)").format(
                gap.start + original.first_frame,
                gap.stop - 1 + original.first_frame,
                gap.length,
                round(1000.0 * gap.length / original.rate),
            )
        elif place.x() >= GUTTER:
            text += self.tr(": measured here")
        QToolTip.showText(on_screen, text, self)

    # --- painting ----------------------------------------------------------------------------

    def _repaint(self) -> None:
        self._picture = None
        lanes = self._document.original.markers * self._lane_height() + NAME_MARGIN
        page = self.viewport().height() - LANES_TOP
        self.verticalScrollBar().setRange(0, max(0, lanes - page))
        self.verticalScrollBar().setPageStep(page)
        self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._picture is None or self._picture.devicePixelRatioF() != self.devicePixelRatioF():
            self._picture = self._paint_picture()
        painter = QPainter(self.viewport())
        painter.drawPixmap(0, 0, self._picture)
        x = self.axis.x_of(self._view.frame + 0.5)
        if GUTTER <= x <= self.viewport().width():
            painter.setPen(QPen(QColor(self._theme.playhead), 1))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.viewport().height()))
            self._paint_frame_number(painter, x)
        painter.end()

    def _paint_frame_number(self, painter: QPainter, x: float) -> None:
        original = self._document.original
        text = str(self._view.frame + original.first_frame)
        width = painter.fontMetrics().horizontalAdvance(text) + 10
        left = min(max(GUTTER, x - width / 2), self.viewport().width() - width)
        flag = QRectF(left, 0, width, RULER - 3)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(self._theme.accent))
        painter.drawRoundedRect(flag, 3, 3)
        painter.setPen(QColor(self._theme.on_accent))
        painter.drawText(flag, Qt.AlignmentFlag.AlignCenter, text)

    def _paint_picture(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        picture = QPixmap(self.viewport().size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(QColor(self._theme.window))
        painter = QPainter(picture)
        painter.setFont(self.font())
        area = QRect(0, RULER, self.viewport().width(), max(0, self.viewport().height() - RULER))
        painter.setClipRect(area)
        self._paint_lanes(painter)
        self._paint_names(painter)
        self._paint_current_gap(painter)
        painter.setClipping(False)
        self._paint_ruler(painter)
        painter.end()
        return picture

    def _paint_lanes(self, painter: QPainter) -> None:
        markers, width = self._lanes_in_view(), self.axis.width
        edges = column_edges(*self._view.visible, width)
        indices = np.zeros((max(1, len(markers)), width), np.uint8)
        for row, marker in enumerate(markers):
            # Missing last: a gap must show even where it shares its column with others.
            for state in (SampleState.FILLED, SampleState.BAD, SampleState.MISSING):
                runs = self._document.runs(marker, state)
                if len(runs):
                    indices[row, columns_with(runs, edges)] = state
        height = self._lane_height()
        tall = np.repeat(indices, height, axis=0)
        if height > 2:
            tall[height - 1 :: height] = NO_LANE
        tall = np.ascontiguousarray(np.pad(tall, ((0, 0), (0, -width % 4))))
        image = QImage(tall.data, width, len(tall), tall.shape[1], QImage.Format.Format_Indexed8)
        colours = [self._theme.state_colour(state) for state in SampleState]
        image.setColorTable([QColor(c).rgba() for c in (*colours, self._theme.window)])
        painter.drawImage(QPointF(GUTTER, self.lane_top(markers.start)), image)

    def _paint_names(self, painter: QPainter) -> None:
        """Write the names of the selected lanes, and of as many others as keep apart."""
        height = self._lane_height()
        metrics = painter.fontMetrics()
        every = max(1, int(np.ceil((metrics.height() - 3) / height)))
        labels = self._document.names
        seen = self._lanes_in_view()
        chosen = set(self._view.selection)
        # The current marker first, then the other selected ones, then as many as have room.
        selected = (marker for marker in reversed(self._view.selection) if marker in seen)
        shown: list[int] = []
        for marker in (*selected, *range(seen.start - seen.start % every, seen.stop, every)):
            if all(abs(marker - other) >= every for other in shown):
                shown.append(marker)
        for marker in shown:
            place = QRectF(0, self.lane_top(marker) + height / 2 - 8, GUTTER - 4, 16)
            if marker in chosen:
                painter.fillRect(place, QColor(self._theme.accent))
            painter.setPen(QColor(self._theme.on_accent if marker in chosen else self._theme.dim))
            place.adjust(4, 0, -4, 0)
            text = elided(labels[marker], metrics, int(place.width()))
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)

    def _paint_current_gap(self, painter: QPainter) -> None:
        gap = self._view.gap
        if gap is None:
            return
        left, right = self.axis.x_of(gap.start), self.axis.x_of(gap.stop)
        if right < GUTTER:
            return
        top = self.lane_top(gap.marker)
        painter.setPen(QPen(QColor(self._theme.preview), 1.5))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        left = max(left, GUTTER - 2.0)
        painter.drawRect(QRectF(left - 1, top - 1, right - left + 1, self._lane_height()))

    def _paint_ruler(self, painter: QPainter) -> None:
        original = self._document.original
        start, stop = self._view.visible
        painter.setPen(QColor(self._theme.dim))
        seconds, decimals = ticks(
            start / original.rate, stop / original.rate, max(2, self.axis.width // 90)
        )
        for second in seconds:
            x = self.axis.x_of(second * original.rate)
            painter.drawLine(QPointF(x, RULER - 5), QPointF(x, RULER - 1))
            if x + 60 < self.viewport().width():
                place = QRectF(x + 3, 0, 80, RULER - 4)
                painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, f"{second:.{decimals}f} s")
