"""What colours an icon has."""

from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QIcon

from mocapmend.views.icons import LARGE


def is_of(icon: QIcon, colour: str) -> bool:
    """Say whether an icon has opaque pixels of a colour."""
    image = icon.pixmap(QSize(LARGE, LARGE)).toImage()
    places = [(x, y) for x in range(image.width()) for y in range(image.height())]
    return any(image.pixelColor(x, y) == QColor(colour) for x, y in places)
