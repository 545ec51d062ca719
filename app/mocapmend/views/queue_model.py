"""The problems of a document as a table, filtered and in an order."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtCore import QAbstractTableModel, QObject, Qt, Signal

from mocapmend.document import Document
from mocapmend.problem_list import ALL_KINDS, Places, ProblemList
from mocapmend.prospects import Prospects
from mocapmend.ranking import Problem, Status
from mocapmend.suspects import Suspects
from mocapmend.views.marker_table import NO_PARENT, Index
from mocapmend.views.queue_texts import Column, QueueTexts
from mocapmend.views.tables import LEFT, RIGHT
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun

CENTRE = Qt.AlignmentFlag.AlignCenter


_ORDER_OF = {
    Column.STATUS: "status", Column.MARKER: "marker", Column.KIND: "kind", Column.FRAMES: "length",
    Column.ERROR: "error", Column.HARM: "harm", Column.MS: "length", Column.PLACE: "time",
}  # fmt: skip
TO_DO = frozenset({Status.OPEN, Status.BEYOND, Status.FOUND})


@dataclass(frozen=True)
class Filter:
    """Which problems are listed.

    Attributes
    ----------
    text : str
        Part of the marker's name.
    status : frozenset of Status
        What may have become of them.
    shortest_ms, longest_ms : float
        Bounds of the length: longer than the first, up to the second.
    kinds : tuple of str
        Gaps, or kinds of bad samples.
    """

    text: str = ""
    status: frozenset[Status] = TO_DO
    shortest_ms: float = 0.0
    longest_ms: float = math.inf
    kinds: tuple[str, ...] = ALL_KINDS


class QueueModel(QAbstractTableModel):
    """One row per problem that passes the filter."""

    changed = Signal()

    def __init__(
        self,
        document: Document,
        prospects: Prospects,
        suspects: Suspects,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self.texts = QueueTexts(document, self)
        self._filter = Filter()
        self._order = (Column.HARM, True)
        self._list = ProblemList(document, prospects, suspects)
        self._stale = False
        self._rows = np.empty(0, np.intp)
        """The place in the list of what each row shows."""
        self._row_at = np.empty(0, np.intp)
        """The row that shows what is at a place; -1 where none does."""
        self._titles = {
            Column.STATUS: "",
            Column.MARKER: self.tr("Marker"),
            Column.KIND: self.tr("Kind"),
            Column.FRAMES: self.tr("Frames"),
            Column.ERROR: self.tr("Error"),
            Column.HARM: self.tr("Harm"),
            Column.MS: self.tr("ms"),
            Column.METHOD: self.tr("Best"),
            Column.CONTEXT: self.tr("Context"),
            Column.PLACE: self.tr("Place"),
        }
        self._tips = {
            Column.STATUS: self.tr("What has become of the problem"),
            Column.KIND: self.tr("A gap, or what is wrong with the samples"),
            Column.FRAMES: self.tr("Frames that are missing or bad"),
            Column.ERROR: self.tr(
                "Expected error of the best repair that was tried, or how far bad samples are off, "
                "in mm"
            ),
            Column.HARM: self.tr("Error times frames: what comes first is worst"),
            Column.METHOD: self.tr("The method with the least expected error"),
            Column.CONTEXT: self.tr(
                "Where the gap lies, and how many other markers are missing in its middle"
            ),
            Column.PLACE: self.tr("First and last missing frame"),
        }
        document.samples_changed.connect(self.take_anew)
        document.left_open_changed.connect(self.take_anew)
        self.refresh()

    # --- what is listed ----------------------------------------------------------------------

    @property
    def gaps(self) -> list[Gap]:
        """Where the problems that are listed are, in their order."""
        return [self._list.gaps[place] for place in self._rows.tolist()]

    @property
    def total(self) -> int:
        """How many problems there are, listed or not."""
        return len(self._list.gaps)

    @property
    def by_time(self) -> bool:
        """Whether the list is in the order of time: chosen so, or because nothing else is known."""
        column, falling = self._order
        unknown = column in (Column.HARM, Column.ERROR) and not self._list.tried[self._rows].any()
        return bool(unknown) or (column == Column.PLACE and not falling)

    def row_of(self, gap: Gap) -> int | None:
        """Return the row of a gap."""
        place = self._list.place_of(gap)
        row = -1 if place is None or place >= len(self._row_at) else int(self._row_at[place])
        return row if row >= 0 else None

    def row_of_bad(self, run: BadRun) -> int | None:
        """Return the row of a run of bad samples."""
        place = self._list.place_of_bad(run)
        row = -1 if place is None or place >= len(self._row_at) else int(self._row_at[place])
        return row if row >= 0 else None

    @property
    def has_bad(self) -> bool:
        """Whether any bad samples are listed."""
        return bool(self._list.kind[self._rows].any())

    def bad(self, row: int) -> BadRun | None:
        """Return the bad samples of a row; None where a gap is listed."""
        return self._list.bad(int(self._rows[row]))

    def problem(self, row: int) -> Problem:
        """Return what is listed in a row."""
        return self._list.problem(int(self._rows[row]))

    def take_anew(self) -> None:
        """List other bad samples the next time."""
        self._stale = True

    def set_filter(self, chosen: Filter) -> None:
        """List other problems."""
        self._filter = chosen
        self.refresh()

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        wanted = (column, order == Qt.SortOrder.DescendingOrder)
        if 0 <= column < len(Column) and wanted != self._order:
            self._order = (Column(column), order == Qt.SortOrder.DescendingOrder)
            self.refresh()

    def refresh(self) -> None:
        """List the problems anew, or what has become known of them."""
        before = None if self._stale else self._rows
        if self._stale:
            self._list.take()
            self._stale = False
        else:
            self._list.learn()
        rows = self._in_order(self._passing())
        if before is not None and np.array_equal(rows, before):
            self._tell_values()
        else:
            self.beginResetModel()
            self._rows = rows
            self._row_at = np.full(len(self._list.gaps), -1)
            self._row_at[rows] = np.arange(len(rows))
            self.endResetModel()
        self.changed.emit()

    def _tell_values(self) -> None:
        """Say that rows are where they were, but may show something else."""
        if len(self._rows):
            last = self.index(len(self._rows) - 1, len(Column) - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    def _passing(self) -> Places:
        chosen, names = self._filter, self._document.names
        part = chosen.text.casefold()
        markers = [marker for marker, name in enumerate(names) if part in name.casefold()]
        per_ms = self._document.original.rate / 1000.0
        return self._list.passing(
            markers,
            chosen.status,
            chosen.shortest_ms * per_ms,
            chosen.longest_ms * per_ms,
            chosen.kinds,
        )

    def _in_order(self, places: Places) -> Places:
        listed, (column, falling) = self._list, self._order
        values = {
            Column.STATUS: listed.status, Column.MARKER: listed.marker, Column.KIND: listed.kind,
            Column.FRAMES: listed.length, Column.ERROR: listed.error,
            Column.HARM: listed.error * listed.length, Column.MS: listed.length,
            Column.PLACE: listed.start,
        }  # fmt: skip
        if column in values:
            return listed.ordered(places, values[column], falling=falling)
        texts = [self.texts.text(listed.problem(place), column) for place in places.tolist()]
        number = np.zeros(len(listed.gaps))
        number[places] = np.unique(texts, return_inverse=True)[1]
        return listed.ordered(places, number, falling=falling)

    # --- Qt's questions ----------------------------------------------------------------------

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(Column)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return self._titles[Column(section)]
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tips.get(Column(section))
        return _alignment(Column(section)) if role == Qt.ItemDataRole.TextAlignmentRole else None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        problem, column = self.problem(index.row()), Column(index.column())
        if role == Qt.ItemDataRole.DisplayRole:
            return self.texts.text(problem, column)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(column)
        if role == Qt.ItemDataRole.ToolTipRole:
            return self.texts.tip(problem)
        if role == Qt.ItemDataRole.AccessibleTextRole and column == Column.STATUS:
            return self.texts.status_text(problem.status)
        return None


def _alignment(column: Column) -> Qt.AlignmentFlag:
    if column == Column.STATUS:
        return CENTRE
    numbers = (Column.FRAMES, Column.ERROR, Column.HARM, Column.MS)
    return RIGHT if column in numbers else LEFT
