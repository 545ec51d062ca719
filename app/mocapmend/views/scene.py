"""The 3D marker view: painted by numpy and QPainter, so it needs no OpenGL."""

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath, arrayToQPolygonF
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.theme import AXIS_COLOURS, Theme
from mocapmend.views.camera import Camera, body_path, body_size, upright
from mocapmend.views.floor import floor_grid
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap

Array = NDArray[np.float64]

FIT = 3.0
"""Distance of the camera in body sizes at which the body fills the view."""
NEAR_AND_FAR = np.array([0.1, 60.0])
"""Bounds of that distance in body sizes."""
PICK_RADIUS = 12.0
DRAG_THRESHOLD = 4.0
TRAIL_SECONDS = 0.5


class Scene(QWidget):
    """Markers, sticks, floor and the previewed repair of one document, seen from a camera."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._theme = theme
        self.show_labels = False
        self.show_trails = True
        self.follow = True
        original = document.original
        self._turn = upright(original.up).T
        path = body_path(original.points, original.rate)
        self._size = body_size(original.points, path)
        self._path = path @ self._turn
        self._floor = floor_grid(original, self._turn, self._path, self._size)
        self._take_bones()
        self.camera = Camera(distance=FIT * self._size)
        self._offset = np.zeros(3)
        self._press: QPointF | None = None
        self._dragged = False
        self.setMinimumSize(QSize(220, 160))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("3D marker view"))
        for signal in (
            view.frame_changed,
            view.selection_changed,
            view.preview_changed,
            document.samples_changed,
        ):
            signal.connect(self.update)
        document.skeleton_changed.connect(self._take_bones)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self.update()

    def look(self, name: str) -> None:
        """Turn to a fixed view and bring the body back to the middle."""
        self.camera.look(name)
        self.camera.distance = FIT * self._size
        self._offset = np.zeros(3)
        self.update()

    def set_follow(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Keep the body in the middle, or let it walk through the picture."""
        self._offset = np.zeros(3) if on else self._offset + self._path[self._view.frame]
        self.follow = on
        self.update()

    def set_labels(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Show every marker's label, or only those of the selection."""
        self.show_labels = on
        self.update()

    def set_trails(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Show where the selected markers come from and go to."""
        self.show_trails = on
        self.update()

    def pick(self, position: QPointF) -> int | None:
        """Return the marker nearest to a point of the picture, or None."""
        pixels = self._project(self._current_points())
        distance = np.hypot(pixels[:, 0] - position.x(), pixels[:, 1] - position.y())
        if not np.isfinite(distance).any():
            return None
        nearest = int(np.nanargmin(distance))
        return nearest if distance[nearest] <= PICK_RADIUS else None

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._press = event.position()
        self._dragged = False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._press is None:
            return
        moved = event.position() - self._press
        if not self._dragged and moved.manhattanLength() < DRAG_THRESHOLD:
            return
        self._dragged = True
        self._press = event.position()
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.buttons() & Qt.MouseButton.LeftButton and not shift:
            self.camera.orbit(-0.4 * moved.x(), 0.4 * moved.y())
        else:
            self._aim()
            before = self.camera.target
            self.camera.pan(moved.x(), moved.y(), min(self.width(), self.height()))
            self._offset = self._offset + self.camera.target - before
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, self._press = self._press, None
        if pressed is None or self._dragged or event.button() != Qt.MouseButton.LeftButton:
            return
        marker = self.pick(event.position())
        if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            if marker is not None:
                self._view.toggle(marker)
        else:
            self._view.select(() if marker is None else (marker,))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        marker = self.pick(event.position())
        if marker is not None:
            place = self._current_points()[marker]
            self._offset = place - (self._path[self._view.frame] if self.follow else 0.0)
            self.camera.distance = 1.2 * self._size
            self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        self.camera.zoom(0.999 ** event.angleDelta().y())
        self.camera.distance = float(np.clip(self.camera.distance, *NEAR_AND_FAR * self._size))
        self.update()

    # --- painting ----------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(self._theme.base))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._aim()
        self._paint_floor(painter)
        points = self._current_points()
        pixels = self._project(points)
        ghost = self._ghost_pixels(pixels)
        if self.show_trails:
            self._paint_trails(painter)
        self._paint_bones(painter, pixels, ghost)
        self._paint_markers(painter, pixels)
        self._paint_ghost(painter, ghost)
        self._paint_labels(painter, pixels, ghost)
        self._paint_axes(painter)
        painter.end()

    def _aim(self) -> None:
        centre = self._path[self._view.frame] if self.follow and len(self._path) else 0.0
        self.camera.target = self._offset + centre

    def _take_bones(self) -> None:
        self._bones = np.array(self._document.skeleton.bones, dtype=np.intp).reshape(-1, 2)
        self.update()

    def _project(self, points: Array) -> Array:
        return self.camera.project(points, self.width(), self.height())[0]

    def _current_points(self) -> Array:
        return np.asarray(self._document.points[self._view.frame] @ self._turn)

    def _paint_floor(self, painter: QPainter) -> None:
        painter.setPen(QPen(QColor(self._theme.line), 1))
        self._draw_segments(painter, self._project(self._floor))

    def _paint_bones(
        self, painter: QPainter, pixels: Array, ghost: tuple[int, Array] | None
    ) -> None:
        if not len(self._bones):
            return
        painter.setPen(QPen(QColor(self._theme.bone), 1.5))
        self._draw_segments(painter, pixels[self._bones].reshape(-1, 2))
        if ghost is not None:
            marker, place = ghost
            touching = self._bones[(self._bones == marker).any(axis=1)]
            ends = pixels[touching].copy()
            ends[touching == marker] = place
            painter.setPen(QPen(QColor(self._theme.preview), 1.2, Qt.PenStyle.DashLine))
            self._draw_segments(painter, ends.reshape(-1, 2))

    def _paint_markers(self, painter: QPainter, pixels: Array) -> None:
        states = self._document.state[self._view.frame]
        drawn = np.isfinite(pixels[:, 0])
        colours = {
            SampleState.MEASURED: self._theme.marker,
            SampleState.FILLED: self._theme.state_colour(SampleState.FILLED),
            SampleState.BAD: self._theme.state_colour(SampleState.BAD),
        }
        for state, colour in colours.items():
            self._draw_points(painter, pixels[drawn & (states == state)], colour, 6.0)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for order, marker in enumerate(self._view.selection):
            if drawn[marker]:
                painter.setPen(QPen(QColor(self._curve_colour(order)), 2))
                painter.drawEllipse(QPointF(*pixels[marker]), 7.0, 7.0)

    def _paint_trails(self, painter: QPainter) -> None:
        reach = max(1, round(TRAIL_SECONDS * self._document.original.rate))
        frames = slice(max(0, self._view.frame - reach), self._view.frame + reach + 1)
        for order, marker in enumerate(self._view.selection):
            colour = QColor(self._curve_colour(order))
            colour.setAlpha(150)
            painter.setPen(QPen(colour, 1.5))
            self._draw_line(painter, self._document.points[frames, marker])
        preview = self._view.preview
        if preview is not None and preview.patch is not None:
            painter.setPen(QPen(QColor(self._theme.preview), 1.5))
            self._draw_line(painter, preview.patch.values)

    def _ghost_pixels(self, pixels: Array) -> tuple[int, Array] | None:
        """Return the marker that a preview would put into this frame, and where."""
        preview, frame = self._view.preview, self._view.frame
        if preview is None or preview.patch is None:
            return None
        gap: Gap = preview.gap
        if not gap.start <= frame < gap.stop:
            return None
        place = preview.patch.values[frame - gap.start] @ self._turn
        pixel = self._project(place[None])[0]
        return (gap.marker, pixel) if np.isfinite(pixel).all() else None

    def _paint_ghost(self, painter: QPainter, ghost: tuple[int, Array] | None) -> None:
        if ghost is None:
            return
        x, y = ghost[1]
        painter.setPen(QPen(QColor(self._theme.preview), 2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        diamond = [QPointF(x, y - 8), QPointF(x + 8, y), QPointF(x, y + 8), QPointF(x - 8, y)]
        painter.drawPolygon(QPolygonF(diamond))

    def _paint_labels(
        self, painter: QPainter, pixels: Array, ghost: tuple[int, Array] | None
    ) -> None:
        labels = self._document.names
        shown = range(len(labels)) if self.show_labels else self._view.selection
        painter.setPen(QColor(self._theme.dim))
        for marker in shown:
            place = pixels[marker]
            if ghost is not None and ghost[0] == marker:
                place = ghost[1]
            if np.isfinite(place[0]):
                current = marker in self._view.selection
                painter.setPen(QColor(self._theme.text if current else self._theme.dim))
                width = painter.fontMetrics().horizontalAdvance(labels[marker])
                left = place[0] + 10
                if left + width > self.width():
                    # On the other side, but never with its beginning out of the picture.
                    left = max(2.0, place[0] - 10 - width)
                painter.drawText(QPointF(left, place[1] - 6), labels[marker])

    def _paint_axes(self, painter: QPainter) -> None:
        """Paint the file's axes into the lower left corner."""
        corner = QPointF(34.0, self.height() - 34.0)
        for axis, name in enumerate("XYZ"):
            direction = self.camera.turned(self._turn[axis])
            tip = corner + QPointF(22.0 * direction[0], -22.0 * direction[1])
            painter.setPen(QPen(QColor(AXIS_COLOURS[axis]), 2))
            painter.drawLine(corner, tip)
            beyond = corner + QPointF(31.0 * direction[0], -31.0 * direction[1])
            painter.drawText(
                QRectF(beyond.x() - 8, beyond.y() - 8, 16, 16), Qt.AlignmentFlag.AlignCenter, name
            )

    def _curve_colour(self, order: int) -> str:
        return self._theme.curves[order % len(self._theme.curves)]

    def _draw_line(self, painter: QPainter, points: Array) -> None:
        pixels = self._project(points @ self._turn)
        painter.drawPath(arrayToQPath(pixels[:, 0], pixels[:, 1], connect="finite"))

    @staticmethod
    def _draw_segments(painter: QPainter, ends: Array) -> None:
        """Draw lines between consecutive pairs of points; those with a missing end are left out."""
        whole = np.isfinite(ends[:, 0].reshape(-1, 2)).all(axis=1)
        pairs = ends.reshape(-1, 2, 2)[whole].reshape(-1, 2)
        if len(pairs):
            painter.drawPath(arrayToQPath(pairs[:, 0], pairs[:, 1], connect="pairs"))

    @staticmethod
    def _draw_points(painter: QPainter, pixels: Array, colour: str, width: float) -> None:
        if len(pixels):
            pen = QPen(QColor(colour), width)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            painter.drawPoints(arrayToQPolygonF(pixels[:, 0], pixels[:, 1]))
