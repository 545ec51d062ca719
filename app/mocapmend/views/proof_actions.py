"""Recipes and checks: what was done to a recording, done again, and proved."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QFileDialog

from mocapmend import engine, recipe
from mocapmend.document import Document, Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import C3DFile, CheckReport
from mocapmend.settings import LAST_FOLDER
from mocapmend.views.check_dialog import check_dialog
from mocapmend_algorithms.fill.contract import FillResult

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow
    from mocapmend.views.workspace import Workspace


class ProofActions(QObject):
    """Saves and replays recipes, and checks files against the open one.

    Parameters
    ----------
    window : MainWindow
        Asks over it, shows in it.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window

    def ask_and_save_recipe(self) -> None:
        """Let the user choose where the recipe goes, and write it there."""
        document = self._document()
        if document is None:
            return
        name = f"{document.source.path.stem}_recipe.json"
        path = self._window.files.ask_where(
            self.tr("Save recipe"), name, {self.tr("Recipes (*.json)"): ".json"}
        )
        if path is None:
            return
        job = self._window.files.write(
            self.tr("Writing the recipe"),
            recipe.write_recipe,
            document.source,
            document.changes().repairs,
            path,
        )
        written = self.tr("Recipe written to {0}").format(path)
        job.finished.connect(lambda _: self._window.say(written))

    def ask_and_replay(self) -> None:
        """Let the user choose a recipe and make its edits."""
        if self._document() is None:
            return
        path = self._ask(self.tr("Replay recipe"), self.tr("Recipes (*.json);;All files (*)"))
        if path is not None:
            self.replay(path)

    def replay(self, path: Path) -> None:
        """Make the edits of a recipe, in one undoable step."""
        workspace = self._window.workspace
        assert workspace is not None
        document = workspace.document
        try:
            planned = recipe.plan(document.source, recipe.read_recipe(path))
        except MocapmendError as error:
            self._window.show_error(error)
            return
        job = self._window.jobs.compute(
            self.tr("Replaying {0}").format(path.name),
            recipe.fill,
            document.share_original(),
            planned.jobs,
        )
        revision = document.revision
        job.finished.connect(
            lambda results: self._accept(workspace, revision, path, planned, results)
        )
        job.failed.connect(self._window.show_error)

    def ask_and_check(self) -> None:
        """Let the user choose a repaired copy, and compare it with the open recording's file."""
        document = self._document()
        if document is None:
            return
        if not isinstance(document.source, C3DFile):
            self._window.say(self.tr("Only copies of C3D files can be checked."))
            return
        path = self._ask(
            self.tr("Check a repaired copy"), self.tr("C3D recordings (*.c3d *.C3D);;All files (*)")
        )
        if path is not None:
            self.check(path)

    def check(self, repaired: Path) -> None:
        """Compare a file with the open recording's file, and show what differs."""
        document = self._document()
        assert document is not None
        original = document.source.path
        job = self._window.jobs.read_or_write(
            self.tr("Checking {0}").format(repaired.name), engine.check, original, repaired
        )
        # Later: a dialog must not hold up the end of the job.
        job.finished.connect(
            lambda found: QTimer.singleShot(
                0, self, lambda: self._show_check(original, repaired, found)
            )
        )
        job.failed.connect(self._window.show_error)

    def _document(self) -> Document | None:
        return None if self._window.workspace is None else self._window.workspace.document

    def _ask(self, title: str, kinds: str) -> Path | None:
        folder = self._window.settings.get(LAST_FOLDER)
        text, _ = QFileDialog.getOpenFileName(self._window, title, folder, kinds)
        return Path(text) if text else None

    def _accept(
        self,
        workspace: "Workspace",
        revision: int,
        path: Path,
        planned: recipe.Plan,
        results: list[FillResult],
    ) -> None:
        document = workspace.document
        if self._window.workspace is not workspace or revision != document.revision:
            self._window.say(self.tr("The recording was edited meanwhile: replay again."))
            return
        reopened = [gap for gap in planned.reopened if gap in document.repairs]
        edits = [Edit.clear(gap) for gap in reopened]
        for job, result in zip(planned.jobs, results, strict=True):
            edits += [Edit.fill(patch, job.method, job.params) for patch in result.patches]
        if not edits:
            self._window.say(self.tr("The recipe has nothing to do here."))
            return
        workspace.push(edits, self.tr("replay {0}").format(path.name))
        self._window.say(self.tr("{0} edits made again.").format(len(edits)))

    def _show_check(self, original: Path, repaired: Path, found: CheckReport) -> None:
        check_dialog(self._window, original, repaired, found).show()
