"""Play, speed and frame number, in the toolbar."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QSpinBox, QToolButton, QWidget

from mocapmend.theme import Theme
from mocapmend.views.icons import icon
from mocapmend.views.player import SPEEDS

if TYPE_CHECKING:
    from mocapmend.views.workspace import Workspace


class Transport(QWidget):
    """Shows and moves the playhead of the open workspace."""

    def __init__(self, actions: dict[str, QAction], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._workspace: Workspace | None = None
        self._play = actions["play"]
        self._theme: Theme | None = None
        self._scale = 1.0
        self.button = QToolButton()
        self.button.setDefaultAction(self._play)
        self.button.setAutoRaise(True)
        self._speed = QComboBox()
        self._speed.setAccessibleName(self.tr("Playback speed"))
        self._speed.setToolTip(self.tr("Playback speed ([ and ])"))
        for speed in SPEEDS:
            self._speed.addItem(f"{speed:g} ×", speed)
        self._speed.setCurrentIndex(SPEEDS.index(1.0))
        self._speed.activated.connect(self._set_speed)
        self._frame = QSpinBox()
        self._frame.setAccessibleName(self.tr("Frame"))
        self._frame.setKeyboardTracking(False)
        self._frame.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._frame.valueChanged.connect(self._go)
        self._time = QLabel()
        self._time.setMinimumWidth(self._time.fontMetrics().horizontalAdvance("0000.000 s"))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for part in (self.button, self._speed, QLabel(self.tr("  Frame")), self._frame, self._time):
            layout.addWidget(part)

    def set_theme(self, theme: Theme, scale: float) -> None:
        """Draw the button in other colours, and for text of another size, from now on."""
        self._theme, self._scale = theme, scale
        self._show_playing()

    def show_workspace(self, workspace: "Workspace | None") -> None:
        """Follow another workspace."""
        if self._workspace is not None:
            self._workspace.view.frame_changed.disconnect(self._show_frame)
            self._workspace.player.playing_changed.disconnect(self._show_playing)
            self._workspace.player.speed_changed.disconnect(self._show_speed)
        self._workspace = workspace
        self.setEnabled(workspace is not None)
        if workspace is None:
            self._frame.setRange(0, 0)
            self._time.setText("")
            return
        original = workspace.document.original
        self._frame.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        self._frame.setRange(original.first_frame, original.first_frame + original.frames - 1)
        self._frame.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        workspace.view.frame_changed.connect(self._show_frame)
        workspace.player.playing_changed.connect(self._show_playing)
        workspace.player.speed_changed.connect(self._show_speed)
        self._show_frame(workspace.view.frame)
        self._show_speed(workspace.player.speed)
        self._show_playing()

    def _go(self, number: int) -> None:
        if self._workspace is not None:
            self._workspace.go_to_frame(number - self._workspace.document.original.first_frame)

    def _set_speed(self, index: int) -> None:
        if self._workspace is not None:
            self._workspace.player.set_speed(SPEEDS[index])

    def _show_frame(self, frame: int) -> None:
        assert self._workspace is not None
        original = self._workspace.document.original
        self._frame.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        self._frame.setValue(frame + original.first_frame)
        self._frame.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        self._time.setText(f"{frame / original.rate:.3f} s")

    def _show_speed(self, speed: float) -> None:
        self._speed.setCurrentIndex(SPEEDS.index(speed))

    def _show_playing(self) -> None:
        if self._theme is None:
            return
        playing = self._workspace is not None and self._workspace.player.playing
        self._play.setIcon(icon("pause" if playing else "play", self._theme, self._scale))
