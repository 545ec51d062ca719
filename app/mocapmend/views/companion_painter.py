"""The curves of a recording that is looked at beside the document: thin, dashed and muted."""

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter

from mocapmend.companion import Companion
from mocapmend.names import short_names
from mocapmend.theme import Theme
from mocapmend.views.columns import Floats
from mocapmend.views.labels import elided
from mocapmend.views.lane import Frame, paint_line, paint_on_ground, thin
from mocapmend.views.quantities import Curve, Quantity, Series

if TYPE_CHECKING:
    from mocapmend.views.lane_painter import Lane

DASHES = [4.0, 3.0]
DASH = "╌ "
"""Before a name: the curve that it belongs to is dashed."""


class CompanionPainter:
    """Paints, for each curve of a lane, the one of its partner."""

    def __init__(self) -> None:
        self._companion: Companion | None = None
        self._series: Series | None = None
        self._names: tuple[str, ...] = ()

    def show(self, companion: Companion | None) -> None:
        """Paint another one from now on, or none."""
        self._companion = companion
        self._series = None if companion is None else Series(companion)
        labels = () if companion is None else companion.original.labels
        self._names = tuple(short_names(labels))

    def partner(self, curve: Curve) -> Curve | None:
        """Return the curve that belongs to one of the document, None where there is none."""
        if self._companion is None:
            return None
        ends = [self._companion.partners[marker] for marker in curve.markers]
        first, other = ends[0], ends[-1] if curve.other is not None else None
        # One point is at both ends where it is the nearest to both.
        if first is None or (curve.other is not None and other in (None, first)):
            return None
        return Curve(first, curve.colour, other)

    def prepare(self, drawn: Iterable[tuple[Quantity, Curve]]) -> bool:
        """Compute a portion of what is to be drawn; see `Series.prepare`."""
        if self._series is None:
            return True
        pairs = [(quantity, self.partner(curve)) for quantity, curve in drawn]
        return self._series.prepare([(quantity, curve) for quantity, curve in pairs if curve])

    def values(
        self,
        quantity: Quantity,
        curves: Sequence[Curve],
        visible: tuple[float, float],
        width: int,
    ) -> list[Floats]:
        """Return what a lane has to show besides its own curves."""
        lines = self._lines(quantity, curves, visible, width)
        return [values for _, values in lines]

    def paint(
        self,
        painter: QPainter,
        frame: Frame,
        quantity: Quantity,
        curves: Sequence[Curve],
        theme: Theme,
    ) -> None:
        """Draw the partners of curves."""
        pen = thin(painter, theme.companion)
        pen.setDashPattern(DASHES)
        visible = frame.start, frame.stop
        for frames, values in self._lines(quantity, curves, visible, int(frame.rect.width())):
            paint_line(painter, frame, frames, values, pen)

    def paint_key(
        self,
        painter: QPainter,
        lane: "Lane",
        rect: QRectF,
        names: Sequence[str],
        theme: Theme,
    ) -> None:
        """Say at the foot of a plot which point of which file the dashed curve is."""
        curve = lane.curves[-1] if lane.curves else None
        partner = None if curve is None else self.partner(curve)
        if self._companion is None or curve is None or partner is None:
            return
        metrics, room = painter.fontMetrics(), int(rect.width()) - 10
        text = DASH + self._name(partner)
        if lane.quantity is not Quantity.BONE and self._name(partner) != names[curve.marker]:
            text += f" ≈ {names[curve.marker]}"
        longer = f"{text} · {self._companion.path.name}"
        # The 3D view names the file, too.
        text = longer if metrics.horizontalAdvance(longer) <= room else elided(text, metrics, room)
        painter.setPen(QColor(theme.companion))
        left = rect.right() - 5 - metrics.horizontalAdvance(text)
        place = QPointF(left, rect.bottom() - 3 - metrics.descent())
        paint_on_ground(painter, place, text, theme)

    def read(
        self, quantities: Sequence[Quantity], curve: Curve, frame: int
    ) -> tuple[str, tuple[float, ...]] | None:
        """Return the name of a curve's partner and its values at a frame; None without one."""
        partner = self.partner(curve)
        if self._series is None or partner is None:
            return None
        series = self._series
        return DASH + self._name(partner), tuple(
            series.value(quantity, partner, frame) for quantity in quantities
        )

    def _name(self, curve: Curve) -> str:
        return " – ".join(self._names[marker] for marker in curve.markers)

    def _lines(
        self,
        quantity: Quantity,
        curves: Sequence[Curve],
        visible: tuple[float, float],
        width: int,
    ) -> Iterator[tuple[Floats, Floats]]:
        if self._series is None or quantity is Quantity.RESIDUAL:
            return
        for partner in filter(None, map(self.partner, curves)):
            yield self._series.line(quantity, partner, visible, width)
