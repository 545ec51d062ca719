"""Refining the open recording: what is asked, the job, and the outcome beside its original."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from mocapmend.refine.apart import Order, Outcome, carry_out
from mocapmend.refine.running import default_name
from mocapmend.views.refine_dialog import RefineDialog

if TYPE_CHECKING:
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.main_window import MainWindow
    from mocapmend.views.workspace import Workspace


class RefineActions(QObject):
    """Has a network make markers of joints.

    Parameters
    ----------
    window : MainWindow
        Asks over it, opens in it.
    files : FileActions
        Write and open.
    """

    def __init__(self, window: "MainWindow", files: "FileActions") -> None:
        super().__init__(files)
        self._window = window
        self._files = files

    def ask(self) -> None:
        """Ask how the open recording is to be refined; nothing waits for the answer."""
        workspace = self._window.workspace
        if workspace is None or not workspace.document.repairable:
            return
        source = workspace.document.source
        out = self._files.folder() / default_name(source.path)
        edited = bool(workspace.document.undo_stack.index())
        dialog = RefineDialog(source, out, self._window.settings, self._window, edited=edited)
        dialog.chosen.connect(self.prepare)
        dialog.open()

    def prepare(self, order: Order) -> None:
        """Begin, once the edits of a recording that is to be replaced are saved, and it is closed.

        They could not be exported when its file is another one.
        """
        open_there = self._window.documents.of_file(order.out)
        if open_there is None:
            self.start(order)
        else:
            self._files.after_saving(open_there, lambda: self._replace(open_there, order))

    def _replace(self, workspace: "Workspace", order: Order) -> None:
        self._window.drop(workspace)
        self.start(order)

    def start(self, order: Order) -> None:
        """Refine in the background, and show the outcome when it is written."""
        title = self.tr("Refining {0}").format(order.recording.name)
        job = self._files.write_apart(title, carry_out, order)
        job.finished.connect(lambda done: self._open(order, done))

    def _open(self, order: Order, done: Outcome) -> None:
        self._files.open(
            order.out,
            instead_of=self._window.documents.of_file(order.out),
            then=lambda workspace: self._show(workspace, order, done),
        )

    def _show(self, workspace: "Workspace", order: Order, done: Outcome) -> None:
        workspace.facts.given = done.judged
        workspace.report.refresh()
        workspace.comparing.look(order.recording, quiet=True)
        self._window.say(self._text(order.out, done))

    def _text(self, out: Path, done: Outcome) -> str:
        text = self.tr("{0} markers computed in {1} frames, none measured: {2}").format(
            done.markers, done.frames, out.name
        )
        if done.bridged:
            more = self.tr("Joints that were missing at times were bridged: {0}.")
            text += ". " + more.format(", ".join(done.bridged))
        return text
