"""Computes the repair of the current gap in the background and drops what is out of date."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.jobs import Job, Jobs
from mocapmend.viewstate import Preview, ViewState
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult

DELAY_MS = 40
"""Scrolling through methods or gaps asks for many previews; only the last one is computed."""


class Previewer(QObject):
    """Keeps the view state's preview true to its gap, the chosen method and the document."""

    failed = Signal(object)

    def __init__(
        self, document: Document, view: ViewState, jobs: Jobs, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._jobs = jobs
        self._method: tuple[str, Any] | None = None
        self._job: Job | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self._start)
        view.gap_changed.connect(self._refresh)
        document.samples_changed.connect(self._refresh)

    def choose(self, method: str, params: object) -> None:
        """Preview with another method or other parameters."""
        self._method = (method, params)
        self._refresh()

    def stop(self) -> None:
        """Give up what is being computed: the document is going away."""
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _refresh(self) -> None:
        self.stop()
        self._view.set_preview(None)
        gap = self._view.gap
        if gap is not None and gap in self._document.gaps_of(gap.marker):
            self._timer.start()

    def _start(self) -> None:
        gap = self._view.gap
        if gap is None or self._method is None:
            return
        method, params = self._method
        job = self._jobs.compute(
            self.tr("Preview"),
            engine.fill_gap,
            self._document.share_original(),
            gap,
            method,
            params,
            quiet=True,
        )
        job.finished.connect(lambda result: self._show(gap, method, params, result))
        none = partial(Preview, gap, method, params, None)
        job.cancelled.connect(
            lambda: self._view.set_preview(none(self.tr("the preview was cancelled")))
        )
        job.failed.connect(lambda error: self._tell(error, none))
        self._job = job

    def _tell(self, error: Exception, none: Callable[[str], Preview]) -> None:
        """Show what the user can mend where the preview would be: no dialog at every gap."""
        if isinstance(error, MocapmendError):
            self._view.set_preview(none(str(error)))
        else:
            self._view.set_preview(none(self.tr("the preview failed")))
            self.failed.emit(error)

    def _show(self, gap: Gap, method: str, params: object, result: FillResult) -> None:
        if result.patches:
            preview = Preview(
                gap,
                method,
                params,
                result.patches[0],
                note=result.notes.get(gap, {}),
                donors=result.donors(gap),
            )
        else:
            preview = Preview(gap, method, params, None, reason=result.unfilled[0].reason)
        self._view.set_preview(preview)
