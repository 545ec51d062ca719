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


def paint_companion(shot: Shot, companion: Companion, *, sticks: bool) -> None:
    """Paint the points of the frame as rings, and the bones between them dashed."""
    pixels = shot.project(companion.points[shot.view.frame])
    colour = shot.theme.companion
    if sticks and companion.bones:
        shot.pen(colour, 1.2, Qt.PenStyle.DashLine)
        shot.pairs(pixels[np.array(companion.bones, dtype=np.intp)].reshape(-1, 2))
    seen = pixels[np.isfinite(pixels[:, 0])]
    # A dot in a dot is a ring, and painted much faster.
    shot.dots(seen, colour, 2 * RING + 1.5)
    shot.dots(seen, shot.theme.base, 2 * RING - 1.5)


def paint_key(shot: Shot, companion: Companion | None) -> float:
    """Say in the upper left corner which recording is which; return where there is room below."""
    if companion is None:
        return MARGIN
    painter, metrics = shot.painter, shot.painter.fontMetrics()
    line, theme = metrics.height(), shot.theme
    indent = line + 4
    room = int(shot.width - 2 * MARGIN - indent)
    texts = (shot.document.source.path.name, companion.path.name, _way(companion))
    rows = [elided(text, metrics, room) for text in texts]
    width = max(map(metrics.horizontalAdvance, rows)) + indent
    box = QRectF(MARGIN, MARGIN, width, len(rows) * line)
    ground = QColor(theme.base)
    ground.setAlpha(GROUND)
    painter.fillRect(box.adjusted(-4, -2, 4, 2), ground)
    middle = QPointF(MARGIN + line / 2, MARGIN + line / 2)
    painter.setPen(QPen(QColor(theme.marker), 6.0, c=Qt.PenCapStyle.RoundCap))
    painter.drawPoint(middle)
    shot.pen(theme.companion, 1.4)
    painter.drawEllipse(middle + QPointF(0, line), RING, RING)
    for row, (text, colour) in enumerate(
        zip(rows, (theme.text, theme.text, theme.dim), strict=True)
    ):
        painter.setPen(QColor(colour))
        painter.drawText(QPointF(MARGIN + indent, MARGIN + row * line + metrics.ascent()), text)
    return box.bottom() + 6.0


def _way(companion: Companion) -> str:
    """Say how it was brought beside the document."""
    if companion.way == "origin":
        return translate("Scene", "that is what it was made from")
    if companion.way == "as it is":
        return translate("Scene", "in its own place")
    text = translate("Scene", "turned and shifted to fit, lag {0} ms")
    return text.format(f"{1000 * companion.lag:+.0f}")
