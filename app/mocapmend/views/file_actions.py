"""Opening, exporting and closing: what the user is asked, and the jobs that follow."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox

from mocapmend import engine, unsaved
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.files import LONG_CSV, same_file
from mocapmend.jobs import APART, Job
from mocapmend.settings import LAST_FOLDER
from mocapmend.views.dialogs import widen
from mocapmend.views.file_kinds import all_kinds, kinds
from mocapmend.views.naming import kind_of, meant, repaired_name
from mocapmend.views.opening import Opening
from mocapmend.views.recovery import Recovery
from mocapmend.views.refine_actions import RefineActions
from mocapmend.views.samples import is_sample

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow
    from mocapmend.views.workspace import Workspace


class FileActions(QObject):
    """The file menu of a window.

    Parameters
    ----------
    window : MainWindow
        Asks over it, opens in it.

    Signals
    -------
    all_read :
        Every recording that was to be opened has been read, or could not be.
    """

    all_read = Signal()

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.recovery = Recovery(window, self)
        self.refining = RefineActions(window, self)
        self._loading: Job | None = None
        self._waiting: list[Opening] = []
        self._writing: list[Job] = []

    @property
    def writing(self) -> bool:
        """Whether a file is being written."""
        return bool(self._writing)

    def when_written(self, then: Callable[[], object]) -> None:
        """Go on when the files that are being written are complete."""
        self._writing[-1].ended.connect(then)

    def when_loaded(self, then: Callable[[], object]) -> None:
        """Go on at once, or when the recordings that are being opened are read."""
        if self._loading is None and not self._waiting:
            then()
        else:
            self.all_read.connect(then, Qt.ConnectionType.SingleShotConnection)

    def ask_and_open(self) -> None:
        """Let the user choose recordings and open them."""
        paths, _ = QFileDialog.getOpenFileNames(
            self._window,
            self.tr("Open recordings"),
            self._window.settings.get(LAST_FOLDER),
            ";;".join((all_kinds(), *kinds(), self.tr("All files (*)"))),
        )
        for path in paths:
            self.open(Path(path))

    def open(
        self,
        path: Path,
        journal: Path | None = None,
        instead_of: "Workspace | None" = None,
        then: "Callable[[Workspace], None] | None" = None,
    ) -> None:
        """Open a recording in a tab, after those that are being opened; or go to its tab.

        Parameters
        ----------
        path : Path
            The file.
        journal : Path, optional
            Of edits that are to be recovered.
        instead_of : Workspace, optional
            Whose tab it takes, once its edits are saved and the file is fully read.
        then : callable, optional
            Called with the workspace when it is shown.
        """
        self._waiting.append(Opening(path, journal, instead_of, then))
        self._open_next()

    def _open_next(self) -> None:
        if self._loading is not None or not self._waiting:
            return
        opening = self._waiting.pop(0)
        there = self._window.documents.of_file(opening.path)
        if there is not None and opening.journal is None and opening.instead_of is None:
            self._window.documents.setCurrentWidget(there)
            self._window.say(self.tr("{0} is open already.").format(opening.path.name))
            self._open_next()
            return
        if there is not None and opening.instead_of is None:
            opening = replace(opening, instead_of=there)
        path = opening.path
        title = self.tr("Opening {0}").format(path.name)
        job = self._window.jobs.read_or_write(title, engine.load_to_show, path)
        self._loading = job
        # Later: a question must not hold up the end of the job.
        job.finished.connect(
            lambda read: QTimer.singleShot(0, self, lambda: self.adopt(read, opening))
        )
        job.failed.connect(self._window.show_error)
        job.failed.connect(lambda _: self._forget_if_gone(path))
        job.ended.connect(self._end_loading)

    def adopt(self, read: engine.ToShow, opening: Opening) -> None:
        """Show a recording that has been read, once the edits of the one that goes are saved."""
        leaving = opening.instead_of
        if leaving is None or self._window.documents.of(leaving.document) is None:
            self._show(read, replace(opening, instead_of=None))
        else:
            self.after_saving(leaving, lambda: self._show(read, opening))

    def close(self, workspace: "Workspace | None" = None) -> None:
        """Close a recording, the current one if none is named."""
        leaving = self._window.workspace if workspace is None else workspace
        if leaving is not None:
            self.after_saving(leaving, lambda: self._window.drop(leaving))

    def ask_and_export(self, then: Callable[[], None] | None = None) -> None:
        """Let the user choose where the repaired recording goes, and write it there."""
        if self._window.workspace is None:
            return
        kinds = {
            self.tr("C3D (*.c3d)"): ".c3d",
            self.tr("TRC (*.trc)"): ".trc",
            self.tr("CSV, one line per frame (*.csv)"): ".csv",
            self.tr("CSV, one line per sample (*.long.csv)"): LONG_CSV,
            self.tr("NumPy (*.npz)"): ".npz",
        }
        path = self.ask_where(self.tr("Export repaired recording"), self.export_name(), kinds)
        if path is not None:
            self.export(path, then)

    def export_name(self) -> str:
        """Return how a repaired copy of the open recording is called if the user does not care."""
        assert self._window.workspace is not None
        return repaired_name(self._window.workspace.document.source.path.name)

    def folder(self) -> Path:
        """Return where files go: beside the open recording, unless that ships with us."""
        assert self._window.workspace is not None
        path = self._window.workspace.document.source.path
        return Path.home() if is_sample(path) else path.parent

    def export(self, path: Path, then: Callable[[], None] | None = None) -> None:
        """Write the repaired recording, after asking about what cannot be taken back."""
        assert self._window.workspace is not None
        document = self._window.workspace.document
        replaces = same_file(path, document.source.path)
        if replaces and not self._confirm_replacing(path):
            return
        if document.source.truncated and not self._confirm(
            self.tr("Export a truncated recording?"),
            self.tr("The file ends before its data do. The copy will be as short as the original."),
        ):
            return
        job = self.write(
            self.tr("Exporting {0}").format(path.name),
            unsaved.export,
            document.unsaved(),
            path,
            replaces,
            APART,
        )
        index = document.undo_stack.index()
        job.finished.connect(lambda done: self._exported(document, index, done, then))

    def ask_and_save_report(self) -> None:
        """Let the user choose where the report goes, HTML or PDF, and write it there."""
        workspace = self._window.workspace
        if workspace is None:
            return
        stem = workspace.document.source.path.stem
        kinds = {self.tr("HTML (*.html)"): ".html", self.tr("PDF (*.pdf)"): ".pdf"}
        path = self.ask_where(self.tr("Save report"), f"{stem}_report.html", kinds)
        if path is None:
            return
        job = self.write_apart(
            self.tr("Writing the report"),
            engine.write_report,
            *workspace.report_inputs(),
            path,
        )
        written = self.tr("Report written to {0}").format(path)
        job.finished.connect(lambda _: self._window.say(written))

    def after_saving(self, workspace: "Workspace", then: Callable[[], None]) -> None:
        """Go on with what ends a document, once its edits are saved or given up."""
        if workspace.saved:
            then()
            return
        # The user sees what the question is about, and the export is of the current one.
        self._window.documents.setCurrentWidget(workspace)
        buttons = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self._window,
            "mocapmend",
            self.tr("{0} has repairs that are not exported yet.").format(
                workspace.document.source.path.name
            ),
            buttons.Save | buttons.Discard | buttons.Cancel,
            buttons.Save,
        )
        if answer == buttons.Save:
            self.ask_and_export(then)
        elif answer == buttons.Discard:
            then()

    def ask_where(self, title: str, name: str, kinds: Mapping[str, str]) -> Path | None:
        """Ask for the name of a new file, beside the recording unless that ships with us."""
        text, kind = QFileDialog.getSaveFileName(
            self._window, title, str(self.folder() / name), ";;".join(kinds), kind_of(name, kinds)
        )
        if not text:
            return None
        path = meant(Path(text), name, kinds, kind)
        if path == Path(text):
            # The dialog has asked.
            return path
        replaces = self.tr("Replace {0}?").format(path.name)
        if path.exists() and not self._confirm(replaces, self.tr("There is a file of this name.")):
            return None
        return path

    def write(self, title: str, function: Callable[..., Any], *args: object) -> Job:
        """Write a file in the background; the window stays open until it is there."""
        return self._follow(self._window.jobs.read_or_write(title, function, *args))

    def write_apart(self, title: str, function: Callable[..., Any], *args: object) -> Job:
        """Write a file that takes more computing than writing, in a process of its own."""
        return self._follow(self._window.jobs.compute(title, function, *args))

    def _follow(self, job: Job) -> Job:
        self._writing.append(job)
        job.ended.connect(self._end_writing)
        job.failed.connect(self._window.show_error)
        return job

    def _forget_if_gone(self, path: Path) -> None:
        if not path.exists():
            self._window.settings.forget_file(str(path))

    def _end_loading(self) -> None:
        self._loading = None
        if self._waiting:
            # After what was read is shown: it may be the same file again.
            QTimer.singleShot(0, self, self._open_next)
        else:
            self.all_read.emit()

    def _end_writing(self) -> None:
        self._writing = [job for job in self._writing if not job.over]

    def _show(self, read: engine.ToShow, opening: Opening) -> None:
        source = read.source
        try:
            history = self._window.show_source(read, opening.journal, opening.instead_of)
        except MocapmendError as error:
            self._window.show_error(error)
            return
        path = source.path.resolve()
        self._window.settings.remember_file(str(path))
        if not is_sample(path):
            self._window.settings.set(LAST_FOLDER, str(path.parent))
        opened = self.tr("Opened {0}")
        if source.repaired:
            opened = self.tr("Opened {0}, in which {3} gaps have been repaired before")
        if source.truncated:
            opened = self.tr("Opened {0}, which is truncated: {1} of {2} frames are there")
        self._window.say(
            opened.format(
                path.name,
                source.recording.frames,
                source.frames_promised,
                len(source.repaired),
            )
        )
        if history is None:
            self.recovery.offer(source)
        else:
            self.recovery.tell(history, source)
        if opening.then is not None and self._window.workspace is not None:
            opening.then(self._window.workspace)

    def _exported(
        self,
        document: Document,
        index: int,
        exported: engine.Exported,
        then: Callable[[], None] | None,
    ) -> None:
        path = exported.saved.path
        self._window.settings.remember_file(str(path.resolve()))
        workspace = self._window.documents.of(document)
        # Edits made while the file was written are not in it.
        if workspace is not None:
            workspace.proofs.take(exported, complete=document.undo_stack.index() == index)
            if then is None and same_file(path, document.source.path):
                self.open(path, instead_of=workspace)
        text = self.tr("Exported {0} to {1}: {2} repaired samples, read back and compared.")
        if exported.check is not None:
            text = self.tr("Exported {0} to {1}: {2} samples changed, all else is the same.")
        if exported.check is not None and exported.check.identical:
            text = self.tr("Exported {0} to {1}: the same as the original, byte for byte.")
        self._window.say(text.format(path.name, path.parent, exported.saved.samples))
        if then is not None and workspace is not None:
            # Asks again if there were edits in the meantime.
            self.after_saving(workspace, then)

    def _confirm_replacing(self, path: Path) -> bool:
        return self._confirm(
            self.tr("Replace the original recording?"),
            self.tr(
                "{0} is the file that you opened. Its missing samples will be overwritten with the "
                "repairs, and the undo history ends here. A new name keeps both."
            ).format(path.name),
        )

    def _confirm(self, question: str, detail: str) -> bool:
        box = QMessageBox(QMessageBox.Icon.Warning, "mocapmend", question, parent=self._window)
        box.setInformativeText(detail)
        go = box.addButton(self.tr("Go on"), QMessageBox.ButtonRole.AcceptRole)
        box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Cancel))
        widen(box)
        box.exec()
        return box.clickedButton() is go
