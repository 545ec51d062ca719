"""The arrows on the ends of the current gap: alike in the timeline and in the plots."""

from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from mocapmend.theme import Theme
from mocapmend.views.lane import Frame
from mocapmend_algorithms import Gap

ARROW = 8.0
"""Length of the arrows on the ends of the current gap, in pixels."""
HINT = 11.0
"""Length of the arrow that points to a gap out of view."""


def paint_arrow(painter: QPainter, theme: Theme, tip: QPointF, length: float) -> None:
    """Draw an arrow of a length to the right of its tip, or to its left."""
    half = abs(length) / 2 + 0.5
    back = tip + QPointF(length, 0)
    # The rim keeps it apart from what is under it, which may have its colour.
    painter.setPen(QPen(QColor(theme.window), 1))
    painter.setBrush(QColor(theme.preview))
    painter.drawPolygon(QPolygonF([tip, back + QPointF(0, half), back - QPointF(0, half)]))


def paint_plot_arrows(painter: QPainter, theme: Theme, frame: Frame, gap: Gap) -> None:
    """Put arrows on the ends of a gap at the bottom of a plot; point to it when it is out of view.

    Parameters
    ----------
    frame : Frame
        Of the plot.
    gap : Gap
        The current one.
    """
    rect = frame.rect
    left, right = (float(frame.x(end - 0.5)) for end in (gap.start, gap.stop))
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setClipRect(rect)
    if right < rect.left() or left > rect.right():
        y = rect.bottom() - HINT / 2 - 1
        if right < rect.left():
            paint_arrow(painter, theme, QPointF(rect.left() + 2, y), HINT)
        else:
            paint_arrow(painter, theme, QPointF(rect.right() - 2, y), -HINT)
    else:
        y = rect.bottom() - ARROW / 2 - 1
        paint_arrow(painter, theme, QPointF(left - 0.5, y), -ARROW)
        paint_arrow(painter, theme, QPointF(right + 0.5, y), ARROW)
    painter.restore()
