"""What the user does to the current gap.

Names of edits and reasons are English, for reports and journals; they are translated where shown.
"""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files.records import LEFT_OPEN, NEVER_FILLED, NO_REASON
from mocapmend.navigation import in_time_order, neighbour, place
from mocapmend.state import SampleState
from mocapmend.trimming import resized, widened
from mocapmend.views.queue_pane import QueuePane
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap


class GapActions(QObject):
    """Steps from gap to gap, applies the preview, and decides what is never filled.

    Parameters
    ----------
    push : callable
        Makes edits, in one undoable step of a given text.

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
        queue: QueuePane,
        push: Callable[[list[Edit], str], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._queue = queue
        self._push = push
        document.samples_changed.connect(self._keep_up)

    def _keep_up(self) -> None:
        """Stay at the current gap when an edit, done or undone, has given it other ends."""
        gap = self._view.gap
        if gap is not None:
            middle = (gap.start + gap.stop - 1) // 2
            self._view.set_gap(self._document.gap_near(gap.marker, middle))

    def step(self, step: int) -> None:
        """Go to the next (1) or previous (-1) problem of the queue."""
        if not self._queue.step(step):
            self.message.emit(self.tr("No problem is left in the queue."))

    def step_here(self, step: int) -> None:
        """Go to the next (1) or previous (-1) open gap of the current marker, in time."""
        document, view = self._document, self._view
        gaps = document.gaps if view.marker is None else document.gaps_of(view.marker)
        ordered = in_time_order(gaps, document.original.frames)
        gap = neighbour(ordered, *place(view.gap, view.frame), step)
        if gap is None:
            self.message.emit(self.tr("No gap is left to go to."))
        else:
            view.go_to(gap)

    def apply(self) -> bool:
        """Make the previewed repair an undoable edit; say whether there was one."""
        preview = self._view.preview
        if preview is None:
            self.message.emit(self.tr("There is no preview to apply: choose a gap first (N)."))
            return False
        if preview.patch is None:
            self.message.emit(self.tr("This method leaves the gap open; choose another (M)."))
            return False
        edit = Edit.fill(preview.patch, *preview.way, preview.donors, self._document.base_revision)
        self._push([edit], f"fill {self._name(preview.gap)} ({preview.method})")
        return True

    def apply_and_go_on(self) -> None:
        """Apply the previewed repair and go to the next gap."""
        if self.apply():
            self.step(1)

    def reopen(self) -> None:
        """Turn the current gap's repair back into a gap."""
        gap = self._view.gap
        if gap is not None and gap in self._document.repairs:
            text = f"clear the repair of {self._name(gap)}"
            self._push([Edit.clear(gap)], text)
        else:
            self.message.emit(self.tr("There is no repair here."))

    def leave_open(self) -> None:
        """Leave the current gap open and go to the next; or take it up again."""
        gap = self._open_gap()
        if gap is None:
            return
        if gap in self._document.set_aside:
            self._push([Edit.clear(gap)], f"take up a gap of {self._name(gap)} again")
            self.message.emit(self.tr("The gap is open again."))
        else:
            self._push(
                [Edit.clear(gap, reason=LEFT_OPEN)], f"leave a gap of {self._name(gap)} open"
            )
            self.step(1)

    def never_fill(self) -> None:
        """Protect the current gap, or the selection's gaps in the selected time, from any fill.

        Where all of them are protected already, they become gaps again.
        """
        gaps = self._chosen()
        if not gaps:
            self.message.emit(self.tr("There is no gap here."))
            return
        open_gaps = [gap for gap in gaps if gap in self._document.gaps_of(gap.marker)]
        if open_gaps:
            aside = self._document.set_aside
            given = {gap: reason for gap, reason in aside.items() if reason not in NO_REASON}
            edits = [Edit.clear(gap, SampleState.NEVER, given.get(gap)) for gap in open_gaps]
            text = f"never fill {len(edits)} gaps"
        else:
            edits = [Edit.clear(gap) for gap in gaps]
            text = f"allow to fill {len(edits)} gaps"
        self._push(edits, text)

    def to_explain(self) -> dict[Gap, str | None]:
        """Return the gaps that a reason can be given for, with those that they have.

        Among the current gap, or the selection's gaps in the selected time, they are those that
        are kept open; where none of them is, they are all of them.
        """
        document, gaps = self._document, self._chosen()
        aside = document.set_aside
        never = {gap for gap in gaps if gap in document.never_of(gap.marker)}
        kept = [gap for gap in gaps if gap in never or gap in aside]
        if not gaps:
            self.message.emit(self.tr("There is no gap here."))
        return {
            gap: document.never_reason(gap) if gap in never else aside.get(gap)
            for gap in kept or gaps
        }

    def explain(self, gaps: Mapping[Gap, str | None], reason: str) -> None:
        """Give a reason for keeping gaps open.

        Parameters
        ----------
        gaps : mapping of Gap to str or None
            What `to_explain` returned; open ones are left open from now on.
        reason : str
            Why; if it is empty, no more than that.
        """
        edits = []
        for gap, before in gaps.items():
            if gap in self._document.never_of(gap.marker):
                edit = Edit.clear(gap, SampleState.NEVER, reason or NEVER_FILLED)
            elif gap in self._document.gaps_of(gap.marker):
                edit = Edit.clear(gap, reason=reason or LEFT_OPEN)
            else:
                # Filled while the user was asked.
                continue
            if edit.reason != before:
                edits.append(edit)
        if len(edits) == 1:
            self._push(edits, f"say why a gap of {self._name(edits[0].gap)} stays open")
        elif edits:
            self._push(edits, f"say why {len(edits)} gaps stay open")
        if list(gaps.values()) == [None]:
            self.step(1)

    def widen(self, frames: int) -> None:
        """Move the ends of the current gap over measured samples, or back."""
        gap = self._open_gap()
        if gap is None:
            return
        wanted = widened(self._document, gap, frames)
        if wanted == gap:
            self.message.emit(self.tr("The ends of this gap go no further."))
            return
        self._push(
            [resized(self._document, gap, wanted)],
            f"move the ends of a gap of {self._name(gap)}",
        )
        self._view.set_gap(wanted)

    def _open_gap(self) -> Gap | None:
        gap = self._view.gap
        if gap is not None and gap in self._document.gaps_of(gap.marker):
            return gap
        self.message.emit(self.tr("There is no open gap here."))
        return None

    def _chosen(self) -> list[Gap]:
        """Return the current gap, or all gaps of the selected markers in the selected time."""
        document, gap = self._document, self._view.gap
        span = self._view.span
        if span is None:
            known = gap is not None and (
                gap in document.gaps_of(gap.marker) or gap in document.never_of(gap.marker)
            )
            return [gap] if known and gap is not None else []
        return [
            other
            for marker in self._view.selection
            for other in (*document.gaps_of(marker), *document.never_of(marker))
            if other.start < span[1] and other.stop > span[0]
        ]

    def _name(self, gap: Gap) -> str:
        return self._document.names[gap.marker]
