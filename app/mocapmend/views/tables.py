"""The look that all tables share."""

from typing import Any

from PySide6.QtCore import QEvent, QLocale, QObject, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyledItemDelegate,
    QTableView,
    QWidget,
)

from mocapmend_algorithms import Gap

DIGITS = "0123456789"
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


def in_sight(widget: QWidget) -> bool:
    """Say whether any of a widget can be seen: what is behind another tab is visible for Qt."""
    return widget.isVisible() and not widget.visibleRegion().isEmpty()


def frames_text(gap: Gap, first_frame: int) -> str:
    """Write the frames of a gap as the file counts them, beginning with `first_frame`."""
    first, last = gap.start + first_frame, gap.stop - 1 + first_frame
    return str(first) if first == last else f"{first} – {last}"


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
    table.horizontalHeader().setHighlightSections(False)
    RowHeights(table)


class RowHeights(QObject):
    """Makes the rows of a table as high as its text needs, also when the text changes its size."""

    def __init__(self, table: QTableView) -> None:
        super().__init__(table)
        self._table = table
        table.installEventFilter(self)
        self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FontChange:
            self._fit()
        return False

    def _fit(self) -> None:
        height = self._table.fontMetrics().height() + 6
        self._table.verticalHeader().setDefaultSectionSize(height)


def narrow(table: QTableView, widths: dict[int, int], stretched: int = 0) -> None:
    """Give some columns a width in pixels, and one of them the rest."""
    header = table.horizontalHeader()
    header.setMinimumSectionSize(30)
    header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    header.setSectionResizeMode(stretched, QHeaderView.ResizeMode.Stretch)
    ColumnWidths(table, widths)


class ColumnWidths(QObject):
    """Keeps columns as wide as texts that had a width at first, when the text changes its size."""

    def __init__(self, table: QTableView, widths: dict[int, int]) -> None:
        super().__init__(table)
        self._table = table
        self._widths = widths
        self._first = table.fontMetrics().horizontalAdvance(DIGITS)
        table.installEventFilter(self)
        self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.FontChange:
            self._fit()
        return False

    def _fit(self) -> None:
        scale = self._table.fontMetrics().horizontalAdvance(DIGITS) / self._first
        for column, width in self._widths.items():
            self._table.horizontalHeader().resizeSection(column, round(width * scale))


INDENT = "   "


class Indented(QStyledItemDelegate):
    """Keeps the texts of a column off the numbers of the one before it."""

    def displayText(self, value: Any, locale: QLocale | QLocale.Language) -> str:
        return INDENT + super().displayText(value, locale)
