"""Asks why gaps stay open: a reason is typed, or one of the usual ones is taken."""

from collections.abc import Mapping

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.files.record_values import LONGEST_TEXT
from mocapmend.files.records import NO_REASON
from mocapmend.views.catalogue.reasons import USUAL
from mocapmend.views.engine_texts import shown
from mocapmend.views.tables import frames_text
from mocapmend_algorithms import Gap

CHARACTERS = 60
"""Width of the field."""
SPACING = 2
_MOVES = {Qt.Key.Key_Up, Qt.Key.Key_Down}


class ReasonDialog(QDialog):
    """A field to type in, and the usual reasons below it; Enter takes what is in the field.

    Parameters
    ----------
    document : Document
        Has the gaps.
    gaps : mapping of Gap to str or None
        What is asked about, with the reasons that are known.
    parent : QWidget
        It is asked over.

    Signals
    -------
    given : str
        The reason; empty where the user gives none.
    """

    given = Signal(str)

    def __init__(self, document: Document, gaps: Mapping[Gap, str | None], parent: QWidget) -> None:
        super().__init__(parent)
        self._document = document
        self._stored = {shown(reason): reason for reason in USUAL}
        self.setWindowTitle(self.tr("Why it stays open"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.about = QLabel(self._about(gaps))
        self.about.setTextFormat(Qt.TextFormat.PlainText)
        self._known = [reason for reason in set(gaps.values()) - NO_REASON if reason is not None]
        self.field = self._make_field()
        self.usual = self._make_list()
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self._give)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        for part in (self.about, self.field, self.usual, buttons):
            layout.addWidget(part)
        layout.setSizeConstraint(QVBoxLayout.SizeConstraint.SetFixedSize)
        self.field.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.KeyPress:
            return False
        if event.key() not in _MOVES:
            return False
        QApplication.sendEvent(self.usual, event)
        return True

    def _about(self, gaps: Mapping[Gap, str | None]) -> str:
        """Say which gaps are asked about, and what becomes of them."""
        if len(gaps) == 1:
            (gap,) = gaps
            text = self.tr("{0}, frame {1}") if gap.length == 1 else self.tr("{0}, frames {1}")
            frames = frames_text(gap, self._document.original.first_frame)
            text = text.format(self._document.names[gap.marker], frames)
        else:
            text = self.tr("{0} gaps").format(len(gaps))
        if None in gaps.values():
            state = self.tr("Left open from now on, for this reason:")
        elif all(gap in self._document.never_of(gap.marker) for gap in gaps):
            state = self.tr("Never to be filled, for this reason:")
        else:
            state = self.tr("Kept open, for this reason:")
        return f"{text}\n{state}"

    def _make_field(self) -> QLineEdit:
        field = QLineEdit()
        field.setAccessibleName(self.tr("The reason"))
        field.setPlaceholderText(self.tr("Type why, or choose below (↑ ↓)"))
        field.setMaxLength(LONGEST_TEXT)
        field.setClearButtonEnabled(True)
        field.setMinimumWidth(CHARACTERS * field.fontMetrics().averageCharWidth())
        if len(self._known) == 1:
            text = shown(self._known[0])
            field.setText(text)
            # From its end: what is seen of a long one is how it begins.
            field.setSelection(len(text), -len(text))
        field.installEventFilter(self)
        return field

    def _make_list(self) -> QListWidget:
        usual = QListWidget()
        usual.setAccessibleName(self.tr("Usual reasons"))
        for text in self._stored:
            usual.addItem(QListWidgetItem(text))
        usual.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        usual.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        usual.setSpacing(SPACING)
        rows = sum(usual.sizeHintForRow(row) + 2 * SPACING for row in range(usual.count()))
        usual.setFixedHeight(rows + 2 * usual.frameWidth())
        usual.currentTextChanged.connect(self.field.setText)
        self.field.textEdited.connect(usual.clearSelection)
        usual.itemClicked.connect(lambda item: self.field.setText(item.text()))
        usual.itemDoubleClicked.connect(self._give)
        return usual

    def _give(self) -> None:
        """Take what is in the field; nothing leaves several reasons as they are."""
        text = " ".join(self.field.text().split())
        if text or len(self._known) < 2:
            self.given.emit(self._stored.get(text, text))
        self.accept()
