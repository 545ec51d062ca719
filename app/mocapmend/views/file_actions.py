"""Opening, exporting and closing: what the user is asked, and the jobs that follow."""

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QFileDialog, QMessageBox

from mocapmend import engine
from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.files import FORMATS, LONG_CSV, Source, same_file
from mocapmend.jobs import Job
from mocapmend.settings import LAST_FOLDER
from mocapmend.views.naming import kind_of, meant, repaired_name
from mocapmend.views.recovery import Recovery
from mocapmend.views.samples import is_sample
from mocapmend_algorithms.skeleton import Skeleton

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow


class FileActions(QObject):
    """The file menu of a window.

    Parameters
    ----------
    window : MainWindow
        Asks over it, opens in it.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self.recovery = Recovery(window, self)
        self._loading: Job | None = None
        self._writing: list[Job] = []

    @property
    def writing(self) -> bool:
        """Whether a file is being written."""
        return bool(self._writing)

    def when_written(self, then: Callable[[], object]) -> None:
        """Go on when the files that are being written are complete."""
        self._writing[-1].ended.connect(then)

    def when_loaded(self, then: Callable[[], object]) -> None:
        """Go on at once, or when the recording that is being opened is read."""
        if self._loading is None:
            then()
        else:
            self._loading.ended.connect(then)

    def ask_and_open(self) -> None:
        """Let the user choose a recording and open it."""
        path, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open recording"),
            self._window.settings.get(LAST_FOLDER),
            ";;".join((self._all_kinds(), *self._kinds(), self.tr("All files (*)"))),
        )
        if path:
            self.open(Path(path))

    def open(self, path: Path, journal: Path | None = None) -> None:
        """Open a recording, with the edits of a journal or as it is.

        The present one stays until the new one is fully read.
        """
        if self._loading is not None:
            self._window.say(self.tr("Still opening the file before: try again."))
            return
        title = self.tr("Opening {0}").format(path.name)
        job = self._window.jobs.read_or_write(title, engine.load_to_show, path)
        self._loading = job
        # Later: a question must not hold up the end of the job.
        job.finished.connect(
            lambda read: QTimer.singleShot(0, self, lambda: self.adopt(read[0], read[1], journal))
        )
        job.failed.connect(self._window.show_error)
        job.failed.connect(lambda _: self._forget_if_gone(path))
        job.ended.connect(self._end_loading)

    def adopt(self, source: Source, skeleton: Skeleton | None, journal: Path | None) -> None:
        """Show a recording that has been read, once the present one's edits are saved."""
        self.after_saving(lambda: self._show(source, skeleton, journal))

    def close(self) -> None:
        """Close the open recording."""
        self.after_saving(self._window.drop_workspace)

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
            engine.export,
            document.source,
            document.changes(),
            path,
            replaces,
            document.source.truncated,
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
        job = self.write(
            self.tr("Writing the report"),
            engine.write_report,
            *workspace.report_inputs(),
            path,
        )
        written = self.tr("Report written to {0}").format(path)
        job.finished.connect(lambda _: self._window.say(written))

    def after_saving(self, then: Callable[[], None]) -> None:
        """Go on with what ends the present document, once its edits are saved or given up."""
        workspace = self._window.workspace
        if workspace is None or workspace.document.undo_stack.isClean():
            then()
            return
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

    def _all_kinds(self) -> str:
        every = " ".join(f"*{end}" for item in FORMATS for end in item.suffixes)
        return self.tr("Recordings ({0})").format(every)

    def _kinds(self) -> Iterator[str]:
        for item in FORMATS:
            yield f"{item.label} ({' '.join(f'*{end}' for end in item.suffixes)})"

    def write(self, title: str, function: Callable[..., Any], *args: object) -> Job:
        """Write a file in the background; the window stays open until it is there."""
        job = self._window.jobs.read_or_write(title, function, *args)
        self._writing.append(job)
        job.ended.connect(self._end_writing)
        job.failed.connect(self._window.show_error)
        return job

    def _forget_if_gone(self, path: Path) -> None:
        if not path.exists():
            self._window.settings.forget_file(str(path))

    def _end_loading(self) -> None:
        self._loading = None

    def _end_writing(self) -> None:
        self._writing = [job for job in self._writing if not job.over]

    def _show(self, source: Source, skeleton: Skeleton | None, journal: Path | None) -> None:
        try:
            history = self._window.show_source(source, skeleton, journal)
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

    def _exported(
        self,
        document: Document,
        index: int,
        exported: engine.Exported,
        then: Callable[[], None] | None,
    ) -> None:
        path = exported.saved.path
        self._window.settings.remember_file(str(path.resolve()))
        workspace = self._window.workspace
        # Edits made while the file was written are not in it.
        if workspace is not None and workspace.document is document:
            workspace.saved_as(exported, complete=document.undo_stack.index() == index)
            if then is None and same_file(path, document.source.path):
                self.open(path)
        text = self.tr("Exported {0} to {1}: {2} repaired samples, read back and compared.")
        if exported.check is not None:
            text = self.tr("Exported {0} to {1}: {2} samples changed, all else is the same.")
        if exported.check is not None and exported.check.identical:
            text = self.tr("Exported {0} to {1}: the same as the original, byte for byte.")
        self._window.say(text.format(path.name, path.parent, exported.saved.samples))
        if then is not None:
            # Asks again if there were edits in the meantime.
            self.after_saving(then)

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
        box.exec()
        return box.clickedButton() is go
