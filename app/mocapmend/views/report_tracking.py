"""The report's curves of tracking success, before and after the repairs."""

import numpy as np
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from mocapmend.document import Document
from mocapmend.report import Report
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.report_plots import AFTER, BEFORE, ReportPlot
from mocapmend.views.text_scale import scaled

KINDS = ("instantaneous", "running_mean", "survival")
SIDE_WIDTH = 190


class TrackingPage(QWidget):
    """Three plots: tracked now, so far in the mean, and never lost; of markers or segments."""

    def __init__(self, document: Document, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._report: Report | None = None
        self.plots = [ReportPlot(document, "%") for _ in KINDS]
        self._titles = (self.tr("Tracked now"), self.tr("Mean so far"), self.tr("Never lost"))
        self.unit = QComboBox()
        self.unit.addItems([self.tr("Markers"), self.tr("Segments")])
        self.unit.setAccessibleName(self.tr("What the curves count"))
        self.unit.setToolTip(
            self.tr("A segment is a group of markers that keep their distances to each other")
        )
        self.unit.currentIndexChanged.connect(self._draw)
        self._key = QLabel()
        self._key.setTextFormat(Qt.TextFormat.RichText)
        self._key.setWordWrap(True)
        self._key.setAlignment(Qt.AlignmentFlag.AlignTop)
        scrolled = QScrollArea()
        scrolled.setFrameShape(QScrollArea.Shape.NoFrame)
        scrolled.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        scrolled.setWidgetResizable(True)
        scrolled.setWidget(self._key)
        side = QVBoxLayout()
        side.addWidget(self.unit)
        side.addWidget(scrolled, 1)
        self._aside = QWidget()
        side.setContentsMargins(0, 0, 0, 0)
        self._aside.setLayout(side)
        self._take_room()
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._aside)
        for plot in self.plots:
            layout.addWidget(plot, 1)
        self.setFocusProxy(self.unit)
        self.set_theme(theme)

    def _take_room(self) -> None:
        self._aside.setFixedWidth(scaled(self, SIDE_WIDTH))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._take_room()

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        for plot in self.plots:
            plot.set_theme(theme)
        self._draw()

    def show_report(self, report: Report) -> None:
        """Show other figures."""
        self._report = report
        if report.segment_success is None:
            self.unit.setCurrentIndex(0)
        self.unit.setEnabled(report.segment_success is not None)
        self._draw()

    def _draw(self) -> None:
        report = self._report
        if report is None:
            return
        before, after = report.success_before, report.success_after
        if self.unit.currentIndex() == 1 and report.segment_success is not None:
            before, after = report.segment_success
        ends = []
        for plot, kind, title in zip(self.plots, KINDS, self._titles, strict=True):
            old, new = 100.0 * getattr(before, kind), 100.0 * getattr(after, kind)
            plot.start()
            plot.draw(new, self._theme.state_colour(SampleState.FILLED), AFTER)
            plot.draw(old, self._theme.text, BEFORE)
            plot.say(title, self._theme.text)
            if kind != "instantaneous" and old.size and np.isfinite(old[-1]):
                ends.append(
                    self.tr("{0}: {1} % before, {2} % after").format(
                        title, f"{old[-1]:.1f}", f"{new[-1]:.1f}"
                    )
                )
        lines = (
            f'<span style="color:{self._theme.text}">╌╌</span> ' + self.tr("before (dashed)"),
            f'<span style="color:{self._theme.state_colour(SampleState.FILLED)}">━━</span> '
            + self.tr("after (solid)"),
            *ends,
            *self._wrong(report),
        )
        self._key.setText("<br>".join(lines))

    def _wrong(self, report: Report) -> list[str]:
        """Say how many samples do not count as tracked before, though they were there."""
        if not report.wrong_before:
            return []
        return [self.tr("Samples that were there but wrong: {0}").format(report.wrong_before)]
