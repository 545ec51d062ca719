"""Offering the edits that a crash has left, at the start and when their recording is opened."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from mocapmend.engine import ToShow
from mocapmend.errors import MocapmendError
from mocapmend.files import Source
from mocapmend.journal import Abandoned, History, discard, find_abandoned
from mocapmend.states import States
from mocapmend.views.opening import Opening
from mocapmend.views.recovery_dialog import RecoveryDialog

if TYPE_CHECKING:
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.main_window import MainWindow


class Recovery(QObject):
    """Asks what shall become of abandoned edits, and sees to it.

    Parameters
    ----------
    window : MainWindow
        Asks over it.
    files : FileActions
        Opens the recordings.
    """

    def __init__(self, window: "MainWindow", files: "FileActions") -> None:
        super().__init__(window)
        self._window = window
        self._files = files
        self._looking = False
        self._dialog: RecoveryDialog | None = None

    def offer(self, source: Source | None = None) -> None:
        """Look for edits to recover, all or those of a recording, and ask if there are any."""
        folder = self._window.settings.journal_folder
        if self._looking or self._dialog is not None or not folder.is_dir():
            return
        job = self._window.jobs.read_or_write(
            self.tr("Looking for edits to recover"), find_abandoned, folder
        )
        self._looking = True
        job.finished.connect(lambda found: self._ask(found, source))
        job.failed.connect(self._window.show_error)
        job.ended.connect(self._end_looking)

    def tell(self, history: History, source: Source) -> None:
        """Say what was recovered."""
        one, more = self.tr("Recovered 1 edit of {1}"), self.tr("Recovered {0} edits of {1}")
        text = one if history.index == 1 else more
        self._window.say(text.format(history.index, source.path.name))
        if history.damaged:
            self._window.show_error(
                MocapmendError(
                    "The last of the saved edits were damaged and are lost.",
                    str(source.path),
                    "All before them are recovered.",
                )
            )

    def _end_looking(self) -> None:
        self._looking = False

    def _ask(self, found: Sequence[Abandoned], source: Source | None) -> None:
        asked = [each for each in found if source is None or each.belongs_to(source)]
        if not asked or not self._window.isVisible():
            return
        self._dialog = RecoveryDialog(self._window, asked)
        self._dialog.recover.connect(self._recover)
        self._dialog.discard.connect(self._discard)
        self._dialog.finished.connect(self._forget_dialog)
        self._dialog.open()

    def _forget_dialog(self) -> None:
        self._dialog = None

    def _recover(self, abandoned: Abandoned) -> None:
        path = abandoned.subject.path
        workspace = self._window.documents.first(abandoned.belongs_to)
        if workspace is not None:
            source, skeleton = workspace.document.source, workspace.document.found_skeleton
            there = Opening(source.path, abandoned.journal, workspace)
            self._files.adopt(ToShow(source, skeleton, States(source)), there)
        elif path.exists():
            self._files.open(path, abandoned.journal)
        else:
            self._window.show_error(
                MocapmendError(
                    "The recording of these edits is not there any more.",
                    str(path),
                    "Put it back, or open it where it is now: the edits are offered again then.",
                )
            )

    def _discard(self, abandoned: Abandoned) -> None:
        try:
            discard(abandoned.journal)
        except MocapmendError as error:
            self._window.show_error(error)
