"""Plots of analog channels over the time axis of the markers."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QWidget

from mocapmend.files import C3DFile
from mocapmend.theme import Theme
from mocapmend.views.columns import Envelope
from mocapmend.views.labels import elided
from mocapmend.views.lane import (
    Frame,
    paint_grid,
    paint_line,
    paint_message,
    paint_on_ground,
    thin,
    value_range,
)
from mocapmend.views.plot_canvas import PlotCanvas
from mocapmend.views.readout import Readout, Row
from mocapmend.viewstate import ViewState

APART = 18
"""Pixels between the values of two channels."""


class AnalogPlots(PlotCanvas):
    """Paints the channels that `AnalogPane` has chosen and read."""

    def __init__(
        self, source: C3DFile, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        recording = source.recording
        super().__init__(view, recording.rate, recording.first_frame, theme, parent)
        self._source = source
        self._per_frame = source.layout.analog_samples
        self._chosen: tuple[int, ...] = ()
        self._envelopes: dict[int, Envelope] = {}
        self._error = ""
        self._overlaid = False
        self.setAccessibleName(self.tr("Analog plots"))

    def set_overlaid(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Paint all channels into one plot, or give each its own."""
        self._overlaid = on
        self.repaint_plots()

    def show_channels(
        self, chosen: tuple[int, ...], envelopes: dict[int, Envelope], error: str = ""
    ) -> None:
        """Choose the channels; those that are not read yet say so, or why they cannot be."""
        self._chosen, self._envelopes, self._error = chosen, envelopes, error
        self.repaint_plots()

    def lanes(self) -> list[tuple[int, ...]]:
        """Return the channels of each plot, from top to bottom; only plots that can be read."""
        if self._overlaid:
            return [self._chosen] if self._chosen else []
        return [(channel,) for channel in self._chosen[: self._room(self._area())]]

    def _hint(self) -> str:
        return self.tr("Check a channel on the left to see it")

    # --- painting ----------------------------------------------------------------------------

    def _paint_plots(self, painter: QPainter, area: QRectF) -> list[Frame]:
        lanes = self.lanes()
        self._left_out = 0 if self._overlaid else len(self._chosen) - len(lanes)
        return [
            self._paint_lane(painter, channels, rect)
            for channels, rect in zip(lanes, self._rows(area, len(lanes)), strict=True)
        ]

    def _paint_lane(self, painter: QPainter, channels: tuple[int, ...], rect: QRectF) -> Frame:
        start, stop = self._view.visible
        read = [channel for channel in channels if channel in self._envelopes]
        # The first sample of a frame is taken with the frame: it has the same place.
        span = (start - 0.5) * self._per_frame, (stop - 0.5) * self._per_frame
        lines = [self._envelopes[channel].lines(*span, int(rect.width())) for channel in read]
        frame = Frame(rect, start, stop, *value_range(values[0] for _, values in lines))
        painter.fillRect(rect, QColor(self._theme.base))
        message = self._message(channels)
        if message:
            painter.setPen(thin(painter, self._theme.line))
            painter.drawRect(rect)
            paint_message(painter, rect, message, self._theme)
        else:
            paint_grid(painter, frame, self._theme)
        painter.setClipRect(rect)
        for channel, (places, values) in zip(read, lines, strict=True):
            pen = thin(painter, self._colour(channel))
            paint_line(painter, frame, places / self._per_frame, values[0], pen)
        painter.setClipping(False)
        if not self._overlaid:
            metrics = painter.fontMetrics()
            painter.setPen(QColor(self._colour(channels[0])))
            name = elided(self._name(channels[0]), metrics, int(rect.width()) - 10)
            place = QPointF(rect.left() + 5, rect.top() + 2 + metrics.ascent())
            paint_on_ground(painter, place, name, self._theme)
        return frame

    def _message(self, channels: tuple[int, ...]) -> str:
        """Say why a plot is empty; "" where it is not."""
        if self._error:
            return self._error
        if any(channel not in self._envelopes for channel in channels):
            return self.tr("Reading…")
        if all(self._envelopes[channel].empty for channel in channels):
            return self.tr("The file's values of this channel are no numbers")
        return ""

    def _paint_header(self, painter: QPainter) -> None:
        """Write names and values at the playhead of as many channels as there is room for."""
        painter.setFont(self.font())
        metrics = painter.fontMetrics()
        x, baseline = float(self._margins.left), 2.0 + metrics.ascent()
        for done, channel in enumerate(self._chosen):
            text = (
                f"{self._source.analog_labels[channel]}  {self._value(channel, self._view.frame)}"
            )
            more = f"+{len(self._chosen) - done}"
            room = self.width() - self._margins.right - x
            wide = metrics.horizontalAdvance(text)
            if done and wide + metrics.horizontalAdvance(more) + APART > room:
                painter.setPen(QColor(self._theme.dim))
                painter.drawText(QPointF(x, baseline), more)
                return
            painter.setPen(QColor(self._colour(channel)))
            painter.drawText(QPointF(x, baseline), elided(text, metrics, int(room)))
            x += wide + APART

    def _readout(self, frame: float, row: int) -> Readout:
        last = self._view.frames * self._per_frame - 1
        # Between the places of two samples the nearer one is read.
        sample = max(0, min(last, int(np.round((frame - 0.5) * self._per_frame))))
        at = sample / self._per_frame
        title = self.tr("Frame {0} · {1} s").format(
            int(at) + self._first_frame, f"{at / self._rate:.4f}"
        )
        rows = tuple(
            Row(
                self._source.analog_labels[channel],
                self._colour(channel),
                (self._value(channel, at),),
            )
            for channel in self.lanes()[row]
        )
        return Readout(title, (self.tr("Value"),), rows)

    def _value(self, channel: int, frame: float) -> str:
        envelope = self._envelopes.get(channel)
        sample = round(frame * self._per_frame)
        if envelope is None or np.isnan(envelope.rows[0, sample]):
            return "–"
        return f"{envelope.rows[0, sample]:.5g} {self._source.analog_units[channel]}".strip()

    def _name(self, channel: int) -> str:
        label, unit = self._source.analog_labels[channel], self._source.analog_units[channel]
        return f"{label} ({unit})" if unit else label

    def _colour(self, channel: int) -> str:
        colours = self._theme.curves
        return colours[self._chosen.index(channel) % len(colours)]
