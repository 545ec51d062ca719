"""The distance of two selected markers, or the angle at the middle one of three."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QCoreApplication, QRectF, Qt

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.views.painters.shot import Array, Shot

translate = QCoreApplication.translate

ARC = 26.0
"""Radius of the arc that marks an angle, in pixels."""


def distance(one: Array, other: Array) -> float:
    """Return the distance of two points, shape (3,), in their unit; NaN where one is missing."""
    return float(np.linalg.norm(one - other))


def angle(one: Array, middle: Array, other: Array) -> float:
    """Return the angle at the middle one of three points, shape (3,), in degrees from 0 to 180.

    NaN where one is missing, or where two are at the same place.
    """
    first, second = one - middle, other - middle
    if not (first.any() and second.any()):
        return np.nan
    across = np.linalg.norm(np.cross(first, second))
    return float(np.degrees(np.arctan2(across, first @ second)))


def measurement(document: Document, selection: tuple[int, ...], frame: int) -> str:
    """Say how far apart two markers are, or which angle three have: as they are in a frame."""
    if len(selection) not in {2, 3}:
        return translate("Scene", "Measure: select two markers for a distance, three for an angle")
    points = document.points[frame, list(selection)]
    names = " – ".join(document.names[marker] for marker in selection)
    states = document.state[frame, list(selection)]
    missing = _names(document, selection, np.isnan(points[:, 0]))
    if missing:
        return translate("Scene", "{0}: missing here ({1})").format(names, missing)
    if len(selection) == 2:
        value = f"{distance(*points):.{_decimals(document)}f} {document.original.unit}"
    else:
        degrees = angle(*points)
        if np.isnan(degrees):
            return translate("Scene", "{0}: no angle, two of them are at one place").format(names)
        value = f"{degrees:.1f}°"
    doubtful = _names(document, selection, states != SampleState.MEASURED)
    if doubtful:
        text = translate("Scene", "{0}: {1} (not measured: {2})")
        return text.format(names, value, doubtful)
    return translate("Scene", "{0}: {1}").format(names, value)


def paint_measure(shot: Shot) -> None:
    """Draw the line that is measured, or both legs of the angle and an arc between them."""
    selection = shot.view.selection
    if len(selection) not in {2, 3}:
        return
    pixels = shot.pixels[list(selection)]
    shot.pen(shot.theme.text, 1.5, Qt.PenStyle.DashDotLine)
    shot.pairs(np.stack((pixels[:-1], pixels[1:]), axis=1).reshape(-1, 2))
    if len(selection) == 3 and np.isfinite(pixels).all():
        middle = pixels[1]
        # Qt counts angles upwards, and y of the picture points down.
        right, down = (pixels[::2] - middle).T
        start, stop = np.degrees(np.arctan2(-down, right))
        turn = (stop - start + 180.0) % 360.0 - 180.0
        box = QRectF(middle[0] - ARC, middle[1] - ARC, 2 * ARC, 2 * ARC)
        shot.pen(shot.theme.text, 1.5)
        shot.painter.drawArc(box, round(16 * start), round(16 * turn))


def _decimals(document: Document) -> int:
    """Return how many digits show a tenth of a millimetre."""
    return int(np.ceil(np.log10(document.original.mm))) + 1


def _names(document: Document, selection: tuple[int, ...], chosen: NDArray[np.bool_]) -> str:
    """Name some of the selected markers."""
    return ", ".join(
        document.names[marker] for marker, yes in zip(selection, chosen, strict=True) if yes
    )
