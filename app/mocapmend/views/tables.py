"""The look that all tables share."""

from collections.abc import Iterable
from typing import Any

from PySide6.QtCore import QEvent, QLocale, QObject, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionHeader,
    QTableView,
    QTableWidget,
    QWidget,
)

from mocapmend_algorithms import Gap

DIGITS = "0123456789"
LEAST_SECTION = 30
"""Pixels of a column, whatever it holds."""
MARK_ROOM = "\N{EN SPACE}"
RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


def in_sight(widget: QWidget) -> bool:
    """Say whether any of a widget can be seen: what is behind another tab is visible for Qt."""
    # What its children cover has nothing of its own to be seen.
    parts = (widget, *widget.findChildren(QWidget))
    return widget.isVisible() and any(not part.visibleRegion().isEmpty() for part in parts)


def frames_text(gap: Gap, first_frame: int) -> str:
    """Write the frames of a gap as the file counts them, beginning with `first_frame`."""
    first, last = gap.start + first_frame, gap.stop - 1 + first_frame
    return str(first) if first == last else f"{first} – {last}"


def dress(table: QTableView) -> None:
    """Make a table compact: whole rows, no grid, no row numbers, Tab leaves it.

    It gets another header: how columns are sorted and sized is said afterwards.
    """
    table.setHorizontalHeader(Header(table))
    table.setShowGrid(False)
    table.setWordWrap(False)
    table.setTabKeyNavigation(False)
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
    table.verticalHeader().hide()
    RowHeights(table)


def align_right(table: QTableWidget, columns: Iterable[int]) -> None:
    """Put the titles of columns of numbers above their last digits."""
    for column in columns:
        title = table.horizontalHeaderItem(column)
        assert title is not None
        title.setTextAlignment(RIGHT)


class Header(QHeaderView):
    """Titles of columns, at the left where a model says nothing else."""

    def __init__(self, table: QTableView) -> None:
        super().__init__(Qt.Orientation.Horizontal, table)
        self.setSectionsClickable(True)
        self.setHighlightSections(False)
        self.setDefaultAlignment(LEFT)

    def initStyleOptionForIndex(
        self,
        option: QStyleOptionHeader,
        logicalIndex: int,  # noqa: N803 - Qt's own name
    ) -> None:
        super().initStyleOptionForIndex(option, logicalIndex)
        sorts = option.sortIndicator != QStyleOptionHeader.SortIndicator.None_
        if sorts and option.textAlignment & Qt.AlignmentFlag.AlignRight:
            # The mark of the sorted column must not lie on its title.
            option.text += MARK_ROOM


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
        header = self._table.horizontalHeader()
        widths = {column: round(width * scale) for column, width in self._widths.items()}
        # What has the rest of the room must be legible too: the table is scrolled then.
        header.setMinimumSectionSize(max(LEAST_SECTION, min(widths.values())))
        for column, width in widths.items():
            header.resizeSection(column, width)


INDENT = "   "


class Indented(QStyledItemDelegate):
    """Keeps the texts of a column off the numbers of the one before it."""

    def displayText(self, value: Any, locale: QLocale | QLocale.Language) -> str:
        return INDENT + super().displayText(value, locale)
