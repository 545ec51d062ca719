"""Icons of buttons that Qt makes itself: its own can hardly be seen on a dark ground."""

from PySide6.QtWidgets import QToolBar, QToolButton

from mocapmend.theme import Theme
from mocapmend.views.icons import icon

EXTENSION = "qt_toolbar_ext_button"


def draw_extension(bar: QToolBar, theme: Theme) -> None:
    """Draw the button that shows what a tool bar has no room for."""
    button = bar.findChild(QToolButton, EXTENSION)
    assert isinstance(button, QToolButton)
    button.setIcon(icon("more", theme))
