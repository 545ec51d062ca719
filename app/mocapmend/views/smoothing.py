"""Smoothing in the window: looking ahead, applying it, taking it off.

Names of edits are English, for reports and journals; they are translated where shown.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend import engine
from mocapmend.beneath import beneath, share_beneath, without_smoothing
from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.errors import MocapmendError
from mocapmend.jobs import Job, Jobs
from mocapmend.smoothing import Outlook, SmoothWay, found_nothing, look_ahead
from mocapmend.views.engine_texts import error_text
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.contract import SmoothResult

DELAY_MS = 120
"""Turning a number asks for many previews; only the last one is computed."""


class Asked(NamedTuple):
    """What is to be smoothed, and how."""

    way: SmoothWay
    runs: tuple[Gap, ...]
    shown: int | None


class Smoothing(QObject):
    """Smooths runs of a document.

    Parameters
    ----------
    do : callable
        Does an undo command.

    Signals
    -------
    message : str
        Something the user should read in passing.
    looked :
        There is another preview, or none, or a reason why there is none.
    started, ended :
        Something is being smoothed, or no longer.
    """

    message = Signal(str)
    failed = Signal(object)
    looked = Signal()
    started = Signal()
    ended = Signal()

    def __init__(
        self,
        document: Document,
        view: ViewState,
        jobs: Jobs,
        do: Callable[[EditSamples], None],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._jobs = jobs
        self._do = do
        self._asked: Asked | None = None
        self._found: tuple[int, Asked] | None = None
        """The revision and the question that the outlook is an answer to."""
        self.outlook: Outlook | None = None
        self.refused = ""
        """Why there is no outlook."""
        self._looking: Job | None = None
        self.job: Job | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self._look)

    def stop(self) -> None:
        """Give up what is being computed: the document is going away."""
        self._stop_looking()
        if self.job is not None:
            self.job.abandon()
            self.job = None

    # --- looking ahead -----------------------------------------------------------------------

    def look_ahead(self, way: SmoothWay, runs: Sequence[Gap], shown: int | None) -> None:
        """Compute soon what smoothing would do, and show it in the plots."""
        asked = Asked(way, tuple(runs), shown)
        if self._found == (self._document.revision, asked):
            return
        self._stop_looking()
        self._asked = asked
        self._show(None)
        if runs:
            self._timer.start()

    def look_away(self) -> None:
        """Show no preview any more."""
        self._stop_looking()
        self._asked = None
        self._show(None)

    @property
    def busy(self) -> bool:
        """Whether a preview is still to come."""
        return self._looking is not None or self._timer.isActive()

    def _stop_looking(self) -> None:
        self._timer.stop()
        if self._looking is not None:
            self._looking.abandon()
            self._looking = None

    def _look(self) -> None:
        asked, revision = self._asked, self._document.revision
        if asked is None:
            return
        job = self._jobs.compute(
            self.tr("Preview"),
            look_ahead,
            share_beneath(self._document),
            asked.runs,
            asked.way,
            asked.shown,
            quiet=True,
        )
        job.finished.connect(lambda outlook: self._take(revision, asked, outlook))
        job.failed.connect(self._refuse)
        self._looking = job

    def _take(self, revision: int, asked: Asked, outlook: Outlook) -> None:
        self._looking = None
        if revision == self._document.revision:
            self._found = revision, asked
            self._show(outlook)

    def _refuse(self, error: Exception) -> None:
        self._looking = None
        if isinstance(error, MocapmendError):
            self._show(None, error_text(error))
        else:
            self._show(None)
            self.failed.emit(error)

    def _show(self, outlook: Outlook | None, refused: str = "") -> None:
        if outlook is None:
            self._found = None
        self.outlook, self.refused = outlook, refused
        done = () if outlook is None else outlook.result.runs
        new = tuple(each for each in done if not self.is_applied(each.run))
        self._view.set_smoothing(new)
        self.looked.emit()

    def is_applied(self, run: Gap) -> bool:
        """Say whether a run is smoothed just as the preview is."""
        made = self._document.smoothed.get(run)
        if made is None or self.outlook is None:
            return False
        result = self.outlook.result
        return (made.method, dict(made.params)) == (result.method, result.params)

    # --- doing it ----------------------------------------------------------------------------

    def apply(self, way: SmoothWay, runs: Sequence[Gap]) -> None:
        """Smooth runs, in one undoable step."""
        if self.job is not None:
            self.message.emit(self.tr("Smoothing is still going on."))
            return
        if not runs:
            self.message.emit(self.tr("Nothing to smooth: select markers that are seen here."))
            return
        revision, known = self._document.revision, self._found
        if known is not None and self.outlook is not None:
            same = known[0] == revision and known[1][:2] == (way, tuple(runs))
            if same:
                self._accept(revision, way, self.outlook.result)
                return
        job = self._jobs.compute(
            self.tr("Smoothing {0} markers").format(len(runs)),
            engine.smooth,
            share_beneath(self._document),
            list(runs),
            *way,
        )
        job.finished.connect(lambda result: self._accept(revision, way, result))
        job.failed.connect(self.failed)
        job.cancelled.connect(self._tell_cancelled)
        job.ended.connect(self._end)
        self.job = job
        self.started.emit()

    def take_off(self, runs: Sequence[Gap]) -> None:
        """Take off all smoothing that overlaps some runs, in one undoable step."""
        document = self._document
        edits = without_smoothing(document, (), runs)
        if edits:
            text = f"take smoothing off {self._what(edits)}"
            self._do(EditSamples(document, edits, text))
            self.message.emit(self.tr("Smoothing taken off: stretches {0}.").format(len(edits)))
        elif any(one.marker == run.marker for run in runs for one in document.smoothed):
            self.message.emit(
                self.tr("This file came smoothed: what was measured is in the original alone.")
            )
        else:
            self.message.emit(self.tr("There is no smoothing here."))

    def _accept(self, revision: int, way: SmoothWay, result: SmoothResult) -> None:
        document = self._document
        if document.revision != revision:
            self.message.emit(self.tr("The recording was edited meanwhile: smooth again."))
            return
        edits = Edit.smoothings(result, partial(beneath, document))
        if not edits:
            self.message.emit(self.tr("Nothing was smoothed: the stretches are too short."))
            return
        text = f"smooth {self._what(edits)} ({result.method})"
        self._do(EditSamples(document, edits, text))
        self.message.emit(self._told(way, result))

    def _told(self, way: SmoothWay, result: SmoothResult) -> str:
        """Say what was changed, and what was not."""
        original = self._document.original
        shifts = np.concatenate([done.shifts for done in result.runs]) * original.mm
        text = self.tr("Markers smoothed: {0}; samples moved by {1} mm RMS, {2} mm at most.")
        parts = [
            text.format(
                len({done.run.marker for done in result.runs}),
                f"{np.sqrt(np.nanmean(shifts**2)):.2f}",
                f"{np.nanmax(shifts):.1f}",
            )
        ]
        if result.untouched:
            text = self.tr("Stretches left as they were: {0}.")
            parts.append(text.format(len(result.untouched)))
        idle = [one for one in result.runs if found_nothing(one, way.params, original.rate)]
        if idle:
            text = self.tr("Next to nothing was found to smooth in {0} of them.")
            parts.append(text.format(len(idle)))
        return " ".join(parts)

    def _what(self, edits: Sequence[Edit]) -> str:
        markers = {edit.gap.marker for edit in edits}
        if len(markers) == 1:
            return self._document.names[edits[0].gap.marker]
        return f"{len(markers)} markers"

    def _tell_cancelled(self) -> None:
        self.message.emit(self.tr("Cancelled: nothing was smoothed."))

    def _end(self) -> None:
        self.job = None
        self.ended.emit()
