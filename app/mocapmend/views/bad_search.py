"""Looks for bad samples in the background, and again after each correction."""

from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.label_review import Decision, LabelReview
from mocapmend.suspects import Suspects
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun, detect

REST_MS = 400
"""How long no correction was made before it is looked again."""


class BadSearch(QObject):
    """Knows the suspects of a document, and has them looked for.

    Signals
    -------
    changed :
        Others are known, or something was decided about them.
    decided :
        Something was said about a proposed label.
    done : int
        The search that the user has asked for has found so many.
    failed : Exception
        It has stopped.
    """

    changed = Signal()
    decided = Signal()
    done = Signal(int)
    failed = Signal(object)

    def __init__(self, document: Document, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.suspects = Suspects(document)
        self._document = document
        self._jobs = jobs
        self._job: Job | None = None
        self.on = False
        self._asked = False
        """Whether the user waits for it."""
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(REST_MS)
        self._timer.timeout.connect(self._look)
        document.base_changed.connect(self._abandon)
        document.samples_changed.connect(self._keep_up)
        document.skeleton_changed.connect(self._go_on)
        document.names_changed.connect(self._look_again)

    def start(self) -> None:
        """Begin, or go on."""
        self.on = True
        self._go_on()

    def stop(self) -> None:
        """Do no more; what is known is kept."""
        self.on = self._asked = False
        self._abandon()

    def search(self) -> None:
        """Look now, since the user has asked for it."""
        if self.suspects.known:
            self.done.emit(len(self.suspects.found))
            return
        self._abandon()
        self._asked = True
        self._look()

    @property
    def running(self) -> bool:
        """Whether it is being looked, or will be in a moment."""
        return self._job is not None or self._timer.isActive()

    def dismiss(self, run: BadRun) -> None:
        """Take note that a run is no problem, or that it is one after all."""
        if self.suspects.is_dismissed(run):
            self.suspects.take_up(run)
        else:
            self.suspects.dismiss(run)
        self.changed.emit()

    def show_labels(self, review: LabelReview | None) -> None:
        """List the proposed labels of a review, or none."""
        self.suspects.labels.take(review)
        self.changed.emit()

    def decide(self, run: BadRun, decision: Decision) -> None:
        """Take note of what the user says about a proposed label."""
        self.suspects.labels.decide(run, decision)
        self.decided.emit()

    def _abandon(self) -> None:
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _keep_up(self, changed: tuple[Gap, ...]) -> None:
        if self.suspects.keep_up(changed):
            self.changed.emit()
            self._go_on()

    def _look_again(self) -> None:
        """Look once more: a point that has got a label is no ghost, and one without may be."""
        self._abandon()
        self.suspects.doubt()
        self.changed.emit()
        self._go_on()

    def _go_on(self) -> None:
        """Look in a moment, where that is wanted and something is to be found out."""
        wanted = self.on or self._asked
        if wanted and self._job is None and not self.suspects.known:
            self._timer.start()

    def _look(self) -> None:
        document = self._document
        if document.found_skeleton is None or not document.repairable:
            # The bones bring it back here.
            return
        base = document.base_revision
        job = self._jobs.compute(
            self.tr("Looking for bad samples"),
            detect,
            document.share_base(),
            document.skeleton,
            None,
            quiet=not self._asked,
        )
        job.finished.connect(lambda found: self._keep(base, found))
        job.failed.connect(self._give_up)
        job.cancelled.connect(self._rest)
        self._job = job

    def _keep(self, base: int, found: list[BadRun]) -> None:
        self.suspects.take(base, found)
        self._job = None
        self.changed.emit()
        if self._asked:
            self._asked = False
            self.done.emit(len(self.suspects.found))

    def _rest(self) -> None:
        """Look no more: the user has cancelled it."""
        self._job = None
        self.on = self._asked = False
        self.changed.emit()

    def _give_up(self, error: Exception) -> None:
        self._rest()
        self.failed.emit(error)
