"""One frame as the camera sees it, and how lines and dots get on the picture."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath, arrayToQPolygonF
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from mocapmend.document import Document
from mocapmend.theme import Theme
from mocapmend.views.camera import Camera
from mocapmend.viewstate import ViewState

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Shot:
    """What every painter of the 3D view needs.

    Attributes
    ----------
    painter : QPainter
        Open on the view.
    theme : Theme
        Its colours.
    document : Document
        The recording, with edits.
    view : ViewState
        Frame and selection.
    camera : Camera
        Where it is seen from.
    turn : ndarray, shape (3, 3)
        Brings the file's axes upright: points @ turn.
    width, height : int
        Size of the picture in pixels.
    pixels : ndarray, shape (markers, 2)
        Where the markers are in the picture; NaN where missing or behind the camera.
    """

    painter: QPainter
    theme: Theme
    document: Document
    view: ViewState
    camera: Camera
    turn: Array
    width: int
    height: int
    pixels: Array

    @property
    def names(self) -> tuple[str, ...]:
        """What the markers are called in this frame: as is proposed, where something is."""
        proposed = self.view.proposed
        return tuple(proposed.get(k, name) for k, name in enumerate(self.document.names))

    def project(self, points: Array) -> Array:
        """Return where points of the file, shape (n, 3), are in the picture, shape (n, 2)."""
        return self.camera.project(points @ self.turn, self.width, self.height)[0]

    def curve_colour(self, order: int) -> QColor:
        """Return the colour of a selected marker, by its place in the selection."""
        return QColor(self.theme.curves[order % len(self.theme.curves)])

    def tint(self, colour: QColor | str, share: float) -> QColor:
        """Return a colour thinned with the ground's; opaque, so that shapes do not add up."""
        ink, base = QColor(colour), QColor(self.theme.base)
        return QColor.fromRgbF(
            share * ink.redF() + (1.0 - share) * base.redF(),
            share * ink.greenF() + (1.0 - share) * base.greenF(),
            share * ink.blueF() + (1.0 - share) * base.blueF(),
        )

    def pen(
        self,
        colour: QColor | str,
        width: float = 1.0,
        style: Qt.PenStyle = Qt.PenStyle.SolidLine,
    ) -> None:
        """Draw lines like this from now on, and fill nothing."""
        self.painter.setPen(QPen(QColor(colour), width, style))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)

    def pairs(self, ends: Array) -> None:
        """Draw lines between pairs of pixels, shape (2 n, 2); none where an end is missing."""
        both = ends.reshape(-1, 4)
        pixels = both[np.isfinite(both).all(axis=1)].reshape(-1, 2)
        if len(pixels):
            self.painter.drawPath(arrayToQPath(pixels[:, 0], pixels[:, 1], connect="pairs"))

    def chain(self, pixels: Array, joined: NDArray[np.bool_]) -> None:
        """Draw the lines from each pixel, shape (n, 2), to the next one where they are joined.

        Pixels at both ends of a line must be finite.
        """
        if joined.any():
            used = joined.copy()
            used[1:] |= joined[:-1]
            x, y = pixels[used].T
            path = arrayToQPath(x, y, connect=joined[used].astype(np.int32), finiteCheck=False)
            self.painter.drawPath(path)

    def dots(
        self,
        pixels: Array,
        colour: str,
        width: float,
        cap: Qt.PenCapStyle = Qt.PenCapStyle.RoundCap,
    ) -> None:
        """Draw filled circles or, with a square cap, squares; pixels are finite."""
        if len(pixels):
            pen = QPen(QColor(colour), width)
            pen.setCapStyle(cap)
            self.painter.setPen(pen)
            self.painter.drawPoints(arrayToQPolygonF(pixels[:, 0], pixels[:, 1]))

    def crosses(self, pixels: Array, radius: float) -> None:
        """Draw an x with the present pen at every pixel, shape (n, 2)."""
        arms = np.array([[-1, -1], [1, 1], [-1, 1], [1, -1]]) * radius
        self.pairs((pixels[:, None] + arms).reshape(-1, 2))

    def diamond(self, pixel: Array, radius: float) -> None:
        """Outline a diamond with the present pen around a pixel, shape (2,)."""
        x, y = pixel
        corners = ((x, y - radius), (x + radius, y), (x, y + radius), (x - radius, y))
        self.painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
