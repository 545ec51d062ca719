"""The pages of the report, one on top of the other."""

from PySide6.QtWidgets import QStackedWidget, QWidget

from mocapmend.document import Document
from mocapmend.report import Methods, Report
from mocapmend.theme import Theme
from mocapmend.views.report_bones import BonesPage
from mocapmend.views.report_facts import ReportFacts
from mocapmend.views.report_markers import MarkersPage
from mocapmend.views.report_refinement import RefinementPage
from mocapmend.views.report_texts import HistoryPage, MethodsPage
from mocapmend.views.report_tracking import TrackingPage
from mocapmend.viewstate import ViewState


class ReportPages(QStackedWidget):
    """Tracking, bones, markers, methods and history; of a refined recording, how it was made."""

    def __init__(
        self,
        document: Document,
        facts: ReportFacts,
        view: ViewState,
        theme: Theme,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.tracking = TrackingPage(document, theme)
        self.bones = BonesPage(document, theme)
        self.markers = MarkersPage(document, view)
        self.methods = MethodsPage()
        self.history = HistoryPage(document, facts)
        for page in (self.tracking, self.bones, self.markers, self.methods, self.history):
            self.addWidget(page)
        self._facts = facts
        self.refinement: RefinementPage | None = None
        if facts.refining() is not None:
            self.refinement = RefinementPage()
            self.addWidget(self.refinement)

    @property
    def fields(self) -> tuple[QWidget, ...]:
        """What takes the keyboard, in the order of the tab key."""
        last = self.refinement
        return (
            self.tracking.unit,
            self.bones.table,
            self.markers.table,
            self.methods.text,
            self.methods.copy,
            self.history.table,
            *(() if last is None else (last.text, last.errors, last.distances)),
        )

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        self.tracking.set_theme(theme)
        self.bones.set_theme(theme)

    def show_report(self, report: Report, methods: Methods) -> None:
        """Show other figures."""
        self.tracking.show_report(report)
        self.bones.show_report(report)
        self.markers.show_report(report)
        self.methods.show_methods(methods)
        if self.refinement is not None:
            self.refinement.show_refining(self._facts.refining())

    def show_frame(self, frame: int) -> None:
        """Move the playheads of the plots."""
        for plot in (*self.tracking.plots, self.bones.plot):
            plot.show_frame(frame)
