"""What stays where it is: the ground, the force plates and the axes."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPolygonF

from mocapmend.files import ForcePlate
from mocapmend.theme import AXIS_COLOURS
from mocapmend.views.painters.shot import Array, Shot

CUTS = 8
"""An edge of a plate is cut into so many pieces: one that passes the camera loses a part only."""


def paint_ground(shot: Shot, grid: Array) -> None:
    """Paint the line ends of `floor_grid`, in the file's axes."""
    shot.pen(shot.theme.line)
    shot.pairs(shot.project(grid))


def paint_force_plates(shot: Shot, plates: Sequence[ForcePlate]) -> None:
    """Outline the force plates, with the numbers that the file counts them by."""
    fill = QColor(shot.theme.dim)
    fill.setAlpha(36)
    shares = np.linspace(0.0, 1.0, CUTS + 1)[:, None]
    for number, plate in enumerate(plates, start=1):
        if not plate.spans_surface:
            continue
        corners = plate.corners
        edges = [
            a + shares * (b - a) for a, b in zip(corners, np.roll(corners, -1, 0), strict=True)
        ]
        outline = shot.project(np.concatenate(edges))
        middle = shot.project(corners.mean(axis=0)[None])[0]
        if np.isfinite(outline).all():
            shot.painter.setPen(Qt.PenStyle.NoPen)
            shot.painter.setBrush(fill)
            shot.painter.drawPolygon(QPolygonF([QPointF(*pixel) for pixel in outline]))
        shot.pen(shot.theme.dim, 1.5)
        shot.pairs(np.stack((outline[:-1], outline[1:]), axis=1).reshape(-1, 2))
        if np.isfinite(middle).all():
            box = QRectF(middle[0] - 20, middle[1] - 10, 40, 20)
            shot.painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(number))


def paint_axes(shot: Shot) -> None:
    """Paint the file's axes into the lower left corner."""
    corner = QPointF(34.0, shot.height - 34.0)
    for axis, name in enumerate("XYZ"):
        direction = shot.camera.turned(shot.turn[axis])
        tip = corner + QPointF(22.0 * direction[0], -22.0 * direction[1])
        shot.pen(AXIS_COLOURS[axis], 2)
        shot.painter.drawLine(corner, tip)
        beyond = corner + QPointF(31.0 * direction[0], -31.0 * direction[1])
        box = QRectF(beyond.x() - 8, beyond.y() - 8, 16, 16)
        shot.painter.drawText(box, Qt.AlignmentFlag.AlignCenter, name)
