"""The report's charts as vector figures on a page."""

from reportlab.pdfgen.canvas import Canvas

from mocapmend.report import charts
from mocapmend.report.pdf_text import BOLD, Style, put, wrap

COLOURS = {"before": "#b45309", "after": "#0072b2"}
BAND, GRID = "#d9ecf7", "#d3d7dd"
TITLE = Style(8.5, font=BOLD)
LABEL = Style(7, "#59616d")
DASH = (3.6, 3.0)
TITLE_ROOM = 13.0


def height(width: float) -> float:
    """Return how high a chart of a width is, in points."""
    return TITLE_ROOM + width * charts.HEIGHT / charts.WIDTH


def draw(canvas: Canvas, chart: charts.Chart, left: float, top: float, width: float) -> None:
    """Draw a chart with its title above it; places in points."""
    put(canvas, left, top - TITLE.size, wrap(chart.title, TITLE, width)[0], TITLE)
    scale, top = width / charts.WIDTH, top - TITLE_ROOM

    def at(x: float, y: float) -> tuple[float, float]:
        return left + scale * x, top - scale * y

    canvas.saveState()
    canvas.setFillColor(BAND)
    for start, across in chart.bands:
        x, y = at(start, charts.TOP + charts.PLOT_HEIGHT)
        canvas.rect(x, y, scale * across, scale * charts.PLOT_HEIGHT, stroke=0, fill=1)
    _draw_axes(canvas, chart, at)
    canvas.setLineWidth(0.9)
    canvas.setLineJoin(1)
    for line in chart.lines:
        set_stroke(canvas, line.style)
        path = canvas.beginPath()
        for piece in line.pieces:
            first, *rest = piece.tolist()
            path.moveTo(*at(*first))
            for point in rest:
                path.lineTo(*at(*point))
        canvas.drawPath(path)
    canvas.restoreState()


def _draw_axes(canvas: Canvas, chart: charts.Chart, at: charts.Placed) -> None:
    right, bottom = charts.LEFT + charts.PLOT_WIDTH, charts.TOP + charts.PLOT_HEIGHT
    canvas.setStrokeColor(GRID)
    canvas.setLineWidth(0.5)
    for tick in chart.y_ticks:
        canvas.line(*at(charts.LEFT, tick.at), *at(right, tick.at))
        put(canvas, *at(charts.LEFT - 6, tick.at + 4), tick.text, LABEL, "right")
    for tick in chart.x_ticks:
        canvas.line(*at(tick.at, charts.TOP), *at(tick.at, bottom + 4))
        put(canvas, *at(tick.at, bottom + 17), tick.text, LABEL, "middle")
    middle = charts.LEFT + charts.PLOT_WIDTH / 2, charts.TOP + charts.PLOT_HEIGHT / 2
    put(canvas, *at(middle[0], charts.HEIGHT - 6), chart.x_label, LABEL, "middle")
    canvas.saveState()
    canvas.translate(*at(13, middle[1]))
    canvas.rotate(90)
    put(canvas, 0, 0, chart.y_label, LABEL, "middle")
    canvas.restoreState()


def set_stroke(canvas: Canvas, style: str) -> None:
    """Choose the stroke of a curve: what was before is dashed, so that it needs no colour."""
    canvas.setStrokeColor(COLOURS[style])
    canvas.setDash(*DASH) if style == "before" else canvas.setDash()
    canvas.setLineCap(0 if style == "before" else 1)


def draw_key(canvas: Canvas, left: float, y: float, *, bands: bool) -> None:
    """Say what the strokes mean, on one line."""
    canvas.saveState()
    canvas.setLineWidth(1.2)
    for style, text in (("before", "before (dashed)"), ("after", "after (solid)")):
        set_stroke(canvas, style)
        canvas.line(left, y + 2.5, left + 22, y + 2.5)
        put(canvas, left + 26, y, text, LABEL)
        left += 100
    if bands:
        canvas.setFillColor(BAND)
        canvas.rect(left, y - 1, 12, 8, stroke=0, fill=1)
        put(canvas, left + 16, y, "an end of the bone was repaired", LABEL)
    canvas.restoreState()
