"""The pane of proposed labels: look at each, accept, reject or choose, then apply them all."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QModelIndex, Qt, QTimer, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSlider,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from mocapmend.commands import EditSamples
from mocapmend.correcting import step
from mocapmend.document import Document
from mocapmend.label_review import Decision
from mocapmend.relabelling import doubts
from mocapmend.theme import Theme
from mocapmend.unsure_labels import UnsureLabels
from mocapmend.views.action_button import ActionButton
from mocapmend.views.filling import Filling
from mocapmend.views.label_search import LabelSearch
from mocapmend.views.label_table import LabelTable
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.problems import BadRun

NOBODY = -1
"""Stands in the list of labels for a piece that is no marker."""


class LabelPane(QWidget):
    """Shows a review of proposed labels; nothing changes before it is applied.

    Parameters
    ----------
    unsure : UnsureLabels
        Which of them are in the queue too.
    do : callable
        Does an undo command.

    Signals
    -------
    message : str
        Something the user should read in passing.
    """

    message = Signal(str)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        search: LabelSearch,
        unsure: UnsureLabels,
        filling: Filling,
        do: Callable[[EditSamples], None],
        theme: Theme,
        actions: dict[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._search = search
        self._unsure = unsure
        self._filling = filling
        self._do = do
        self._applied = False
        self.table = LabelTable(document, theme)
        self.table.accepted.connect(self.accept)
        self.table.rejected.connect(self.reject)
        self.table.clicked.connect(self._go_to)
        self.table.selectionModel().currentRowChanged.connect(self._go_to)
        self._make_controls()
        self._arrange(actions)
        view.frame_changed.connect(self._propose)
        view.suspect_changed.connect(self._mark)
        search.changed.connect(self._show)
        search.decided.connect(self._follow)
        search.started.connect(self._show_state)
        search.ended.connect(self._show_state)
        document.names_changed.connect(self.table.labels.refresh)
        self._show()

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.table.set_theme(theme)

    # --- what the user says ------------------------------------------------------------------

    def accept(self) -> None:
        """Accept the marked row's label, and go on to the next row."""
        self._decide(Decision.ACCEPTED)

    def reject(self) -> None:
        """Leave the marked row's piece as it is, and go on to the next row."""
        self._decide(Decision.REJECTED)

    def apply(self) -> None:
        """Give all labels that are accepted or sure enough, in one undoable step."""
        review = self._search.review
        if review is None or not self._search.up_to_date:
            return
        found = review.changes(self._document.base)
        made = step(self._document, exchanges=found.exchanges, set_aside=doubts(found))
        if not (found.names or made.correction.runs):
            self.message.emit(self.tr("There is nothing to be labelled."))
            return
        count, aside = review.counts()[0], sum(run.length for run in made.correction.doubts.come)
        correction = made.correction if made.correction.runs else None
        text = f"label {count} pieces"
        self._applied = True
        self._do(EditSamples(self._document, made.edits, text, correction, found.names))
        self._filling.refill()
        told = self.tr("Pieces labelled: {0}.")
        if aside:
            told = self.tr("Pieces labelled: {0}. Samples set aside, for want of a point: {1}.")
        self.message.emit(told.format(count, aside))

    def _decide(self, decision: Decision) -> None:
        review, row = self._search.review, self._row()
        if review is None or row is None or not self._search.up_to_date:
            return
        review.decide(row, decision)
        self._search.decided.emit()
        if row + 1 < len(review):
            self.table.selectRow(row + 1)

    def _choose(self, index: int) -> None:
        """Take the label that the user has chosen for the marked row."""
        review, row = self._search.review, self._row()
        label = self.choice.itemData(index)
        if review is None or row is None or label is None or not self._search.up_to_date:
            return
        review.choose(row, None if label == NOBODY else label)
        self._search.decided.emit()
        self.table.setFocus()

    def _set_least(self, percent: int) -> None:
        self._search.set_least(percent / 100.0)
        self._search.decided.emit()

    # --- parts -------------------------------------------------------------------------------

    def _make_controls(self) -> None:
        self.choice = QComboBox()
        self.choice.setAccessibleName(self.tr("Label of this piece"))
        self.choice.setToolTip(
            self.tr("Another label for this piece; those that are free at that time come first")
        )
        self.choice.activated.connect(self._choose)
        self.accepting = QPushButton(self.tr("Accept (Enter)"))
        self.accepting.clicked.connect(self.accept)
        self.rejecting = QPushButton(self.tr("Reject (Del)"))
        self.rejecting.clicked.connect(self.reject)
        self.least = QSlider(Qt.Orientation.Horizontal)
        self.least.setRange(0, 100)
        self.least.setPageStep(5)
        self.least.setAccessibleName(self.tr("Least confidence"))
        self.least.setToolTip(
            self.tr("Labels that are less sure are not given, unless you accept them")
        )
        self.least.setValue(round(100 * self._search.least))
        self.least.valueChanged.connect(self._set_least)
        self.summary = QLabel()
        self.summary.setWordWrap(True)
        self.applying = QPushButton(self.tr("Apply"))
        self.applying.clicked.connect(self.apply)
        self.again = QPushButton(self.tr("Run again"))
        self.again.clicked.connect(self._search.again)
        # Clicks must not take the keyboard from the table.
        for button in (self.accepting, self.rejecting, self.applying, self.again):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def _arrange(self, actions: dict[str, QAction]) -> None:
        side = QWidget()
        grid = QGridLayout(side)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        grid.addWidget(self.choice, 0, 0, 1, 2)
        grid.addWidget(self.accepting, 1, 0)
        grid.addWidget(self.rejecting, 1, 1)
        grid.addWidget(self.summary, 2, 0, 1, 2)
        grid.addWidget(self.least, 3, 0, 1, 2)
        grid.addWidget(self.applying, 4, 0)
        grid.addWidget(self.again, 4, 1)
        grid.setRowStretch(5, 1)
        reviewing = QWidget()
        row = QHBoxLayout(reviewing)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.table, 1)
        row.addWidget(side)
        empty = QWidget()
        column = QVBoxLayout(empty)
        self._said = QLabel()
        self._said.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._said.setWordWrap(True)
        self._begin = ActionButton(actions["label_from"], self.tr("Label from recordings…"))
        column.addStretch(1)
        column.addWidget(self._said)
        column.addWidget(self._begin, 0, Qt.AlignmentFlag.AlignHCenter)
        column.addStretch(1)
        self._pages = QStackedLayout(self)
        self.setContentsMargins(4, 4, 4, 4)
        self._pages.addWidget(empty)
        self._pages.addWidget(reviewing)
        self._empty, self._reviewing = empty, reviewing
        # Without proposals it has the keyboard itself, and hands it on to them.
        empty.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        empty.setAccessibleName(self.tr("Labels"))

    # --- showing -----------------------------------------------------------------------------

    def _show(self) -> None:
        """Show another review, or that the recording is another one than it is for."""
        review = self._search.review
        if review is not self.table.labels.review:
            self._applied = False
            self.table.labels.show(review)
            if review is not None and len(review):
                # Later: the pane may only come in sight now.
                QTimer.singleShot(0, self, lambda: self.table.selectRow(0))
        reviewing = review is not None and len(review) > 0
        waited = self._empty.hasFocus()
        self._pages.setCurrentWidget(self._reviewing if reviewing else self._empty)
        self.setFocusProxy(self.table if reviewing else self._empty)
        if waited:
            self.setFocus()
        self._show_state()

    def _show_state(self) -> None:
        running = self._search.job is not None
        said = self.tr(
            "Labels for points that have none, or that are in pieces, can be learned from "
            "recordings of the same marker set."
        )
        if running:
            said = self.tr("Labels are being looked for…")
        elif self._search.review is not None:
            said = self.tr("All points have names that the labelled recordings have.")
        self._said.setText(said)
        self._begin.set_possible(possible=not running)
        possible = self._search.up_to_date and not running
        for part in (self.choice, self.accepting, self.rejecting, self.applying, self.least):
            part.setEnabled(possible)
        self.again.setEnabled(not running)
        self._follow()

    def _follow(self) -> None:
        """Show what the user has said, and what follows from it."""
        self.table.labels.refresh()
        self._offer()
        self._summarise()
        self._propose()

    def _summarise(self) -> None:
        review = self._search.review
        if review is None:
            return
        if self._search.up_to_date:
            self._applied = False
            used, every = review.counts()
            text = self.tr("At least {0} % sure: {1} of {2} pieces get a label.").format(
                self.least.value(), used, every
            )
        elif self._applied:
            text = self.tr("Applied. Undo brings the proposals back.")
        else:
            text = self.tr("⚠ The recording was edited since: run it again.")
        self.summary.setText(text)

    def _offer(self) -> None:
        """List the labels that the marked piece may have."""
        review, row = self._search.review, self._row()
        self.choice.clear()
        if review is None or row is None:
            return
        free, taken = review.choices(row)
        for label in free:
            self.choice.addItem(review.labels[label], label)
        for label in taken:
            text = self.tr("{0} (another piece has it)").format(review.labels[label])
            self.choice.addItem(text, label)
        self.choice.addItem(self.tr("no marker"), NOBODY)
        own = review.proposal(row).label
        self.choice.setCurrentIndex(self.choice.findData(NOBODY if own is None else own))

    def _propose(self) -> None:
        """Let the 3D view call the points as is proposed, while the pane is in sight."""
        review = self._search.review
        shown = review is not None and self._search.up_to_date and self.isEnabled()
        names = review.names_at(self._view.frame) if review is not None and shown else {}
        self._view.set_proposed(names)

    def _go_to(self, index: QModelIndex) -> None:
        """Show the piece of a row: its point selected, the playhead in its middle."""
        review = self._search.review
        if review is None or not index.isValid():
            return
        piece = review.proposal(index.row()).piece
        self._view.select((piece.point,))
        self._view.set_frame((piece.start + piece.stop - 1) // 2)
        self._view.frame_span(piece.start, piece.stop)
        run = self._unsure.run(index.row())
        if run is not None:
            self._view.set_suspect(run)
        self._offer()

    def _mark(self, run: BadRun | None) -> None:
        """Mark the row of what is the current problem of the queue."""
        row = self._unsure.row(run)
        if row is not None and row != self._row():
            self.table.selectRow(row)

    def _row(self) -> int | None:
        row = self.table.currentIndex().row()
        return row if row >= 0 else None

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.EnabledChange:
            # It has come in sight, or has gone behind another pane.
            self._propose()
