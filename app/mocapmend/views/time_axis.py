"""The time axis that plots and timeline share: frames to pixels, and what the mouse does to it."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent

from mocapmend.viewstate import ViewState

ZOOM_PER_STEP = 0.998
"""Of the visible range, per eighth of a degree of the wheel."""


class TimeAxis:
    """The visible frames of a view state, laid over a part of a widget.

    It does not know the widget, which has it: they would keep each other when the tab is closed.

    Parameters
    ----------
    view : ViewState
        Whose visible range it is.

    Attributes
    ----------
    left : int
        Pixels before the axis begins.
    width : int
        Pixels that it takes, at least one.
    """

    def __init__(self, view: ViewState) -> None:
        self.left = 0
        self.width = 1
        self._view = view
        self._grip: float | None = None
        self._anchor: int | None = None

    def place(self, left: int, width: int) -> None:
        """Lay the axis over another part of the widget."""
        self.left, self.width = left, max(1, width)

    @property
    def frames_per_pixel(self) -> float:
        """Scale of the axis."""
        start, stop = self._view.visible
        return (stop - start) / self.width

    def frame_at(self, x: float) -> float:
        """Return the frame at a horizontal place."""
        return self._view.visible[0] + (x - self.left) * self.frames_per_pixel

    def x_of(self, frame: float) -> float:
        """Return the horizontal place of a frame's beginning."""
        return self.left + (frame - self._view.visible[0]) / self.frames_per_pixel

    def press(self, event: QMouseEvent) -> None:
        """Begin to scrub with the left button, to select with Shift, to move with another."""
        self._grip = event.position().x()
        self._anchor = None
        if event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self._anchor = self._whole_frame_at(self._grip)
        else:
            self.drag(event)

    def drag(self, event: QMouseEvent) -> None:
        """Scrub, select, or move the range to where the mouse is."""
        x = event.position().x()
        if event.buttons() & Qt.MouseButton.LeftButton:
            if self._anchor is not None:
                first, last = sorted((self._anchor, self._whole_frame_at(x)))
                self._view.set_span((first, last + 1))
            elif x >= self.left:
                self._view.set_frame(self._whole_frame_at(x))
        elif event.buttons() and self._grip is not None:
            self._view.pan((self._grip - x) * self.frames_per_pixel)
            self._grip = x

    def wheel(self, event: QWheelEvent) -> None:
        """Zoom around the mouse; sideways, or while Shift is held, move the range."""
        turned, moved = event.angleDelta(), event.pixelDelta()
        shift = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        if shift or abs(turned.x()) > abs(turned.y()):
            # A touchpad says how many pixels the fingers have moved: the picture goes with them.
            step = turned if moved.isNull() else moved
            self._view.pan(-(step.x() or step.y()) * self.frames_per_pixel)
        else:
            self._view.zoom(ZOOM_PER_STEP ** turned.y(), self.frame_at(event.position().x()))

    def _whole_frame_at(self, x: float) -> int:
        return int(np.floor(self.frame_at(x)))
