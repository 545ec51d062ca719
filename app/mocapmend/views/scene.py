"""The 3D marker view: what mouse and keyboard do in its picture."""

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from mocapmend.document import Document
from mocapmend.theme import Theme
from mocapmend.views.scene_picture import ScenePicture
from mocapmend.viewstate import ViewState

NEAR_AND_FAR = np.array([0.1, 60.0])
"""Bounds of the camera's distance in body sizes."""
PICK_RADIUS = 12.0
DRAG_THRESHOLD = 4.0
TURN = 15.0
"""Degrees that a key turns the view by."""
APPROACH = 0.8
"""Share of the distance that is left when a key brings the camera nearer."""


class Scene(ScenePicture):
    """A document in 3D: to be turned, moved, and selected from."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(document, view, theme, parent)
        view.picking_changed.connect(self._show_picking)
        self._press: QPointF | None = None
        self._dragged = False
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)

    def pick(self, position: QPointF) -> int | None:
        """Return the marker nearest to a point of the picture, or None."""
        self._aim()
        pixels = self._project(self._current_points())
        distance = np.hypot(pixels[:, 0] - position.x(), pixels[:, 1] - position.y())
        if not np.isfinite(distance).any():
            return None
        nearest = int(np.nanargmin(distance))
        return nearest if distance[nearest] <= PICK_RADIUS else None

    def turn(self, right: int, up: int) -> None:
        """Go around the body by steps."""
        self.camera.orbit(TURN * right, TURN * up)
        self.update()

    def approach(self, steps: int) -> None:
        """Come nearer, or go away by negative steps."""
        self._zoom(APPROACH**steps)

    def centre_on(self, marker: int | None) -> None:
        """Bring a marker near and to the middle; nothing happens where it is missing."""
        place = np.full(3, np.nan) if marker is None else self._current_points()[marker]
        if np.isfinite(place).all():
            self._offset = place - (self._centre() if self.follow else 0.0)
            self.camera.distance = 1.2 * self._size
            self.update()

    def select_in_view(self, *, add: bool) -> None:
        """Select the markers that the picture shows, as a box around all of it does."""
        self._select_inside(QRectF(self.rect()), add=add)

    # --- what the user does ------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._press = event.position()
        self._box = None
        self._dragged = False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._press is None:
            return
        moved = event.position() - self._press
        if not self._dragged and moved.manhattanLength() < DRAG_THRESHOLD:
            return
        buttons, keys = event.buttons(), event.modifiers()
        left = bool(buttons & Qt.MouseButton.LeftButton)
        if not self._dragged and (
            buttons & Qt.MouseButton.RightButton
            or (left and keys & Qt.KeyboardModifier.ControlModifier)
        ):
            self._box = QRectF()
        self._dragged = True
        if self._box is not None:
            self._box = QRectF(self._press, event.position()).normalized()
            self.update()
            return
        self._press = event.position()
        if left and not keys & Qt.KeyboardModifier.ShiftModifier:
            self.camera.orbit(-0.4 * moved.x(), 0.4 * moved.y())
        else:
            self._aim()
            before = self.camera.target
            self.camera.pan(moved.x(), moved.y(), min(self.width(), self.height()))
            self._offset = self._offset + self.camera.target - before
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, self._press = self._press, None
        box, self._box = self._box, None
        add = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if box is not None:
            self._select_inside(box, add=add)
        elif (
            pressed is not None
            and not self._dragged
            and event.button() == Qt.MouseButton.LeftButton
        ):
            self._view.click(self.pick(event.position()), add=add)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.centre_on(self.pick(event.position()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._zoom(0.999 ** event.angleDelta().y())

    def event(self, event: QEvent) -> bool:
        # While a box is drawn, Escape belongs to it, whatever it does elsewhere.
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
            and self._box is not None
        ):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._box is not None:
            self._press = self._box = None
            self.update()
        else:
            super().keyPressEvent(event)

    def _zoom(self, factor: float) -> None:
        self.camera.zoom(factor)
        self.camera.distance = float(np.clip(self.camera.distance, *NEAR_AND_FAR * self._size))
        self.update()

    def _show_picking(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Let the mouse look as if it picked donors, or as ever."""
        self.setCursor(Qt.CursorShape.CrossCursor if on else Qt.CursorShape.ArrowCursor)

    def _select_inside(self, box: QRectF, *, add: bool) -> None:
        """Select the markers in a box of the picture, in place of the others or beside them."""
        self._aim()
        x, y = self._project(self._current_points()).T
        inside = (x >= box.left()) & (x <= box.right()) & (y >= box.top()) & (y <= box.bottom())
        kept = self._view.selection if add else ()
        new = (marker for marker in np.flatnonzero(inside).tolist() if marker not in kept)
        self._view.select((*kept, *new))
        self.update()
