"""The small table of values beside the mouse."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QFontMetrics, QPainter

from mocapmend.theme import Theme
from mocapmend.views.labels import elided

PAD = 6
AWAY = 10
"""Pixels between the mouse and the table."""
LONGEST_NAME = 12
"""Of a row, in widths of an M."""


@dataclass(frozen=True)
class Row:
    """The values of one curve, or of one marker: one per column, "" for none."""

    name: str
    colour: str
    values: tuple[str, ...]


@dataclass(frozen=True)
class Readout:
    """What is read at a moment: its title says when."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[Row, ...]

    def fitting(self, count: int) -> "Readout":
        """Return a table of so many rows; the last of them counts those that are left out."""
        if len(self.rows) <= count:
            return self
        kept = self.rows[: max(0, count - 1)]
        more = Row(f"+{len(self.rows) - len(kept)}", "", ("",) * len(self.columns))
        return Readout(self.title, self.columns, (*kept, more))


def paint_readout(
    painter: QPainter, readout: Readout, at: QPointF, bounds: QRectF, theme: Theme
) -> None:
    """Paint a table beside a place: on its right, or on its left where there is no room.

    Parameters
    ----------
    at : QPointF
        The mouse.
    bounds : QRectF
        What the table must stay in.
    """
    metrics = painter.fontMetrics()
    line = metrics.height()
    readout = readout.fitting(max(1, int((bounds.height() - 2 * PAD) / line) - 2))
    longest = LONGEST_NAME * metrics.horizontalAdvance("M")
    names = [elided(row.name, metrics, longest) for row in readout.rows]
    widths = _widths(readout, names, metrics)
    width = max(sum(widths), metrics.horizontalAdvance(readout.title)) + 2 * PAD
    size = width, (len(readout.rows) + 2) * line + 2 * PAD
    box = QRectF(*_corner(at, *size, bounds), *size)
    painter.fillRect(box, QColor(theme.window))
    painter.setPen(QColor(theme.line))
    painter.drawRect(box)
    baseline = box.top() + PAD + metrics.ascent()
    painter.setPen(QColor(theme.text))
    painter.drawText(QPointF(box.left() + PAD, baseline), readout.title)
    painter.setPen(QColor(theme.dim))
    _paint_cells(painter, ("", *readout.columns), widths, box.left() + PAD, baseline + line)
    for i, (name, row) in enumerate(zip(names, readout.rows, strict=True), 2):
        painter.setPen(QColor(row.colour or theme.dim))
        _paint_cells(painter, (name, *row.values), widths, box.left() + PAD, baseline + i * line)


def _widths(readout: Readout, names: Sequence[str], metrics: QFontMetrics) -> list[int]:
    """Return the width of each column, with the space before it."""
    columns = [[*names, ""]] + [
        [title, *(row.values[i] for row in readout.rows)] for i, title in enumerate(readout.columns)
    ]
    space = metrics.horizontalAdvance("00")
    return [
        max(metrics.horizontalAdvance(text) for text in texts) + (space if i else 0)
        for i, texts in enumerate(columns)
    ]


def _paint_cells(
    painter: QPainter, texts: Sequence[str], widths: Sequence[int], x: float, baseline: float
) -> None:
    """Write a row: its name on the left, its numbers on the right of their columns."""
    right = x
    for i, (text, width) in enumerate(zip(texts, widths, strict=True)):
        right += width
        shift = painter.fontMetrics().horizontalAdvance(text) if i else width
        painter.drawText(QPointF(right - shift, baseline), text)


def _corner(at: QPointF, width: float, height: float, bounds: QRectF) -> tuple[float, float]:
    left = at.x() + AWAY
    if left + width > bounds.right():
        left = max(bounds.left(), at.x() - AWAY - width)
    return left, max(bounds.top(), min(at.y() + AWAY, bounds.bottom() - height))
