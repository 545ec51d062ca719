"""Tries repairs on all open gaps in the background, so that the worst can come first."""

import math

from PySide6.QtCore import QElapsedTimer, QObject, Signal

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.prospects import Prospects, Way
from mocapmend.ranking import METHODS
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult

PORTION_S = 0.7
"""What is computed at a time: a preview that the user waits for comes in between."""
FIRST_PORTION = 12
LARGEST_PORTION = 500


class Survey(QObject):
    """Fills a document's prospects, the longest gaps first.

    Signals
    -------
    advanced :
        More is known, or nothing is left to do.
    failed : Exception
        It has stopped.
    """

    advanced = Signal()
    failed = Signal(object)

    def __init__(
        self, document: Document, prospects: Prospects, jobs: Jobs, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._prospects = prospects
        self._jobs = jobs
        self._ways = [Way.default(method) for method in METHODS]
        self._portion = FIRST_PORTION
        self._gaps: list[Gap] = []
        """The gaps that can be repaired at all, the longest first."""
        self._listed = -1
        """The document's revision that they are of."""
        self._clock = QElapsedTimer()
        self._job: Job | None = None
        self.on = False
        self.portions = 0
        """How many were computed."""
        document.base_changed.connect(self._abandon)
        document.samples_changed.connect(self._go_on)
        document.names_changed.connect(self._begin_again)

    def start(self) -> None:
        """Begin, or go on."""
        self.on = True
        self._go_on()

    def stop(self) -> None:
        """Do no more; what is known is kept."""
        self.on = False
        self._abandon()

    def _abandon(self) -> None:
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _begin_again(self) -> None:
        """Compute nothing with former names: parameters and results name markers."""
        self._abandon()
        self._go_on()

    @property
    def running(self) -> bool:
        """Whether something is being computed."""
        return self._job is not None

    def progress(self) -> tuple[int, int]:
        """Return how many of the open gaps have been tried, and how many there are."""
        tried, gaps = self._prospects.errors, self._document.fillable
        return sum(gap in tried for gap in gaps) if tried else 0, len(gaps)

    def _list(self) -> None:
        """List the gaps anew where they have changed."""
        if self._listed != self._document.revision:
            self._gaps = sorted(self._document.fillable, key=lambda gap: -gap.length)
            self._listed = self._document.revision

    def _go_on(self) -> None:
        if not self.on or self._job is not None:
            return
        self._list()
        for way in self._ways:
            known = self._prospects.known(way)
            left = [gap for gap in self._gaps if gap not in known]
            if left:
                self._compute(way, left[: self._portion])
                return

    def _compute(self, way: Way, gaps: list[Gap]) -> None:
        job = self._jobs.compute(
            self.tr("Ranking"),
            engine.fill_anyway,
            self._document.share_base(),
            gaps,
            *way,
            quiet=True,
        )
        self._clock.start()
        job.finished.connect(lambda result: self._keep(way, gaps, result))
        job.failed.connect(self._give_up)
        self._job = job

    def _keep(self, way: Way, gaps: list[Gap], result: FillResult) -> None:
        self._prospects.add(way, gaps, result)
        seconds = max(1e-3, self._clock.elapsed() / 1000.0)
        wanted = math.ceil(len(gaps) * PORTION_S / seconds)
        self._portion = max(1, min(wanted, 4 * self._portion, LARGEST_PORTION))
        self._job = None
        self.portions += 1
        self._go_on()
        self.advanced.emit()

    def _give_up(self, error: Exception) -> None:
        self._job = None
        self.on = False
        self.advanced.emit()
        self.failed.emit(error)
