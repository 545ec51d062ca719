"""Filling all gaps: the dry run, the work in the background, one undoable step."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend import engine
from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.jobs import Job, Jobs
from mocapmend.prospects import Prospects, Way
from mocapmend.views.survey import Survey
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult, Unfilled
from mocapmend_algorithms.fill.limits import Limits, hold_to
from mocapmend_algorithms.fill.registry import METHODS

Stand = tuple[int, int]
"""What an edit changes: the document's revision and the place in its history."""


class Filling(QObject):
    """Fills the gaps of a document that a way can fill within limits.

    Parameters
    ----------
    do : callable
        Does an undo command.

    Signals
    -------
    started, ended :
        Something is being computed, or no longer.
    computed :
        More is known of what a way makes of the gaps.
    done : int, int
        So many gaps were filled, and so many stayed open.
    """

    message = Signal(str)
    failed = Signal(object)
    started = Signal()
    ended = Signal()
    computed = Signal()
    done = Signal(int, int)

    def __init__(
        self,
        document: Document,
        prospects: Prospects,
        survey: Survey,
        jobs: Jobs,
        do: Callable[[EditSamples], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._prospects = prospects
        self._survey = survey
        self._jobs = jobs
        self._do = do
        self._ranking = False
        self._then: Callable[[], None] | None = None
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(0)
        self._later.timeout.connect(self._go_on)
        self.job: Job | None = None
        document.base_changed.connect(self._give_up)
        document.names_changed.connect(self._give_up)

    def stop(self) -> None:
        """Give up what is being computed: the document is going away."""
        self._later.stop()
        if self.job is not None:
            self.job.abandon()
            self.job = None

    def _give_up(self) -> None:
        """Compute no more from samples that are not believed any more, or called otherwise."""
        if self.job is not None or self._later.isActive():
            self.stop()
            self._then = None
            self._rest()

    def refill(self) -> None:
        """Fill those gaps again that were filled before what is believed changed."""
        document = self._document
        stale = document.stale
        if not stale or self.job is not None:
            return
        of_way: dict[Way, list[Gap]] = {}
        for gap in stale:
            made = document.repairs[gap]
            of_way.setdefault(Way(made.method, made.params), []).append(gap)
        jobs = [engine.FillJob(*way, tuple(gaps)) for way, gaps in of_way.items()]
        base = document.base_revision
        title = self.tr("Filling {0} gaps again").format(len(stale))
        job = self._jobs.compute(title, engine.fill_each, document.share_base(), jobs)
        job.finished.connect(lambda results: self._take_again(jobs, results, base))
        job.failed.connect(self.failed)
        job.cancelled.connect(self._tell_stale)
        job.ended.connect(self._end)
        self.job = job
        self.started.emit()

    def _take_again(self, jobs: list[engine.FillJob], results: list[FillResult], base: int) -> None:
        """Put the new fills in the place of the old ones, but for gaps that changed meanwhile."""
        stale = set(self._document.stale)
        edits = [
            edit
            for job, result in zip(jobs, results, strict=True)
            for edit in Edit.fills(result, job.method, job.params, base)
            if edit.gap in stale
        ]
        left = {
            entry.gap: entry.reason
            for result in results
            for entry in result.unfilled
            if entry.gap in stale
        }
        edits += map(Edit.clear, left)
        self._document.leave_open(left)
        if edits:
            text = f"fill {len(edits)} gaps again"
            self._do(EditSamples(self._document, edits, text))
            self.message.emit(self.tr("Gaps filled again: {0}.").format(len(edits) - len(left)))

    def _tell_stale(self) -> None:
        self.message.emit(
            self.tr("Cancelled: {0} fills are from before the correction.").format(
                len(self._document.stale)
            )
        )

    def planned(self, way: Way, limits: Limits) -> tuple[FillResult, list[Gap]]:
        """Return what filling all gaps would do, and the gaps of which that is not known yet.

        Those that shall never be filled are among the ones that stay open.
        """
        every = self._document.fillable
        known, unknown = self._prospects.result(way, every)
        too_long = {e.gap for e in self._held(way, limits, unknown, FillResult(())).unfilled}
        missing = [gap for gap in unknown if gap not in too_long]
        rest = set(missing)
        gaps = [gap for gap in every if gap not in rest]
        held = self._held(way, limits, gaps, known)
        never = [Unfilled(gap, self._document.never_reason(gap)) for gap in self._document.never]
        return replace(held, unfilled=(*held.unfilled, *never)), missing

    def compute(self, way: Way, limits: Limits) -> None:
        """Find out what filling all gaps would do."""
        self._complete(way, limits, self.computed.emit)

    def fill_all(self, way: Way, limits: Limits) -> None:
        """Fill all gaps within the limits, in one undoable step."""
        self._complete(way, limits, lambda: self._accept(way, limits))

    def _complete(self, way: Way, limits: Limits, then: Callable[[], None]) -> None:
        """Compute what is not known yet, and go on."""
        if self.job is not None or self._later.isActive():
            return
        unknown = self.planned(way, limits)[1]
        if not unknown:
            then()
            return
        job = self._jobs.compute(
            self.tr("Fill all gaps"),
            engine.fill_anyway,
            self._document.share_base(),
            unknown,
            *way,
        )
        job.finished.connect(lambda result: self._keep(way, unknown, result, then))
        job.failed.connect(self.failed)
        job.cancelled.connect(self._tell_cancelled)
        job.ended.connect(self._end)
        self.job = job
        # Not both: the preview that the user waits for needs a worker.
        self._ranking = self._survey.on
        self._survey.stop()
        self.started.emit()

    def _keep(
        self, way: Way, gaps: list[Gap], result: FillResult, then: Callable[[], None]
    ) -> None:
        self._prospects.add(way, gaps, result)
        self._soon(then)

    def _tell_cancelled(self) -> None:
        self.message.emit(self.tr("Cancelled: nothing was filled."))

    def _soon(self, then: Callable[[], None]) -> None:
        """Go on when the window has come to its events: of ten thousand gaps each step is felt."""
        self._then = then
        self._later.start()

    def _go_on(self) -> None:
        then, self._then = self._then, None
        if then is not None:
            then()
        self._end()

    def _end(self) -> None:
        if not self._later.isActive():
            self._rest()

    def _rest(self) -> None:
        self.job = None
        if self._ranking:
            self._ranking = False
            self._survey.start()
        self.ended.emit()

    def _accept(self, way: Way, limits: Limits) -> None:
        """Take what is within the limits; gaps that were repaired meanwhile stay as they are."""
        result, _ = self.planned(way, limits)
        reasons = {entry.gap: entry.reason for entry in result.unfilled}
        for gap in self._document.never:
            reasons.pop(gap, None)
        self._document.leave_open(reasons)
        again = partial(self._accept, way, limits)
        self._soon(partial(self._prepare, way, result, again, self._stand()))

    def _prepare(
        self, way: Way, result: FillResult, again: Callable[[], None], stand: Stand
    ) -> None:
        edits, left = Edit.fills(result, *way, self._document.base_revision), len(result.unfilled)
        text = f"fill {len(edits)} gaps ({way.method})"
        self._soon(partial(self._note, edits, text, left, again, stand))

    def _note(
        self, edits: list[Edit], text: str, left: int, again: Callable[[], None], stand: Stand
    ) -> None:
        """Take note of what was there before."""
        if self._stand() != stand:
            again()
            return
        command = EditSamples(self._document, edits, text)
        self._soon(partial(self._make, command, left, again, stand))

    def _make(
        self, command: EditSamples, left: int, again: Callable[[], None], stand: Stand
    ) -> None:
        """Make the edits, or plan them anew if the recording was edited since."""
        if self._stand() != stand:
            again()
            return
        filled = len(command.edits)
        if filled:
            self._do(command)
        self.message.emit(self.tr("Gaps: {0} filled, {1} left open.").format(filled, left))
        self.done.emit(filled, left)

    def _stand(self) -> Stand:
        return self._document.revision, self._document.undo_stack.index()

    def _held(self, way: Way, limits: Limits, gaps: list[Gap], known: FillResult) -> FillResult:
        method = METHODS[way.method]
        return hold_to(self._document.base, gaps, known, method, way.params, limits)
