"""A recording that is looked at beside the document: muted, under it, and said which is which."""

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPen

from mocapmend.companion import Companion
from mocapmend.views.labels import elided
from mocapmend.views.painters.shot import Shot
from mocapmend.views.painters.texts import MARGIN

translate = QCoreApplication.translate

RING = 2.5
"""Radius of its points: open, where the document's are filled."""
GROUND = 210
LEAST_NAME = "M" * 8


def paint_companion(shot: Shot, companion: Companion, *, sticks: bool) -> None:
    """Paint the points of the frame as rings, and the bones between them dashed."""
    pixels = shot.project(companion.points[shot.view.frame])
    colour = shot.theme.companion
    if sticks and companion.bones:
        shot.pen(colour, 1.2, Qt.PenStyle.DashLine)
        shot.pairs(pixels[np.array(companion.bones, dtype=np.intp)].reshape(-1, 2))
    shot.pen(colour, 1.4)
    for pixel in pixels[np.isfinite(pixels[:, 0])]:
        shot.painter.drawEllipse(QPointF(*pixel), RING, RING)


def paint_key(shot: Shot, companion: Companion | None) -> float:
    """Say in the upper left corner which recording is which; return where there is room below."""
    if companion is None:
        return MARGIN
    painter, metrics = shot.painter, shot.painter.fontMetrics()
    line = metrics.height()
    room = int(max(metrics.horizontalAdvance(LEAST_NAME), shot.width - 2 * MARGIN - 2 * line))
    own = elided(shot.document.source.path.name, metrics, room)
    beside = elided(f"{companion.path.name} ({_way(companion)})", metrics, room)
    width = max(map(metrics.horizontalAdvance, (own, beside))) + line + 4
    box = QRectF(MARGIN, MARGIN, width, 2 * line)
    ground = QColor(shot.theme.base)
    ground.setAlpha(GROUND)
    painter.fillRect(box.adjusted(-4, -2, 4, 2), ground)
    middle = QPointF(MARGIN + line / 2, MARGIN + line / 2)
    painter.setPen(QPen(QColor(shot.theme.marker), 6.0, c=Qt.PenCapStyle.RoundCap))
    painter.drawPoint(middle)
    shot.pen(shot.theme.companion, 1.4)
    painter.drawEllipse(middle + QPointF(0, line), RING, RING)
    for row, (text, colour) in enumerate(((own, shot.theme.text), (beside, shot.theme.dim))):
        painter.setPen(QColor(colour))
        place = QPointF(MARGIN + line + 4, MARGIN + row * line + metrics.ascent())
        painter.drawText(place, text)
    return box.bottom() + 6.0


def _way(companion: Companion) -> str:
    """Say how it was brought beside the document."""
    if companion.way == "origin":
        return translate("Scene", "what it was made from")
    if companion.way == "as it is":
        return translate("Scene", "compared, in its own place")
    text = translate("Scene", "compared, turned and shifted to fit, {0} ms later")
    return text.format(f"{1000 * companion.lag:+.0f}")
