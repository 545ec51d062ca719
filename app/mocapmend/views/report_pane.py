"""The report pane: what the repairs changed, in pages, computed anew after every edit."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QTabBar, QVBoxLayout, QWidget

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.report import Methods, Report
from mocapmend.theme import Theme
from mocapmend.views.action_button import ActionButton
from mocapmend.views.report_facts import ReportFacts
from mocapmend.views.report_pages import ReportPages
from mocapmend.views.tables import in_sight
from mocapmend.viewstate import ViewState

DELAY_MS = 150
"""Undoing in a hurry asks for many reports; only the last one is computed."""


class ReportPane(QWidget):
    """The document as the file has it and as it is now."""

    failed = Signal(object)

    def __init__(
        self,
        document: Document,
        facts: ReportFacts,
        view: ViewState,
        jobs: Jobs,
        theme: Theme,
        actions: Mapping[str, QAction],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._facts = facts
        self._view = view
        self._jobs = jobs
        self._job: Job | None = None
        self.report: Report | None = None
        self._behind: tuple[Report, Methods] | None = None
        """What is to be shown when the pane is in sight."""
        self._frame_shown = -1
        self._theme = theme
        self.tabs = QTabBar()
        for title in (
            self.tr("Tracking"),
            self.tr("Bones"),
            self.tr("Markers"),
            self.tr("Methods"),
            self.tr("History"),
        ):
            self.tabs.addTab(title)
        if facts.refining() is not None:
            self.tabs.addTab(self.tr("Refinement"))
        self._check = ActionButton(actions["check_copy"], self.tr("Check a copy…"))
        self._arrange()
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY_MS)
        self._timer.timeout.connect(self._compute)
        self._timer.start()
        document.samples_changed.connect(self._timer.start)
        document.skeleton_changed.connect(self._timer.start)
        document.names_changed.connect(self._timer.start)
        view.frame_changed.connect(self._move_playheads)

    @cached_property
    def pages(self) -> ReportPages:
        """The pages: their plots take long to make, so that they are made when they are seen."""
        pages = ReportPages(self._document, self._facts, self._view, self._theme)
        self._body.addWidget(pages, 1)
        pages.setCurrentIndex(self.tabs.currentIndex())
        self.tabs.currentChanged.connect(pages.setCurrentIndex)
        for one, other in pairwise((self.tabs, *pages.fields, self._check)):
            QWidget.setTabOrder(one, other)
        return pages

    @property
    def up_to_date(self) -> bool:
        """Whether the pages show what was computed last; they do not while out of sight."""
        return self._behind is None

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self._theme = theme
        if "pages" in self.__dict__:
            self.pages.set_theme(theme)

    def show_proof(self, text: str, sentences: Sequence[str] = ()) -> None:
        """Say what is proved about the last export; the methods paragraph says it too."""
        self._proof.setText(text)
        self._proof.setToolTip("\n".join(sentences))
        self.refresh()

    def refresh(self) -> None:
        """Compute it anew, soon: the facts beside the samples have changed."""
        self._timer.start()

    def stop(self) -> None:
        """Give up what is being computed: it is out of date, or the document is going away."""
        self._timer.stop()
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def _arrange(self) -> None:
        self.tabs.setAccessibleName(self.tr("Pages of the report"))
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        self._proof = QLabel()
        self._proof.setTextFormat(Qt.TextFormat.PlainText)
        self._proof.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._proof.setWordWrap(True)
        # A long sentence must not stretch the window.
        self._proof.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        head = QHBoxLayout()
        head.setSpacing(12)
        head.addWidget(self.tabs)
        head.addWidget(self._proof, 1)
        head.addWidget(self._check)
        self._body = QVBoxLayout(self)
        self._body.setContentsMargins(4, 4, 4, 4)
        self._body.setSpacing(4)
        self._body.addLayout(head)
        # Until there are pages.
        self._body.addStretch(0)
        self.setFocusProxy(self.tabs)

    def _compute(self) -> None:
        self.stop()
        document = self._document
        if document.found_skeleton is None:
            # It comes soon, and a report without bones would only hold it up.
            return
        job = self._jobs.compute(
            self.tr("Report"),
            engine.report_figures,
            document.share_original(),
            document.share(),
            document.skeleton,
            document.repair_rows(),
            self._facts.unfilled(),
            self._facts.about(),
            quiet=True,
        )
        job.finished.connect(self._show)
        job.failed.connect(self.failed)
        self._job = job

    def _show(self, result: tuple[Report, Methods]) -> None:
        self.report = result[0]
        self._behind = result
        self._catch_up()

    def _catch_up(self) -> None:
        """Show the figures that came while the pane was out of sight."""
        if self._behind is None or not in_sight(self):
            return
        (self.report, methods), self._behind = self._behind, None
        self.pages.show_report(self.report, methods)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        # What is painted has come in sight. Later: nothing may change while it is painted.
        if not self.up_to_date or self._frame_shown != self._view.frame:
            QTimer.singleShot(0, self, self._show_anew)

    def _show_anew(self) -> None:
        self._catch_up()
        self._move_playheads()

    def _move_playheads(self) -> None:
        if in_sight(self):
            self._frame_shown = self._view.frame
            self.pages.show_frame(self._view.frame)
