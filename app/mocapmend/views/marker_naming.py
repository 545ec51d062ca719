"""Names and labels of a document: by hand, or proposed as other recordings have them."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QAction

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.jobs import Jobs
from mocapmend.settings import Settings
from mocapmend.theme import Theme
from mocapmend.views.bad_search import BadSearch
from mocapmend.views.filling import Filling
from mocapmend.views.hand_label_actions import HandLabelActions
from mocapmend.views.label_chooser import LabelChooser
from mocapmend.views.label_dialog import LabelDialog
from mocapmend.views.label_pane import LabelPane
from mocapmend.views.label_search import LabelSearch
from mocapmend.views.paned_window import PanedWindow
from mocapmend.views.renaming_actions import RenamingActions
from mocapmend.viewstate import ViewState


class MarkerNaming(QObject):
    """Asks for names and labels, has labels looked for, and lists the unsure ones in the queue.

    Parameters
    ----------
    bad_search : BadSearch
        Has the list of what somebody should look at.
    do : callable
        Does an undo command.
    around : PanedWindow
        Has the pane of proposed labels; dialogs stand over it.

    Signals
    -------
    message : str
        Something the user should read in passing.
    failed : Exception
        Something that could not be done.
    """

    message = Signal(str)
    failed = Signal(object)

    def __init__(
        self,
        document: Document,
        view: ViewState,
        bad_search: BadSearch,
        filling: Filling,
        do: Callable[[EditSamples], None],
        jobs: Jobs,
        settings: Settings,
        theme: Theme,
        actions: dict[str, QAction],
        around: PanedWindow,
    ) -> None:
        super().__init__(around)
        self._document = document
        self._view = view
        self._bad_search = bad_search
        self._settings = settings
        self.renaming = RenamingActions(document, view, do, self)
        self.by_hand = HandLabelActions(document, view, filling, do, self)
        self.search = LabelSearch(document, jobs, settings, self)
        # Before the pane, which asks what is listed.
        for told in (self.search.changed, self.search.decided):
            told.connect(self._list_unsure)
        unsure = bad_search.suspects.labels
        self.pane = LabelPane(document, view, self.search, unsure, filling, do, theme, actions)
        bad_search.decided.connect(self.search.decided)
        self.search.failed.connect(self.failed)
        for part in (self.renaming, self.by_hand, self.search, self.pane):
            part.message.connect(self.message)

    def ask_label(self) -> None:
        """Ask which marker the current one is; nothing waits for the answer."""
        choices, marker = self.by_hand.choices(), self._view.marker
        if choices is None or marker is None:
            return
        names, take = self._document.names, self.by_hand.this_is
        free, taken = ([names[other] for other in some] for some in choices)
        review = self.search.review
        unused = [label for label in (review.labels if review else ()) if label not in names]
        new, over = self.by_hand.may_be_new(marker), self._around()
        LabelChooser(names[marker], free, taken, unused, new=new, take=take, parent=over).open()

    def ask_recordings(self) -> None:
        """Ask which recordings labels are to be learned from; nothing waits for the answer."""
        if self.search.job is not None:
            self.message.emit(self.tr("Labels are being looked for already."))
            return
        dialog = LabelDialog(self._settings, self._around())
        dialog.chosen.connect(self.look)
        dialog.open()

    def look(self, paths: list[Path], keep_names: bool) -> None:  # noqa: FBT001 - a slot
        """Have labels proposed as labelled recordings have them, and show the pane."""
        self.search.start(paths, keep_names=keep_names)
        self._around().show_pane(self.pane)

    def _list_unsure(self) -> None:
        """List unsure labels in the queue while they are for the recording as it is."""
        search = self.search
        self._bad_search.show_labels(search.review if search.up_to_date else None)

    def _around(self) -> PanedWindow:
        # Not an attribute: they would keep each other when the tab is closed.
        around = self.parent()
        assert isinstance(around, PanedWindow)
        return around
