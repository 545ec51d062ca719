"""The command palette: type what to do."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QPalette
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.views.fuzzy import ranked
from mocapmend.views.tables import dress
from mocapmend.views.text_scale import fit_text

SIZE = (620, 420)
_MOVES = {Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown}


@dataclass(frozen=True)
class Entry:
    """A line of the palette.

    Attributes
    ----------
    text, place, keys : str
        What it is, the menu that it is in, and its shortcuts.
    run : callable
        Does it.
    refusal : str
        Why it cannot be done now; empty if it can.
    """

    text: str
    place: str
    keys: str
    run: Callable[[], object]
    refusal: str = ""


class Palette(QDialog):
    """A field to type in, and below it what fits; Enter does the chosen line, Escape nothing."""

    def __init__(self, entries: Sequence[Entry], parent: QWidget) -> None:
        super().__init__(parent)
        self._entries = list(entries)
        self._shown: list[Entry] = []
        self.setWindowTitle(self.tr("Find an action"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Type what to do: an action, a pane, a recent file"))
        self.field.setAccessibleName(self.tr("What to do"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(self._filter)
        self.field.returnPressed.connect(self._run)
        self.field.installEventFilter(self)
        self.table = QTableWidget(0, 3)
        self.table.setAccessibleName(self.tr("What fits"))
        self.table.setHorizontalHeaderLabels([self.tr("Action"), self.tr("Where"), self.tr("Keys")])
        dress(self.table)
        self.table.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        header = self.table.horizontalHeader()
        header.hide()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.table.itemClicked.connect(self._run)
        self.table.currentCellChanged.connect(self._show_refusal)
        self.hint = QLabel()
        self.hint.setTextFormat(Qt.TextFormat.PlainText)
        layout = QVBoxLayout(self)
        for part in (self.field, self.table, self.hint):
            layout.addWidget(part)
        fit_text(self, *SIZE)
        self._filter("")

    def texts(self) -> list[str]:
        """Return what is offered, in order."""
        return [entry.text for entry in self._shown]

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent):
            return False
        if event.key() not in _MOVES:
            return False
        QApplication.sendEvent(self.table, event)
        return True

    def _filter(self, typed: str) -> None:
        self._shown = self._fitting(typed)
        self.table.setRowCount(len(self._shown))
        dim = self.palette().color(QPalette.ColorGroup.Disabled, QPalette.ColorRole.Text)
        dim_place = self.palette().color(QPalette.ColorRole.PlaceholderText)
        for row, entry in enumerate(self._shown):
            for column, text in enumerate((entry.text, entry.place, entry.keys)):
                item = QTableWidgetItem(text)
                item.setToolTip(entry.refusal)
                if entry.refusal:
                    item.setForeground(dim)
                    font = item.font()
                    font.setItalic(True)
                    item.setFont(font)
                elif column:
                    item.setForeground(dim_place)
                self.table.setItem(row, column, item)
        if self._shown:
            self.table.setCurrentCell(0, 0)
        self._show_refusal()

    def _fitting(self, typed: str) -> list[Entry]:
        """Return what fits what is typed, the best first."""
        order = ranked(typed, [f"{entry.text} {entry.place}" for entry in self._entries])
        return [self._entries[k] for k in order]

    def _show_refusal(self) -> None:
        row = self.table.currentRow()
        if not self._shown:
            self.hint.setText(self.tr("Nothing fits. Fewer letters find more."))
        elif 0 <= row < len(self._shown):
            self.hint.setText(self._shown[row].refusal or self.tr("Enter does it, Escape closes."))

    def _run(self) -> None:
        row = self.table.currentRow()
        if not 0 <= row < len(self._shown) or self._shown[row].refusal:
            return
        run = self._shown[row].run
        self.accept()
        run()
