"""The report's texts: the methods paragraph to be copied, and the history of the edits."""

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.report import EditRow, Methods
from mocapmend.views.engine_texts import shown
from mocapmend.views.report_facts import ReportFacts
from mocapmend.views.tables import INDENT, RIGHT, Indented, align_right, dress, narrow

WHAT, STATE = 1, 6


class MethodsPage(QWidget):
    """The paragraph for a paper, and a button that copies it. It is English in every language."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.text = QPlainTextEdit()
        self.text.setReadOnly(True)
        self.text.setTabChangesFocus(True)
        self.text.setAccessibleName(self.tr("Methods paragraph"))
        self.text.setPlaceholderText(self.tr("Being computed…"))
        self.copy = QPushButton(self.tr("Copy"))
        self.copy.setAccessibleName(self.tr("Copy the methods paragraph"))
        self.copy.setEnabled(False)
        self.copy.clicked.connect(self._copy)
        self._said = QLabel(self.tr("Ready to paste into a paper, in English."))
        self._said.setWordWrap(True)
        side = QVBoxLayout()
        side.addWidget(self.copy)
        side.addWidget(self._said)
        side.addStretch(1)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.text, 1)
        layout.addLayout(side)
        self.setFocusProxy(self.text)

    def show_methods(self, methods: Methods) -> None:
        """Show another paragraph; the place in it stays."""
        if methods.text == self.text.toPlainText():
            return
        place = self.text.verticalScrollBar().value()
        self.text.setPlainText(methods.text)
        self.text.verticalScrollBar().setValue(place)
        self.copy.setEnabled(True)
        self._said.setText(self.tr("Ready to paste into a paper, in English."))

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text.toPlainText())
        self._said.setText(self.tr("Copied."))


class HistoryPage(QWidget):
    """The undoable steps, in order; those that were undone are said to be."""

    def __init__(
        self, document: Document, facts: ReportFacts, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._facts = facts
        self.table = self._make_table()
        self._empty = QLabel(self.tr("Nothing is edited yet. Edits are listed here."))
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(self.table)
        self.setFocusProxy(self.table)
        # Later: a stack that is being destroyed tells that it is empty.
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._show)
        document.undo_stack.indexChanged.connect(self._timer.start)
        self._show()

    def _make_table(self) -> QTableWidget:
        titles = [
            self.tr("Step"),
            INDENT + self.tr("What"),
            self.tr("Markers"),
            self.tr("Runs"),
            self.tr("Samples filled"),
            self.tr("Samples set missing"),
            INDENT + self.tr("State"),
        ]
        table = QTableWidget(0, len(titles))
        table.setHorizontalHeaderLabels(titles)
        align_right(table, set(range(len(titles))) - {WHAT, STATE})
        table.setAccessibleName(self.tr("History of edits"))
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        dress(table)
        advance = table.fontMetrics().horizontalAdvance
        widths = {i: advance(title) + 24 for i, title in enumerate(titles) if i != WHAT}
        widths[STATE] = advance(INDENT + self.tr("undone")) + 24
        narrow(table, widths, stretched=WHAT)
        for column in (WHAT, STATE):
            table.setItemDelegateForColumn(column, Indented(table))
        return table

    def _show(self) -> None:
        rows = [(row, self.tr("done")) for row in self._facts.edits()]
        rows += [(row, self.tr("undone")) for row in self._facts.undone()]
        earlier = sum(map(self._document.is_earlier, self._document.repairs))
        if earlier:
            text = self.tr("{0} repairs that the file had when it was opened").format(earlier)
            known = [gap for gap in self._document.repairs if self._document.is_earlier(gap)]
            samples = sum(gap.length for gap in known)
            before = EditRow(text, len({gap.marker for gap in known}), earlier, samples)
            rows.insert(0, (before, self.tr("before")))
        self.table.setRowCount(len(rows))
        first = 0 if earlier else 1
        for place, (row, state) in enumerate(rows):
            numbers = (row.markers, row.runs, row.filled, row.cleared)
            texts = (str(place + first), shown(row.text), *map(str, numbers), state)
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                if column not in (WHAT, STATE):
                    item.setTextAlignment(RIGHT)
                self.table.setItem(place, column, item)
        self._pages.setCurrentWidget(self.table if rows else self._empty)
        self.table.scrollToBottom()
