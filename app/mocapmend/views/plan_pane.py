"""The fill plan: what filling all gaps would do, before it is done."""

import math
from enum import Enum
from typing import Any, NamedTuple

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, Qt, QTimer
from PySide6.QtGui import QAction, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from mocapmend.document import Document
from mocapmend.views.action_button import ActionButton
from mocapmend.views.engine_texts import method_name, shown
from mocapmend.views.filling import Filling
from mocapmend.views.labels import LabelDelegate
from mocapmend.views.marker_table import NO_PARENT, Index
from mocapmend.views.repair_panel import RepairPanel
from mocapmend.views.tables import (
    INDENT,
    LEFT,
    RIGHT,
    Indented,
    dress,
    frames_text,
    in_sight,
    narrow,
)
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult

DELAY_MS = 60


class Outcome(Enum):
    """What a plan would make of a gap."""

    FILLED = "filled"
    OPEN = "open"
    UNKNOWN = "unknown"


class _Row(NamedTuple):
    """A gap and what would become of it."""

    gap: Gap
    outcome: Outcome
    error: float = math.nan
    reason: str = ""


class PlanModel(QAbstractTableModel):
    """One row per open gap: marker, frames, length, expected error, what would be done."""

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._rows: list[_Row] = []
        self._columns = (
            self.tr("Marker"),
            self.tr("Frames"),
            self.tr("Length"),
            self.tr("Expected error"),
            self.tr("What would be done"),
        )

    def show(self, planned: FillResult, unknown: list[Gap], shown: frozenset[Outcome]) -> None:
        """List a plan, or a part of it."""
        rows = [_Row(p.gap, Outcome.FILLED, p.expected_error) for p in planned.patches]
        rows += [_Row(e.gap, Outcome.OPEN, reason=e.reason) for e in planned.unfilled]
        rows += [_Row(gap, Outcome.UNKNOWN) for gap in unknown]
        self.beginResetModel()
        self._rows = sorted(
            (row for row in rows if row.outcome in shown),
            key=lambda row: (row.gap.start, row.gap.marker),
        )
        self.endResetModel()

    def gap(self, row: int) -> Gap:
        """Return the gap of a row."""
        return self._rows[row].gap

    def rowCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return (INDENT if section == 4 else "") + self._columns[section]
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if 0 < section < 4 else LEFT
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if 0 < index.column() < 4 else LEFT
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
            return self._text(self._rows[index.row()], index.column())
        return None

    def _text(self, row: _Row, column: int) -> str:
        original = self._document.original
        match column:
            case 0:
                return self._document.names[row.gap.marker]
            case 1:
                return frames_text(row.gap, original.first_frame)
            case 2:
                ms = round(1000.0 * row.gap.length / original.rate)
                return self.tr("{0} ({1} ms)").format(row.gap.length, ms)
            case 3:
                known = not math.isnan(row.error)
                return f"{row.error * original.mm:.1f} mm" if known else "—"
        if row.outcome is Outcome.UNKNOWN:
            return self.tr("… not computed yet")
        if row.outcome is Outcome.FILLED:
            return self.tr("✔ filled")
        return self.tr("○ stays open: {0}").format(shown(row.reason))


class PlanPane(QWidget):
    """Shows the plan for the method and the limits of the repair pane."""

    def __init__(
        self,
        document: Document,
        view: ViewState,
        repair: RepairPanel,
        filling: Filling,
        actions: dict[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._repair = repair
        self._filling = filling
        self.model = PlanModel(document, self)
        self.table = self._make_table(max(document.names, key=len, default=""))
        self.summary = QLabel()
        self.summary.setWordWrap(True)
        self._shown = QComboBox()
        self._shown.setAccessibleName(self.tr("Which gaps are listed"))
        for text, outcomes in (
            (self.tr("All gaps"), frozenset(Outcome)),
            (self.tr("Would be filled"), frozenset({Outcome.FILLED})),
            (self.tr("Would stay open"), frozenset({Outcome.OPEN})),
        ):
            self._shown.addItem(text, outcomes)
        self._shown.currentIndexChanged.connect(self.refresh)
        self._arrange(actions)
        self._stale = True
        """Whether something has changed since the plan was listed."""
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self.refresh)
        for signal in (
            document.samples_changed,
            document.left_open_changed,
            document.names_changed,
            repair.ways_changed,
            repair.limits.changed,
            filling.computed,
            filling.ended,
        ):
            signal.connect(self._refresh_soon)
        self.setFocusProxy(self.table)

    def compute(self) -> None:
        """Find out what is not known yet."""
        self._filling.compute(self._repair.method(), self._repair.limits.limits())
        self.refresh()

    def refresh(self) -> None:
        """List the plan anew."""
        self._stale = not in_sight(self)
        if self._stale:
            return
        way, limits = self._repair.method(), self._repair.limits.limits()
        planned, unknown = self._filling.planned(way, limits)
        self.model.show(planned, unknown, self._shown.currentData())
        samples = sum(patch.gap.length for patch in planned.patches)
        text = self.tr(
            "Gaps, by {0}: {1} would be filled (samples: {2}), {3} would stay open."
        ).format(method_name(way.method), len(planned.patches), samples, len(planned.unfilled))
        if unknown:
            text += " " + self.tr("{0} are not computed yet.").format(len(unknown))
        self.summary.setText(text)
        self._compute.setVisible(bool(unknown))
        self._compute.set_possible(possible=self._filling.job is None)

    # --- parts -------------------------------------------------------------------------------

    def _make_table(self, longest: str) -> QTableView:
        table = QTableView()
        table.setModel(self.model)
        table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        table.setAccessibleName(self.tr("Fill plan"))
        dress(table)
        table.setItemDelegateForColumn(0, LabelDelegate(table))
        table.setItemDelegateForColumn(4, Indented(table))
        advance = table.fontMetrics().horizontalAdvance
        error = str(self.model.headerData(3, Qt.Orientation.Horizontal))
        texts = (longest, "000000 – 000000", "00000 (00000 ms)", error)
        narrow(
            table, {i: min(advance(text), 320) + 24 for i, text in enumerate(texts)}, stretched=4
        )
        table.setToolTip(self.tr("Double-click a gap, or press Enter, to go there"))
        table.activated.connect(self._go_to)
        return table

    def _arrange(self, actions: dict[str, QAction]) -> None:
        self._compute = ActionButton(actions["plan"], self.tr("Compute"))
        self._fill = ActionButton(actions["fill_all"], self.tr("Fill all"))
        head = QHBoxLayout()
        head.addWidget(self.summary, 1)
        head.addWidget(self._shown)
        head.addWidget(self._compute)
        head.addWidget(self._fill)
        head.addWidget(ActionButton(actions["save_plan"], self.tr("Save plan…")))
        head.addWidget(ActionButton(actions["load_plan"], self.tr("Load plan…")))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.setSpacing(4)
        layout.addLayout(head)
        layout.addWidget(self.table, 1)

    def _refresh_soon(self) -> None:
        self._timer.start()

    def _go_to(self, index: QModelIndex) -> None:
        self._view.go_to(self.model.gap(index.row()))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        # What is painted has come in sight.
        if self._stale:
            self._refresh_soon()
