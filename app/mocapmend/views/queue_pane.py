"""The queue: every gap and bad run, the most harmful first, to go from one to the next."""

import math
from typing import NamedTuple

from PySide6.QtCore import QItemSelectionModel, QModelIndex, Qt, QTimer
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QSizePolicy,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.navigation import neighbour, place
from mocapmend.problem_list import ALL_KINDS, GAP
from mocapmend.prospects import Prospects
from mocapmend.ranking import Problem, Status
from mocapmend.settings import RANKING, SEARCHING, Settings
from mocapmend.suspects import KINDS, place_of
from mocapmend.views.bad_search import BadSearch
from mocapmend.views.eliding_combo import ElidingCombo
from mocapmend.views.queue_model import TO_DO, Filter, QueueModel
from mocapmend.views.queue_table import QueueTable
from mocapmend.views.survey import Survey
from mocapmend.views.suspect_texts import help_text, kinds_text
from mocapmend.viewstate import ViewState

DELAY_MS = 60
"""Edits and portions of the survey that come together make one new list."""
SECOND = 1000.0
SHORT = 200.0


class _Choice(NamedTuple):
    """An entry of a filter's list."""

    text: str
    value: object
    tip: str = ""


class QueuePane(QWidget):
    """Lists the problems of a document and steps through them."""

    def __init__(
        self,
        document: Document,
        view: ViewState,
        prospects: Prospects,
        survey: Survey,
        search: BadSearch,
        settings: Settings,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._survey = survey
        self._search = search
        self._settings = settings
        self._following = False
        self._place = -1
        """Row of the current problem when it was last listed: what comes next is there."""
        self.model = QueueModel(document, prospects, search.suspects, self)
        self.table = QueueTable(self.model, max(document.names, key=len, default=""))
        self.table.clicked.connect(self._go_to)
        self.table.selectionModel().selectionChanged.connect(self._lead)
        self.filter = QLineEdit()
        self.filter.setPlaceholderText(self.tr("Filter markers"))
        self.filter.setAccessibleName(self.tr("Filter the queue by marker"))
        self.filter.setClearButtonEnabled(True)
        self.filter.textChanged.connect(self._set_filter)
        self.status = self._make_combo(self.tr("Status"), self._statuses())
        self.length = self._make_combo(self.tr("Length"), self._lengths())
        self.kind = self._make_combo(self.tr("Kind of problem"), self._kinds())
        self.rank = QCheckBox(self.tr("Rank"))
        self.rank.setToolTip(
            self.tr("Try repairs on all gaps in the background, so that the worst come first")
        )
        self.rank.setChecked(settings.get(RANKING))
        self.rank.toggled.connect(self._switch_ranking)
        self.look = QCheckBox(self.tr("Search"))
        self.look.setToolTip(self.tr("Look for bad samples in the background"))
        self.look.setChecked(settings.get(SEARCHING))
        self.look.toggled.connect(self._switch_searching)
        self._said = QLabel()
        # What goes on must not widen the pane.
        self._said.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._empty = QLabel()
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setWordWrap(True)
        self._arrange()
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self.model.refresh)
        self.model.modelReset.connect(self._show)
        self.model.dataChanged.connect(self._show_said)
        document.samples_changed.connect(self._timer.start)
        document.left_open_changed.connect(self._timer.start)
        document.names_changed.connect(self._timer.start)
        survey.advanced.connect(self._timer.start)
        search.changed.connect(self._take_anew)
        view.gap_changed.connect(self._follow)
        view.suspect_changed.connect(self._follow)
        self.setFocusProxy(self.table)
        self._show()

    def step(self, step: int) -> bool:
        """Go to the next (1) or previous (-1) problem of the list; say whether there is one.

        In a list by time that is the next from the playhead.
        """
        self._catch_up()
        count = self.model.rowCount()
        if not count:
            return False
        self._show_row(self._next_row(step) % count)
        return True

    def _next_row(self, step: int) -> int:
        run, row = self._view.suspect, self._current_row()
        if self.model.by_time:
            gaps = self.model.gaps
            current = self._view.gap if run is None else place_of(run)
            gap = neighbour(gaps, *place(current, self._view.frame), step)
            return 0 if gap is None else gaps.index(gap)
        if row is not None:
            return row + step
        if self._place < 0:
            return 0 if step > 0 else -1
        # The current one has left the list, and the next has taken its place.
        return self._place + min(step, 0)

    def worst(self) -> Problem | None:
        """Return the first problem of the list."""
        self._catch_up()
        return self.model.problem(0) if self.model.rowCount() else None

    def begin_again(self) -> None:
        """Let the next step go to the worst problem that is left then."""
        self._place = -1

    def _show_row(self, row: int) -> None:
        problem = self.model.problem(row)
        if problem.bad is None:
            self._view.go_to(problem.gap)
        else:
            self._view.go_to_suspect(problem.bad)

    def _current_row(self) -> int | None:
        """Return the row of what is worked on, where it is listed."""
        run, gap = self._view.suspect, self._view.gap
        if run is not None:
            return self.model.row_of_bad(run)
        return None if gap is None else self.model.row_of(gap)

    def _take_anew(self) -> None:
        """List other bad samples in a moment."""
        self.model.take_anew()
        self._timer.start()

    def _catch_up(self) -> None:
        """List now what would be listed in a moment."""
        if self._timer.isActive():
            self._timer.stop()
            self.model.refresh()

    # --- parts -------------------------------------------------------------------------------

    def _statuses(self) -> tuple[_Choice, ...]:
        return (
            _Choice(self.tr("Open"), TO_DO),
            _Choice(self.tr("Beyond the limits"), frozenset({Status.BEYOND})),
            _Choice(self.tr("Left open"), frozenset({Status.LEFT})),
            _Choice(
                self.tr("Done"),
                frozenset({Status.REPAIRED, Status.FIXED}),
                self.tr("Gaps that are repaired, and problems that are fixed"),
            ),
            _Choice(self.tr("Never to be filled"), frozenset({Status.NEVER})),
            _Choice(self.tr("No problem"), frozenset({Status.DISMISSED})),
            _Choice(self.tr("All"), frozenset(Status)),
        )

    def _kinds(self) -> tuple[_Choice, ...]:
        return (
            _Choice(self.tr("All kinds"), ALL_KINDS),
            _Choice(self.tr("Gaps"), (GAP,)),
            _Choice(self.tr("Bad samples"), KINDS),
            *(_Choice(kinds_text(kind), (kind,), help_text(kind)) for kind in KINDS),
        )

    def _lengths(self) -> tuple[_Choice, ...]:
        return (
            _Choice(self.tr("Any length"), (0.0, math.inf)),
            _Choice(self.tr("Up to 0.2 s"), (0.0, SHORT)),
            _Choice(self.tr("0.2 to 1 s"), (SHORT, SECOND)),
            _Choice(self.tr("Above 1 s"), (SECOND, math.inf)),
        )

    def _make_combo(self, name: str, choices: tuple[_Choice, ...]) -> QComboBox:
        combo = ElidingCombo()
        for row, choice in enumerate(choices):
            combo.addItem(choice.text, choice.value)
            combo.setItemData(row, choice.tip, Qt.ItemDataRole.ToolTipRole)
        combo.setAccessibleName(name)
        combo.setToolTip(name)
        combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        combo.setMinimumContentsLength(7)
        combo.currentIndexChanged.connect(self._set_filter)
        return combo

    def _arrange(self) -> None:
        tops = QGridLayout()
        for column in (0, 1):
            tops.setColumnStretch(column, 1)
        tops.addWidget(self.filter, 0, 0)
        tops.addWidget(self.kind, 0, 1)
        tops.addWidget(self.status, 1, 0)
        tops.addWidget(self.length, 1, 1)
        middle = QWidget()
        self._pages = QStackedLayout(middle)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(self.table)
        bottom = QHBoxLayout()
        bottom.addWidget(self._said, 1)
        bottom.addWidget(self.look)
        bottom.addWidget(self.rank)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.setSpacing(4)
        layout.addLayout(tops)
        layout.addWidget(middle, 1)
        layout.addLayout(bottom)

    # --- what the user does ------------------------------------------------------------------

    def _set_filter(self) -> None:
        shortest, longest = self.length.currentData()
        self._place = -1
        self.model.set_filter(
            Filter(
                self.filter.text(),
                self.status.currentData(),
                shortest,
                longest,
                self.kind.currentData(),
            )
        )

    def _switch_ranking(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self._settings.set(RANKING, on)
        if on:
            self._survey.start()
        else:
            self._survey.stop()
        self._show_said()

    def _switch_searching(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self._settings.set(SEARCHING, on)
        if on:
            self._search.start()
        else:
            self._search.stop()
        self._show()

    def _go_to(self, index: QModelIndex) -> None:
        self._show_row(index.row())

    def _lead(self) -> None:
        """Go to the row that the user has marked by the keyboard."""
        chosen = self.table.selectionModel().selectedRows()
        if chosen and not self._following:
            self._go_to(chosen[0])

    # --- showing -----------------------------------------------------------------------------

    def _show(self) -> None:
        self._pages.setCurrentWidget(self.table if self.model.rowCount() else self._empty)
        if not self.model.rowCount():
            self._empty.setText(self._why_empty())
        self.table.show_kinds(shown=self.model.has_bad)
        self._show_said()
        self._follow()

    def _why_empty(self) -> str:
        if self.model.total:
            return self.tr("No problem passes the filter.")
        told = self.tr("No marker is missing anywhere: there is nothing to fill.")
        if self._search.suspects.known:
            return told + "\n" + self.tr("No bad samples were found.")
        if self._search.on or self._search.running:
            return told + "\n" + self.tr("Bad samples are being looked for…")
        return told + "\n" + self.tr("Bad samples were not looked for: Ctrl+F does it.")

    def _show_said(self) -> None:
        done, all_gaps = self._survey.progress()
        count = self.model.rowCount()
        if self._survey.running and done < all_gaps:
            text = self.tr("{0} listed · ranked {1} of {2}").format(count, done, all_gaps)
        elif self.model.has_bad:
            text = self.tr("1 problem") if count == 1 else self.tr("{0} problems").format(count)
        else:
            text = self.tr("1 gap") if count == 1 else self.tr("{0} gaps").format(count)
        self._said.setText(text)

    def _follow(self) -> None:
        """Mark the current problem."""
        row = self._current_row()
        self._following = True
        if row is None:
            self.table.clearSelection()
        else:
            self._place = row
            flags = QItemSelectionModel.SelectionFlag
            place = self.model.index(row, 0)
            self.table.selectionModel().setCurrentIndex(place, flags.ClearAndSelect | flags.Rows)
            self.table.scrollTo(place)
        self._following = False
