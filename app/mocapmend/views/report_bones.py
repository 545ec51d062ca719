"""The report's bones: how constant each is, and the length of one over time."""

import numpy as np
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.report import Report
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.report_plots import AFTER, BEFORE, ReportPlot
from mocapmend.views.tables import RIGHT, align_right, dress, narrow
from mocapmend_algorithms.metrics import bone_lengths

NUMBERS = (1, 2, 3)
"""Columns that are aligned at the right."""


class BonesPage(QWidget):
    """The list of the bones, and the curve of the one that is marked in it."""

    def __init__(self, document: Document, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._theme = theme
        self._report: Report | None = None
        length = self.tr("Length ({0})").format(document.original.unit)
        self.plot = ReportPlot(document, length)
        self.table = self._make_table()
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table, 2)
        layout.addWidget(self.plot, 3)
        self.setFocusProxy(self.table)
        self.set_theme(theme)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        self.plot.set_theme(theme)
        self._draw()

    def show_report(self, report: Report) -> None:
        """Show other figures."""
        self._report = report
        chosen = max(0, self.table.currentRow())
        self.table.blockSignals(True)  # noqa: FBT003 - Qt's own signature
        self.table.setRowCount(len(report.bone_names))
        before, after = report.spread_before, report.spread_after
        for row, name in enumerate(report.bone_names):
            item = QTableWidgetItem(name)
            item.setToolTip(name)
            self.table.setItem(row, 0, item)
            texts = (_percent(before[row]), _percent(after[row]), str(report.bone_repairs[row]))
            for column, text in enumerate(texts, 1):
                item = QTableWidgetItem(text)
                item.setTextAlignment(RIGHT)
                self.table.setItem(row, column, item)
        if report.bone_names:
            self.table.selectRow(min(chosen, len(report.bone_names) - 1))
        self.table.blockSignals(False)  # noqa: FBT003 - Qt's own signature
        self._draw()

    def _make_table(self) -> QTableWidget:
        table = QTableWidget(0, 4)
        titles = [
            self.tr("Bone spread"),
            self.tr("Before"),
            self.tr("After"),
            self.tr("Repaired frames"),
        ]
        table.setHorizontalHeaderLabels(titles)
        align_right(table, NUMBERS)
        table.setAccessibleName(self.tr("Spread of the bone lengths"))
        table.setToolTip(self.tr("Standard deviation of the length over its mean"))
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        dress(table)
        advance = table.fontMetrics().horizontalAdvance
        narrow(table, {i: max(advance(titles[i]), advance("00.00 %")) + 20 for i in NUMBERS})
        table.itemSelectionChanged.connect(self._draw)
        return table

    def _draw(self) -> None:
        self.plot.start()
        row = self.table.currentRow()
        if self._report is None or not 0 <= row < len(self._report.bones):
            return
        bone = np.array([self._report.bones[row]])
        measured, repaired = self._theme.text, self._theme.state_colour(SampleState.FILLED)
        after = bone_lengths(self._document.points, bone)[:, 0]
        self.plot.draw(after, repaired, AFTER)
        self.plot.draw(bone_lengths(self._document.original.points, bone)[:, 0], measured, BEFORE)
        legend = (
            f'<span style="color:{measured}">╌╌ ' + self.tr("measured (dashed)") + "</span>",
            f'<span style="color:{repaired}">━━ ' + self.tr("repaired (solid)") + "</span>",
        )
        self.plot.say(" &nbsp; ".join(legend), self._theme.dim)


def _percent(value: float) -> str:
    return f"{value:.2f} %" if np.isfinite(value) else "—"
