"""Looking at another recording beside the document: chosen, shown or hidden, and given up."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from mocapmend import companion
from mocapmend.companion import Companion
from mocapmend.document import Document
from mocapmend.jobs import Job, Jobs
from mocapmend.settings import LAST_FOLDER, Settings
from mocapmend.views.file_kinds import all_kinds, kinds
from mocapmend.views.report_facts import ReportFacts
from mocapmend.viewstate import ViewState


class CompanionActions(QObject):
    """What the user does with the recording that a document is compared with.

    Parameters
    ----------
    facts : ReportFacts
        Are told how far a refined document is from it.
    refresh : callable
        Has the report made anew.
    around : QWidget
        Dialogs stand over it.

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
        jobs: Jobs,
        facts: ReportFacts,
        refresh: Callable[[], None],
        settings: Settings,
        around: QWidget,
    ) -> None:
        super().__init__(around)
        self._document = document
        self._view = view
        self._jobs = jobs
        self._facts = facts
        self._refresh = refresh
        self._settings = settings
        self._job: Job | None = None
        self._shown = True
        self.companion: Companion | None = None
        """It, whether it is shown or not."""
        document.names_changed.connect(self._follow_names)

    def ask(self) -> None:
        """Let the user choose a recording to compare with."""
        around = self.parent()
        assert isinstance(around, QWidget)
        text, _ = QFileDialog.getOpenFileName(
            around,
            self.tr("Compare with a recording"),
            self._settings.get(LAST_FOLDER),
            ";;".join((all_kinds(), *kinds(), self.tr("All files (*)"))),
        )
        if text:
            self.look(Path(text))

    def look(self, path: Path, *, quiet: bool = False) -> None:
        """Read a recording and show it beside the document.

        Parameters
        ----------
        path : Path
            Its file.
        quiet : bool
            Whether nothing is said when it is there.
        """
        self.stop()
        title = self.tr("Reading {0} to compare").format(path.name)
        provenance = self._document.source.provenance
        # What was measured: how far it is from a reference must not depend on edits.
        own = self._document.share_original()
        job = self._jobs.read_or_write(title, companion.load, own, provenance, path)
        job.finished.connect(lambda found: self._take(found, quiet=quiet))
        job.failed.connect(self.failed)
        self._job = job

    def stop(self) -> None:
        """Give up what is being read: something else is wanted, or the document goes away."""
        if self._job is not None:
            self._job.abandon()
            self._job = None

    def end(self) -> None:
        """Compare no more."""
        self.stop()
        if self.companion is None:
            self.message.emit(self.tr("No recording is compared with this one."))
            return
        text = self.tr("No longer compared with {0}.").format(self.companion.path.name)
        self.companion = None
        self._tell()
        self.message.emit(text)

    def set_shown(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Show the other recording in 3D and plots, or hide it."""
        self._shown = on
        self._view.set_companion(self.companion if on else None)

    def _take(self, found: Companion, *, quiet: bool) -> None:
        self._job = None
        self.companion = found.beside(self._document.original)
        self._tell()
        if not quiet:
            self.message.emit(self._text(found))

    def _tell(self) -> None:
        self._view.set_companion(self.companion if self._shown else None)
        judged = None if self.companion is None else self.companion.judged
        if judged != self._facts.beside:
            self._facts.beside = judged
            self._refresh()

    def _follow_names(self) -> None:
        if self.companion is not None:
            self.companion = self.companion.beside(self._document.original)
            self._view.set_companion(self.companion if self._shown else None)

    def _text(self, found: Companion) -> str:
        texts = {
            "origin": self.tr("Compared with {0}, from which this recording was made."),
            "fitted": self.tr("Compared with {0}, turned and shifted so that common labels fit."),
            "as it is": self.tr(
                "Compared with {0} in its own place: fewer than three labels are common, or too "
                "little of the time is."
            ),
        }
        return texts[found.way].format(found.path.name)
