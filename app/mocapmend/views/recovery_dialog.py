"""The question what shall become of edits that a crash has left."""

from collections.abc import Sequence

from PySide6.QtCore import QDateTime, QLocale, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.journal import Abandoned
from mocapmend.views.tables import INDENT, RIGHT, Indented, align_right, dress
from mocapmend.views.text_scale import fit_text

SIZE = (560, 260)
EDITS, TIME = 1, 2
"""Columns of numbers."""


class RecoveryDialog(QDialog):
    """Lists recordings with edits that can be recovered.

    Signals
    -------
    recover : Abandoned
        The user wants these edits back. The dialog closes.
    discard : Abandoned
        The user gives these edits up. The dialog closes after the last of them.
    """

    recover = Signal(object)
    discard = Signal(object)

    def __init__(self, parent: QWidget, abandoned: Sequence[Abandoned]) -> None:
        super().__init__(parent)
        self._abandoned = list(abandoned)
        self.setWindowTitle(self.tr("Recover edits"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        text = QLabel(
            self.tr(
                "The program ended before these edits were exported. Recover opens the recording "
                "with the edits, which can still be undone; the file itself is not changed."
            )
        )
        text.setWordWrap(True)
        self._table = self._make_table()
        kinds = QDialogButtonBox.ButtonRole
        buttons = QDialogButtonBox()
        self.recover_button = buttons.addButton(self.tr("Recover"), kinds.AcceptRole)
        self.recover_all_button = buttons.addButton(self.tr("Recover all"), kinds.ActionRole)
        self.recover_all_button.setVisible(len(abandoned) > 1)
        self.discard_button = buttons.addButton(self.tr("Discard"), kinds.DestructiveRole)
        self.later_button = buttons.addButton(self.tr("Later"), kinds.RejectRole)
        self.recover_button.clicked.connect(self._recover)
        self.recover_all_button.clicked.connect(self._recover_all)
        self.discard_button.clicked.connect(self._discard)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(text)
        layout.addWidget(self._table)
        layout.addWidget(buttons)
        # Not before: a button is the default one of the dialog that it is in.
        self.recover_button.setDefault(True)
        self._table.setFocus()
        fit_text(self, *SIZE)

    def _make_table(self) -> QTableWidget:
        headers = [self.tr("Recording"), self.tr("Edits"), INDENT + self.tr("Last edit")]
        table = QTableWidget(len(self._abandoned), len(headers))
        table.setHorizontalHeaderLabels(headers)
        table.setAccessibleName(self.tr("Recordings with edits that can be recovered"))
        dress(table)
        table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        for row, each in enumerate(self._abandoned):
            moment = QDateTime.fromSecsSinceEpoch(int(each.time))
            when = QLocale().toString(moment, QLocale.FormatType.ShortFormat)
            path = each.subject.path
            for column, text in enumerate((path.name, str(each.edits), when)):
                item = QTableWidgetItem(text)
                item.setToolTip(str(path))
                if column == EDITS:
                    item.setTextAlignment(RIGHT)
                table.setItem(row, column, item)
        align_right(table, (EDITS,))
        table.setItemDelegateForColumn(TIME, Indented(table))
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        table.selectRow(0)
        table.itemActivated.connect(self._recover)
        return table

    def _recover(self) -> None:
        self.accept()
        self.recover.emit(self._abandoned[self._table.currentRow()])

    def _recover_all(self) -> None:
        self.accept()
        for each in self._abandoned:
            self.recover.emit(each)

    def _discard(self) -> None:
        row = self._table.currentRow()
        self.discard.emit(self._abandoned.pop(row))
        self._table.removeRow(row)
        self.recover_all_button.setVisible(len(self._abandoned) > 1)
        if not self._abandoned:
            self.accept()
