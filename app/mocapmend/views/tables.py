"""The look that all tables share."""

from typing import Any

from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStyledItemDelegate, QTableView


def dress(table: QTableView) -> None:
    """Make a table compact: whole rows, no grid, no row numbers, Tab leaves it."""
    table.setShowGrid(False)
    table.setWordWrap(False)
    table.setTabKeyNavigation(False)
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + 6)
    table.horizontalHeader().setHighlightSections(False)


def narrow(table: QTableView, widths: dict[int, int], stretched: int = 0) -> None:
    """Give some columns a width in pixels, and one of them the rest."""
    header = table.horizontalHeader()
    header.setMinimumSectionSize(30)
    header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    header.setSectionResizeMode(stretched, QHeaderView.ResizeMode.Stretch)
    for column, width in widths.items():
        header.resizeSection(column, width)


INDENT = "   "


class Indented(QStyledItemDelegate):
    """Keeps the texts of a column off the numbers of the one before it."""

    def displayText(self, value: Any, locale: QLocale | QLocale.Language) -> str:
        return INDENT + super().displayText(value, locale)
