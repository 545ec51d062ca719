"""Where the user begins: at a gap at once, and at the worst problem when that is known."""

from PySide6.QtCore import QObject

from mocapmend.document import Document
from mocapmend.navigation import place_to_begin
from mocapmend.ranking import Problem, Status
from mocapmend.views.bad_search import BadSearch
from mocapmend.views.queue_pane import QueuePane
from mocapmend.views.survey import Survey
from mocapmend.viewstate import ViewState


class Beginning(QObject):
    """Leads the user, with the whole recording in view, as long as nothing has been begun."""

    def __init__(
        self,
        document: Document,
        view: ViewState,
        queue: QueuePane,
        survey: Survey,
        search: BadSearch,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._queue = queue
        self._survey = survey
        self._first = place_to_begin(document.original, document.fillable_corners)
        survey.advanced.connect(self._lead)
        search.changed.connect(self._lead_to_bad)
        if self._first is not None:
            self._show(Problem(self._first, Status.OPEN))
        elif document.original.markers:
            view.select((0,))

    def _lead(self) -> None:
        """Begin at the worst problem that is known, unless the user has begun already."""
        untouched = self._view.gap == self._first and self._view.suspect is None
        if self._survey.portions == 1 and untouched and not self._document.undo_stack.count():
            self._show(self._queue.worst())

    def _lead_to_bad(self) -> None:
        """Begin at the worst of the bad samples where there is no gap to begin at."""
        view = self._view
        untouched = view.gap is None and view.suspect is None and view.selection == (0,)
        if self._first is None and untouched and not self._document.undo_stack.count():
            self._show(self._queue.worst())

    def _show(self, problem: Problem | None) -> None:
        """Show a problem with the whole recording around it."""
        if problem is None:
            return
        self._view.select((problem.gap.marker,))
        if problem.bad is None:
            self._view.set_gap(problem.gap)
        else:
            self._view.set_suspect(problem.bad)
        self._view.set_frame((problem.gap.start + problem.gap.stop - 1) // 2)
