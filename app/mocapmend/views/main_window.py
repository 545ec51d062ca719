"""The window: menus, toolbar and status bar around the workspace that shows the document."""

import logging
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QMimeData, QSize, Qt, QUrl
from PySide6.QtGui import (
    QAction,
    QCloseEvent,
    QDesktopServices,
    QDragEnterEvent,
    QDropEvent,
)
from PySide6.QtWidgets import (
    QApplication,
    QLabel,
    QMainWindow,
    QMenu,
    QMessageBox,
    QStackedWidget,
)

from mocapmend import __version__, theme
from mocapmend.actions import ACTIONS, MENUS, make_actions
from mocapmend.errors import MocapmendError
from mocapmend.jobs import Jobs
from mocapmend.log import log_path
from mocapmend.settings import (
    COMPARE,
    GEOMETRY,
    MOST_MISSING_FIRST,
    RECENT_FILES,
    SHOWN,
    THEME,
    Settings,
)
from mocapmend.theme import DARK, LIGHT, THEMES, Theme
from mocapmend.views.action_calls import COMMANDS, FILE_COMMANDS, PROOF_COMMANDS, SWITCHES
from mocapmend.views.dialogs import environment, error_box, shortcuts_dialog
from mocapmend.views.icons import icon, program_icon
from mocapmend.views.job_indicator import JobIndicator
from mocapmend.views.keys import KeyGuard
from mocapmend.views.notes import NotesBar
from mocapmend.views.samples import sample_recordings
from mocapmend.views.transport import Transport
from mocapmend.views.welcome import Welcome

if TYPE_CHECKING:
    from mocapmend.files import Source
    from mocapmend.journal import History
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.proof_actions import ProofActions
    from mocapmend.views.workspace import Workspace
    from mocapmend_algorithms.skeleton import Skeleton

log = logging.getLogger(__name__)

ICONS = (
    "open", "export", "undo", "redo", "previous_gap", "next_gap", "apply", "fill_all",
    "play", "follow", "labels", "trails",
)  # fmt: skip
TOOLBAR = (
    "open", "export", None, "undo", "redo", None, "previous_gap", "next_gap", "apply", "fill_all",
    None, "follow", "labels", "trails", None,
)  # fmt: skip
MESSAGE_MS = 8000
FIRST_SIZE = QSize(1280, 800)
FRAME = QSize(16, 48)
"""Room for the frame and the title that the window system adds."""


class MainWindow(QMainWindow):
    """Wires actions to the workspace of the open document."""

    def __init__(self, settings: Settings) -> None:
        super().__init__()
        self.settings = settings
        self.jobs = Jobs(self)
        self.workspace: Workspace | None = None
        self.theme: Theme = THEMES.get(settings.get(THEME), DARK)
        self.actions_by_id = dict(make_actions(self))
        self._keys = KeyGuard(self)
        self.setWindowIcon(program_icon())
        self.setAcceptDrops(True)
        self.resize(FIRST_SIZE.boundedTo(self.screen().availableSize() - FRAME))
        self.welcome = Welcome(sample_recordings(), self.theme)
        self.welcome.chosen.connect(self.open)
        self.welcome.browse.connect(self.actions_by_id["open"].trigger)
        self.stack = QStackedWidget()
        self.stack.addWidget(self.welcome)
        self.setCentralWidget(self.stack)
        self.notes = NotesBar()
        self.transport = Transport(self.actions_by_id)
        self._keys.guard(self.transport)
        self._make_menus()
        self._make_toolbar()
        self._make_status_bar()
        self._connect()
        self.restoreGeometry(settings.get(GEOMETRY))
        self.actions_by_id["theme"].setChecked(self.theme is LIGHT)
        self.actions_by_id["compare"].setChecked(settings.get(COMPARE))
        for name, shown in SHOWN.items():
            self.actions_by_id[name].setChecked(settings.get(shown))
            self.actions_by_id[name].toggled.connect(
                lambda on, shown=shown: settings.set(shown, on)
            )
        self.actions_by_id["most_missing_first"].setChecked(settings.get(MOST_MISSING_FIRST))
        self._show_theme()
        self._show_document()

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

    def _make_menus(self) -> None:
        titles = {
            "File": self.tr("&File"),
            "Edit": self.tr("&Edit"),
            "Gaps": self.tr("&Gaps"),
            "Repair": self.tr("&Repair"),
            "Play": self.tr("&Play"),
            "View": self.tr("&View"),
            "Plots": self.tr("P&lots"),
            "Help": self.tr("&Help"),
        }
        menus = {name: self.menuBar().addMenu(titles[name]) for name in MENUS}
        for spec in ACTIONS:
            if spec.starts_group:
                menus[spec.menu].addSeparator()
            menus[spec.menu].addAction(self.actions_by_id[spec.id])
        self.recent_menu = QMenu(self.tr("Open recent"), self)
        self.recent_menu.setToolTipsVisible(True)
        self.recent_menu.aboutToShow.connect(self._fill_recent_menu)
        menus["File"].insertMenu(self.actions_by_id["export"], self.recent_menu)
        self.panes_menu = QMenu(self.tr("Panes"), self)
        self.panes_menu.aboutToShow.connect(self._fill_panes_menu)
        menus["View"].addMenu(self.panes_menu)
        # Actions that are only in menus answer to their keys through the window.
        self.addActions(list(self.actions_by_id.values()))

    def _make_toolbar(self) -> None:
        bar = self.addToolBar(self.tr("Tools"))
        bar.setObjectName("tools")
        bar.setMovable(False)
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        for name in TOOLBAR:
            if name is None:
                bar.addSeparator()
            else:
                bar.addAction(self.actions_by_id[name])
        bar.addWidget(self.transport)

    def _make_status_bar(self) -> None:
        self._facts = QLabel()
        self.statusBar().addPermanentWidget(JobIndicator(self.jobs))
        self.statusBar().addPermanentWidget(self.notes)
        self.statusBar().addPermanentWidget(self._facts)

    def _connect(self) -> None:
        plain: dict[str, Callable[[], object]] = {
            "quit": self.close,
            "shortcuts": lambda: shortcuts_dialog(self, self.actions_by_id).open(),
            "log": lambda: QDesktopServices.openUrl(QUrl.fromLocalFile(str(log_path()))),
            "about": self._about,
        }
        for name, call in plain.items():
            self.actions_by_id[name].triggered.connect(lambda _=False, call=call: call())
        for name, do in FILE_COMMANDS.items():
            self.actions_by_id[name].triggered.connect(lambda _=False, do=do: do(self.files))
        for name, prove in PROOF_COMMANDS.items():
            self.actions_by_id[name].triggered.connect(
                lambda _=False, prove=prove: prove(self.proofs)
            )
        for name, use in COMMANDS.items():
            self.actions_by_id[name].triggered.connect(lambda _=False, use=use: self._with(use))
        for name, switch in SWITCHES.items():
            self.actions_by_id[name].toggled.connect(
                lambda on, switch=switch: self._with(lambda w: switch(w, on))
            )
        self.actions_by_id["theme"].toggled.connect(self._choose_theme)

    def _with(self, use: "Callable[[Workspace], object]") -> None:
        if self.workspace is not None:
            use(self.workspace)

    # --- documents ---------------------------------------------------------------------------

    def open(self, path: Path) -> None:
        """Open a recording; the present one stays until the new one is fully read."""
        self.files.open(path)

    def show_source(
        self, source: "Source", skeleton: "Skeleton | None", journal: Path | None = None
    ) -> "History | None":
        """Show a recording that has been read in place of the present one.

        Parameters
        ----------
        source : Source
            The recording.
        skeleton : Skeleton or None
            Its bones; None where they are still to be found.
        journal : Path, optional
            Of edits that are to be recovered.

        Returns
        -------
        History or None
            What was recovered.

        Raises
        ------
        MocapmendError
            If the edits cannot be recovered. The present recording stays then.
        """
        from mocapmend.document import Document
        from mocapmend.journal import resume
        from mocapmend.views.workspace import Workspace

        document = Document(source, skeleton)
        recovered = None if journal is None else resume(journal, document)
        self.drop_workspace()
        workspace = Workspace(document, self.jobs, self.settings, self.theme, self.actions_by_id)
        self.workspace = workspace
        workspace.message.connect(self.say)
        workspace.failed.connect(self.show_error)
        if recovered is not None:
            workspace.recorder.resume(*recovered)
        for name, switch in SWITCHES.items():
            switch(workspace, self.actions_by_id[name].isChecked())
        stack = workspace.document.undo_stack
        stack.indexChanged.connect(self._show_undo)
        stack.cleanChanged.connect(self._show_title)
        self._keys.guard(workspace)
        workspace.repair.rebuilt.connect(self._guard_repair)
        self.stack.addWidget(workspace)
        self.stack.setCurrentWidget(workspace)
        self._show_document()
        workspace.setFocus()
        return None if recovered is None else recovered[1]

    def drop_workspace(self) -> None:
        """Close the present recording and show the empty window."""
        if self.workspace is None:
            return
        workspace, self.workspace = self.workspace, None
        workspace.stop()
        workspace.save_layout()
        self.stack.removeWidget(workspace)
        workspace.deleteLater()
        self.statusBar().clearMessage()
        self._show_document()

    def _guard_repair(self) -> None:
        self._with(lambda workspace: self._keys.guard(workspace.repair))

    # --- showing -----------------------------------------------------------------------------

    def say(self, text: str) -> None:
        """Tell something in passing, in the status bar."""
        self.statusBar().showMessage(text, MESSAGE_MS)

    def show_error(self, error: Exception) -> None:
        """Report an error; the document stays as it is."""
        expected = isinstance(error, MocapmendError)
        log.error("%s", error, exc_info=None if expected else error)
        error_box(self, error).open()

    def _about(self) -> None:
        QMessageBox.about(
            self,
            self.tr("About mocapmend"),
            f"<b>mocapmend {__version__}</b><p>"
            + self.tr("Inspects and repairs optical motion-capture recordings.")
            + f"</p><p>{environment()}</p>",
        )

    def _choose_theme(self, light: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        self.theme = LIGHT if light else DARK
        self.settings.set(THEME, self.theme.name)
        self._show_theme()

    def _show_theme(self) -> None:
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        theme.apply(app, self.theme)
        for name in ICONS:
            self.actions_by_id[name].setIcon(icon(name, self.theme))
        self.transport.set_theme(self.theme)
        self.welcome.set_theme(self.theme)
        if self.workspace is not None:
            self.workspace.set_theme(self.theme)

    def _show_document(self) -> None:
        workspace = self.workspace
        has = {
            "nothing": True,
            "document": workspace is not None,
            "c3d": workspace is not None and workspace.document.source.kind == "C3D",
            "markers": workspace is not None and workspace.document.repairable,
        }
        for spec in ACTIONS:
            self.actions_by_id[spec.id].setEnabled(has[spec.needs])
        self.transport.show_workspace(workspace if has["markers"] else None)
        self.notes.show_warnings(workspace.document.source.warnings if workspace else ())
        if workspace is None:
            recent = self.settings.get(RECENT_FILES)
            self.welcome.show_recent(recent)
            self.stack.setCurrentWidget(self.welcome)
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
        self._show_undo()
        self._show_title()

    def _show_undo(self) -> None:
        stack = self.workspace.document.undo_stack if self.workspace else None
        for name, text, label in (
            ("undo", stack.undoText() if stack else "", self.tr("Undo")),
            ("redo", stack.redoText() if stack else "", self.tr("Redo")),
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

    def _fill_recent_menu(self) -> None:
        self.recent_menu.clear()
        recent = self.settings.get(RECENT_FILES)
        for text in recent:
            action = QAction(Path(text).name.replace("&", "&&"), self.recent_menu)
            action.setToolTip(text)
            action.triggered.connect(lambda _=False, text=text: self.open(Path(text)))
            self.recent_menu.addAction(action)
        if not recent:
            self.recent_menu.addAction(self.tr("None yet")).setEnabled(False)

    def _fill_panes_menu(self) -> None:
        self.panes_menu.clear()
        if self.workspace is None or not self.workspace.panes():
            self.panes_menu.addAction(self.tr("None without markers")).setEnabled(False)
            return
        for pane in self.workspace.panes():
            self.panes_menu.addAction(pane.toggleViewAction())
        self.panes_menu.addSeparator()
        self.panes_menu.addAction(
            self.tr("Arrange as at first"), self.workspace.restore_first_layout
        )

    # --- what the user does to the window ----------------------------------------------------

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if _dropped_file(event.mimeData()) is not None:
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        path = _dropped_file(event.mimeData())
        if path is not None:
            event.acceptProposedAction()
            self.open(path)

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.workspace is not None and not self.workspace.document.undo_stack.isClean():
            event.ignore()
            self.files.after_saving(self._close_for_good)
            return
        if self.files.writing:
            event.ignore()
            self.say(self.tr("The window closes when the file is written."))
            self.files.when_written(self.close)
            return
        self.settings.set(GEOMETRY, bytes(self.saveGeometry().data()))
        self.drop_workspace()
        self.jobs.shut_down()
        event.accept()

    def _close_for_good(self) -> None:
        self.drop_workspace()
        self.close()


def _dropped_file(data: QMimeData) -> Path | None:
    files = [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]
    return files[0] if len(files) == 1 else None
