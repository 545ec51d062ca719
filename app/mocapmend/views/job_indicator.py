"""The status bar's view of background work: what runs, how far, and a way to stop it."""

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QToolButton, QWidget

from mocapmend.jobs import Job, Jobs

TITLE_WIDTH = 240
PATIENCE_MS = 250
"""What ends sooner is not shown: a flicker tells nothing."""


class JobIndicator(QWidget):
    """Shows the newest of the jobs that take longer than a moment."""

    def __init__(self, jobs: Jobs, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._jobs: list[Job] = []
        self._title = QLabel()
        self._bar = QProgressBar()
        self._bar.setRange(0, 100)
        self._bar.setFixedWidth(140)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress"))
        self._cancel = QToolButton()
        self._cancel.setObjectName("cancel_job")
        self._cancel.setText(self.tr("Cancel"))
        self._cancel.clicked.connect(self._stop)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._title.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for part in (self._title, self._bar, self._cancel):
            layout.addWidget(part)
        self._patience = QTimer(self)
        self._patience.setSingleShot(True)
        self._patience.setInterval(PATIENCE_MS)
        self._patience.timeout.connect(self.show)
        jobs.started.connect(self._follow)
        jobs.ended.connect(self._leave)
        self.hide()

    def _follow(self, job: Job) -> None:
        if job.quiet:
            return
        self._jobs.append(job)
        job.progressed.connect(self._show_progress)
        self._show_newest()

    def _leave(self, job: Job) -> None:
        if job in self._jobs:
            self._jobs.remove(job)
            self._show_newest()

    def _show_newest(self) -> None:
        if not self._jobs:
            self._patience.stop()
            self.hide()
            return
        title = self._jobs[-1].title
        self._title.setText(
            self._title.fontMetrics().elidedText(title, Qt.TextElideMode.ElideMiddle, TITLE_WIDTH)
        )
        self._show_progress()
        if not (self.isVisible() or self._patience.isActive()):
            self._patience.start()

    def _show_progress(self) -> None:
        self._bar.setValue(round(100 * self._jobs[-1].progress))

    def _stop(self) -> None:
        if self._jobs:
            self._jobs[-1].cancel()
