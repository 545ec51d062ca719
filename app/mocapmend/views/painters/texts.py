"""Marker labels, and what is said in the corner of the view."""

from collections.abc import Iterable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor

from mocapmend.views.lane import GROUND
from mocapmend.views.painters.shot import Array, Shot

MARGIN = 8.0


def place_labels(shot: Shot, places: Array, markers: Iterable[int]) -> dict[int, QRectF]:
    """Find room for labels beside their markers' places in the picture, shape (markers, 2).

    The current marker has its label, then the other selected ones; one that would lie over
    another is left out.
    """
    labels, metrics = shot.document.names, shot.painter.fontMetrics()
    wanted = set(markers)
    selected = [marker for marker in reversed(shot.view.selection) if marker in wanted]
    found: dict[int, QRectF] = {}
    for marker in dict.fromkeys((*selected, *sorted(wanted))):
        x, y = places[marker]
        if not np.isfinite(x):
            continue
        width = metrics.horizontalAdvance(labels[marker])
        left = x + 10
        if left + width > shot.width:
            # On the other side, but never with its beginning out of the picture.
            left = max(2.0, x - 10 - width)
        box = QRectF(left, y - 6 - metrics.ascent(), width, metrics.height())
        if not any(box.intersects(other) for other in found.values()):
            found[marker] = box
    return found


def paint_labels(shot: Shot, places: Array, markers: Iterable[int]) -> None:
    """Write labels beside their markers' places in the picture, as far as they keep apart."""
    labels, selection = shot.document.names, set(shot.view.selection)
    ascent = shot.painter.fontMetrics().ascent()
    text, dim, ground = (QColor(getattr(shot.theme, name)) for name in ("text", "dim", "base"))
    ground.setAlpha(GROUND)
    for marker, box in place_labels(shot, places, markers).items():
        if marker in selection:
            shot.painter.fillRect(box.adjusted(-2, 0, 2, 0), ground)
        shot.painter.setPen(text if marker in selection else dim)
        shot.painter.drawText(box.topLeft() + QPointF(0, ascent), labels[marker])


def paint_captions(shot: Shot, lines: Sequence[str]) -> None:
    """Write lines into the upper left corner, readable whatever is behind them."""
    painter, top = shot.painter, MARGIN
    flags = Qt.AlignmentFlag.AlignLeft | Qt.TextFlag.TextWordWrap
    ground = QColor(shot.theme.base)
    ground.setAlpha(210)
    for line in lines:
        room = QRectF(MARGIN, top, shot.width - 2 * MARGIN, shot.height)
        box = painter.boundingRect(room, flags, line)
        painter.fillRect(box.adjusted(-4, -2, 4, 2), ground)
        painter.setPen(QColor(shot.theme.text))
        painter.drawText(room, flags, line)
        top = box.bottom() + 4.0
