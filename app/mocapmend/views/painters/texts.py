"""Marker labels, and what is said in the corner of the view."""

from collections.abc import Iterable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics

from mocapmend.views.labels import elided
from mocapmend.views.lane import GROUND
from mocapmend.views.painters.shot import Array, Shot

MARGIN = 8.0


def place_labels(
    shot: Shot, places: Array, markers: Iterable[int], others: Sequence[QRectF] = ()
) -> dict[int, QRectF]:
    """Find room for labels beside their markers' places in the picture, shape (markers, 2).

    The current marker has its label first, then the other selected ones, at another side where
    there is more room; a label that would lie over another, or over other texts, is left out.
    """
    labels, metrics = shot.names, shot.painter.fontMetrics()
    wanted = set(markers)
    selected = [marker for marker in reversed(shot.view.selection) if marker in wanted]
    found: dict[int, QRectF] = {}
    for marker in dict.fromkeys((*selected, *sorted(wanted))):
        if not np.isfinite(places[marker][0]):
            continue
        width = min(metrics.horizontalAdvance(labels[marker]), shot.width - 4)
        boxes = _boxes_beside(places[marker], width, metrics, shot.width)
        if marker not in shot.view.selection:
            # Those of all markers would jump about while the body moves.
            boxes = boxes[:1]
        taken = (*others, *found.values())
        free = (box for box in boxes if not any(map(box.intersects, taken)))
        box = next(free, None)
        if box is not None:
            found[marker] = box
    return found


def _boxes_beside(place: Array, width: int, metrics: QFontMetrics, room: int) -> list[QRectF]:
    """Return where a label may stand: above its marker and below it, rather on the right."""
    x, y = place
    # Never with its beginning out of the picture.
    lefts = [x + 10, max(2.0, x - 10 - width)]
    if lefts[0] + width > room:
        lefts = lefts[1:]
    tops = (y - 6 - metrics.ascent(), y + 6)
    return [QRectF(left, top, width, metrics.height()) for top in tops for left in lefts]


def paint_labels(
    shot: Shot, places: Array, markers: Iterable[int], others: Sequence[QRectF] = ()
) -> None:
    """Write labels beside their markers' places in the picture, as far as they keep apart."""
    labels, selection = shot.names, set(shot.view.selection)
    metrics = shot.painter.fontMetrics()
    ink, dim, ground = (QColor(getattr(shot.theme, name)) for name in ("text", "dim", "base"))
    ground.setAlpha(GROUND)
    proposed = dict.fromkeys(shot.view.proposed, QColor(shot.theme.preview))
    for marker, box in place_labels(shot, places, markers, others).items():
        if marker in selection:
            shot.painter.fillRect(box.adjusted(-2, 0, 2, 0), ground)
        shot.painter.setPen(ink if marker in selection else proposed.get(marker, dim))
        # One more: at fractional scales a text is wider than the pixels that it is said to be.
        text = elided(labels[marker], metrics, round(box.width()) + 1)
        shot.painter.drawText(box.topLeft() + QPointF(0, metrics.ascent()), text)


def paint_captions(shot: Shot, lines: Sequence[str], top: float = MARGIN) -> None:
    """Write lines into the upper left corner, readable whatever is behind them."""
    painter = shot.painter
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
