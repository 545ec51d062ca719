"""The steps of the undo history: done ones, undone ones, and the one that is exported."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex
from PySide6.QtGui import QPalette, QUndoStack
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem, QUndoView

from mocapmend.views.engine_texts import shown

Index = QModelIndex | QPersistentModelIndex


class HistoryPane(QUndoView):
    """A list of all steps; a click or the arrow keys go back or forward to one."""

    def __init__(self, stack: QUndoStack) -> None:
        super().__init__(stack)
        self._stack = stack
        self.setAccessibleName(self.tr("History"))
        self.setToolTip(self.tr("Click a step, or use the arrow keys, to go back or forward to it"))
        self.setEmptyLabel(self.tr("As opened"))
        self.setItemDelegate(StepDelegate(self))
        self.setSpacing(2)
        stack.cleanChanged.connect(self.viewport().update)
        stack.indexChanged.connect(self.viewport().update)

    def row_text(self, row: int) -> str:
        """Return what is shown of a step; row 0 is the recording as it was opened."""
        text = self.emptyLabel() if row == 0 else f"{row}. {shown(self._stack.text(row - 1))}"
        if row > self._stack.index():
            text = self.tr("{0} (undone)").format(text)
        # A recording that was just opened is clean, but nothing was exported.
        if row and row == self._stack.cleanIndex():
            text = self.tr("{0} ✔ exported").format(text)
        return text


class StepDelegate(QStyledItemDelegate):
    """Shows the texts of the pane's rows; undone steps are dimmed."""

    def __init__(self, pane: HistoryPane) -> None:
        super().__init__(pane)
        self._pane = pane

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        option.text = self._pane.row_text(index.row())
        if index.row() > self._pane.stack().index():
            dim = option.palette.color(QPalette.ColorRole.PlaceholderText)
            option.palette.setColor(QPalette.ColorRole.Text, dim)
