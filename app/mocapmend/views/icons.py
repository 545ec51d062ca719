"""Icons in the colours of the theme, sharp on every screen."""

from functools import cache
from importlib.resources import files

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QGuiApplication, QIcon, QPainter, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer

from mocapmend.theme import Theme

SMALL, LARGE = 16, 24
"""Pixels of icons in menus and titles, and in the tool bar."""
_INK = b"#888888"


def icon(name: str, theme: Theme, scale: float = 1.0) -> QIcon:
    """Return a line icon from the resources, drawn in the theme's colours.

    Parameters
    ----------
    name : str
        Of the resource.
    theme : Theme
        The colours.
    scale : float
        Of what is shown larger with the text.
    """
    # Drawn for each size that is asked for: what Qt makes smaller or larger is blurred.
    screens = QGuiApplication.screens()
    sides = {
        round(side * screen.devicePixelRatio())
        for side in (SMALL, LARGE, LARGE * scale)
        for screen in screens
    }
    result = QIcon()
    for mode, colour in ((QIcon.Mode.Normal, theme.text), (QIcon.Mode.Disabled, theme.bone)):
        for side in sides:
            result.addPixmap(_picture(name, colour, side), mode)
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


def _picture(name: str, colour: str, size: int) -> QPixmap:
    # The titles of ten panes have the same two pictures, drawn anew whenever they are arranged.
    key = f"{name} {colour} {size}"
    picture = QPixmap()
    if not QPixmapCache.find(key, picture):
        picture = _pixmap(_source(name).replace(_INK, colour.encode()), size)
        QPixmapCache.insert(key, picture)
    return picture


def _pixmap(svg: bytes, size: int) -> QPixmap:
    pixmap = QPixmap(QSize(size, size))
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(QByteArray(svg)).render(painter, QRectF(0, 0, size, size))
    painter.end()
    return pixmap
