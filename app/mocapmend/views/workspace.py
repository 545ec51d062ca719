"""Everything that shows one document: the views around it, and what the user does to it."""

from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QByteArray, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import QDockWidget, QLabel, QMainWindow, QSplitter, QTabWidget, QWidget

from mocapmend import engine
from mocapmend.commands import EditSamples
from mocapmend.document import Document, Edit
from mocapmend.jobs import Job, Jobs
from mocapmend.journal import Recorder
from mocapmend.navigation import in_time_order, neighbour
from mocapmend.report import About
from mocapmend.settings import LAYOUT, Settings
from mocapmend.theme import Theme
from mocapmend.views.dialogs import left_open_dialog
from mocapmend.views.history_pane import HistoryPane
from mocapmend.views.marker_table import MarkerTable
from mocapmend.views.pane_widths import PaneWidths
from mocapmend.views.player import Player
from mocapmend.views.previewer import Previewer
from mocapmend.views.repair_panel import RepairPanel
from mocapmend.views.repair_table import RepairTable
from mocapmend.views.report_pane import ReportPane
from mocapmend.views.scene import Scene
from mocapmend.views.timeline import Timeline
from mocapmend.views.trajectories import Trajectories
from mocapmend.viewstate import ViewState
from mocapmend_algorithms.fill.contract import FillResult, Unfilled
from mocapmend_algorithms.fill.limits import Limits, default_frames
from mocapmend_algorithms.fill.registry import method_label

LAYOUT_VERSION = 3
TAB_HEIGHT = 36


class Workspace(QMainWindow):
    """The views of a document; the window around it holds menus and files.

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
        jobs: Jobs,
        settings: Settings,
        theme: Theme,
        actions: dict[str, QAction],
    ) -> None:
        super().__init__()
        self.setWindowFlags(Qt.WindowType.Widget)
        self.document = document
        document.setParent(self)
        self._jobs = jobs
        self._settings = settings
        self.recorder = Recorder(settings.journal_folder, document.source, self.failed.emit)
        original = document.original
        self.view = ViewState(original.frames, self)
        self.player = Player(self.view, original.rate, self)
        self.previewer = Previewer(document, self.view, jobs, self)
        self.scene = Scene(document, self.view, theme)
        self.trajectories = Trajectories(document, self.view, theme)
        self.timeline = Timeline(document, self.view, theme)
        self.markers = MarkerTable(document, self.view, theme)
        self.repair = RepairPanel(document, self.view, settings, actions)
        self.repairs = RepairTable(document, self.view)
        self.report = ReportPane(document, self.view, jobs, theme, actions)
        self.history = HistoryPane(document.undo_stack)
        self._themed = (self.scene, self.trajectories, self.timeline, self.markers, self.report)
        self._left_open: tuple[Unfilled, ...] = ()
        self.last_export: Path | None = None
        self._exported: engine.Exported | None = None
        self._panes: list[QDockWidget] = []
        self._put_away: list[QWidget] = []
        self._first_layout = QByteArray()
        self._filling: Job | None = None
        self._arrange()
        PaneWidths(self)
        self.repair.method_chosen.connect(self.previewer.choose)
        self.repair.left_open.clicked.connect(self._show_left_open)
        self.previewer.choose(*self.repair.method())
        document.undo_stack.indexChanged.connect(self._forget_outcome)
        document.undo_stack.indexChanged.connect(self.recorder.move)
        document.undo_stack.cleanChanged.connect(self.recorder.export)
        document.undo_stack.cleanChanged.connect(self._show_proof)
        # A stack that is destroyed, because the program ends, tells that it is empty and clean.
        document.destroyed.connect(self.recorder.close)
        for part in (self.previewer, self.report):
            part.failed.connect(self.failed)
        self._show_proof()
        self._show_first_gap()

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        for part in self._themed:
            part.set_theme(theme)

    def stop(self) -> None:
        """End what goes on by itself: the document is going away."""
        self.player.pause()
        self.previewer.stop()
        self.report.stop()
        self.recorder.discard()
        if self._filling is not None:
            self._filling.abandon()

    @property
    def saved(self) -> bool:
        """Whether all edits are exported."""
        return self.document.undo_stack.isClean()

    def panes(self) -> list[QDockWidget]:
        """Return the panes around the middle, in the order in which they were made."""
        return self._panes

    @property
    def arranged(self) -> bool:
        """Whether the panes are where the user had them last."""
        return not self._first_layout.isEmpty()

    def show_pane(self, content: QWidget) -> None:
        """Bring a pane to the front and give it the keyboard."""
        for pane in self._panes:
            if pane.widget() is content:
                pane.show()
                pane.raise_()
                # Later: what was behind another pane is enabled when it is seen.
                QTimer.singleShot(0, content, content.setFocus)

    def restore_first_layout(self) -> None:
        """Put all panes back where they were when the program was new."""
        self.restoreState(self._first_layout, LAYOUT_VERSION)

    def save_layout(self) -> None:
        """Remember where the panes are."""
        if self.arranged:
            self._settings.set(LAYOUT, self.layout_state())

    def layout_state(self) -> bytes:
        """Return where the panes are."""
        return bytes(self.saveState(LAYOUT_VERSION).data())

    def restore_layout(self, state: bytes) -> bool:
        """Put the panes where `layout_state` had them; False if it is of another version."""
        return self.restoreState(state, LAYOUT_VERSION)

    def leave(self) -> None:
        """Stand back: another recording is looked at."""
        self.player.pause()
        self.save_layout()
        children = Qt.FindChildOption.FindDirectChildrenOnly
        # Panes that float and dialogs are windows: they do not go with what they belong to.
        self._put_away = [
            each
            for each in self.findChildren(QWidget, options=children)
            if each.isWindow() and each.isVisible()
        ]
        for window in self._put_away:
            window.hide()

    def enter(self) -> None:
        """Come to the front again, with the panes where the user had them last."""
        for window in self._put_away:
            window.show()
        self._put_away = []
        if self.arranged:
            self.restore_layout(self._settings.get(LAYOUT))

    # --- gaps --------------------------------------------------------------------------------

    def step_gap(self, step: int, *, same_marker: bool = False) -> None:
        """Go to the next (1) or previous (-1) open gap."""
        document, view = self.document, self.view
        gaps = document.gaps
        if same_marker and view.marker is not None:
            gaps = document.gaps_of(view.marker)
        ordered = in_time_order(gaps, document.original.frames)
        start, marker = view.frame, -1
        if view.gap is not None and view.gap.start <= view.frame < view.gap.stop:
            start, marker = view.gap.start, view.gap.marker
        gap = neighbour(ordered, start, marker, step)
        if gap is None:
            self.message.emit(self.tr("No gap is left to go to."))
        else:
            view.go_to(gap)

    def apply_preview(self) -> None:
        """Make the previewed repair an undoable edit."""
        preview = self.view.preview
        if preview is None:
            self.message.emit(self.tr("There is no preview to apply: choose a gap first (N)."))
            return
        if preview.patch is None:
            self.message.emit(self.tr("This method leaves the gap open; choose another (M)."))
            return
        edit = Edit.fill(preview.patch, preview.method, preview.params, preview.donors)
        label = self.document.names[preview.gap.marker]
        self.push([edit], self.tr("fill {0} ({1})").format(label, preview.method))

    def apply_and_go_on(self) -> None:
        """Apply the previewed repair and go to the next gap."""
        before = self.document.revision
        self.apply_preview()
        if self.document.revision != before:
            self.step_gap(1)

    def clear_fill(self) -> None:
        """Turn the current gap's repair back into a gap."""
        gap = self.view.gap
        if gap is not None and gap in self.document.repairs:
            label = self.document.names[gap.marker]
            self.push([Edit.clear(gap)], self.tr("clear the repair of {0}").format(label))
        else:
            self.message.emit(self.tr("There is no repair here."))

    def fill_all(self) -> None:
        """Fill every gap within the limits, in one undoable step."""
        if self._filling is not None:
            return
        document = self.document
        method, params = self.repair.method()
        limits = Limits(max_gap=self.repair.max_gap(), max_error_mm=self.repair.max_error_mm())
        gaps = [gap for gap in document.gaps if gap.length < document.original.frames]
        job = self._jobs.compute(
            self.tr("Fill all gaps"),
            engine.fill,
            document.share_original(),
            gaps,
            method,
            params,
            limits,
        )
        job.finished.connect(lambda result: self._accept_all(method, params, result))
        job.failed.connect(self.failed)
        job.cancelled.connect(lambda: self.message.emit(self.tr("Cancelled: nothing was filled.")))
        job.ended.connect(self._end_filling)
        self._filling = job
        self.repair.show_filling(running=True)

    def _end_filling(self) -> None:
        self._filling = None
        self.repair.show_filling(running=False)

    def _accept_all(self, method: str, params: object, result: FillResult) -> None:
        """Take what was filled; gaps that the user has repaired meanwhile stay as they are."""
        still_open = set(self.document.gaps)
        result = FillResult(
            tuple(patch for patch in result.patches if patch.gap in still_open),
            tuple(entry for entry in result.unfilled if entry.gap in still_open),
            result.notes,
        )
        self._left_open = result.unfilled
        filled, left = len(result.patches), len(result.unfilled)
        if filled:
            edits = Edit.fills(result, method, params)
            self.push(edits, self.tr("fill {0} gaps ({1})").format(filled, method))
        text = self.tr("{0} gaps filled, {1} left open.").format(filled, left)
        self.repair.show_outcome(text, open_gaps=bool(left))
        self.message.emit(text)

    def _forget_outcome(self) -> None:
        self.repair.show_outcome("", open_gaps=False)

    def _show_left_open(self) -> None:
        left_open_dialog(self, self.document.original, self._left_open, self.view.go_to).show()

    def push(self, edits: list[Edit], text: str) -> None:
        """Make edits, in one undoable step."""
        command = EditSamples(self.document, edits, text)
        self.recorder.push(text, edits)
        self.document.undo_stack.push(command)

    def _show_first_gap(self) -> None:
        """Begin at the longest of the shorter gaps, with the whole recording in view."""
        original = self.document.original
        ordered = in_time_order(self.document.gaps, original.frames)
        seen = original.present.mean(axis=0) if original.frames else np.empty(0)
        longest = default_frames(original.rate)
        within = [
            gap
            for gap in ordered
            if gap.kind(original.frames) == "interior"
            and gap.length <= longest
            # Fragments of trajectories and frames without a body are no place to begin.
            and not original.labels[gap.marker].startswith("*")
            and seen[gap.marker] > 0.5
            and original.present[gap.start].mean() > 0.5
        ]
        gap = max(within, key=lambda gap: gap.length, default=None)
        if gap is not None:
            self.view.select((gap.marker,))
            self.view.set_gap(gap)
            self.view.set_frame((gap.start + gap.stop - 1) // 2)
        elif original.markers:
            self.view.select((0,))

    def saved_as(self, exported: engine.Exported, *, complete: bool) -> None:
        """Take note that a file now holds the edits: all of them, or those of a while ago."""
        self.last_export = exported.saved.path
        if complete:
            self._exported = exported
            self.document.undo_stack.setClean()
        self._show_proof()

    @property
    def _proof(self) -> engine.Exported | None:
        """The export that holds the recording as it is now, if there is one."""
        return self._exported if self.document.undo_stack.isClean() else None

    def _show_proof(self) -> None:
        if self.last_export is None:
            self.report.show_proof(self.tr("Not exported yet."))
        elif self._proof is None:
            edited = self.tr("Edited since {0} was exported.")
            self.report.show_proof(edited.format(self.last_export.name))
        else:
            finding, name = self._proof.sentences[0], self._proof.saved.path.name
            self.report.show_proof(f"✔ {name}: {finding}", self._proof.sentences)

    def report_inputs(self) -> tuple[Any, ...]:
        """Return what `engine.write_report` needs, as it is now."""
        document = self.document
        used = sorted({repair.method for repair in document.repairs.values()})
        proof = self._proof
        about = About(
            file=document.source.path.name,
            methods=tuple(method_label(method) for method in used),
            warnings=document.source.warnings,
            earlier=sum(map(document.is_earlier, document.repairs)),
            proof=() if proof is None else proof.sentences,
        )
        still_open = set(document.gaps)
        unfilled = [entry for entry in self._left_open if entry.gap in still_open]
        return (
            document.original,
            document.snapshot(),
            document.skeleton,
            document.repair_rows(),
            unfilled,
            about,
        )

    # --- time --------------------------------------------------------------------------------

    def step_frames(self, frames: int) -> None:
        """Move the playhead and keep it in view."""
        self.go_to_frame(self.view.frame + frames)

    def step_seconds(self, seconds: float) -> None:
        """Move the playhead by a time."""
        self.step_frames(round(seconds * self.document.original.rate))

    def go_to_frame(self, frame: int) -> None:
        """Put the playhead on a frame, counted from 0, and keep it in view."""
        self.view.set_frame(frame)
        self.view.keep_in_view()

    def zoom_time(self, factor: float) -> None:
        """Scale the visible range around the playhead."""
        self.view.zoom(factor, float(np.clip(self.view.frame, *self.view.visible)))

    def zoom_all(self) -> None:
        """Show the whole recording."""
        self.view.set_visible(0.0, float(self.view.frames))

    # --- arrangement -------------------------------------------------------------------------

    def _arrange(self) -> None:
        self.setDockNestingEnabled(True)
        self.setTabPosition(Qt.DockWidgetArea.AllDockWidgetAreas, QTabWidget.TabPosition.North)
        if not self.document.repairable:
            self.setCentralWidget(self._nothing_to_repair())
            return
        middle = QSplitter(Qt.Orientation.Horizontal)
        middle.addWidget(self.scene)
        middle.addWidget(self.trajectories)
        middle.setSizes([420, 480])
        middle.setChildrenCollapsible(False)
        self.setCentralWidget(middle)
        areas = Qt.DockWidgetArea
        corners = Qt.Corner
        self.setCorner(corners.BottomLeftCorner, areas.BottomDockWidgetArea)
        self.setCorner(corners.BottomRightCorner, areas.BottomDockWidgetArea)
        self._dock("markers", self.tr("Markers"), self.markers, areas.LeftDockWidgetArea)
        self._dock("repair", self.tr("Repair"), self.repair, areas.RightDockWidgetArea)
        timeline = self._dock(
            "timeline", self.tr("Timeline"), self.timeline, areas.BottomDockWidgetArea
        )
        repairs = self._dock(
            "repairs", self.tr("Repairs"), self.repairs, areas.BottomDockWidgetArea
        )
        report = self._dock("report", self.tr("Report"), self.report, areas.BottomDockWidgetArea)
        history = self._dock(
            "history", self.tr("History"), self.history, areas.BottomDockWidgetArea
        )
        for tabbed in (timeline, repairs, report, history):
            # The tab says the name already.
            tabbed.setTitleBarWidget(QWidget())
        self.tabifyDockWidget(timeline, repairs)
        self.tabifyDockWidget(repairs, report)
        self.tabifyDockWidget(report, history)
        timeline.raise_()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._panes and not self.arranged:
            # Sizes of panes mean nothing before the window has its own.
            QTimer.singleShot(0, self, self._size_panes)

    def _size_panes(self) -> None:
        markers, repair, timeline, *_ = self._panes
        self.resizeDocks([markers, repair], [310, 280], Qt.Orientation.Horizontal)
        height = self.timeline.sizeHint().height() + TAB_HEIGHT
        self.resizeDocks([timeline], [height], Qt.Orientation.Vertical)
        self._first_layout = self.saveState(LAYOUT_VERSION)
        self.restoreState(self._settings.get(LAYOUT), LAYOUT_VERSION)

    def _dock(
        self, name: str, title: str, content: QWidget, area: Qt.DockWidgetArea
    ) -> QDockWidget:
        dock = QDockWidget(title)
        dock.setObjectName(name)
        dock.setWidget(content)
        # A pane behind another one would take the keyboard unseen.
        dock.visibilityChanged.connect(content.setEnabled)
        self.addDockWidget(area, dock)
        self._panes.append(dock)
        return dock

    def _nothing_to_repair(self) -> QLabel:
        source = self.document.source
        held = [self.tr("{0} events").format(len(source.events))] if source.events else []
        if source.analog_labels:
            held.append(self.tr("{0} analog channels").format(len(source.analog_labels)))
        if source.model_outputs:
            held.append(self.tr("{0} model outputs").format(len(source.model_outputs)))
        label = QLabel(
            self.tr(
                "This file has no marker samples: there is nothing to repair.\n\nIt holds {0}."
            ).format(", ".join(held) or self.tr("nothing that can be shown"))
        )
        label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        label.setWordWrap(True)
        return label
