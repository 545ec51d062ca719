"""The list of the repair methods, grouped by family."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QComboBox, QWidget

from mocapmend.views.engine_texts import method_text
from mocapmend_algorithms.fill.registry import FAMILIES, METHODS, Family, Method

INDENT = "   "


class MethodBox(QComboBox):
    """Chooses a method; the names of the families between them cannot be chosen."""

    def __init__(self, chosen: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(self.tr("Method"))
        self.setModel(self._make_items())
        self.setMaxVisibleItems(self.count())
        self._choices = [row for row in range(self.count()) if self.itemData(row) is not None]
        self.setCurrentIndex(max(self._choices[0], self.findData(chosen)))

    @property
    def method(self) -> Method:
        """The chosen method."""
        return METHODS[str(self.currentData())]

    def step(self, step: int) -> None:
        """Choose the next or the previous method of the list, round and round."""
        place = self._choices.index(self.currentIndex()) + step
        self.setCurrentIndex(self._choices[place % len(self._choices)])

    def _make_items(self) -> QStandardItemModel:
        items = QStandardItemModel(self)
        for family in FAMILIES:
            members = [method for method in METHODS.values() if method.family == family]
            if members and family != "Automatic":
                items.appendRow(self._heading(family))
            for method in members:
                item = QStandardItem(method_text(method.label))
                item.setData(method.id, Qt.ItemDataRole.UserRole)
                item.setToolTip(method_text(method.help))
                items.appendRow(item)
        return items

    def _heading(self, family: Family) -> QStandardItem:
        item = QStandardItem(method_text(family))
        item.setFlags(Qt.ItemFlag.NoItemFlags)
        font = self.font()
        font.setBold(True)
        item.setFont(font)
        return item
