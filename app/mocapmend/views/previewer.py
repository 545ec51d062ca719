"""Computes repairs of the current gap in the background and drops what is out of date."""

from collections.abc import Sequence

from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.jobs import Job, Jobs
from mocapmend.prospects import Preview, Prospects, Way
from mocapmend.suspects import gap_to_be
from mocapmend.views.engine_texts import error_text
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult

DELAY_MS = 40
"""Scrolling through methods or gaps asks for many previews; only the last ones are computed."""


class Previewer(QObject):
    """Keeps the view state's preview and candidates true to its gap and the chosen ways.

    The chosen way comes first, then the others, one after another.
    """

    failed = Signal(object)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        prospects: Prospects,
        jobs: Jobs,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._prospects = prospects
        self._jobs = jobs
        self._chosen: Way | None = None
        self._others: tuple[Way, ...] = ()
        self._refused: dict[Way, Preview] = {}
        """Ways that ended with an error for the current gap: they are tried again at the next."""
        self._job: Job | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self._compute_next)
        view.gap_changed.connect(self._refresh)
        view.suspect_changed.connect(self._refresh)
        document.samples_changed.connect(self._refresh)
        document.names_changed.connect(self._refresh)

    def choose(self, chosen: Way, others: Sequence[Way]) -> None:
        """Preview with another way, beside other candidates in the order of their numbers."""
        self._chosen, self._others = chosen, tuple(others)
        self._refresh()

    def stop(self) -> None:
        """Give up what is being computed: the document is going away."""
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    @property
    def busy(self) -> bool:
        """Whether a candidate is still to come."""
        return self._job is not None or self._timer.isActive()

    def _refresh(self) -> None:
        self.stop()
        self._refused = {}
        gap = self._open_gap()
        if gap is None:
            self._view.set_preview(None)
            self._view.set_candidates(())
            return
        self._show(gap)
        if self._missing(gap) is not None:
            self._timer.start()

    def _open_gap(self) -> Gap | None:
        run, gap = self._view.suspect, self._view.gap
        if run is not None:
            return gap_to_be(self._document, run)
        return gap if gap is not None and gap in self._document.gaps_of(gap.marker) else None

    def _known(self, gap: Gap, way: Way) -> Preview | None:
        return self._refused.get(way) or self._prospects.get(gap, way)

    def _missing(self, gap: Gap) -> Way | None:
        """Return the next way to compute: of what is still to be a gap the chosen one alone."""
        others = self._others if self._view.suspect is None else ()
        wanted = (*(() if self._chosen is None else (self._chosen,)), *others)
        return next((way for way in wanted if self._known(gap, way) is None), None)

    def _show(self, gap: Gap) -> None:
        chosen = None if self._chosen is None else self._known(gap, self._chosen)
        self._view.set_preview(chosen)
        if self._view.suspect is not None:
            self._view.set_candidates(())
            return
        known = ((number, self._known(gap, way)) for number, way in enumerate(self._others, 1))
        self._view.set_candidates(
            tuple((number, preview) for number, preview in known if preview is not None)
        )

    def _compute_next(self) -> None:
        gap = self._open_gap()
        way = None if gap is None else self._missing(gap)
        if gap is None or way is None:
            return
        job = self._jobs.compute(
            self.tr("Preview"),
            engine.fill_gap,
            self._document.share_base(),
            gap,
            *way,
            quiet=True,
        )
        job.finished.connect(lambda result: self._keep(gap, way, result))
        job.cancelled.connect(lambda: self._refuse(gap, way, "the preview was cancelled"))
        job.failed.connect(lambda error: self._tell(gap, way, error))
        self._job = job

    def _keep(self, gap: Gap, way: Way, result: FillResult) -> None:
        self._prospects.add(way, [gap], result)
        self._go_on(gap)

    def _tell(self, gap: Gap, way: Way, error: Exception) -> None:
        """Show what the user can mend where the preview would be: no dialog at every gap."""
        if isinstance(error, MocapmendError):
            self._refuse(gap, way, error_text(error))
        else:
            self._refuse(gap, way, "the preview failed")
            self.failed.emit(error)

    def _refuse(self, gap: Gap, way: Way, reason: str) -> None:
        self._refused[way] = Preview(gap, *way, None, reason)
        self._go_on(gap)

    def _go_on(self, gap: Gap) -> None:
        self._job = None
        self._show(gap)
        self._compute_next()
