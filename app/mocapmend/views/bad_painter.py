"""What the plots show of bad samples: those held for bad, those set aside, and an exchange."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from pyqtgraph.functions import arrayToQPath, arrayToQPolygonF
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPen

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.suspects import place_of
from mocapmend.theme import Theme
from mocapmend.views.columns import Floats
from mocapmend.views.lane import Frame, paint_line
from mocapmend.views.quantities import Curve, Quantity, Series
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun

MOST_FRAMES = 20_000
"""Above this many visible frames the timeline alone tells where bad samples are."""
POINTS_APART = 3.0
"""Pixels between frames from which each sample has its point."""
DASHES = [3.0, 3.0]
"""Of what would be exchanged, in widths of the line."""
POINT, ARM = 5.0, 3.0
"""Sizes of a point, and of an arm of a cross, in pixels."""


class BadPainter:
    """Paints over the curves of a lane.

    Parameters
    ----------
    document : Document
        Whose samples they are.
    series : Series
        Their curves.

    Attributes
    ----------
    suspects : mapping of int to sequence of BadRun
        The measured samples that are held for bad, by marker.
    """

    def __init__(self, document: Document, series: Series) -> None:
        self._document = document
        self._series = series
        self.suspects: Mapping[int, Sequence[BadRun]] = {}

    def paint(
        self, painter: QPainter, frame: Frame, quantity: Quantity, curve: Curve, theme: Theme
    ) -> None:
        """Paint the suspects of a curve in their colour, and what is set aside as crosses."""
        if frame.stop - frame.start > MOST_FRAMES or quantity is Quantity.RESIDUAL:
            return
        colour = QColor(theme.state_colour(SampleState.BAD))
        values: Floats | None = None
        for marker in curve.markers:
            for start, stop in self._in_view(frame, marker):
                values = self._series.rows(quantity, curve) if values is None else values
                rows = np.arange(start, stop, dtype=np.float64)
                paint_line(painter, frame, rows, values[start:stop], QPen(colour, 2))
                if float(frame.x(1.0) - frame.x(0.0)) >= POINTS_APART:
                    _paint_points(painter, frame, rows, values[start:stop], colour)
        if quantity.kind == "position":
            self._paint_set_aside(painter, frame, quantity, curve, colour)

    def stored(self, quantity: Quantity, curves: Sequence[Curve], run: BadRun) -> list[Floats]:
        """Return what was measured in a run that is set aside, where a lane shows its marker."""
        shown = any(run.marker == curve.marker for curve in curves)
        if quantity.kind != "position" or not shown:
            return []
        bad = self._document.state[run.start : run.stop, run.marker] == SampleState.BAD
        return [self._document.stored(place_of(run))[bad, quantity.row]]

    def paint_exchange(
        self,
        painter: QPainter,
        frame: Frame,
        quantity: Quantity,
        curves: Sequence[Curve],
        exchange: Exchange,
    ) -> None:
        """Paint the trajectories of two markers as they would be after an exchange: dashed."""
        if quantity.kind != "position":
            return
        pair = exchange.first, exchange.second
        start = max(0, exchange.start - 1)
        stop = min(self._document.original.frames, exchange.stop + 1)
        rows = np.arange(start, stop, dtype=np.float64)
        inside = (rows >= exchange.start) & (rows < exchange.stop)
        for marker, other in (pair, pair[::-1]):
            curve = next((curve for curve in curves if curve.marker == marker), None)
            if curve is None:
                continue
            own = self._series.rows(quantity, curve)[start:stop]
            theirs = self._series.rows(quantity, Curve(other, curve.colour))[start:stop]
            pen = QPen(QColor(curve.colour), 2)
            pen.setDashPattern(DASHES)
            paint_line(painter, frame, rows, np.where(inside, theirs, own), pen)

    def _in_view(self, frame: Frame, marker: int) -> Iterator[tuple[int, int]]:
        """Yield what is to be seen of the suspects of a marker: first frame and end."""
        first, end = max(0, int(frame.start)), int(np.ceil(frame.stop)) + 1
        for run in self.suspects.get(marker, ()):
            start, stop = max(run.start, first), min(run.stop, end)
            if start < stop:
                yield start, stop

    def _paint_set_aside(
        self, painter: QPainter, frame: Frame, quantity: Quantity, curve: Curve, colour: QColor
    ) -> None:
        runs = self._document.runs(curve.marker, SampleState.BAD)
        runs = runs[(runs[:, 1] > frame.start) & (runs[:, 0] < frame.stop)]
        for start, stop in runs.tolist():
            values = self._document.stored(Gap(curve.marker, start, stop))[:, quantity.row]
            _paint_crosses(painter, frame, np.arange(start, stop, dtype=np.float64), values, colour)


def _paint_points(
    painter: QPainter, frame: Frame, rows: Floats, values: Floats, colour: QColor
) -> None:
    known = np.isfinite(values)
    pen = QPen(colour, POINT)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    painter.setPen(pen)
    painter.drawPoints(arrayToQPolygonF(frame.x(rows[known]), frame.y(values[known])))


def _paint_crosses(
    painter: QPainter, frame: Frame, rows: Floats, values: Floats, colour: QColor
) -> None:
    known = np.isfinite(values)
    x, y = frame.x(rows[known]), frame.y(values[known])
    if not len(x):
        return
    arms = np.array([[-ARM, -ARM], [ARM, ARM], [-ARM, ARM], [ARM, -ARM]])
    ends = (np.stack((x, y), axis=1)[:, None] + arms).reshape(-1, 2)
    painter.setPen(QPen(colour, 1.5))
    painter.drawPath(arrayToQPath(ends[:, 0], ends[:, 1], connect="pairs"))
