"""Icons of buttons that Qt makes itself: its own can hardly be seen on a dark ground."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QToolBar, QToolButton

from mocapmend.theme import Theme
from mocapmend.views.icons import icon

EXTENSION = "qt_toolbar_ext_button"
TITLE_BUTTONS = {"qt_dockwidget_floatbutton": "float", "qt_dockwidget_closebutton": "close"}
"""Icons by Qt's names of the buttons in the title of a pane."""


def draw_extension(bar: QToolBar, theme: Theme) -> None:
    """Draw the button that shows what a tool bar has no room for."""
    button = bar.findChild(QToolButton, EXTENSION)
    assert isinstance(button, QToolButton)
    button.setIcon(icon("more", theme))


class TitleIcons(QObject):
    """Draws the buttons in the title of a pane; Qt draws its own anew when the pane floats.

    Parameters
    ----------
    pane : QDockWidget
        Has the title, and owns this.
    theme : Theme
        The colours.
    """

    def __init__(self, pane: QDockWidget, theme: Theme) -> None:
        super().__init__(pane)
        self._pane = pane
        self._theme = theme
        pane.topLevelChanged.connect(self._draw)
        self._draw()

    def set_theme(self, theme: Theme) -> None:
        """Draw in other colours from now on."""
        self._theme = theme
        self._draw()

    def _draw(self) -> None:
        for name, picture in TITLE_BUTTONS.items():
            button = self._pane.findChild(QAbstractButton, name)
            assert isinstance(button, QAbstractButton)
            button.setIcon(icon(picture, self._theme))
