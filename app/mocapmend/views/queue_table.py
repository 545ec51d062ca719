"""The table of the queue: what matters most has room without scrolling."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView

from mocapmend.problem_list import ALL_KINDS
from mocapmend.ranking import METHODS
from mocapmend.views.engine_texts import method_name
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.queue_model import QueueModel
from mocapmend.views.queue_texts import Column
from mocapmend.views.suspect_texts import kind_text
from mocapmend.views.tables import dress

FIRST = (Column.STATUS, Column.KIND, Column.FRAMES, Column.ERROR, Column.HARM)
"""Are seen beside the marker; the others are further to the right."""
PADDING = 10
LEAST_NAME = "MMMMMM"


class QueueTable(QTableView):
    """Shows the problems; the column of markers grows and shrinks with the table.

    Parameters
    ----------
    model : QueueModel
        The problems.
    longest : str
        Name of a marker.
    """

    def __init__(self, model: QueueModel, longest: str) -> None:
        super().__init__()
        self._model = model
        self._longest = longest
        dress(self)
        self.setModel(model)
        header = self.horizontalHeader()
        header.setMinimumSectionSize(20)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setStretchLastSection(True)
        # Before the table sorts: else it does so twice.
        header.setSortIndicator(Column.HARM, Qt.SortOrder.DescendingOrder)
        self.setSortingEnabled(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setAccessibleName(self.tr("Queue of problems"))
        self.setItemDelegateForColumn(Column.MARKER, LabelDelegate(self))
        self.hideColumn(Column.KIND)
        self._fit()

    def show_kinds(self, *, shown: bool) -> None:
        """Show what kind of problem each is, or not: where there are gaps alone it says nothing."""
        if shown == self.isColumnHidden(Column.KIND):
            self.horizontalHeader().setSectionHidden(Column.KIND, not shown)
            self._fit_names()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_names()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._fit()

    def _fit(self) -> None:
        """Give the columns the room that their widest texts need."""
        advance = self.fontMetrics().horizontalAdvance
        widest = {
            Column.STATUS: "⊘",
            Column.KIND: max(map(kind_text, ALL_KINDS), key=advance),
            Column.FRAMES: "0000",
            Column.ERROR: "0000.0",
            Column.HARM: "00000",
            Column.MS: "00000",
            Column.METHOD: max(map(method_name, METHODS), key=len),
            Column.CONTEXT: self.tr("inside, {0} more missing"),
            Column.PLACE: "000000 – 000000",
        }
        for column, text in widest.items():
            title = str(self._model.headerData(column, Qt.Orientation.Horizontal))
            # The mark of the sorted column has room beside its title.
            mark = advance("000") if column == Column.HARM else 0
            width = max(advance(text), advance(title) + mark) + PADDING
            self.horizontalHeader().resizeSection(column, width)
        self._fit_names()

    def _fit_names(self) -> None:
        """Give the names what the first columns leave them."""
        header, advance = self.horizontalHeader(), self.fontMetrics().horizontalAdvance
        room = self.viewport().width() - sum(map(header.sectionSize, FIRST))
        # Where there are bad samples, some are of two markers.
        pairs = not self.isColumnHidden(Column.KIND)
        longest = f"{self._longest} ↔ {self._longest}" if pairs else self._longest
        least, most = advance(LEAST_NAME) + PADDING, advance(longest) + PADDING
        header.resizeSection(Column.MARKER, max(least, min(most, room)))
