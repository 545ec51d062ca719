"""Looks for the bones of a document in the background, and again when its markers are renamed."""

from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend import engine
from mocapmend.document import NO_SKELETON, Document
from mocapmend.jobs import Job, Jobs

REST_MS = 300
"""After other names came: bones are looked for once, also where several steps are undone."""


class BoneSearch(QObject):
    """Brings a document the bones that its file does not name.

    Signals
    -------
    failed : Exception
        None could be looked for: the document goes on without.
    """

    failed = Signal(object)

    def __init__(self, document: Document, jobs: Jobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._jobs = jobs
        self._job: Job | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(REST_MS)
        self._timer.timeout.connect(self._look)
        document.names_changed.connect(self._look_again)

    def start(self) -> None:
        """Look, where the bones are not known yet."""
        if self._document.found_skeleton is None:
            self._look()

    def stop(self) -> None:
        """Look no more: the document is going away."""
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()

    def _look_again(self) -> None:
        """Look for other bones: which are known depends on what the markers are called."""
        if self._document.found_skeleton is not None and not self._document.source.bones:
            self._timer.start()

    def _look(self) -> None:
        self.stop()
        job = self._jobs.compute(
            self.tr("Skeleton"), engine.search_skeleton, self._document.share_base(), quiet=True
        )
        job.finished.connect(self._document.set_skeleton)
        job.failed.connect(self._do_without)
        self._job = job

    def _do_without(self, error: Exception) -> None:
        self._document.set_skeleton(NO_SKELETON)
        self.failed.emit(error)
