"""Panes at the sides that grow and shrink with the text in them."""

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QMainWindow

SIDES = (Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea)
SAMPLE = "0123456789"


class PaneWidths(QObject):
    """Keeps the room of the side panes in step with the size of the text.

    Parameters
    ----------
    around : QMainWindow
        Whose panes they are.
    """

    def __init__(self, around: QMainWindow) -> None:
        super().__init__(around)
        self._around = around
        self._advance = self._measure()
        around.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FontChange:
            # Later, when the panes have the new text too.
            QTimer.singleShot(0, self, self._fit)
        return False

    def _measure(self) -> int:
        return self._around.fontMetrics().horizontalAdvance(SAMPLE)

    def _fit(self) -> None:
        before, self._advance = self._advance, self._measure()
        panes = [
            pane
            for pane in self._around.findChildren(QDockWidget)
            # Of panes that share a place, the one in front.
            if not pane.visibleRegion().isEmpty()
            and not pane.isFloating()
            and self._around.dockWidgetArea(pane) in SIDES
        ]
        widths = [round(pane.width() * self._advance / before) for pane in panes]
        self._around.resizeDocks(panes, widths, Qt.Orientation.Horizontal)
