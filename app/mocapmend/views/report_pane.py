"""The report pane: tracking success and bone lengths, before and after the repairs."""

from collections.abc import Mapping, Sequence

import numpy as np
import pyqtgraph
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QColor, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QSplitter,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.report import Report, summarise
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.action_button import ActionButton
from mocapmend.views.tables import dress, narrow
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.metrics import bone_lengths

DELAY_MS = 150
"""Undoing in a hurry asks for many reports; only the last one is computed."""


class ReportPane(QWidget):
    """Curves of the document as the file has it and as it is now."""

    failed = Signal(object)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        jobs: Jobs,
        theme: Theme,
        actions: Mapping[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._jobs = jobs
        self._theme = theme
        self._job: Job | None = None
        self.report: Report | None = None
        self._success = _plot(self.tr("Tracked"), "%")
        self._bone = _plot(self.tr("Length"), document.original.unit)
        self._playheads = [pyqtgraph.InfiniteLine(angle=90) for _ in range(2)]
        self._table = self._make_table()
        charts = QSplitter(Qt.Orientation.Horizontal)
        for part, share in ((self._success, 4), (self._bone, 4), (self._table, 3)):
            charts.addWidget(part)
            charts.setStretchFactor(charts.count() - 1, share)
        charts.setSizes([440, 440, 280])
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.setSpacing(4)
        layout.addWidget(charts, 1)
        layout.addLayout(
            self._make_proof(ActionButton(actions["check_copy"], self.tr("Check a copy…")))
        )
        self.setFocusProxy(self._table)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self._compute)
        if document.found_skeleton is not None:
            self._timer.start()
        document.samples_changed.connect(self._timer.start)
        document.skeleton_changed.connect(self._timer.start)
        view.frame_changed.connect(self._move_playheads)
        self.set_theme(theme)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        for plot in (self._success, self._bone):
            plot.setBackground(theme.base)
            for side in ("left", "bottom"):
                plot.getAxis(side).setPen(theme.line)
                plot.getAxis(side).setTextPen(theme.dim)
        for line in self._playheads:
            line.setPen(pyqtgraph.mkPen(theme.playhead, width=1))
        self._draw_success()
        self._draw_bone()

    def show_proof(self, text: str, sentences: Sequence[str] = ()) -> None:
        """Say what is proved about the last export."""
        self._proof.setText(text)
        self._proof.setToolTip("\n".join(sentences))

    # --- computing ---------------------------------------------------------------------------

    def stop(self) -> None:
        """Give up what is being computed: it is out of date, or the document is going away."""
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _compute(self) -> None:
        self.stop()
        document = self._document
        job = self._jobs.compute(
            self.tr("Report"),
            summarise,
            document.share_original(),
            document.share(),
            document.skeleton,
            (),
            (),
            quiet=True,
        )
        job.finished.connect(self._show)
        job.failed.connect(self.failed)
        self._job = job

    def _show(self, result: Report) -> None:
        self.report = result
        self._fill_table()
        self._draw_success()
        self._draw_bone()

    # --- showing -----------------------------------------------------------------------------

    def _make_table(self) -> QTableWidget:
        table = QTableWidget(0, 3)
        table.setHorizontalHeaderLabels(
            [self.tr("Bone spread"), self.tr("Before"), self.tr("After")]
        )
        table.setAccessibleName(self.tr("Spread of the bone lengths"))
        table.setToolTip(self.tr("Standard deviation of the length over its mean"))
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        dress(table)
        width = table.fontMetrics().horizontalAdvance(self.tr("Before")) + 20
        narrow(table, {1: width, 2: width})
        table.itemSelectionChanged.connect(self._draw_bone)
        return table

    def _make_proof(self, check: ActionButton) -> QHBoxLayout:
        self._proof = QLabel()
        self._proof.setTextFormat(Qt.TextFormat.PlainText)
        self._proof.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        # A long sentence must not stretch the window.
        self._proof.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        row = QHBoxLayout()
        row.addWidget(self._proof, 1)
        row.addWidget(check)
        return row

    def _fill_table(self) -> None:
        assert self.report is not None
        chosen = max(0, self._table.currentRow())
        self._table.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        self._table.setRowCount(len(self.report.bone_names))
        before, after = self.report.spread_before, self.report.spread_after
        for row, name in enumerate(self.report.bone_names):
            item = QTableWidgetItem(name)
            item.setToolTip(name)
            self._table.setItem(row, 0, item)
            for column, value in ((1, before[row]), (2, after[row])):
                item = QTableWidgetItem(f"{value:.2f} %" if np.isfinite(value) else "—")
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                self._table.setItem(row, column, item)
        if self.report.bone_names:
            self._table.selectRow(min(chosen, len(self.report.bone_names) - 1))
        self._table.blockSignals(False)  # noqa: FBT003 - Qt's own signature

    def _draw_success(self) -> None:
        self._success.clear()
        self._success.addItem(self._playheads[0], ignoreBounds=True)
        if self.report is None:
            return
        before, after = self.report.success_before, self.report.success_after
        names = (self.tr("now"), self.tr("mean so far"), self.tr("never lost"))
        kinds = ("instantaneous", "running_mean", "survival")
        legend = []
        for name, kind, colour in zip(names, kinds, self._theme.curves, strict=False):
            for shares, style in ((before, Qt.PenStyle.DotLine), (after, Qt.PenStyle.SolidLine)):
                pen = pyqtgraph.mkPen(QColor(colour), width=1, style=style)
                self._success.plot(self._seconds(), 100.0 * getattr(shares, kind), pen=pen)
            legend.append(f'<span style="color:{colour}">━ {name}</span>')
        legend.append(self.tr("dotted: before"))
        self._success.setTitle(" &nbsp; ".join(legend), size="9pt", color=self._theme.dim)
        self._success.setXRange(*self._span(), padding=0.02)

    def _draw_bone(self) -> None:
        self._bone.clear()
        self._bone.addItem(self._playheads[1], ignoreBounds=True)
        row = self._table.currentRow()
        if self.report is None or not 0 <= row < len(self.report.bones):
            return
        bone = np.array([self.report.bones[row]])
        before = bone_lengths(self._document.original.points, bone)[:, 0]
        after = bone_lengths(self._document.points, bone)[:, 0]
        measured, repaired = self._theme.text, self._theme.state_colour(SampleState.FILLED)
        for values, colour in ((after, repaired), (before, measured)):
            self._bone.plot(self._seconds(), values, pen=colour, connect="finite")
        legend = (
            f'<span style="color:{measured}">━ {self.tr("measured")}</span>',
            f'<span style="color:{repaired}">━ {self.tr("repaired")}</span>',
        )
        self._bone.setTitle(" &nbsp; ".join(legend), size="9pt", color=self._theme.dim)
        self._bone.setXRange(*self._span(), padding=0.02)

    def _seconds(self) -> NDArray[np.float64]:
        return np.arange(self._document.original.frames) / self._document.original.rate

    def _span(self) -> tuple[float, float]:
        return 0.0, max(1, self._document.original.frames - 1) / self._document.original.rate

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._move_playheads()

    def _move_playheads(self) -> None:
        if not self.isVisible():
            return
        for line in self._playheads:
            line.setValue(self._view.frame / self._document.original.rate)


def _plot(title: str, unit: str) -> pyqtgraph.PlotWidget:
    plot = pyqtgraph.PlotWidget()
    item = plot.getPlotItem()
    # Before any curve is added, and with X fixed: otherwise nothing is clipped.
    item.setDownsampling(auto=True, mode="peak")
    item.setClipToView(True)
    item.enableAutoRange(x=False, y=True)
    item.setLabel("left", f"{title} ({unit})")
    item.getAxis("left").enableAutoSIPrefix(enable=False)
    item.setMenuEnabled(False)
    item.hideButtons()
    plot.setMinimumWidth(160)
    plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return plot
