"""The window: menus, toolbar and status bar around the workspace that shows the document."""

import logging
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QMimeData, QSize, QTimer, QUrl
from PySide6.QtGui import (
    QCloseEvent,
    QDesktopServices,
    QDragEnterEvent,
    QDropEvent,
)
from PySide6.QtWidgets import (
    QLabel,
    QMainWindow,
    QMessageBox,
    QStackedWidget,
)

from mocapmend import __version__
from mocapmend.action_table import ACTIONS
from mocapmend.actions import make_actions
from mocapmend.errors import MocapmendError
from mocapmend.jobs import Jobs
from mocapmend.log import log_path
from mocapmend.settings import COMPARE, GEOMETRY, MOST_MISSING_FIRST, SHOWN, Settings
from mocapmend.theme import Theme
from mocapmend.views import language
from mocapmend.views.action_calls import SWITCHES
from mocapmend.views.action_wiring import connect_actions
from mocapmend.views.appearance import Appearance
from mocapmend.views.dialogs import environment, error_box
from mocapmend.views.documents import Documents
from mocapmend.views.engine_texts import shown
from mocapmend.views.frame_icons import draw_extension
from mocapmend.views.icons import LARGE, program_icon
from mocapmend.views.job_indicator import JobIndicator
from mocapmend.views.keys import KeyGuard
from mocapmend.views.layouts import Layouts
from mocapmend.views.menus import Menus
from mocapmend.views.notes import NotesBar
from mocapmend.views.palette import Palette
from mocapmend.views.palette_entries import entries
from mocapmend.views.recent import RecentFiles
from mocapmend.views.samples import sample_recordings
from mocapmend.views.shortcuts import Shortcuts
from mocapmend.views.shortcuts_dialog import ShortcutsDialog
from mocapmend.views.text_scale import FRAME
from mocapmend.views.toolbar import draw_icons, fill_toolbar
from mocapmend.views.tour import Tour
from mocapmend.views.transport import Transport
from mocapmend.views.welcome import Welcome

if TYPE_CHECKING:
    from mocapmend.engine import ToShow
    from mocapmend.journal import History
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.proof_actions import ProofActions
    from mocapmend.views.workspace import Workspace

log = logging.getLogger(__name__)

MESSAGE_MS = 8000
FIRST_SIZE = QSize(1280, 800)


class MainWindow(QMainWindow):
    """Wires actions to the workspaces of the open documents."""

    def __init__(self, settings: Settings) -> None:
        super().__init__()
        self.settings = settings
        self.jobs = Jobs(self)
        self._tour: Tour | None = None
        self.appearance: Appearance = Appearance(settings, self)
        self.appearance.changed.connect(self._show_theme)
        self.actions_by_id = dict(make_actions(self))
        self.shortcuts = Shortcuts(self.actions_by_id, settings, self)
        self.layouts: Layouts = Layouts(self)
        self.recent = RecentFiles(settings, self.jobs, self)
        self.recent.changed.connect(self._show_recent)
        self._keys = KeyGuard(self)
        self.setWindowIcon(program_icon())
        self.setAcceptDrops(True)
        self.resize(FIRST_SIZE.boundedTo(self.screen().availableSize() - FRAME))
        self.welcome = Welcome(sample_recordings(), self.theme)
        self.welcome.chosen.connect(self.open)
        self.welcome.forgotten.connect(self.recent.forget)
        self.welcome.browse.connect(self.actions_by_id["open"].trigger)
        self.documents: Documents = Documents()
        self.documents.switched.connect(self._show_document)
        self.documents.counted.connect(self._show_possible)
        self.stack = QStackedWidget()
        self.stack.addWidget(self.welcome)
        self.stack.addWidget(self.documents)
        self.setCentralWidget(self.stack)
        self.notes = NotesBar()
        self.transport = Transport(self.actions_by_id)
        self._keys.guard(self.transport)
        self.menus = Menus(self)
        # Actions that are only in menus answer to their keys through the window.
        self.addActions(list(self.actions_by_id.values()))
        self.documents.tabCloseRequested.connect(self._close_tab)
        self.toolbar = self.addToolBar(self.tr("Tools"))
        fill_toolbar(self.toolbar, self.actions_by_id, self.transport)
        self._make_status_bar()
        connect_actions(self)
        self.restoreGeometry(settings.get(GEOMETRY))
        self.actions_by_id[f"theme_{self.appearance.choice}"].setChecked(True)
        self.actions_by_id[f"language_{language.wanted(settings)}"].setChecked(True)
        self.actions_by_id["compare"].setChecked(settings.get(COMPARE))
        self.actions_by_id["most_missing_first"].setChecked(settings.get(MOST_MISSING_FIRST))
        for name, setting in SHOWN.items():
            self.actions_by_id[name].setChecked(settings.get(setting))
            self.actions_by_id[name].toggled.connect(
                lambda on, setting=setting: settings.set(setting, on)
            )
        self.appearance.apply()
        self._show_theme()
        self._show_document()

    @property
    def theme(self) -> Theme:
        """The colours of the window."""
        return self.appearance.theme

    @property
    def workspace(self) -> "Workspace | None":
        """The workspace of the recording that is seen."""
        return self.documents.current

    @cached_property
    def files(self) -> "FileActions":
        """The file menu; what reads and repairs files is loaded when it is first needed."""
        from mocapmend.views.file_actions import FileActions

        return FileActions(self)

    @cached_property
    def proofs(self) -> "ProofActions":
        """Recipes and checks; loaded when they are first needed."""
        from mocapmend.views.proof_actions import ProofActions

        return ProofActions(self)

    def get_ready(self) -> None:
        """Load and start what the first recording needs, once the user sees the window.

        Edits that a crash has left are offered.
        """
        from mocapmend.views import file_actions, workspace  # noqa: F401

        self.files.when_loaded(self.files.recovery.offer)
        self.jobs.warm_up()

    # --- making ------------------------------------------------------------------------------

    def _make_status_bar(self) -> None:
        self._facts = QLabel()
        self.statusBar().addPermanentWidget(JobIndicator(self.jobs))
        self.statusBar().addPermanentWidget(self.notes)
        self.statusBar().addPermanentWidget(self._facts)

    def with_all(self, use: "Callable[[Workspace], object]") -> None:
        """Do something to every open recording."""
        for workspace in self.documents:
            use(workspace)

    # --- documents ---------------------------------------------------------------------------

    def open(self, path: Path) -> None:
        """Open a recording in a tab, or go to the tab that it has already."""
        self.files.open(path)

    def show_source(
        self,
        read: "ToShow",
        journal: Path | None = None,
        instead_of: "Workspace | None" = None,
    ) -> "History | None":
        """Show a recording that has been read, in a tab of its own.

        Parameters
        ----------
        read : ToShow
            The recording.
        journal : Path, optional
            Of edits that are to be recovered.
        instead_of : Workspace, optional
            Whose tab it takes; the edits of that one are given up.

        Returns
        -------
        History or None
            What was recovered.

        Raises
        ------
        MocapmendError
            If the edits cannot be recovered. Nothing is changed then.
        """
        from mocapmend.document import Document
        from mocapmend.journal import resume
        from mocapmend.views.workspace import Workspace

        document = Document(*read)
        recovered = None if journal is None else resume(journal, document)
        workspace = Workspace(document, self.jobs, self.settings, self.theme, self.actions_by_id)
        workspace.message.connect(self.say)
        workspace.failed.connect(self.show_error)
        if recovered is not None:
            workspace.recorder.resume(*recovered)
        for name, switch in SWITCHES.items():
            switch(workspace, self.actions_by_id[name].isChecked())
        stack = workspace.document.undo_stack
        stack.indexChanged.connect(self._show_undo)
        stack.cleanChanged.connect(self._show_title)
        workspace.document.names_changed.connect(self._show_notes)
        self._keys.guard(workspace)
        workspace.repair.rebuilt.connect(self._guard_repairs)
        workspace.smooth.rebuilt.connect(self._guard_repairs)
        workspace.paint_later()
        self.documents.add(workspace, instead_of)
        if instead_of is not None:
            self.drop(instead_of)
        workspace.setFocus()
        return None if recovered is None else recovered[1]

    def drop(self, workspace: "Workspace") -> None:
        """Close a recording, and give up what is not exported."""
        workspace.stop()
        workspace.save_layout()
        self.documents.remove(workspace)
        workspace.deleteLater()

    def _close_tab(self, index: int) -> None:
        self.files.close(self.documents.at(index))

    def _guard_repairs(self) -> None:
        for workspace in self.documents:
            self._keys.guard(workspace.repair)
            self._keys.guard(workspace.smooth)

    # --- showing -----------------------------------------------------------------------------

    def say(self, text: str) -> None:
        """Tell something in passing, in the status bar."""
        self.statusBar().showMessage(text, MESSAGE_MS)

    def show_error(self, error: Exception) -> None:
        """Report an error; the document stays as it is."""
        expected = isinstance(error, MocapmendError)
        log.error("%s", error, exc_info=None if expected else error)
        error_box(self, error).open()

    def show_about(self) -> None:
        """Say which program this is."""
        QMessageBox.about(
            self,
            self.tr("About mocapmend"),
            f"<b>mocapmend {__version__}</b><p>"
            + self.tr("Inspects and repairs optical motion-capture recordings.")
            + f"</p><p>{environment()}</p>",
        )

    def show_log(self) -> None:
        """Show the log file in what the system has for texts."""
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(log_path())))

    def show_shortcuts(self) -> None:
        """Show all keys, which can be changed."""
        ShortcutsDialog(self.shortcuts, self).open()

    def show_palette(self) -> None:
        """Let the user type what to do."""
        Palette(entries(self), self).open()

    def start_tour(self) -> None:
        """Show around, beginning at the first step that can be made."""
        if self._tour is not None:
            self._tour.destroyed.disconnect(self._forget_tour)
            self._tour.end()
        self._tour = Tour(self)
        self._tour.destroyed.connect(self._forget_tour)
        self._tour.begin()

    def _forget_tour(self) -> None:
        self._tour = None

    def _show_theme(self) -> None:
        scale = self.appearance.text_size
        size = QSize(round(LARGE * scale), round(LARGE * scale))
        for buttons in (self.toolbar, self.transport.button):
            buttons.setIconSize(size)
        draw_icons(self.actions_by_id, self.theme, scale)
        draw_extension(self.toolbar, self.theme)
        self.transport.set_theme(self.theme, scale)
        self.welcome.set_theme(self.theme)
        self.with_all(lambda workspace: workspace.set_theme(self.theme))

    def _show_recent(self) -> None:
        self.welcome.show_recent(self.recent.paths, self.recent.gone)

    def _show_document(self) -> None:
        workspace = self.workspace
        self.statusBar().clearMessage()
        repairable = workspace is not None and workspace.document.repairable
        self._show_possible()
        self.transport.show_workspace(workspace if repairable else None)
        self._show_notes()
        if workspace is None:
            self._show_recent()
            self.recent.look()
            self._facts.setText("")
        else:
            original = workspace.document.original
            self._facts.setText(
                self.tr("{0} markers · {1} frames · {2} Hz · {3} s · {4}").format(
                    original.markers,
                    original.frames,
                    f"{original.rate:g}",
                    f"{original.frames / original.rate:.2f}",
                    original.unit,
                )
            )
        self.stack.setCurrentWidget(self.welcome if workspace is None else self.documents)
        self._show_title()

    def _show_notes(self) -> None:
        """Tell what was odd in the file, and what could be done about points without a label."""
        if self.workspace is None:
            self.notes.show_warnings(())
            return
        from mocapmend.renaming import hints

        document = self.workspace.document
        self.notes.show_warnings((*document.source.warnings, *hints(document.labels)))

    def _show_possible(self) -> None:
        """Enable what can be done with the current recording."""
        document = None if self.workspace is None else self.workspace.document
        has = {
            "nothing": True,
            "document": document is not None,
            "c3d": document is not None and document.source.kind == "C3D",
            "markers": document is not None and document.repairable,
            "several": self.documents.count() > 1,
        }
        for spec in ACTIONS:
            self.actions_by_id[spec.id].setEnabled(has[spec.needs])
        self._show_undo()

    def _show_undo(self) -> None:
        stack = self.workspace.document.undo_stack if self.workspace else None
        for name, text, label in (
            ("undo", shown(stack.undoText()) if stack else "", self.tr("Undo")),
            ("redo", shown(stack.redoText()) if stack else "", self.tr("Redo")),
        ):
            action = self.actions_by_id[name]
            action.setEnabled(bool(text))
            action.setText(f"{label} {text}".strip())

    def _show_title(self) -> None:
        if self.workspace is None:
            self.setWindowModified(False)
            self.setWindowTitle("mocapmend")
            return
        document = self.workspace.document
        self.setWindowTitle(f"{document.source.path.name}[*] — mocapmend")
        self.setWindowModified(not document.undo_stack.isClean())

    # --- what the user does to the window ----------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if _dropped_files(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = _dropped_files(event.mimeData())
        if paths:
            event.acceptProposedAction()
        for path in paths:
            self.open(path)

    def closeEvent(self, event: QCloseEvent) -> None:
        if any(not each.saved for each in self.documents):
            event.ignore()
            self._close_when_saved(frozenset())
            return
        if self.files.writing:
            event.ignore()
            self.say(self.tr("The window closes when the file is written."))
            self.files.when_written(self.close)
            return
        self.settings.set(GEOMETRY, bytes(self.saveGeometry().data()))
        self.with_all(self.drop)
        self.jobs.shut_down()
        event.accept()

    def _close_when_saved(self, given_up: "frozenset[tuple[Workspace, int]]") -> None:
        """Ask about the recordings with edits, one after the other; nothing is closed before all.

        What was given up is kept with its revision: what is edited after that is asked about again.
        """
        states = ((each, each.document.revision) for each in self.documents if not each.saved)
        asked = next((state for state in states if state not in given_up), None)
        if asked is None:
            self.with_all(self.drop)
            # Later: a window that is being closed does not close once more.
            QTimer.singleShot(0, self, self.close)
        else:
            self.files.after_saving(asked[0], lambda: self._close_when_saved(given_up | {asked}))


def _dropped_files(data: QMimeData) -> list[Path]:
    return [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
