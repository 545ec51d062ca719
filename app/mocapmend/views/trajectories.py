"""The trajectory plots: quantities of the selected markers, the gaps shaded."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QMouseEvent, QPainter
from PySide6.QtWidgets import QWidget

from mocapmend.document import Document
from mocapmend.state import SampleState
from mocapmend.suspects import by_marker, place_of
from mocapmend.theme import Theme
from mocapmend.views.gap_arrows import paint_plot_arrows
from mocapmend.views.labels import elided
from mocapmend.views.lane import Frame, paint_on_ground
from mocapmend.views.lane_painter import Lane, LanePainter
from mocapmend.views.painters.exchange import exchange_shown
from mocapmend.views.plot_canvas import PlotCanvas
from mocapmend.views.quantities import Curve, Quantity
from mocapmend.views.readout import Readout, Row
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun

POSITION = (Quantity.X, Quantity.Y, Quantity.Z)
DECIMALS = {"m": 4, "cm": 2}
"""Of a coordinate, by unit; 1 of others."""
MORE_DECIMALS = {Quantity.SPEED: -1, Quantity.ACCELERATION: -1, Quantity.RESIDUAL: 1}
LEAST_NAME = "MMMM"
"""What must be left of the first name."""
APART = 18
"""Pixels between the values of two markers."""
LEAST_LEFT = 4
"""Pixels before a header that is longer than the plots are wide."""


class Trajectories(PlotCanvas):
    """Plots of the selected markers; which quantities is chosen by `PlotPane`."""

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        original = document.original
        super().__init__(view, original.rate, original.first_frame, theme, parent)
        self._document = document
        self._painter = LanePainter(document, theme)
        self._found: frozenset[BadRun] = frozenset()
        self._quantities: tuple[Quantity, ...] = POSITION
        self._shown: list[Lane] = []
        """The plots of the picture, which may be behind the selection for a moment."""
        self._shown_curves: tuple[Curve, ...] = ()
        """Of all markers that were selected then."""
        self._bone: tuple[int, int] | None = None
        self._separate = False
        self._same_scale = False
        self._short = {
            Quantity.SPEED: self.tr("Speed"),
            Quantity.ACCELERATION: self.tr("Accel."),
            Quantity.RESIDUAL: self.tr("Residual"),
            Quantity.BONE: self.tr("Length"),
        }
        self.setAccessibleName(self.tr("Trajectory plots"))
        view.selection_changed.connect(self.repaint_plots)
        view.gap_changed.connect(self.update)
        view.suspect_changed.connect(self.repaint_plots)
        view.exchange_changed.connect(self.repaint_plots)
        view.preview_changed.connect(self.repaint_plots)
        view.candidates_changed.connect(self.repaint_plots)
        view.smoothing_changed.connect(self.repaint_plots)
        view.companion_changed.connect(self._show_companion)
        document.samples_changed.connect(self._forget)
        document.names_changed.connect(self.repaint_plots)

    def set_theme(self, theme: Theme) -> None:
        self._painter.theme = theme
        super().set_theme(theme)

    def set_suspects(self, found: Sequence[BadRun]) -> None:
        """Mark measured samples that are held for bad."""
        self._found = frozenset(found)
        self._painter.bad.suspects = by_marker(found)
        self.repaint_plots()

    def set_separate(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Give every selected marker its own plots, or overlay them."""
        self._separate = on
        self.repaint_plots()

    def set_same_scale(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Make a unit of x, y and z equally high in all plots, or let each fill its plot."""
        self._same_scale = on
        self.repaint_plots()

    def set_quantities(self, quantities: tuple[Quantity, ...]) -> None:
        """Choose what is plotted, from top to bottom."""
        self._quantities = quantities
        self.repaint_plots()

    def set_bone(self, bone: tuple[int, int] | None) -> None:
        """Choose the two markers whose distance is plotted as a bone's length."""
        self._bone = bone
        self.repaint_plots()

    def lanes(self) -> list[Lane]:
        """Return the plots for the present selection, from top to bottom.

        Of separate plots only as many as can be read; the markers selected last come first.
        """
        curves = self._curves()
        if not curves:
            return []
        single = [quantity for quantity in self._quantities if quantity is not Quantity.BONE]
        lanes = [Lane(quantity, curves) for quantity in single]
        if self._separate and single:
            room = self._room(self._area()) - (len(single) < len(self._quantities))
            shown = curves[-max(1, room // len(single)) :]
            lanes = [Lane(quantity, (curve,)) for curve in shown for quantity in single]
        if len(single) < len(self._quantities):
            lanes.append(Lane(Quantity.BONE, self._bone_curves()))
        return lanes

    def _curves(self) -> tuple[Curve, ...]:
        colours = self._theme.curves
        return tuple(
            Curve(marker, colours[order % len(colours)])
            for order, marker in enumerate(self._view.selection)
        )

    def _bone_curves(self) -> tuple[Curve, ...]:
        if self._bone is None:
            return ()
        return (Curve(self._bone[0], self._theme.text, self._bone[1]),)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        marker = self._view.marker
        if marker is None:
            return
        gap = self._document.gap_near(marker, self._axis.frame_at(event.position().x()))
        if gap is not None:
            self._view.go_to(gap)

    # --- painting ----------------------------------------------------------------------------

    def _get_ready(self) -> bool:
        drawn = [(lane.quantity, curve) for lane in self.lanes() for curve in lane.curves]
        beside = self._painter.companion.prepare(drawn)
        return self._painter.series.prepare(drawn) and beside

    def _show_companion(self) -> None:
        self._painter.companion.show(self._view.companion)
        self.repaint_plots()

    def _forget(self, gaps: tuple[Gap, ...]) -> None:
        self._painter.series.forget({gap.marker for gap in gaps})
        self.repaint_plots()

    def _hint(self) -> str:
        if not self._view.selection:
            return self.tr("Select a marker to see its trajectory")
        return self.tr("Nothing is chosen to be plotted: press V")

    def _paint_plots(self, painter: QPainter, area: QRectF) -> list[Frame]:
        self._shown = lanes = self.lanes()
        self._shown_curves = self._curves()
        of_markers = [lane for lane in lanes if lane.quantity is not Quantity.BONE]
        seen = {curve.marker for lane in of_markers for curve in lane.curves}
        per_marker = len(of_markers) // max(1, len(seen))
        self._left_out = (len(self._view.selection) - len(seen)) * per_marker
        rows = list(zip(lanes, self._rows(area, len(lanes)), strict=True))
        frames = self._painter.paint(
            painter,
            rows,
            self._view.visible,
            self._view.preview,
            self._view.others,
            suspect=self._view.suspect,
            exchange=exchange_shown(self._view, self._found),
            smoothing=self._view.smoothing,
            same_scale=self._same_scale,
        )
        if self._separate:
            self._paint_markers(painter, rows)
        if rows:
            self._painter.companion.paint_key(painter, *rows[0], self._document.names, self._theme)
        return frames

    def _paint_markers(self, painter: QPainter, rows: list[tuple[Lane, QRectF]]) -> None:
        """Write each marker's name into the first of its own plots."""
        metrics, named = painter.fontMetrics(), set()
        for lane, rect in rows:
            marker = lane.curves[0].marker if lane.curves else None
            if marker is None or lane.quantity is Quantity.BONE or marker in named:
                continue
            named.add(marker)
            title = metrics.horizontalAdvance(self._painter.title(lane)) + 15
            name = elided(self._document.names[marker], metrics, int(rect.width()) - title - 5)
            painter.setPen(QColor(lane.curves[0].colour))
            place = QPointF(rect.left() + title, rect.top() + 2 + metrics.ascent())
            paint_on_ground(painter, place, name, self._theme)

    def _paint_marks(self, painter: QPainter) -> None:
        """Put arrows on the ends of the current gap or bad run, in the plots that show it."""
        run = self._view.suspect
        gap = self._view.gap if run is None else place_of(run)
        for lane, frame in zip(self._shown, self._frames, strict=True):
            if gap is not None and lane.curves and gap.marker in lane.curves[-1].markers:
                paint_plot_arrows(painter, self._theme, frame, gap)

    def _paint_header(self, painter: QPainter) -> None:
        """Write the names and places of the selected markers, the current first."""
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        self._paint_derived(painter)
        margins, curves = self._margins, self._shown_curves
        x, baseline = self._header_left(curves), 2.0 + metrics.ascent()
        for done, curve in enumerate(reversed(curves)):
            name, value = self._document.names[curve.marker], f"  {self._place_now(curve)}"
            if not done and x + metrics.horizontalAdvance(value) > self.width():
                # Half a number would be another one.
                value = ""
            more = f"+{len(curves) - done}"
            room = self.width() - margins.right - x - metrics.horizontalAdvance(value)
            rest = room - metrics.horizontalAdvance(more) - APART
            if done and rest < metrics.horizontalAdvance(name):
                painter.setPen(QColor(self._theme.dim))
                if x + metrics.horizontalAdvance(more) <= self.width():
                    painter.drawText(QPointF(x, baseline), more)
                return
            if len(curves) > 1 and rest > metrics.horizontalAdvance(LEAST_NAME):
                # How many are not named is read, too, where the first takes nearly all the room.
                room = rest
            text = elided(name, metrics, int(room)) + value
            painter.setPen(QColor(curve.colour))
            painter.drawText(QPointF(x, baseline), text)
            x += metrics.horizontalAdvance(text) + APART

    def _header_left(self, curves: Sequence[Curve]) -> float:
        """Return where the header begins: above the plots, or before them where it is long."""
        if not curves:
            return float(self._margins.left)
        advance, current = self.fontMetrics().horizontalAdvance, curves[-1]
        name, value = self._document.names[current.marker], self._place_now(current)
        wanted = advance(f"{name}  {value}") + self._margins.right
        return float(max(LEAST_LEFT, min(self._margins.left, self.width() - wanted)))

    def _place_now(self, curve: Curve) -> str:
        """Write where a marker is at the playhead."""
        frame = self._view.frame
        if np.isnan(self._document.points[frame, curve.marker, 0]):
            aside = self._document.state[frame, curve.marker] == SampleState.BAD
            return self.tr("set aside") if aside else self.tr("missing")
        place = "  ".join(self._value(axis, curve, frame) for axis in POSITION)
        return f"{place} {self._document.original.unit}"

    def _paint_derived(self, painter: QPainter) -> None:
        """Write into each other plot the value that its current curve has at the playhead."""
        metrics = painter.fontMetrics()
        for lane, frame in zip(self._shown, self._frames, strict=True):
            if lane.quantity.kind == "position" or not lane.curves:
                continue
            text = self._value(lane.quantity, lane.curves[-1], self._view.frame)
            right = frame.rect.right() - 5 - metrics.horizontalAdvance(text)
            painter.setPen(QColor(lane.curves[-1].colour))
            place = QPointF(right, frame.rect.top() + 2 + metrics.ascent())
            paint_on_ground(painter, place, text, self._theme)

    def _value(self, quantity: Quantity, curve: Curve, frame: int) -> str:
        return self._text(quantity, self._painter.series.value(quantity, curve, frame))

    def _text(self, quantity: Quantity, value: float) -> str:
        if np.isnan(value):
            return "–"
        decimals = DECIMALS.get(self._document.original.unit, 1) + MORE_DECIMALS.get(quantity, 0)
        return f"{value:.{decimals}f}"

    def _readout(self, frame: float, row: int) -> Readout:
        at = max(0, min(self._view.frames - 1, int(np.floor(frame))))
        lane = self._shown[row]
        kind = lane.quantity.kind
        quantities = dict.fromkeys(shown.quantity for shown in self._shown)
        columns = [quantity for quantity in quantities if quantity.kind == kind]
        curves = lane.curves if kind == "bone" else tuple(reversed(self._shown_curves))
        rows = []
        for curve in curves:
            name = " – ".join(self._document.names[marker] for marker in curve.markers)
            values = tuple(self._value(quantity, curve, at) for quantity in columns)
            rows.append(Row(name, curve.colour, values))
            beside = self._painter.companion.read(columns, curve, at)
            if beside is not None:
                texts = map(self._text, columns, beside[1])
                rows.append(Row(beside[0], self._theme.companion, tuple(texts)))
        title = self.tr("Frame {0} · {1} s").format(
            at + self._first_frame, f"{at / self._rate:.3f}"
        )
        names = tuple(self._short.get(quantity, quantity.name) for quantity in columns)
        return Readout(title, names, tuple(rows))
