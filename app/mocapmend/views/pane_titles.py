"""Titles of panes: seen where no tab says the name, with buttons in the colours of the theme."""

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMainWindow, QWidget

from mocapmend.theme import Theme
from mocapmend.views.icons import icon

TITLE_BUTTONS = {"qt_dockwidget_floatbutton": "float", "qt_dockwidget_closebutton": "close"}
"""Icons by Qt's names of the buttons in the title of a pane."""


class PaneTitles(QObject):
    """Shows and hides the titles of a window's panes, and draws the buttons in them.

    Parameters
    ----------
    around : QMainWindow
        Has the panes, and owns this.
    theme : Theme
        The colours.
    """

    def __init__(self, around: QMainWindow, theme: Theme) -> None:
        super().__init__(around)
        self._theme = theme
        self._panes: list[QDockWidget] = []
        self._hidden: dict[QDockWidget, QWidget] = {}
        """What stands in the place of a title that is not seen."""
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.fit)

    def add(self, pane: QDockWidget) -> None:
        """Care for a pane from now on."""
        self._panes.append(pane)
        # Later: the other panes are not yet where they will be.
        pane.topLevelChanged.connect(self._later.start)
        pane.dockLocationChanged.connect(self._later.start)
        pane.toggleViewAction().toggled.connect(self._later.start)
        self._draw(pane)

    def set_theme(self, theme: Theme) -> None:
        """Draw in other colours from now on."""
        self._theme = theme
        for pane in self._panes:
            self._draw(pane)

    def fit(self) -> None:
        """Hide the titles of panes that have a tab, and show the others."""
        for pane in self._panes:
            if self._has_tab(pane) and pane not in self._hidden:
                self._hidden[pane] = QWidget()
                pane.setTitleBarWidget(self._hidden[pane])
            elif pane in self._hidden and not self._has_tab(pane):
                # Qt takes None, and does not say so.
                pane.setTitleBarWidget(None)  # type: ignore[arg-type]
                self._hidden.pop(pane).deleteLater()
            # Qt has drawn its own anew.
            self._draw(pane)

    def _has_tab(self, pane: QDockWidget) -> bool:
        # Not an attribute: they would keep each other when the tab is closed.
        around = self.parent()
        assert isinstance(around, QMainWindow)
        beside = around.tabifiedDockWidgets(pane)
        # A closed pane keeps its place among the tabs, but is none of them.
        return any(other.toggleViewAction().isChecked() for other in beside)

    def _draw(self, pane: QDockWidget) -> None:
        for name, picture in TITLE_BUTTONS.items():
            button = pane.findChild(QAbstractButton, name)
            assert isinstance(button, QAbstractButton)
            button.setIcon(icon(picture, self._theme))
