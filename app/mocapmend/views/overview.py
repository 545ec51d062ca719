"""The overview: where in the whole recording markers are missing, and what of it is in view."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QHelpEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from mocapmend.document import Document
from mocapmend.state import OPEN, SampleState
from mocapmend.theme import Theme
from mocapmend.views.lane import thin
from mocapmend.views.run_index import missing_share
from mocapmend.views.time_axis import ZOOM_PER_STEP
from mocapmend.viewstate import LEAST_VISIBLE, ViewState
from mocapmend_algorithms.problems import BadRun

GRIP = 6
"""Pixels around an end of the window in which it can be taken."""
LEAST_WINDOW = 4
"""Pixels of a window that shows less than that of the recording."""
MARK = 3
"""Height of what tells where samples are held for bad."""
LEAST_HEAT = 2
"""Pixels of a column with a single missing sample."""


class Overview(QWidget):
    """A strip of the whole recording; the window on it can be moved and its ends pulled."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._theme = theme
        self.title = self.tr("Overview")
        self._gutter = 0
        self._suspects: Sequence[BadRun] = ()
        self._heat: NDArray[np.float64] | None = None
        self._strip_picture: QPixmap | None = None
        self._picture: QPixmap | None = None
        self._grip = ""
        self._taken_at = 0.0
        self._moved = False
        self.setMouseTracking(True)
        self.setAccessibleName(self.tr("Overview of the whole recording"))
        self._shown = 0
        view.frame_changed.connect(self._show_frame)
        view.range_changed.connect(self._repaint)
        view.span_changed.connect(self._repaint)
        document.samples_changed.connect(self._forget)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self._forget()

    def set_gutter(self, gutter: int) -> None:
        """Leave room for a name at the left."""
        self._gutter = gutter
        self._forget()

    def set_suspects(self, runs: Sequence[BadRun]) -> None:
        """Mark where measured samples are held for bad."""
        self._suspects = runs
        self._forget()

    def heat(self) -> NDArray[np.float64]:
        """Return the share of samples that is missing in each column, shape (width,)."""
        width = self._width()
        if self._heat is None or len(self._heat) != width:
            # What is set aside counts as missing.
            missing = [
                np.concatenate([self._document.runs(marker, state) for state in OPEN])
                for marker in range(self._document.original.markers)
            ]
            edges = np.linspace(0.0, max(1, self._view.frames), width + 1)
            self._heat = missing_share(missing, self._view.frames, edges)
        return self._heat

    def window_rect(self) -> QRectF:
        """Return where the window on the visible frames is."""
        left, right = map(self.x_of, self._view.visible)
        lacking = max(0.0, LEAST_WINDOW - (right - left)) / 2.0
        return QRectF(left - lacking, 0.5, right - left + 2.0 * lacking, self.height() - 1.0)

    def x_of(self, frame: float) -> float:
        """Return the horizontal place of a frame's beginning."""
        return self._gutter + frame * self._width() / max(1, self._view.frames)

    def frame_at(self, x: float) -> float:
        """Return the frame at a horizontal place."""
        return (x - self._gutter) * max(1, self._view.frames) / self._width()

    def _width(self) -> int:
        return max(1, self.width() - self._gutter - 1)

    def _forget(self) -> None:
        self._heat = self._strip_picture = None
        self._repaint()

    def _repaint(self) -> None:
        self._picture = None
        self.update()

    def _show_frame(self) -> None:
        """Paint again where the playhead was and where it is."""
        x = round(self.x_of(self._view.frame + 0.5))
        if x != self._shown:
            for place in (x, self._shown):
                self.update(place - 2, 0, 4, self.height())
            self._shown = x

    # --- what the user does ------------------------------------------------------------------

    def _grip_at(self, x: float) -> str:
        """Say what the mouse would take: an end of the window, all of it, or a new place."""
        window = self.window_rect()
        third = window.width() / 3.0
        if window.left() - GRIP <= x <= window.left() + min(GRIP, third):
            return "start"
        if window.right() - min(GRIP, third) <= x <= window.right() + GRIP:
            return "stop"
        return "window" if window.left() <= x <= window.right() else "elsewhere"

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton or event.position().x() < self._gutter:
            return
        self._grip = self._grip_at(event.position().x())
        self._taken_at = self.frame_at(event.position().x())
        self._moved = False
        if self._grip == "elsewhere":
            start, stop = self._view.visible
            self._view.pan(self._taken_at - (start + stop) / 2.0)
            self._grip = "window"

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        x = event.position().x()
        if not event.buttons() & Qt.MouseButton.LeftButton or not self._grip:
            ends = x >= self._gutter and self._grip_at(x) in {"start", "stop"}
            self.setCursor(Qt.CursorShape.SizeHorCursor if ends else Qt.CursorShape.ArrowCursor)
            return
        self._moved = True
        frame = min(max(self.frame_at(x), 0.0), float(self._view.frames))
        start, stop = self._view.visible
        if self._grip == "window":
            self._view.pan(frame - self._taken_at)
            # What the end of the recording has held back does not count.
            self._taken_at += self._view.visible[0] - start
        elif self._grip == "start":
            self._view.set_visible(min(frame, stop - LEAST_VISIBLE), stop)
        else:
            self._view.set_visible(start, max(frame, start + LEAST_VISIBLE))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._grip == "window" and not self._moved:
            self._view.set_frame(int(self.frame_at(event.position().x())))
        self._grip = ""

    def wheelEvent(self, event: QWheelEvent) -> None:
        factor = ZOOM_PER_STEP ** event.angleDelta().y()
        self._view.zoom(factor, float(np.mean(self._view.visible)))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self._tip(event.pos().x()), self)
            return True
        return super().event(event)

    def _tip(self, x: int) -> str:
        column = x - self._gutter
        if not 0 <= column < self._width():
            return self.tr("Drag the window or its ends; click to go there.")
        first = self._document.original.first_frame
        return self.tr("Frames {0} to {1}: {2} % of the samples are missing").format(
            int(self.frame_at(x)) + first,
            max(int(self.frame_at(x)), int(np.ceil(self.frame_at(x + 1))) - 1) + first,
            f"{100.0 * self.heat()[column]:.1f}",
        )

    # --- painting ----------------------------------------------------------------------------

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._forget()
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.FontChange:
            self._forget()
        super().changeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._picture is None or self._picture.devicePixelRatioF() != self.devicePixelRatioF():
            self._picture = self._paint_picture()
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._picture)
        painter.setPen(thin(painter, self._theme.playhead))
        x = round(self.x_of(self._view.frame + 0.5))
        painter.drawLine(x, 0, x, self.height())
        painter.end()

    def _paint_picture(self) -> QPixmap:
        """Paint all but the playhead."""
        strip, ratio = self._strip_picture, self.devicePixelRatioF()
        if strip is None or strip.devicePixelRatioF() != ratio:
            strip = self._strip_picture = self._paint_strip(ratio)
        picture = strip.copy()
        painter = QPainter(picture)
        self._paint_window(painter)
        painter.end()
        return picture

    def _paint_strip(self, ratio: float) -> QPixmap:
        """Paint the heat, which costs more and changes less often than the window on it."""
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(QColor(self._theme.window))
        painter = QPainter(picture)
        painter.setFont(self.font())
        painter.fillRect(self._strip(), QColor(self._theme.base))
        heat = self.heat()
        ink = QColor(self._theme.state_colour(SampleState.MISSING))
        # The root: where few of many markers are missing it is seen too.
        tall = np.maximum(LEAST_HEAT, np.round(np.sqrt(heat) * (self.height() - 2)))
        for column in np.flatnonzero(heat).tolist():
            height = float(tall[column])
            painter.fillRect(QRectF(self._gutter + column, self.height() - height, 1, height), ink)
        bad = QColor(self._theme.state_colour(SampleState.BAD))
        for run in self._suspects:
            left, right = self.x_of(run.start), self.x_of(run.stop)
            painter.fillRect(QRectF(left, 0, max(2.0, right - left), MARK), bad)
        painter.setPen(QColor(self._theme.dim))
        name = QRectF(6, 0, self._gutter - 8, self.height())
        painter.drawText(name, Qt.AlignmentFlag.AlignVCenter, self.title)
        painter.end()
        return picture

    def _strip(self) -> QRectF:
        return QRectF(self._gutter, 0, self._width(), self.height())

    def _paint_window(self, painter: QPainter) -> None:
        window, strip = self.window_rect(), self._strip()
        veil = QColor(self._theme.window)
        veil.setAlpha(150)
        painter.fillRect(QRectF(strip.topLeft(), window.bottomLeft()), veil)
        painter.fillRect(QRectF(window.topRight(), strip.bottomRight()), veil)
        accent = QColor(self._theme.accent)
        if self._view.span is not None:
            left, right = map(self.x_of, self._view.span)
            painter.fillRect(QRectF(left, 0, max(2.0, right - left), 3), accent)
        painter.setPen(thin(painter, accent))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(window)
        for x in (window.left(), window.right()):
            painter.fillRect(QRectF(x - 2, self.height() / 4, 4, self.height() / 2), accent)
