"""The status bar's view of background work: what runs, how far, and a way to stop it."""

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QToolButton, QWidget

from mocapmend.jobs import Job, Jobs

PATIENCE_MS = 250
"""What ends sooner is not shown: a flicker tells nothing."""


class JobIndicator(QWidget):
    """Shows the newest job that takes longer than a moment."""

    def __init__(self, jobs: Jobs, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._job: Job | None = None
        self._title = QLabel()
        self._bar = QProgressBar()
        self._bar.setRange(0, 100)
        self._bar.setFixedWidth(140)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress"))
        self._cancel = QToolButton()
        self._cancel.setText(self.tr("Cancel"))
        self._cancel.clicked.connect(self._stop)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for part in (self._title, self._bar, self._cancel):
            layout.addWidget(part)
        self._patience = QTimer(self)
        self._patience.setSingleShot(True)
        self._patience.setInterval(PATIENCE_MS)
        self._patience.timeout.connect(self.show)
        jobs.started.connect(self._follow)
        self.hide()

    def _follow(self, job: Job) -> None:
        self._job = job
        self._title.setText(job.title)
        self._bar.setValue(0)
        job.progressed.connect(lambda share: self._show_progress(job, share))
        job.ended.connect(lambda: self._leave(job))
        self._patience.start()

    def _show_progress(self, job: Job, share: float) -> None:
        if job is self._job:
            self._bar.setValue(round(100 * share))

    def _leave(self, job: Job) -> None:
        if job is self._job:
            self._job = None
            self._patience.stop()
            self.hide()

    def _stop(self) -> None:
        if self._job is not None:
            self._job.cancel()
