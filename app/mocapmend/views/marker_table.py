"""The marker list: names, how much of each marker is missing, and in how many gaps."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QAction, QBrush, QColor, QKeyEvent, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QLabel,
    QLineEdit,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.renaming import without_label
from mocapmend.state import SampleState
from mocapmend.theme import Theme
from mocapmend.views.engine_texts import segment_name, smoother_name
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.tables import LEFT, RIGHT, dress, narrow
from mocapmend.viewstate import ViewState

Index = QModelIndex | QPersistentModelIndex
NO_PARENT = QModelIndex()
SORT_ROLE = Qt.ItemDataRole.UserRole
TABLE_WIDTH = 180


class MarkerModel(QAbstractTableModel):
    """One row per marker: label, % missing, open gaps, longest gap, repaired samples.

    Signals
    -------
    renamed : int, str
        A marker and the name that the user has typed for it.
    """

    renamed = Signal(int, str)

    def __init__(self, document: Document, theme: Theme) -> None:
        super().__init__()
        self._document = document
        self._theme = theme
        self._columns = (
            self.tr("Marker"),
            self.tr("Missing"),
            self.tr("Gaps"),
            self.tr("Longest"),
        )
        document.samples_changed.connect(self._refresh)
        document.names_changed.connect(self._rename)
        self._nameless = frozenset(without_label(document.labels))

    def set_theme(self, theme: Theme) -> None:
        """Colour the rows for another theme."""
        self._theme = theme
        self._refresh()

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else self._document.original.markers

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._columns)

    @property
    def nameless(self) -> int:
        """Number of points without a label."""
        return len(self._nameless)

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        return flags | Qt.ItemFlag.ItemIsEditable if index.column() == 0 else flags

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.EditRole or index.column():
            return False
        if str(value) != self._document.names[index.row()]:
            self.renamed.emit(index.row(), str(value))
        return True

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if section else LEFT
        return self._columns[section] if role == Qt.ItemDataRole.DisplayRole else None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        marker, column = index.row(), index.column()
        if role == Qt.ItemDataRole.TextAlignmentRole and column:
            return RIGHT
        if role == Qt.ItemDataRole.ForegroundRole:
            return self._brush(marker)
        if role == Qt.ItemDataRole.ToolTipRole:
            unknown = self.tr("Nobody has said which marker this is.")
            tip = self._tip(marker)
            return f"{tip}\n{unknown}" if marker in self._nameless else tip
        if role == Qt.ItemDataRole.EditRole and not column:
            return self._document.names[marker]
        if role not in (Qt.ItemDataRole.DisplayRole, SORT_ROLE):
            return None
        value = self._value(marker, column)
        if role == SORT_ROLE or isinstance(value, str):
            return value
        if column == 1:
            return "—" if value == 0 else f"{value:.1f} %"
        return str(value) if value else "—"

    def _value(self, marker: int, column: int) -> str | float | int:
        gaps = self._document.gaps_of(marker)
        if column == 0:
            return self._document.names[marker]
        if column == 1:
            frames = max(1, self._document.original.frames)
            return 100.0 * sum(gap.length for gap in gaps) / frames
        if column == 2:
            return len(gaps)
        return max((gap.length for gap in gaps), default=0)

    def _brush(self, marker: int) -> QBrush | None:
        gaps, frames = self._document.gaps_of(marker), self._document.original.frames
        if marker in self._nameless or (gaps and gaps[0].length == frames):
            return QBrush(QColor(self._theme.dim))
        return None

    def _tip(self, marker: int) -> str:
        gaps, original = self._document.gaps_of(marker), self._document.original
        label = original.labels[marker]
        if gaps and gaps[0].length == original.frames:
            return self.tr("{0}: never seen in this recording").format(label)
        filled = int(np.diff(self._document.runs(marker, SampleState.FILLED), axis=1).sum())
        longest = max((gap.length for gap in gaps), default=0)
        tip = self.tr("{0}: open gaps {1}, longest {2} frames ({3} ms), {4} samples filled").format(
            label, len(gaps), longest, round(1000.0 * longest / original.rate), filled
        )
        aside = int(np.diff(self._document.runs(marker, SampleState.BAD), axis=1).sum())
        bad = self.tr("{0} samples set aside").format(aside) if aside else ""
        return "\n".join(filter(None, (tip, bad, self._smoothed(marker), self._segment(marker))))

    def _smoothed(self, marker: int) -> str:
        """Say how it is smoothed."""
        made = [how for run, how in self._document.smoothed.items() if run.marker == marker]
        if not made:
            return ""
        methods = ", ".join(dict.fromkeys(smoother_name(how.method) for how in made))
        moved = max(how.rms for how in made) * self._document.original.mm
        samples = int(np.diff(self._document.runs(marker, SampleState.SMOOTHED), axis=1).sum())
        text = self.tr("{0} samples smoothed: {1}, moved by {2} mm RMS")
        return text.format(samples, methods, f"{moved:.2f}")

    def _segment(self, marker: int) -> str:
        """Say with which markers it moves as one."""
        for part in self._document.skeleton.segments:
            if marker in part.markers:
                others = [self._document.names[m] for m in part.markers if m != marker]
                if others:
                    text = self.tr("Moves as one with {0}").format(", ".join(others))
                    return f"{text} ({segment_name(part.name)})" if part.name else text
        return ""

    def _rename(self) -> None:
        self._nameless = frozenset(without_label(self._document.labels))
        self._refresh()

    def _refresh(self) -> None:
        last = self.index(self.rowCount() - 1, len(self._columns) - 1)
        self.dataChanged.emit(self.index(0, 0), last)


class NameDelegate(LabelDelegate):
    """Lets Enter end the typing of a name, although it is the key of an action too."""

    def eventFilter(self, editor: QObject, event: QEvent) -> bool:
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        ):
            event.accept()
            return True
        return super().eventFilter(editor, event)


class MarkerTable(QWidget):
    """The marker list with a filter; its selection is the view state's.

    Signals
    -------
    renamed : int, str
        A marker and the name that the user has typed for it.
    """

    renamed = Signal(int, str)

    def __init__(
        self, document: Document, view: ViewState, theme: Theme, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setMinimumWidth(TABLE_WIDTH)
        self._view = view
        self._following = False
        self._model = MarkerModel(document, theme)
        self._model.setParent(self)
        self._proxy = QSortFilterProxyModel(self)
        self._proxy.setSourceModel(self._model)
        self._proxy.setSortRole(SORT_ROLE)
        self._proxy.setFilterCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self.filter = QLineEdit()
        self.filter.setPlaceholderText(self.tr("Filter markers"))
        self.filter.setClearButtonEnabled(True)
        self.filter.setAccessibleName(self.tr("Filter markers"))
        self.filter.textChanged.connect(self._set_filter)
        self.table = self._make_table()
        self._model.renamed.connect(self.renamed)
        self.nameless = QLabel()
        self.nameless.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.addWidget(self.filter)
        layout.addWidget(self.table)
        layout.addWidget(self.nameless)
        document.names_changed.connect(self._count_nameless)
        self._count_nameless()
        view.selection_changed.connect(self._follow)

    def set_theme(self, theme: Theme) -> None:
        """Colour the rows for another theme."""
        self._model.set_theme(theme)

    def offer(self, actions: Sequence[QAction]) -> None:
        """Offer actions in the menu of the right mouse button."""
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.table.addActions(list(actions))

    def edit_name(self, marker: int) -> None:
        """Let the user type a marker's name where it stands."""
        if not self._place(marker).isValid():
            self.filter.clear()
        place = self._place(marker)
        self.table.scrollTo(place)
        self.table.setCurrentIndex(place)
        self.table.edit(place)

    def _count_nameless(self) -> None:
        count = self._model.nameless
        text = self.tr("1 point without a label")
        if count != 1:
            text = self.tr("{0} points without a label").format(count)
        self.nameless.setText(text)
        self.nameless.setVisible(bool(count))

    def _make_table(self) -> QTableView:
        table = QTableView()
        dress(table)
        table.setModel(self._proxy)
        table.setSortingEnabled(True)
        table.sortByColumn(-1, Qt.SortOrder.AscendingOrder)
        table.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        table.setAccessibleName(self.tr("Markers"))
        table.setItemDelegateForColumn(0, NameDelegate(table))
        table.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked)
        widths = {}
        for column, widest in ((1, "100.0 %"), (2, "0000"), (3, "00000")):
            texts = (widest, str(self._model.headerData(column, Qt.Orientation.Horizontal)))
            # Room for the margins and the mark of the sorted column.
            widths[column] = max(map(table.fontMetrics().horizontalAdvance, texts)) + 16
        narrow(table, widths)
        table.selectionModel().selectionChanged.connect(self._lead)
        return table

    def _set_filter(self, text: str) -> None:
        """Hide other rows; what is hidden stays selected."""
        self._following = True
        self._proxy.setFilterFixedString(text)
        self._following = False
        self._follow(self._view.selection)

    def _lead(self, chosen: QItemSelection, dropped: QItemSelection) -> None:
        """Take the user's selection over into the view state, the newest marker last."""
        if self._following:
            return
        if self._view.picking:
            for index in chosen.indexes()[:1]:
                self._view.click(self._proxy.mapToSource(index).row())
            self._follow(self._view.selection)
            return
        rows = self.table.selectionModel().selectedRows()
        selected = {self._proxy.mapToSource(row).row() for row in rows}
        kept = tuple(
            marker
            for marker in self._view.selection
            if marker in selected or not self._place(marker).isValid()
        )
        new = tuple(sorted(selected.difference(kept)))
        self._view.select((*kept, *new))

    def _follow(self, markers: tuple[int, ...]) -> None:
        """Show a selection that was made elsewhere."""
        rows = self.table.selectionModel().selectedRows()
        if {self._proxy.mapToSource(row).row() for row in rows} == set(markers):
            return
        chosen = QItemSelection()
        for marker in markers:
            place = self._place(marker)
            if place.isValid():
                chosen.select(place, place)
        flags = QItemSelectionModel.SelectionFlag
        self._following = True
        self.table.selectionModel().select(chosen, flags.ClearAndSelect | flags.Rows)
        self._following = False
        self._show_current()

    def _show_current(self) -> None:
        if self._view.marker is not None:
            self.table.scrollTo(self._place(self._view.marker))

    def _place(self, marker: int) -> QModelIndex:
        """Return where a marker's row is; invalid while the filter hides it."""
        return self._proxy.mapFromSource(self._model.index(marker, 0))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # Only now are the rows laid out.
        QTimer.singleShot(0, self, self._show_current)
