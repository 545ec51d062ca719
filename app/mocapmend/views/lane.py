"""What all plots share: where they are painted, what their axes span, and how lines are drawn."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from pyqtgraph.functions import arrayToQPath, arrayToQPolygonF
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen

from mocapmend.theme import Theme

LEAST_SPAN = 1e-5
"""Of values about 1, in the recording's unit; greater values have more."""
GROUND = 190
"""Opacity of the ground behind texts that lie over curves, of 255."""
MOST_MARKS = 12
"""At an axis: more are hard to read, however high the plot is."""
WIDEST_MARK = "−88888.8"


@dataclass(frozen=True)
class Margins:
    """Room around plots for their texts, in pixels.

    Attributes
    ----------
    left, right, top, bottom : int
        Around all plots.
    space : int
        Between two plots.
    least : int
        Height below which a plot cannot be read.
    line : int
        Height of a line of text.
    """

    left: int
    right: int
    top: int
    bottom: int
    space: int
    least: int
    line: int

    @classmethod
    def of(cls, metrics: QFontMetrics) -> "Margins":
        """Return the room that texts of a font need."""
        line = metrics.height()
        left = metrics.horizontalAdvance(WIDEST_MARK) + 8
        return cls(left, 8, line + 6, line + 4, 6, 2 * line + 12, line)


@dataclass(frozen=True)
class Frame:
    """Where a lane is painted and what its axes span."""

    rect: QRectF
    start: float
    stop: float
    low: float
    high: float

    def x(self, frame: NDArray[np.floating] | float) -> NDArray[np.float64]:
        """Return the picture's x of a frame (the middle of its time)."""
        scale = self.rect.width() / (self.stop - self.start)
        return np.asarray(
            np.asarray(frame) * scale + (self.rect.left() + (0.5 - self.start) * scale)
        )

    def y(self, value: NDArray[np.floating] | float) -> NDArray[np.float64]:
        """Return the picture's y of a value."""
        scale = self.rect.height() / (self.high - self.low)
        return np.asarray(np.asarray(value) * -scale + (self.rect.bottom() + self.low * scale))


def value_range(lines: Iterable[NDArray[np.floating]]) -> tuple[float, float]:
    """Return the span of the values of some lines with a margin, never empty."""
    low, high = np.inf, -np.inf
    for values in lines:
        if values.size:
            # Where all are NaN the result is, and then the comparison keeps what there was.
            low = min(low, float(np.fmin.reduce(values)))
            high = max(high, float(np.fmax.reduce(values)))
    if low > high:
        return 0.0, 1.0
    # What varies less than this is constant: numbers at its axis would be of too many digits.
    constant = high - low <= LEAST_SPAN * max(1.0, abs(low), abs(high))
    margin = max(1e-3 * abs(high), 1e-2) if constant else 0.08 * (high - low)
    return low - margin, high + margin


def ticks(low: float, high: float, about: int) -> tuple[NDArray[np.float64], int]:
    """Return round numbers inside a span, and how many decimals they need."""
    step = (high - low) / max(1, about)
    power = 10.0 ** np.floor(np.log10(step))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= step)
    decimals = max(0, -int(np.floor(np.log10(step) + 1e-9)))
    first, last = np.ceil(low / step), np.floor(high / step)
    # Adding zero turns a negative zero into a plain one.
    return np.arange(first, last + 1) * step + 0.0, decimals


def mark_text(mark: float, decimals: int) -> str:
    """Write a number at an axis, shortened where it would not fit."""
    text = f"{mark:.{decimals}f}"
    return text if len(text) <= len(WIDEST_MARK) else f"{mark:.2e}"


def alone_in(values: NDArray[np.floating]) -> NDArray[np.bool_]:
    """Say which values have no finite neighbour: a line through them is nothing to see."""
    known = np.concatenate(([False], np.isfinite(values), [False]))
    return np.asarray(known[1:-1] & ~known[:-2] & ~known[2:])


@lru_cache(maxsize=128)
def mixed(under: str, over: str, alpha: float = 1.0) -> QColor:
    """Return the opaque colour of a translucent one over another: it is painted much faster."""
    below, above = QColor(under), QColor(over)
    share = above.alphaF() * alpha
    pairs = (
        (below.red(), above.red()),
        (below.green(), above.green()),
        (below.blue(), above.blue()),
    )
    return QColor(*(round(one + (other - one) * share) for one, other in pairs))


def thin(
    painter: QPainter, colour: QColor | str, style: Qt.PenStyle = Qt.PenStyle.SolidLine
) -> QPen:
    """Make a pen for lines that are equally thick wherever they are.

    One pixel of the window is 1.5 of some screens: a line of that width takes one here, two there.
    """
    ratio = painter.device().devicePixelRatioF()
    return QPen(QColor(colour), max(1, round(ratio)) / ratio, style)


def paint_line(
    painter: QPainter,
    frame: Frame,
    frames: NDArray[np.floating],
    values: NDArray[np.floating],
    pen: QPen,
) -> None:
    """Draw a line through values over frames; NaN values break it, lone ones become points."""
    painter.setPen(pen)
    x, y = frame.x(frames), frame.y(values)
    if np.isfinite(y).all() and len(y) > 1:
        painter.drawPath(arrayToQPath(x, y, connect="all"))
        return
    painter.drawPath(arrayToQPath(x, y, connect="finite"))
    alone = alone_in(y)
    if alone.any():
        painter.setPen(QPen(pen.color(), 3))
        painter.drawPoints(arrayToQPolygonF(x[alone], y[alone]))


def paint_grid(painter: QPainter, frame: Frame, theme: Theme) -> None:
    """Draw the lines of round values with their numbers, and the frame around the plot."""
    rect, metrics = frame.rect, painter.fontMetrics()
    line = metrics.height()
    about = max(1, min(MOST_MARKS, int(rect.height() / (1.5 * line))))
    marks, decimals = ticks(frame.low, frame.high, about)
    heights = frame.y(marks).tolist()
    painter.setPen(thin(painter, theme.raised))
    painter.drawLines([QLineF(rect.left(), y, rect.right(), y) for y in heights])
    painter.setPen(QColor(theme.dim))
    middle = metrics.ascent() - line / 2
    for mark, y in zip(marks.tolist(), heights, strict=True):
        if rect.top() + line / 2 - 4 <= y <= rect.bottom() - line / 2 + 6:
            text = mark_text(mark, decimals)
            x = rect.left() - 6 - metrics.horizontalAdvance(text)
            painter.drawText(QPointF(x, y + middle), text)
    painter.setPen(thin(painter, theme.line))
    painter.drawRect(rect)


def paint_message(painter: QPainter, rect: QRectF, text: str, theme: Theme) -> None:
    """Write why there is nothing to see in a plot."""
    painter.setPen(QColor(theme.dim))
    flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    painter.drawText(rect.adjusted(8, 0, -8, 0), flags, text)


def paint_on_ground(painter: QPainter, place: QPointF, text: str, theme: Theme) -> None:
    """Write text at a baseline with the present pen, readable over the curves behind it."""
    metrics, ground = painter.fontMetrics(), QColor(theme.base)
    ground.setAlpha(GROUND)
    box = QRectF(place.x(), place.y() - metrics.ascent(), metrics.horizontalAdvance(text), 0)
    box.setHeight(metrics.height())
    painter.fillRect(box.adjusted(-2, 0, 2, 0), ground)
    painter.drawText(place, text)


def paint_span(
    painter: QPainter, frame: Frame, span: tuple[int, int], bottom: float, theme: Theme
) -> None:
    """Shade a selected run of frames over all plots, with a line at each end.

    Parameters
    ----------
    frame : Frame
        Of the uppermost plot.
    span : (int, int)
        First frame, and the one after the last.
    bottom : float
        Where the lowest plot ends.
    """
    area = QRectF(frame.rect.topLeft(), QPointF(frame.rect.right(), bottom))
    left, right = (float(frame.x(end - 0.5)) for end in span)
    painter.save()
    painter.setClipRect(area)
    shade = QColor(theme.accent)
    shade.setAlpha(50)
    painter.fillRect(QRectF(left, area.top(), right - left, area.height()), shade)
    painter.setPen(thin(painter, theme.accent, Qt.PenStyle.DashLine))
    painter.drawLines([QLineF(x, area.top(), x, area.bottom()) for x in (left, right)])
    painter.restore()
