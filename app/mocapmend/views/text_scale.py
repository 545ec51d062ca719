"""Sizes in pixels that follow the size of the text."""

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QWidget

LINE = 14
"""Height of a line in pixels that all other sizes are said for."""
FRAME = QSize(16, 48)
"""Room for the frame and the title that the window system adds."""


def scaled(widget: QWidget, pixels: float) -> int:
    """Return a size as large as a widget's text makes it."""
    return round(pixels * widget.fontMetrics().height() / LINE)


def fit_text(window: QWidget, width: int, height: int) -> None:
    """Make a window as large as its text makes a size, but no larger than its screen."""
    room = window.screen().availableSize() - FRAME
    window.resize(QSize(scaled(window, width), scaled(window, height)).boundedTo(room))
