"""What stays where it is: the ground, the force plates and the axes."""

from collections.abc import Mapping, Sequence

import numpy as np
from pyqtgraph.functions import arrayToQPolygonF
from PySide6.QtCore import QPointF, QRectF, Qt

from mocapmend.files import ForcePlate
from mocapmend.theme import AXIS_COLOURS
from mocapmend.views.painters.shot import Array, Shot

CUTS = 8
"""An edge of a plate is cut into so many pieces: one that passes the camera loses a part only."""


def paint_ground(shot: Shot, grid: Array) -> None:
    """Paint the line ends of `floor_grid`, in the file's axes."""
    shot.pen(shot.theme.line)
    shot.pairs(shot.project(grid))


def plate_outlines(plates: Sequence[ForcePlate]) -> dict[int, Array]:
    """Return the outlines of the force plates that have one, by the file's numbers from 1.

    Each is shape (4 * CUTS + 1, 3), in the file's axes: once around and back.
    """
    shares = np.linspace(0.0, 1.0, CUTS, endpoint=False)[:, None]
    outlines = {}
    for number, plate in enumerate(plates, start=1):
        if plate.spans_surface:
            sides = zip(plate.corners, np.roll(plate.corners, -1, axis=0), strict=True)
            cut = [start + shares * (stop - start) for start, stop in sides]
            outlines[number] = np.concatenate([*cut, plate.corners[:1]])
    return outlines


def paint_force_plates(shot: Shot, outlines: Mapping[int, Array]) -> None:
    """Paint the force plates, with the numbers that the file counts them by."""
    for number, outline in outlines.items():
        pixels = shot.project(np.vstack((outline, outline.mean(axis=0))))
        around, middle = pixels[:-1], pixels[-1]
        if np.isfinite(around).all():
            shot.painter.setPen(Qt.PenStyle.NoPen)
            shot.painter.setBrush(shot.tint(shot.theme.dim, 0.18))
            shot.painter.drawPolygon(arrayToQPolygonF(*around.T))
        # Wider lines would take ten times as long.
        shot.pen(shot.theme.dim, 1.0)
        shot.pairs(np.stack((around[:-1], around[1:]), axis=1).reshape(-1, 2))
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
