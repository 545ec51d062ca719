"""What the user does about bad samples: fix, dismiss, set aside, believe again, exchange.

Names of edits and reasons are English, for reports and journals; they are translated where shown.
"""

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QObject, Signal

from mocapmend.commands import EditSamples
from mocapmend.correcting import Step, step
from mocapmend.document import Document
from mocapmend.doubts import BY_HAND, Doubt, overlapping
from mocapmend.fixing import exchanged_kinds, find, is_fixable, remedies
from mocapmend.jobs import Job, Jobs
from mocapmend.label_review import Decision
from mocapmend.unsure_labels import UNSURE
from mocapmend.views.bad_search import BadSearch
from mocapmend.views.filling import Filling
from mocapmend.views.queue_pane import QueuePane
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun

NO_REASON = "It was set aside by hand."


class BadActions(QObject):
    """Corrects samples, each time in one undoable step; fills that lean on them are made anew.

    Parameters
    ----------
    do : callable
        Does an undo command.

    Signals
    -------
    message : str
        Something the user should read in passing.
    failed : Exception
        Something that could not be done.
    """

    message = Signal(str)
    failed = Signal(object)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        queue: QueuePane,
        search: BadSearch,
        filling: Filling,
        jobs: Jobs,
        do: Callable[[EditSamples], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._queue = queue
        self._search = search
        self._filling = filling
        self._jobs = jobs
        self._job: Job | None = None
        self._do = do
        document.base_changed.connect(self._forget_exchange)
        search.changed.connect(self._keep_up)
        search.done.connect(self._tell_found)

    # --- what was found ----------------------------------------------------------------------

    def fix(self) -> None:
        """Put the current problem right, and go to the next."""
        run = self._current()
        if run is None:
            return
        if run.kind == UNSURE:
            self._decide(run, Decision.ACCEPTED)
        elif not self._search.suspects.is_open(run):
            self.message.emit(self.tr("This problem is fixed already; undo takes it back."))
        elif not is_fixable(run):
            self.message.emit(
                self.tr("This piece fits no marker: exchange it by hand, or say it is no problem.")
            )
        else:
            self._fix([run], f"fix {self._names(run)} ({run.kind})")
            self._queue.step(1)

    def fix_kind(self) -> None:
        """Put all problems right that are of the kind of the current one, in one step."""
        run = self._current()
        if run is not None and run.kind == UNSURE:
            self.message.emit(self.tr("Unsure labels are accepted one by one."))
        elif run is not None:
            same = [other for other in self._search.suspects.fixable if other.kind == run.kind]
            self._fix(same, f"fix {len(same)} problems ({run.kind})")
            self._queue.begin_again()

    def fix_all(self) -> None:
        """Put all problems right that were found, in one step."""
        every = self._search.suspects.fixable
        self._fix(every, f"fix {len(every)} problems")
        self._queue.begin_again()

    def dismiss(self) -> None:
        """Say that the current problem is none, and go to the next; or that it is one after all."""
        run = self._current()
        if run is None:
            return
        if run.kind == UNSURE:
            self._decide(run, Decision.REJECTED)
            return
        if not self._search.suspects.is_open(run):
            self.message.emit(self.tr("This problem is fixed already; undo takes it back."))
            return
        self._search.dismiss(run)
        if self._search.suspects.is_dismissed(run):
            self.message.emit(self.tr("No problem: it is listed under that status from now on."))
            self._queue.step(1)
        else:
            self.message.emit(self.tr("It is a problem again."))

    def fix_then(self, kinds: Sequence[str], then: Callable[[], None]) -> None:
        """Put right all that some detectors find, in one step, and go on.

        What was exchanged or set aside then is looked through by the detectors that come later, as
        `fixing.find` does. What the user holds for no problem stays as it is.
        """
        document = self._document
        if self._job is not None:
            return
        if document.found_skeleton is None:
            self.message.emit(self.tr("The bones are still being looked for: try again soon."))
            return
        base = document.base_revision
        job = self._jobs.compute(
            self.tr("Looking for bad samples"),
            find,
            document.share_base(),
            document.skeleton,
            tuple(kinds),
        )
        job.finished.connect(lambda found: self._fix_found(base, found, then))
        job.failed.connect(self.failed)
        job.ended.connect(self._end)
        self._job = job

    def stop(self) -> None:
        """Give up what is being looked for: the document is going away."""
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _end(self) -> None:
        self._job = None

    def _fix_found(self, base: int, found: list[BadRun], then: Callable[[], None]) -> None:
        self._job = None
        if base != self._document.base_revision:
            self.message.emit(self.tr("The recording was corrected meanwhile: try again."))
            return
        runs = [run for run in found if not self._search.suspects.is_dismissed(run)]
        if runs:
            made = self._remedy(runs)
            text = f"fix {len(runs)} problems"
            self._do(EditSamples(self._document, made.edits, text, made.correction))
        then()

    # --- by hand -----------------------------------------------------------------------------

    def set_aside(self) -> None:
        """Set the selected markers' samples aside: in the selected time, or at the playhead."""
        start, stop = self._span()
        runs = [Gap(marker, start, stop) for marker in self._view.selection]
        made = step(self._document, set_aside=dict.fromkeys(runs, Doubt(BY_HAND, NO_REASON)))
        count = sum(run.length for run in made.correction.doubts.come)
        if not count:
            self.message.emit(self.tr("No measured sample is selected here."))
            return
        what = self._names_of(self._view.selection)
        self._make(made, f"set {count} samples of {what} aside")
        self.message.emit(self.tr("Samples set aside: {0}.").format(count))

    def believe(self) -> None:
        """Believe samples again: the current run's, or those selected as in `set_aside`."""
        run = self._view.suspect
        start, stop = self._span()
        runs = [Gap(marker, start, stop) for marker in self._view.selection]
        if run is not None and self._view.span is None:
            runs = [Gap(run.marker, run.start, run.stop)]
        elif self._view.span is None:
            # At the playhead all of a run is meant.
            doubts = self._document.doubts
            runs = [whole for gap in runs for whole in overlapping(doubts, gap)]
        made = step(self._document, believe=runs)
        if not made.correction.doubts.gone:
            self.message.emit(self.tr("No sample is set aside here."))
            return
        gone, come = made.correction.doubts
        count = sum(run.length for run in gone) - sum(run.length for run in come)
        what = self._names_of(sorted({run.marker for run in gone}))
        self._make(made, f"believe {count} samples of {what} again")
        self.message.emit(self.tr("Samples believed again: {0}.").format(count))

    def exchange(self) -> None:
        """Show how the two selected markers would be exchanged; asked again, exchange them.

        That is in the selected time, or from the playhead on.
        """
        if len(self._view.selection) != 2:
            self.message.emit(
                self.tr("Select the two markers to be exchanged (Ctrl+click adds one).")
            )
            return
        first, second = self._view.selection
        wanted = self.to_exchange()
        if wanted is None:
            self.message.emit(self.tr("Neither of the two markers is seen here."))
            return
        if wanted != self._view.exchange:
            self._view.set_exchange(wanted)
            self.message.emit(
                self.tr("Dashed lines show how it would be: Ctrl+E again exchanges the two.")
            )
            return
        self._view.set_exchange(None)
        made = step(self._document, exchanges=[wanted])
        self._make(made, f"exchange {self._names_of((first, second))}")
        self.message.emit(
            self.tr("Exchanged in {0} frames, from frame {1} on.").format(
                wanted.stop - wanted.start, wanted.start + self._document.original.first_frame
            )
        )

    def to_exchange(self) -> Exchange | None:
        """Return what `exchange` would exchange; None where it would do nothing.

        Without a selected time that is from the playhead to where one of the two markers goes
        missing or comes back, or to the end.
        """
        pair = list(self._view.selection)
        # Samples that are set aside are exchanged like any other.
        there = self._document.base.present[:, pair] | self._document.doubted[:, pair]
        start, stop = self._span()
        if self._view.span is None:
            changes = np.flatnonzero((there[start + 1 :] != there[start:-1]).any(axis=1))
            stop = start + 1 + int(changes[0]) if len(changes) else self._view.frames
        if not there[start:stop].any():
            return None
        return Exchange(pair[0], pair[1], start, stop)

    # --- proposed labels ---------------------------------------------------------------------

    def _decide(self, run: BadRun, decision: Decision) -> None:
        """Take note of what the user says about a label, and go to the next problem."""
        self._search.decide(run, decision)
        self._queue.step(1)
        if not self._search.suspects.labels.left:
            self.message.emit(
                self.tr("All unsure labels are looked at: apply them in the pane of labels.")
            )

    # --- how ---------------------------------------------------------------------------------

    def _fix(self, runs: Sequence[BadRun], text: str) -> None:
        if not runs:
            told = self.tr("Bad samples are not known yet: look for them first (Ctrl+F).")
            if self._search.suspects.known:
                told = self.tr("There is nothing that could be fixed.")
            self.message.emit(told)
            return
        made = self._remedy(runs)
        self._make(made, text)
        told = self.tr("Problems fixed: {0}. Samples set aside are gaps now, to be filled.")
        if len(made.correction.found_as) == len(runs):
            # All of them were exchanged.
            told = self.tr("Problems fixed: {0}.")
        self.message.emit(told.format(len(runs)))

    def _remedy(self, runs: Sequence[BadRun]) -> Step:
        """Return the step that puts bad samples right."""
        exchanges, aside = remedies(runs)
        kinds = exchanged_kinds(runs)
        return step(self._document, exchanges=exchanges, set_aside=aside, found_as=kinds)

    def _make(self, made: Step, text: str) -> None:
        self._do(EditSamples(self._document, made.edits, text, made.correction))
        self._filling.refill()

    def _current(self) -> BadRun | None:
        if self._view.suspect is None:
            self.message.emit(self.tr("There is no bad sample here: choose a problem first (N)."))
        return self._view.suspect

    def _span(self) -> tuple[int, int]:
        frame = self._view.frame
        return self._view.span or (frame, frame + 1)

    def _keep_up(self) -> None:
        """Leave a problem that is none any more, or is another."""
        run = self._view.suspect
        if run is not None and self._search.suspects.status(run) is None:
            self._view.set_suspect(None)

    def _forget_exchange(self) -> None:
        """Show no more how it would be: the samples are others now."""
        self._view.set_exchange(None)

    def _tell_found(self, count: int) -> None:
        told = self.tr("Bad samples found: {0}; they are in the queue.")
        if not count:
            told = self.tr("No bad samples were found.")
        self.message.emit(told.format(count))

    def _names(self, run: BadRun) -> str:
        other = () if run.other is None else (run.other,)
        return self._names_of((run.marker, *other))

    def _names_of(self, markers: Sequence[int]) -> str:
        names = self._document.names
        if len(markers) > 2:
            return f"{len(markers)} markers"
        return ", ".join(names[marker] for marker in markers)
