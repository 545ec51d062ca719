"""The list of the repairs: those made now and those that the file had when it was opened."""

from typing import Any

import numpy as np
from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QSortFilterProxyModel,
    Qt,
)
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QLabel, QStackedLayout, QTableView, QWidget

from mocapmend.document import Document
from mocapmend.edits import Repair
from mocapmend.views.engine_texts import method_name
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.marker_table import NO_PARENT, SORT_ROLE, Index
from mocapmend.views.tables import INDENT, LEFT, RIGHT, Indented, dress, frames_text, narrow
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.registry import METHODS

NUMBERS = {1, 2, 4}
"""Columns that are aligned at the right."""
INDENTED = {3, 5}
"""Columns of texts that follow one of numbers."""
ARROWS = {Qt.Key.Key_Up, Qt.Key.Key_Down}
WIDEST_MARKER = 320
"""Pixels."""


class RepairModel(QAbstractTableModel):
    """One row per repair: marker, frames, length, method, error, when it was made, donors."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        self._rows: list[tuple[Gap, Repair]] = []
        self._columns = (
            self.tr("Marker"),
            self.tr("Frames"),
            self.tr("Length"),
            self.tr("Method"),
            self.tr("Expected error"),
            self.tr("Made"),
            self.tr("Donors"),
        )
        document.samples_changed.connect(self._refresh)
        document.names_changed.connect(self._refresh)
        self._refresh()

    def gap(self, row: int) -> Gap:
        """Return the gap that a row's repair fills."""
        return self._rows[row][0]

    def row_of(self, gap: Gap) -> int | None:
        """Return the row of a gap's repair."""
        rows = (row for row, (other, _) in enumerate(self._rows) if other == gap)
        return next(rows, None)

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if section in NUMBERS else LEFT
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        return (INDENT if section in INDENTED else "") + self._columns[section]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        gap, repair = self._rows[index.row()]
        column = index.column()
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if column in NUMBERS else LEFT
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(gap, repair)
        if role == SORT_ROLE:
            return self._key(gap, repair, column)
        return self._text(gap, repair, column) if role == Qt.ItemDataRole.DisplayRole else None

    def _key(self, gap: Gap, repair: Repair, column: int) -> str | float | int:
        error = repair.patch.expected_error
        keys = {1: gap.start, 2: gap.length, 4: error if np.isfinite(error) else np.inf}
        return keys.get(column, self._text(gap, repair, column))

    def _text(self, gap: Gap, repair: Repair, column: int) -> str:
        error = repair.patch.expected_error * self._document.original.mm
        texts = (
            self._document.names[gap.marker],
            frames_text(gap, self._document.original.first_frame),
            str(gap.length),
            method_name(repair.method),
            f"{error:.1f} mm" if np.isfinite(error) else "—",
            self.tr("before") if self._document.is_earlier(gap) else self.tr("now"),
            ", ".join(self._names.get(donor, donor) for donor in repair.donors),
        )
        return texts[column]

    def _tip(self, gap: Gap, repair: Repair) -> str:
        label = self._document.original.labels[gap.marker]
        text = self.tr("{0}: click to go there, Del turns the repair back into a gap").format(label)
        if repair.donors:
            text += "\n" + self.tr("Computed from {0}").format(", ".join(repair.donors))
        return text

    def _refresh(self) -> None:
        self.beginResetModel()
        document, repairs = self._document, self._document.repairs
        self._names = dict(zip(document.labels, document.names, strict=True))
        self._rows = sorted(repairs.items(), key=lambda row: (row[0].start, row[0].marker))
        self.endResetModel()


class _Table(QTableView):
    """A table in which, while nothing is marked, an arrow key marks the row where it is."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        place = self.currentIndex()
        if event.key() in ARROWS and place.isValid() and not self.selectionModel().hasSelection():
            self.selectRow(place.row())
        else:
            super().keyPressEvent(event)


class RepairTable(QWidget):
    """The list of the repairs; the current one is the view state's gap."""

    def __init__(self, document: Document, view: ViewState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self._following = False
        self._row = -1
        self._scrolled = 0
        self._model = RepairModel(document)
        self._model.setParent(self)
        self._proxy = QSortFilterProxyModel(self)
        self._proxy.setSourceModel(self._model)
        self._proxy.setSortRole(SORT_ROLE)
        self.table = self._make_table(max(document.names, key=len, default=""))
        self._empty = QLabel(self.tr("Nothing is repaired yet. Repairs are listed here."))
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._pages = QStackedLayout(self)
        self.setContentsMargins(4, 4, 4, 4)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(self.table)
        self.setFocusProxy(self.table)
        self._model.modelAboutToBeReset.connect(self._keep_place)
        self._model.modelReset.connect(self._show_page)
        view.gap_changed.connect(self._follow)
        self._show_page()

    def _make_table(self, longest: str) -> QTableView:
        table = _Table()
        dress(table)
        table.setModel(self._proxy)
        table.setSortingEnabled(True)
        table.sortByColumn(-1, Qt.SortOrder.AscendingOrder)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        table.setAccessibleName(self.tr("Repairs"))
        table.setItemDelegateForColumn(0, LabelDelegate(table))
        advance = table.fontMetrics().horizontalAdvance
        texts = {
            0: longest,
            1: "000000 – 000000",
            2: "00000",
            3: INDENT + max(map(method_name, METHODS), key=advance),
            4: "0000.0 mm",
            5: INDENT + self.tr("before"),
        }
        headers = [str(self._model.headerData(i, Qt.Orientation.Horizontal)) for i in range(7)]
        widths = {i: max(advance(text), advance(headers[i])) + 24 for i, text in texts.items()}
        widths[0] = min(widths[0], WIDEST_MARKER)
        narrow(table, widths, stretched=6)
        for column in INDENTED:
            table.setItemDelegateForColumn(column, Indented(table))
        table.clicked.connect(self._go_to)
        table.selectionModel().selectionChanged.connect(self._lead)
        return table

    def _keep_place(self) -> None:
        self._scrolled = self.table.verticalScrollBar().value()

    def _show_page(self) -> None:
        self._pages.setCurrentWidget(self.table if self._model.rowCount() else self._empty)
        self.table.verticalScrollBar().setValue(self._scrolled)
        self._follow(self._view.gap)

    def _go_to(self, index: QModelIndex) -> None:
        self._view.go_to(self._model.gap(self._proxy.mapToSource(index).row()))

    def _lead(self) -> None:
        """Go to the repair that the user has marked: it is what Del reverts."""
        chosen = self.table.selectionModel().selectedRows()
        if chosen and not self._following:
            self._go_to(chosen[0])

    def _follow(self, gap: Gap | None) -> None:
        """Mark the repair of the current gap."""
        self._following = True
        row = None if gap is None else self._model.row_of(gap)
        if row is None:
            self._mark_none()
        else:
            place = self._proxy.mapFromSource(self._model.index(row, 0))
            flags = QItemSelectionModel.SelectionFlag
            self.table.selectionModel().setCurrentIndex(place, flags.ClearAndSelect | flags.Rows)
            self.table.scrollTo(place)
            self._row = place.row()
        self._following = False

    def _mark_none(self) -> None:
        """Mark no row, but keep the place: a repair that was reverted gives its own to the next."""
        place = self._proxy.index(min(self._row, self._proxy.rowCount() - 1), 0)
        self.table.clearSelection()
        self.table.selectionModel().setCurrentIndex(
            place, QItemSelectionModel.SelectionFlag.NoUpdate
        )
