"""The table of proposed labels: piece, label now and then, how sure, and why."""

from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QEvent,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QBrush, QColor, QKeyEvent, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from mocapmend.document import Document
from mocapmend.label_review import Decision, LabelReview
from mocapmend.theme import Theme
from mocapmend.views.engine_texts import shown
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.tables import INDENT, LEFT, RIGHT, Indented, dress, frames_text, narrow
from mocapmend_algorithms import Gap

Index = QModelIndex | QPersistentModelIndex
NO_PARENT = QModelIndex()
SHARE_ROLE = Qt.ItemDataRole.UserRole
ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
REJECT = {Qt.Key.Key_Delete, Qt.Key.Key_Backspace}
WIDEST_NAME = 160
"""Pixels."""
PADDING = 18


class Column(IntEnum):
    """What is listed."""

    STATUS = 0
    NOW = 1
    FRAMES = 2
    LABEL = 3
    SURE = 4
    REASON = 5


INDENTED = (Column.LABEL, Column.REASON)


class LabelModel(QAbstractTableModel):
    """One row per piece, the least sure first."""

    def __init__(self, document: Document, theme: Theme) -> None:
        super().__init__()
        self._document = document
        self._theme = theme
        self.review: LabelReview | None = None
        """What is listed."""
        self._titles = {
            Column.STATUS: "",
            Column.NOW: self.tr("Now"),
            Column.FRAMES: self.tr("Frames"),
            Column.LABEL: self.tr("Proposed"),
            Column.SURE: self.tr("Sure"),
            Column.REASON: self.tr("Reason"),
        }

    def show(self, review: LabelReview | None) -> None:
        """List other proposals."""
        self.beginResetModel()
        self.review = review
        self.endResetModel()

    def set_theme(self, theme: Theme) -> None:
        """Colour the rows for another theme."""
        self._theme = theme
        self.refresh()

    def refresh(self) -> None:
        """Show what the user has said about the rows."""
        if self.rowCount():
            last = self.index(self.rowCount() - 1, len(Column) - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() or self.review is None else len(self.review)

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(Column)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        column = Column(section)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if column is Column.FRAMES else LEFT
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        return (INDENT if column in INDENTED else "") + self._titles[column]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        assert self.review is not None
        row, column = index.row(), Column(index.column())
        if role == Qt.ItemDataRole.DisplayRole:
            return self._text(self.review, row, column)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if column is Column.FRAMES else LEFT
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(self.review, row)
        if role == SHARE_ROLE and column is Column.SURE:
            return self.review.proposal(row).confidence
        if role == Qt.ItemDataRole.ForegroundRole and not self.review.used(row):
            return QBrush(QColor(self._theme.dim))
        if role == Qt.ItemDataRole.AccessibleTextRole and column is Column.STATUS:
            return self._status(self.review, row)
        return None

    def _text(self, review: LabelReview, row: int, column: Column) -> str:
        proposal = review.proposal(row)
        piece = proposal.piece
        match column:
            case Column.STATUS:
                return self._glyph(review, row)
            case Column.NOW:
                return self._document.names[piece.point]
            case Column.FRAMES:
                return frames_text(Gap(*piece), self._document.original.first_frame)
            case Column.LABEL:
                return review.label(row) or self.tr("no marker")
            case Column.SURE:
                return f"{proposal.confidence:.0%}"
            case Column.REASON:
                return shown(proposal.reason)

    def _glyph(self, review: LabelReview, row: int) -> str:
        if review.decision(row) is Decision.REJECTED:
            return "✕"
        if review.decision(row) is Decision.ACCEPTED:
            return "✔"
        return "•" if review.used(row) else ""

    def _status(self, review: LabelReview, row: int) -> str:
        if review.decision(row) is Decision.REJECTED:
            return self.tr("rejected")
        if review.decision(row) is Decision.ACCEPTED:
            return self.tr("accepted")
        return self.tr("sure enough") if review.used(row) else self.tr("too unsure to be used")

    def _tip(self, review: LabelReview, row: int) -> str:
        return f"{self._status(review, row)}\n{shown(review.proposal(row).reason)}"


class BarDelegate(QStyledItemDelegate):
    """Shows a share as a bar behind its number."""

    def __init__(self, table: QTableView, theme: Theme) -> None:
        super().__init__(table)
        self.theme = theme

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        share = index.data(SHARE_ROLE)
        chosen = bool(option.state & QStyle.StateFlag.State_Selected)
        if share is not None and not chosen:
            bar = option.rect.adjusted(2, 3, -2, -3)
            bar.setWidth(max(1, round(bar.width() * float(share))))
            colour = QColor(self.theme.accent)
            colour.setAlpha(90)
            painter.fillRect(bar, colour)
        super().paint(painter, option, index)


class LabelTable(QTableView):
    """Shows the proposals; Enter accepts one and Delete rejects it.

    Signals
    -------
    accepted, rejected :
        What the user says about the row that is marked.
    """

    accepted = Signal()
    rejected = Signal()

    def __init__(self, document: Document, theme: Theme) -> None:
        super().__init__()
        self.labels = LabelModel(document, theme)
        self.labels.setParent(self)
        dress(self)
        self.setModel(self.labels)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setAccessibleName(self.tr("Proposed labels"))
        self.setItemDelegateForColumn(Column.NOW, LabelDelegate(self))
        for column in INDENTED:
            self.setItemDelegateForColumn(column, Indented(self))
        self._bars = BarDelegate(self, theme)
        self.setItemDelegateForColumn(Column.SURE, self._bars)
        advance = self.fontMetrics().horizontalAdvance
        names = max(map(advance, document.names), default=0)
        widths = {
            Column.STATUS: advance("✔") + PADDING,
            Column.NOW: max(min(names, WIDEST_NAME), advance("MMMMM")) + PADDING,
            Column.FRAMES: advance("00000 – 00000") + PADDING,
            Column.LABEL: advance(INDENT + "MMMMMMM") + PADDING,
            Column.SURE: advance("0000000000"),
        }
        narrow(self, {int(k): width for k, width in widths.items()}, stretched=Column.REASON)

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._bars.theme = theme
        self.labels.set_theme(theme)

    def event(self, event: QEvent) -> bool:
        # Else the window would apply or reopen the repair of a gap.
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            plain = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
            if plain == Qt.KeyboardModifier.NoModifier and event.key() in ENTER | REJECT:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in ENTER:
            self.accepted.emit()
        elif event.key() in REJECT:
            self.rejected.emit()
        else:
            super().keyPressEvent(event)
