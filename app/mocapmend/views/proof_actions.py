"""Recipes and checks: what was done to a recording, done again, and proved."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtWidgets import QFileDialog

from mocapmend import engine, recipe_plan, replaying, unsaved
from mocapmend.believed import Correction
from mocapmend.beneath import beneath, share_beneath
from mocapmend.commands import EditSamples
from mocapmend.correcting import towards
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import CheckReport, patches
from mocapmend.layers import Layers
from mocapmend.plan import Plan, read_plan, write_plan
from mocapmend.replay_edits import replayed
from mocapmend.views.check_dialog import check_dialog
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.smooth.contract import SmoothResult

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
        name = _recipe_name(document)
        path = self._window.files.ask_where(
            self.tr("Save recipe"), name, {self.tr("Recipes (*.json)"): ".json"}
        )
        if path is None:
            return
        job = self._window.files.write(
            self.tr("Writing the recipe"),
            unsaved.write_recipe,
            document.unsaved(),
            path,
        )
        written = self.tr("Recipe written to {0}").format(path)
        job.finished.connect(lambda _: self._window.say(written))

    def ask_and_replay(self) -> None:
        """Let the user choose a recipe and make its edits."""
        document = self._document()
        if document is None:
            return
        path = self._ask(
            self.tr("Replay recipe"),
            self._window.files.folder() / _recipe_name(document),
            self.tr("Recipes (*.json);;All files (*)"),
        )
        if path is not None:
            self.replay(path)

    def replay(self, path: Path) -> None:
        """Make the edits of a recipe: a step of corrections, if it has any, and one of fills."""
        workspace = self._window.workspace
        assert workspace is not None
        title = self.tr("Replaying {0}").format(path.name)
        source, begun = workspace.document.source, workspace.document.revision

        def compute(prepared: tuple[recipe_plan.Planned, bool]) -> None:
            if not self._is_as_it_was(workspace, begun):
                return
            corrected = self._correct(workspace, path, prepared[0])
            revision = workspace.document.revision
            base, jobs = workspace.document.share_base(), prepared[0].jobs
            job = self._window.jobs.compute(title, replaying.fill, base, jobs)
            job.finished.connect(
                lambda results: self._accept(
                    workspace, revision, path, prepared, results, corrected
                )
            )
            job.failed.connect(self._window.show_error)

        job = self._window.jobs.read_or_write(title, recipe_plan.prepare, source, path)
        job.finished.connect(compute)
        job.failed.connect(self._window.show_error)

    def ask_and_save_plan(self) -> None:
        """Let the user choose where the plan goes, and write it there."""
        workspace = self._window.workspace
        if workspace is None:
            return
        repair, limits = workspace.repair, workspace.repair.limits
        made = Plan(
            repair.method(),
            limits.max_gap_ms(),
            limits.max_error_mm(),
            repair.fix_first.kinds(),
        )
        path = self._window.files.ask_where(
            self.tr("Save plan"), "plan.json", {self.tr("Plans (*.json)"): ".json"}
        )
        if path is None:
            return
        try:
            write_plan(made, path)
        except MocapmendError as error:
            self._window.show_error(error)
        else:
            self._window.say(self.tr("Plan written to {0}").format(path))

    def ask_and_load_plan(self) -> None:
        """Let the user choose a plan, and show its method, its limits, and what it fixes first."""
        workspace = self._window.workspace
        if workspace is None:
            return
        path = self._ask(
            self.tr("Load plan"),
            self._window.files.folder() / "plan.json",
            self.tr("Plans (*.json);;All files (*)"),
        )
        if path is None:
            return
        try:
            read = read_plan(path)
        except MocapmendError as error:
            self._window.show_error(error)
        else:
            workspace.repair.choose_way(read.way)
            workspace.repair.limits.set_limits(read.max_gap_ms, read.max_error_mm)
            workspace.repair.fix_first.set_kinds(read.fix)

    def ask_and_check(self) -> None:
        """Let the user choose a repaired copy, and compare it with the open recording's file."""
        workspace = self._window.workspace
        if workspace is None:
            return
        likely, last = self._window.files.folder(), workspace.proofs.last_export
        likely /= self._window.files.export_name()
        if last is not None and patches(workspace.document.source, last):
            likely = last
        path = self._ask(
            self.tr("Check a repaired copy"),
            likely,
            self.tr("C3D recordings (*.c3d *.C3D);;All files (*)"),
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

    def _ask(self, title: str, likely: Path, kinds: str) -> Path | None:
        """Ask for a file; begin at the one that it should be, or in its folder."""
        start = likely if likely.exists() else likely.parent
        text, _ = QFileDialog.getOpenFileName(self._window, title, str(start), kinds)
        return Path(text) if text else None

    def _accept(
        self,
        workspace: "Workspace",
        revision: int,
        path: Path,
        prepared: tuple[recipe_plan.Planned, bool],
        results: list[FillResult],
        corrected: int,
    ) -> None:
        document, (planned, same_file) = workspace.document, prepared
        if not self._is_as_it_was(workspace, revision):
            return
        edits = replayed(document, planned, results)
        if not (edits or corrected or planned.smoothing):
            self._window.say(self.tr("The recipe has nothing to do here."))
            return
        if edits:
            workspace.push(edits, f"replay {path.name}")
        workspace.filling.refill()
        text = self.tr("{0} edits made again.")
        if not same_file:
            text = self.tr("{0} edits made again, by a recipe that was made for another file.")
        told = text.format(len(edits) + corrected)
        if not planned.smoothing:
            self._window.say(told)
            return
        smooth = partial(self._smooth, workspace, path, planned.smoothing, told)
        if workspace.filling.job is None:
            smooth()
        else:
            # At last, from what lies beneath then.
            workspace.filling.ended.connect(smooth, Qt.ConnectionType.SingleShotConnection)

    def _is_as_it_was(self, workspace: "Workspace", revision: int) -> bool:
        """Say whether a recording is open still, and has not been edited meanwhile."""
        if self._window.documents.of(workspace.document) is None:
            return False
        if revision != workspace.document.revision:
            self._window.say(self.tr("The recording was edited meanwhile: replay again."))
            return False
        return True

    @staticmethod
    def _correct(workspace: "Workspace", path: Path, planned: recipe_plan.Planned) -> int:
        """Make the corrections of a recipe; return how many there were.

        A recipe without any leaves those that the user has made.
        """
        document = workspace.document
        edits, correction = towards(document, planned.layers)
        if Layers.of(document.source).is_same(planned.layers) or not correction.runs:
            edits, correction = [], Correction()
        labels = {
            marker: label
            for marker, label in planned.labels(document.source).items()
            if document.labels[marker] != label
        }
        if not correction.runs and not labels:
            return 0
        text = f"correct as in {path.name}"
        workspace.do(EditSamples(document, edits, text, correction, labels))
        return len(correction.runs) + len(labels)

    def _smooth(
        self,
        workspace: "Workspace",
        path: Path,
        jobs: tuple[recipe_plan.SmoothJob, ...],
        told: str,
    ) -> None:
        """Smooth what a recipe smooths, now that its other edits are made."""
        document, revision = workspace.document, workspace.document.revision

        def accept(results: list[SmoothResult]) -> None:
            if not self._is_as_it_was(workspace, revision):
                return
            edits = [
                edit
                for result in results
                for edit in Edit.smoothings(result, partial(beneath, document))
            ]
            workspace.push(edits, f"replay the smoothing of {path.name}")
            text = self.tr("{0} Stretches smoothed again: {1}.")
            self._window.say(text.format(told, len(edits)))

        title = self.tr("Replaying {0}").format(path.name)
        shared = share_beneath(document)
        job = self._window.jobs.compute(title, replaying.smooth, shared, jobs)
        job.finished.connect(accept)
        job.failed.connect(self._window.show_error)

    def _show_check(self, original: Path, repaired: Path, found: CheckReport) -> None:
        check_dialog(self._window, original, repaired, found).show()


def _recipe_name(document: Document) -> str:
    return f"{document.source.path.stem}_recipe.json"
