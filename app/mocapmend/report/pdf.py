"""The report as PDF: the same content as the page, with vector figures. No display needed."""

from io import BytesIO

from reportlab.lib.pagesizes import A4
from reportlab.pdfgen.canvas import Canvas

from mocapmend.report import pdf_figures
from mocapmend.report.content import Bullets, Figures, Pairs, Part, Text, contents
from mocapmend.report.model import About, Report
from mocapmend.report.pdf_table import PdfTable
from mocapmend.report.pdf_text import BOLD, Style, put, register_fonts, width, wrap
from mocapmend.report.tables import Table

MARGIN = 43.0
ROOM = A4[0] - 2 * MARGIN
TOP, BOTTOM = A4[1] - MARGIN, MARGIN + 14.0
BODY, DIM, SMALL = Style(9), Style(9, "#59616d"), Style(7.5, "#59616d")
TITLE, HEADING = Style(15, font=BOLD), Style(11, font=BOLD)
LINE, WARNING = "#d3d7dd", "#b45309"
SPACE = 5.0
COLUMN_SPACE = 14.0


def render(report: Report, about: About) -> bytes:
    """Return the report as PDF; the same bytes for the same input."""
    content = contents(report, about)
    register_fonts()
    stream = BytesIO()
    # Invariant: no time and no random number goes into the file.
    canvas = Canvas(stream, pagesize=A4, invariant=1, pageCompression=1, lang="en")
    canvas.setTitle(f"{content.title} – mocapmend report")
    canvas.setCreator(content.subtitle)
    pages = _Pages(canvas, f"{content.title} – {content.subtitle}")
    pages.text(content.title, TITLE)
    pages.text(content.subtitle, DIM)
    for part in content.head:
        pages.part(part)
    for section in content.sections:
        pages.heading(section.anchor, section.title)
        for part in section.parts:
            pages.part(part)
    pages.finish()
    canvas.save()
    return stream.getvalue()


class _Pages:
    """Pages that are filled from top to bottom."""

    def __init__(self, canvas: Canvas, footer: str) -> None:
        self._canvas = canvas
        self._footer = wrap(footer, SMALL, ROOM - 60)[0]
        self._y = TOP

    def text(self, text: str, style: Style, indent: float = 0.0) -> None:
        """Set a paragraph."""
        for line in wrap(text, style, ROOM - indent):
            self._need(style.line)
            self._y -= style.line
            put(self._canvas, MARGIN + indent, self._y + 0.3 * style.size, line, style)
        self._y -= 0.3 * SPACE

    def heading(self, anchor: str, title: str) -> None:
        """Set a heading, never at the very end of a page, and list it in the outline."""
        self._need(90)
        self._y -= 3 * SPACE
        self._canvas.bookmarkHorizontal(anchor, 0, self._y)
        self._canvas.addOutlineEntry(title, anchor)
        self.text(title, HEADING)
        self._canvas.setStrokeColor(LINE)
        self._canvas.setLineWidth(0.7)
        self._canvas.line(MARGIN, self._y, MARGIN + ROOM, self._y)
        self._y -= SPACE

    def part(self, part: Part) -> None:
        """Set one part of a section."""
        if isinstance(part, Text):
            self.text(part.text, DIM if part.dim else BODY)
        elif isinstance(part, Pairs):
            self._pairs(part)
        elif isinstance(part, Bullets):
            self._bullets(part)
        elif isinstance(part, Figures):
            self._figures(part)
        else:
            self._table(part)

    def finish(self) -> None:
        """Complete the last page."""
        put(self._canvas, MARGIN, MARGIN - 6, self._footer, SMALL)
        page = str(self._canvas.getPageNumber())
        put(self._canvas, MARGIN + ROOM, MARGIN - 6, page, SMALL, "right")
        self._canvas.showPage()

    def _need(self, height: float) -> bool:
        """Begin a new page where a height is not left, and say so."""
        if self._y - height >= BOTTOM:
            return False
        self.finish()
        self._y = TOP
        return True

    def _pairs(self, part: Pairs) -> None:
        indent = max(width(name, DIM) for name, _ in part.rows) + COLUMN_SPACE
        for name, value in part.rows:
            self._need(BODY.line)
            put(self._canvas, MARGIN, self._y - BODY.size, name, DIM)
            self.text(value, BODY, indent)

    def _bullets(self, part: Bullets) -> None:
        for item in part.items:
            self._need(BODY.line)
            self._canvas.setFillColor(WARNING if part.warning else BODY.colour)
            self._canvas.circle(MARGIN + 4, self._y - 0.72 * BODY.size, 1.5, stroke=0, fill=1)
            self.text(item, BODY, 12)

    def _figures(self, part: Figures) -> None:
        across = (ROOM - COLUMN_SPACE) / 2
        high = pdf_figures.height(across)
        self._need(SMALL.line + high + 2 * SPACE)
        self._y -= SMALL.line
        pdf_figures.draw_key(self._canvas, MARGIN, self._y, bands=part.bands)
        for start in range(0, len(part.charts), 2):
            self._need(high + 2 * SPACE)
            self._y -= SPACE
            for column, chart in enumerate(part.charts[start : start + 2]):
                left = MARGIN + column * (across + COLUMN_SPACE)
                pdf_figures.draw(self._canvas, chart, left, self._y, across)
            self._y -= high + SPACE

    def _table(self, part: Table) -> None:
        table = PdfTable(self._canvas, part, MARGIN, ROOM)
        self._need(table.head_height + 3 * table.line)
        self._y = table.draw_head(self._y)
        for row in part.rows:
            cells = table.lay_out(row)
            if self._need(table.height(cells)):
                self._y = table.draw_head(self._y)
            self._y = table.draw_row(self._y, cells)
        self._y -= SPACE
        if part.note:
            self.text(part.note, BODY)
