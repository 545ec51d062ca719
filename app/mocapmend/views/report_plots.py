"""Plots over time for the report: how they look, and the playhead in them."""

import numpy as np
import pyqtgraph
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QColor, QPen

from mocapmend.document import Document
from mocapmend.theme import Theme

BEFORE, AFTER = Qt.PenStyle.DashLine, Qt.PenStyle.SolidLine


class ReportPlot(pyqtgraph.PlotWidget):  # type: ignore[misc]
    """A plot of quantities over the whole recording.

    Parameters
    ----------
    document : Document
        Whose time it shows.
    label : str
        Of the vertical axis.
    """

    def __init__(self, document: Document, label: str) -> None:
        super().__init__()
        self._frames, self._rate = document.original.frames, document.original.rate
        self._title = ("", "")
        self._playhead = pyqtgraph.InfiniteLine(angle=90)
        item = self.getPlotItem()
        # Before any curve is added, and with X fixed: otherwise nothing is clipped.
        item.setDownsampling(auto=True, mode="peak")
        item.setClipToView(True)
        item.enableAutoRange(x=False, y=True)
        item.setLabel("left", label)
        item.getAxis("left").enableAutoSIPrefix(enable=False)
        item.setMenuEnabled(False)
        item.hideButtons()
        self.setMinimumWidth(120)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.setBackground(theme.base)
        for side in ("left", "bottom"):
            self.getAxis(side).setPen(self._pen(theme.line))
            self.getAxis(side).setTextPen(theme.dim)
        self._playhead.setPen(self._pen(theme.playhead))

    def _pen(self, colour: str, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> QPen:
        """Make a pen; the plots take its width in pixels of the screen, not of the window."""
        width = max(1, round(self.devicePixelRatioF()))
        pen: QPen = pyqtgraph.mkPen(QColor(colour), width=width, style=style)
        return pen

    def say(self, title: str, colour: str) -> None:
        """Write a title, which may hold HTML, as large as other texts."""
        self._title = title, colour
        self.setTitle(title, size=f"{self.fontInfo().pointSizeF():g}pt", color=colour)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self._title[0]:
            self.say(*self._title)

    def start(self) -> None:
        """Take away the curves."""
        self.clear()
        self.addItem(self._playhead, ignoreBounds=True)
        self.setXRange(0.0, max(1, self._frames - 1) / self._rate, padding=0.02)

    def draw(self, values: NDArray[np.float64], colour: str, style: Qt.PenStyle) -> None:
        """Add a curve, one value per frame; NaN interrupts it."""
        pen = self._pen(colour, style)
        self.plot(np.arange(self._frames) / self._rate, values, pen=pen, connect="finite")

    def show_frame(self, frame: int) -> None:
        """Move the playhead."""
        self._playhead.setValue(frame / self._rate)
