"""A table on pages: widths of its columns, and its rows one by one."""

from collections.abc import Sequence

from reportlab.pdfgen.canvas import Canvas

from mocapmend.report.pdf_text import BOLD, Style, put, width, wrap
from mocapmend.report.tables import Table

CELL, HEAD = Style(7), Style(7, font=BOLD)
PAD = 3.0
WIDEST_NAME = 150.0
LEAST_TEXT = 60.0
HEAD_FILL, RULE = "#f3f4f6", "#d3d7dd"


class PdfTable:
    """Draws a table row by row, so that others may turn the page in between.

    Parameters
    ----------
    canvas : Canvas
        Where.
    table : Table
        What.
    left, room : float
        Where it begins, and how wide it may be, in points.
    """

    def __init__(self, canvas: Canvas, table: Table, left: float, room: float) -> None:
        self._canvas = canvas
        self._table = table
        self._widths = _widths(table, room)
        self._lefts = [left + sum(self._widths[:i]) for i in range(len(self._widths))]
        self._titles = [
            wrap(column.title, HEAD, size - 2 * PAD)
            for column, size in zip(table.columns, self._widths, strict=True)
        ]

    @property
    def line(self) -> float:
        """Height of a row of one line."""
        return CELL.line + 2.0

    @property
    def head_height(self) -> float:
        """Height of the headings."""
        return self.height(self._titles)

    def lay_out(self, row: Sequence[str]) -> list[list[str]]:
        """Break the cells of a row into lines."""
        return [
            wrap(cell, CELL, size - 2 * PAD) for cell, size in zip(row, self._widths, strict=True)
        ]

    def height(self, cells: Sequence[Sequence[str]]) -> float:
        """Return the height of a row."""
        return max(map(len, cells)) * CELL.line + 2.0

    def draw_head(self, top: float) -> float:
        """Draw the headings and return where they end."""
        self._canvas.setFillColor(HEAD_FILL)
        high = self.head_height
        self._canvas.rect(self._lefts[0], top - high, sum(self._widths), high, stroke=0, fill=1)
        return self._draw(top, self._titles, HEAD)

    def draw_row(self, top: float, cells: Sequence[Sequence[str]]) -> float:
        """Draw a row of `lay_out` and return where it ends."""
        return self._draw(top, cells, CELL)

    def _draw(self, top: float, cells: Sequence[Sequence[str]], style: Style) -> float:
        for i, (column, lines) in enumerate(zip(self._table.columns, cells, strict=True)):
            right = column.align == "number"
            x = self._lefts[i] + (self._widths[i] - PAD if right else PAD)
            for k, text in enumerate(lines):
                y = top - 1.0 - (k + 1) * style.line + 0.35 * style.size
                put(self._canvas, x, y, text, style, "right" if right else "left")
        bottom = top - self.height(cells)
        self._canvas.setStrokeColor(RULE)
        self._canvas.setLineWidth(0.4)
        self._canvas.line(self._lefts[0], bottom, self._lefts[0] + sum(self._widths), bottom)
        return bottom


def _widths(table: Table, room: float) -> list[float]:
    """Give numbers what they need, names no more than that, and texts what is left."""
    sizes = []
    for i, column in enumerate(table.columns):
        words = max(width(word, HEAD) for word in column.title.split())
        cells = max((width(row[i], CELL) for row in table.rows), default=0.0)
        most = cells if column.align == "number" else min(cells, WIDEST_NAME)
        sizes.append(max(words, most) + 2 * PAD)
    texts = [i for i, column in enumerate(table.columns) if column.align == "text"]
    names = [i for i, column in enumerate(table.columns) if column.align == "name"]
    rest = room - sum(size for i, size in enumerate(sizes) if i not in texts)
    for i in texts:
        sizes[i] = max(rest / len(texts), LEAST_TEXT)
    over = sum(sizes) - room
    for i in names:
        # Long labels are broken rather than let the table run off the page.
        sizes[i] = max(sizes[i] - max(over, 0.0) / len(names), LEAST_TEXT)
    return sizes
