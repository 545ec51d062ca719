"""Icons in the colours of the theme, sharp on every screen."""

from functools import cache
from importlib.resources import files

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

from mocapmend.theme import Theme

SIZES = (20, 40)
_INK = b"#888888"


def icon(name: str, theme: Theme) -> QIcon:
    """Return a line icon from the resources, drawn in the theme's colours."""
    result = QIcon()
    for mode, colour in ((QIcon.Mode.Normal, theme.text), (QIcon.Mode.Disabled, theme.bone)):
        svg = _source(name).replace(_INK, colour.encode())
        for size in SIZES:
            result.addPixmap(_pixmap(svg, size), mode)
    return result


def program_icon() -> QIcon:
    """Return the program's own icon."""
    result = QIcon()
    for size in (16, 32, 48, 128):
        result.addPixmap(_pixmap(_source("mocapmend"), size))
    return result


@cache
def _source(name: str) -> bytes:
    return (files("mocapmend_resources") / "icons" / f"{name}.svg").read_bytes()


def _pixmap(svg: bytes, size: int) -> QPixmap:
    pixmap = QPixmap(QSize(size, size))
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(QByteArray(svg)).render(painter, QRectF(0, 0, size, size))
    painter.end()
    return pixmap
