"""The residual of a marker's filter against its cut-off, for choosing one."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from mocapmend.theme import AXIS_COLOURS, Theme
from mocapmend.views.lane import Frame, paint_line, paint_on_ground, thin
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.smooth.residual_curve import ResidualCurve

AXES = "xyz"
LINES = 9
"""Height in lines of text."""
DEEPEST = 1e-5
"""Least residual that is shown, as a share of the largest."""
MARKED = (1.0, 2.0, 5.0)
DOT = 3.5


class ResidualPlot(QWidget):
    """A line per axis, that of noise alone beside it, and a dot at the cut-off.

    Both axes are logarithmic: the motion is a thousand times as large as the noise.

    Signals
    -------
    picked : float
        A cut-off in Hz that was clicked.
    """

    picked = Signal(float)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._curve: ResidualCurve | None = None
        self._chosen: tuple[float, ...] = ()
        self._mm = 1.0
        self.setAccessibleName(self.tr("Residual by cut-off"))
        self.setToolTip(
            self.tr(
                "What the filter takes away, in mm, by its cut-off. Dashed: what it would take of "
                "noise alone. Dot: the cut-off. Click to give another one."
            )
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setCursor(Qt.CursorShape.CrossCursor)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self.update()

    def show_curve(self, curve: ResidualCurve | None, chosen: Sequence[float], mm: float) -> None:
        """Show another curve, or none; `mm` is the length of its unit."""
        self._curve, self._chosen, self._mm = curve, tuple(chosen), mm
        self.setAccessibleDescription(self._described())
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(200, LINES * self.fontMetrics().height())

    def _described(self) -> str:
        if self._curve is None:
            return ""
        text = self.tr("{0}: cut-off {1} Hz, noise {2} mm")
        parts = zip(AXES, self._chosen, (self._curve.noise * self._mm).tolist(), strict=False)
        return "; ".join(text.format(axis, f"{hz:.1f}", f"{mm:.2g}") for axis, hz, mm in parts)

    # --- mouse -------------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        curve = self._curve
        if curve is None or event.button() != Qt.MouseButton.LeftButton:
            return
        frame = self._frame(curve)
        share = (event.position().x() - frame.rect.left()) / frame.rect.width()
        if 0 <= share <= 1:
            low, high = np.log10(curve.cutoffs[[0, -1]])
            self.picked.emit(round(float(10 ** (low + share * (high - low))), 1))

    # --- painting ----------------------------------------------------------------------------

    def _frame(self, curve: ResidualCurve) -> Frame:
        """Return where logarithms are painted: of the cut-off in half steps, and of the mm."""
        metrics = self.fontMetrics()
        left, line = metrics.horizontalAdvance("0.0001 "), metrics.height()
        rect = QRectF(left, line + 4, self.width() - left - 6, self.height() - 2 * line - 8)
        values = np.concatenate((curve.residuals, curve.noise_line)) * self._mm
        most = float(values.max(initial=0.0)) or 1.0
        least = max(float(values[values > 0].min(initial=most)), DEEPEST * most)
        low, high = np.log10([least, most])
        first, last = np.log10(curve.cutoffs[[0, -1]])
        # A frame's x is in the middle of its time.
        return Frame(rect, first + 0.5, last + 0.5, low - 0.1, max(high, low + 0.5) + 0.1)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setFont(self.font())
        painter.fillRect(self.rect(), QColor(self._theme.window))
        if self._curve is not None:
            frame = self._frame(self._curve)
            painter.fillRect(frame.rect, QColor(self._theme.base))
            self._paint_axes(painter, frame)
            painter.setClipRect(frame.rect)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint_curves(painter, frame, self._curve)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, on=False)
            painter.setClipping(False)
            painter.setPen(thin(painter, self._theme.line))
            painter.drawRect(frame.rect)
            self._paint_chosen(painter, frame)
        painter.end()

    def _paint_axes(self, painter: QPainter, frame: Frame) -> None:
        rect, metrics = frame.rect, painter.fontMetrics()
        for hz in _marks(frame.start - 0.5, frame.stop - 0.5, MARKED):
            x = float(frame.x(np.log10(hz)))
            painter.setPen(thin(painter, self._theme.raised))
            painter.drawLine(QLineF(x, rect.top(), x, rect.bottom()))
            text = f"{hz:g}"
            half = metrics.horizontalAdvance(text) / 2
            painter.setPen(QColor(self._theme.dim))
            painter.drawText(QPointF(x - half, rect.bottom() + metrics.ascent() + 2), text)
        for mm in _marks(frame.low, frame.high, (1.0,)):
            y = float(frame.y(np.log10(mm)))
            painter.setPen(thin(painter, self._theme.raised))
            painter.drawLine(QLineF(rect.left(), y, rect.right(), y))
            text = f"{mm:g}"
            place = QPointF(
                rect.left() - 4 - metrics.horizontalAdvance(text), y + metrics.ascent() / 2 - 1
            )
            painter.setPen(QColor(self._theme.dim))
            painter.drawText(place, text)

    def _paint_curves(self, painter: QPainter, frame: Frame, curve: ResidualCurve) -> None:
        cutoffs = np.log10(curve.cutoffs)
        for axis, colour in enumerate(AXIS_COLOURS):
            noise = QPen(QColor(colour), 1, Qt.PenStyle.DashLine)
            residual = _logs(curve.residuals[:, axis] * self._mm)
            paint_line(painter, frame, cutoffs, _logs(curve.noise_line[:, axis] * self._mm), noise)
            paint_line(painter, frame, cutoffs, residual, QPen(QColor(colour), 1.5))
            if axis < len(self._chosen):
                at = np.log10(self._chosen[axis])
                place = QPointF(
                    float(frame.x(at)), float(frame.y(np.interp(at, cutoffs, residual)))
                )
                painter.setBrush(QColor(colour))
                painter.setPen(QPen(QColor(self._theme.base), 1))
                painter.drawEllipse(place, DOT, DOT)
                painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_chosen(self, painter: QPainter, frame: Frame) -> None:
        """Write what is shown and the cut-offs above the plot."""
        metrics = painter.fontMetrics()
        baseline = 2.0 + metrics.ascent()
        painter.setPen(QColor(self._theme.dim))
        painter.drawText(QPointF(4, baseline), self.tr("mm by Hz"))
        x = frame.rect.right()
        pairs = list(zip(AXES, self._chosen, AXIS_COLOURS, strict=False))
        for axis, hz, colour in reversed(pairs):
            text = f"{axis} {hz:.1f}"
            x -= metrics.horizontalAdvance(text)
            painter.setPen(QColor(colour))
            paint_on_ground(painter, QPointF(x, baseline), text, self._theme)
            x -= metrics.horizontalAdvance("  ")


def _marks(low: float, high: float, factors: Sequence[float]) -> list[float]:
    """Return round numbers of which the logarithms are in a range."""
    powers = range(int(np.floor(low)), int(np.ceil(high)) + 1)
    marks = [factor * 10.0**power for power in powers for factor in factors]
    return [mark for mark in marks if low <= np.log10(mark) <= high]


def _logs(values: FloatArray) -> FloatArray:
    return np.log10(np.maximum(values, np.finfo(np.float64).tiny))
