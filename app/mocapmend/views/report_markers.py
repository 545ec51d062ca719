"""The report's table of markers: what was missing, what filled it, what is missing still."""

from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QSortFilterProxyModel,
    Qt,
)
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QVBoxLayout, QWidget

from mocapmend.document import Document
from mocapmend.report import MarkerRow, Report
from mocapmend.report.tables import filled_by, number, percent
from mocapmend.views.engine_texts import method_name
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.marker_table import NO_PARENT, SORT_ROLE, Index
from mocapmend.views.tables import INDENT, LEFT, RIGHT, Indented, dress
from mocapmend.viewstate import ViewState

SMOOTHED, FILLED_BY, ERROR = 10, 11, 12
TEXTS = {0, FILLED_BY}
WIDEST_MARKER = 200
"""Pixels."""


class MarkerReportModel(QAbstractTableModel):
    """One row per marker of a report."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        self._rate = document.original.rate
        self._rows: tuple[MarkerRow, ...] = ()
        self._columns = (
            (self.tr("Marker"), self.tr("Marker")),
            (self.tr("Missing (%)"), self.tr("Frames in which it was missing before, in %")),
            (self.tr("now (%)"), self.tr("Frames in which it is missing now, in %")),
            (self.tr("Gaps"), self.tr("Gaps before")),
            (self.tr("now"), self.tr("Gaps now")),
            (self.tr("Longest"), self.tr("Longest gap before, in frames")),
            (self.tr("ms"), self.tr("Longest gap before, in milliseconds")),
            (self.tr("now"), self.tr("Longest gap now, in frames")),
            (self.tr("Filled"), self.tr("Samples filled")),
            (self.tr("Unfilled"), self.tr("Samples that are missing now")),
            (self.tr("Smoothed (mm)"), self.tr("How far smoothing moved it: RMS, in mm")),
            (self.tr("Filled by (%)"), self.tr("Frames that each method filled, in %")),
            (self.tr("Error (mm)"), self.tr("Largest expected error of its repairs, in mm")),
        )

    def show_rows(self, rows: tuple[MarkerRow, ...]) -> None:
        """Show other figures; the rows stay where they are."""
        if len(rows) != len(self._rows):
            self.beginResetModel()
            self._rows = rows
            self.endResetModel()
            return
        self._rows = rows
        last = self.index(len(rows) - 1, len(self._columns) - 1)
        self.dataChanged.emit(self.index(0, 0), last)

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        title, tip = self._columns[section]
        if role == Qt.ItemDataRole.DisplayRole:
            return (INDENT if section == FILLED_BY else "") + title
        if role in (Qt.ItemDataRole.ToolTipRole, Qt.ItemDataRole.AccessibleDescriptionRole):
            return tip
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return LEFT if section in TEXTS else RIGHT
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self._rows[index.row()], index.column()
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return LEFT if column in TEXTS else RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            return filled_by(row, method_name) if column == FILLED_BY else row.label
        if role == SORT_ROLE:
            return self._values(index.row(), row)[column]
        return self._text(index.row(), row, column) if role == Qt.ItemDataRole.DisplayRole else None

    def _values(self, marker: int, row: MarkerRow) -> tuple[str | float | int, ...]:
        error = row.worst_error_mm
        return (
            self._document.names[marker],
            row.missing_before,
            row.missing_after,
            row.gaps_before,
            row.gaps_after,
            row.longest_before,
            1000.0 * row.longest_before / self._rate,
            row.longest_after,
            row.filled,
            row.unfilled,
            # What is unknown is sorted below all that is known: NaN has no order.
            smoothed if (smoothed := self._smoothed(marker)) >= 0 else -1.0,
            filled_by(row, method_name),
            error if error >= 0 else -1.0,
        )

    def _text(self, marker: int, row: MarkerRow, column: int) -> str:
        if column in (1, 2):
            return percent((row.missing_before, row.missing_after)[column - 1])
        if column == SMOOTHED:
            return number(self._smoothed(marker), 2)
        if column == ERROR:
            return number(row.worst_error_mm)
        value = self._values(marker, row)[column]
        return f"{value:.0f}" if isinstance(value, float) else str(value)

    def _smoothed(self, marker: int) -> float:
        """Return how far smoothing moved a marker's samples in mm; NaN where it did not."""
        moved = [how.rms for run, how in self._document.smoothed.items() if run.marker == marker]
        return max(moved, default=float("nan")) * self._document.original.mm


class MarkersPage(QWidget):
    """The table; the row that is marked is the view state's marker."""

    def __init__(self, document: Document, view: ViewState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self._following = False
        self._model = MarkerReportModel(document)
        self._model.setParent(self)
        self._proxy = QSortFilterProxyModel(self)
        self._proxy.setSourceModel(self._model)
        self._proxy.setSortRole(SORT_ROLE)
        self.table = self._make_table(max(document.names, key=len, default=""))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table)
        self.setFocusProxy(self.table)
        view.selection_changed.connect(self._follow)

    def show_report(self, report: Report) -> None:
        """Show other figures."""
        self._model.show_rows(report.markers)
        self._follow(self._view.selection)

    def _make_table(self, longest: str) -> QTableView:
        table = QTableView()
        dress(table)
        table.setModel(self._proxy)
        table.setSortingEnabled(True)
        table.sortByColumn(-1, Qt.SortOrder.AscendingOrder)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        table.setAccessibleName(self.tr("Markers before and after the repairs"))
        table.setItemDelegateForColumn(0, LabelDelegate(table))
        table.setItemDelegateForColumn(FILLED_BY, Indented(table))
        advance = table.fontMetrics().horizontalAdvance
        header = table.horizontalHeader()
        header.setMinimumSectionSize(30)
        for column in range(self._model.columnCount()):
            title = str(self._model.headerData(column, Qt.Orientation.Horizontal))
            # Room for the margins and the mark of the sorted column.
            header.resizeSection(column, max(advance(title), advance("100.00")) + 18)
        header.resizeSection(0, min(max(advance(longest), advance("Marker")) + 24, WIDEST_MARKER))
        header.setSectionResizeMode(FILLED_BY, QHeaderView.ResizeMode.Stretch)
        table.selectionModel().selectionChanged.connect(self._lead)
        return table

    def _lead(self) -> None:
        """Make the marked row's marker the current one."""
        chosen = self.table.selectionModel().selectedRows()
        if chosen and not self._following:
            self._view.select((self._proxy.mapToSource(chosen[0]).row(),))

    def _follow(self, _: tuple[int, ...]) -> None:
        """Mark the current marker's row."""
        self._following = True
        marker = self._view.marker
        place = QModelIndex()
        if marker is not None and marker < self._model.rowCount():
            place = self._proxy.mapFromSource(self._model.index(marker, 0))
        flags = QItemSelectionModel.SelectionFlag
        if place.isValid():
            self.table.selectionModel().setCurrentIndex(place, flags.ClearAndSelect | flags.Rows)
        else:
            self.table.clearSelection()
        self._following = False
