"""Looking for the labels of a recording in the background."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.label_review import LabelReview
from mocapmend.settings import LEAST_CONFIDENCE, Settings
from mocapmend_algorithms.labelling import Labelling, LabelParams

Stand = tuple[int, tuple[str, ...]]
"""What proposals are for: the state of the believed samples, and the labels."""


class LabelSearch(QObject):
    """Proposes labels for a document, as other recordings have them.

    Attributes
    ----------
    review : LabelReview or None
        What was proposed last.

    Signals
    -------
    started, ended :
        Something is being computed, or no longer.
    changed :
        There is another review, or none; or the recording is another one than it is for, or the
        same again.
    decided :
        Something was said about a proposal.
    message : str
        Something the user should read in passing.
    failed : Exception
        It could not be done.
    """

    started = Signal()
    ended = Signal()
    changed = Signal()
    decided = Signal()
    message = Signal(str)
    failed = Signal(object)

    def __init__(
        self, document: Document, jobs: Jobs, settings: Settings, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._jobs = jobs
        self._asked: tuple[tuple[Path, ...], LabelParams] | None = None
        self._stand: Stand | None = None
        self._settings = settings
        self.review: LabelReview | None = None
        self.job: Job | None = None
        document.base_changed.connect(self.changed)
        document.names_changed.connect(self.changed)

    @property
    def up_to_date(self) -> bool:
        """Whether the recording is as it was when labels were proposed."""
        return self.review is not None and self._stand == self._now()

    @property
    def least(self) -> float:
        """The confidence from which on labels are given without being accepted."""
        return self._settings.get(LEAST_CONFIDENCE)

    def set_least(self, least: float) -> None:
        """Give labels from another confidence on, and remember it."""
        self._settings.set(LEAST_CONFIDENCE, least)
        if self.review is not None:
            self.review.least = least

    def start(self, paths: Sequence[Path], *, keep_names: bool) -> None:
        """Propose labels as labelled recordings have them.

        Parameters
        ----------
        paths : sequence of Path
            The labelled recordings.
        keep_names : bool
            Whether names that the recording has are trusted.
        """
        self._asked = tuple(paths), LabelParams(keep_names=keep_names)
        self.again()

    def again(self) -> None:
        """Propose labels anew, from the same recordings."""
        if self._asked is None or self.job is not None:
            return
        stand = self._now()
        job = self._jobs.compute(
            self.tr("Labelling"), engine.label_from, self._document.share_base(), *self._asked
        )
        job.finished.connect(lambda found: self._take(found, stand))
        job.failed.connect(self.failed)
        job.cancelled.connect(self._tell_cancelled)
        job.ended.connect(self._end)
        self.job = job
        self.started.emit()

    def discard(self) -> None:
        """Forget what was proposed."""
        self.review = None
        self.changed.emit()

    def stop(self) -> None:
        """Give up what is being computed: the document is going away."""
        if self.job is not None:
            self.job.abandon()
            self.job = None

    def _now(self) -> Stand:
        return self._document.base_revision, self._document.labels

    def _take(self, found: Labelling, stand: Stand) -> None:
        self._stand = stand
        self.review = LabelReview(found, self.least)
        count = len(self.review)
        told = self.tr("Pieces with a proposed label: {0}. Nothing is changed yet.")
        if not count:
            told = self.tr("All points have names that the labelled recordings have.")
        self.message.emit(told.format(count))
        self.changed.emit()

    def _tell_cancelled(self) -> None:
        self.message.emit(self.tr("Cancelled: no labels are proposed."))

    def _end(self) -> None:
        self.job = None
        self.ended.emit()
