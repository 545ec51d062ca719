"""Everything that shows one document: the views around it, and what the user does to it."""

from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QAction, QShowEvent

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files import C3DFile
from mocapmend.jobs import Jobs
from mocapmend.journal import Recorder
from mocapmend.prospects import Prospects
from mocapmend.settings import RANKING, SEARCHING, TRAIL_SECONDS, Settings
from mocapmend.theme import Theme
from mocapmend.views.analog_pane import AnalogPane
from mocapmend.views.arrangement import arrange, size_panes
from mocapmend.views.bad_actions import BadActions
from mocapmend.views.bad_search import BadSearch
from mocapmend.views.beginning import Beginning
from mocapmend.views.bone_search import BoneSearch
from mocapmend.views.companion_actions import CompanionActions
from mocapmend.views.dialogs import left_open_dialog
from mocapmend.views.engine_texts import shown
from mocapmend.views.filling import Filling
from mocapmend.views.gap_actions import GapActions
from mocapmend.views.history_pane import HistoryPane
from mocapmend.views.marker_naming import MarkerNaming
from mocapmend.views.marker_table import MarkerTable
from mocapmend.views.paned_window import PanedWindow
from mocapmend.views.plan_pane import PlanPane
from mocapmend.views.player import Player
from mocapmend.views.plot_pane import PlotPane
from mocapmend.views.previewer import Previewer
from mocapmend.views.proofs import Proofs
from mocapmend.views.queue_pane import QueuePane
from mocapmend.views.reason_dialog import ReasonDialog
from mocapmend.views.repair_panel import RepairPanel
from mocapmend.views.repair_table import RepairTable
from mocapmend.views.report_facts import ReportFacts
from mocapmend.views.report_pane import ReportPane
from mocapmend.views.scene import Scene
from mocapmend.views.smooth_pane import SmoothPane
from mocapmend.views.smoothing import Smoothing
from mocapmend.views.survey import Survey
from mocapmend.views.taken_off import TakenOff
from mocapmend.views.time_actions import TimeActions
from mocapmend.views.timeline import Timeline
from mocapmend.viewstate import ViewState
from mocapmend_algorithms import Gap

BEGIN_MS = 50
JOURNAL_MS = 50
"""How often it is looked whether a large step has reached the journal."""
MANY_RUNS = 500
"""Above that an edit takes so long that what it changes is painted a moment later."""


class Workspace(PanedWindow):
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
        super().__init__(settings, theme)
        self.document = document
        document.setParent(self)
        self._jobs = jobs
        self.recorder = Recorder(settings.journal_folder, document.source, self.failed.emit)
        # No methods: parts that have one of the workspace would keep it when its tab is closed.
        self.do = partial(_do, document, self.recorder)
        self.push = partial(_push, document, self.recorder)
        self._journal_timer = QTimer(self)
        self._journal_timer.setInterval(JOURNAL_MS)
        self._journal_timer.timeout.connect(self._look_at_journal)
        original = document.original
        self.view = ViewState(original.frames, self)
        self.player = Player(self.view, original.rate, self)
        self.prospects = Prospects()
        # Before all that asks them what to do.
        document.base_changed.connect(self.prospects.clear)
        document.names_changed.connect(self.prospects.clear)
        self.survey = Survey(document, self.prospects, jobs, self)
        self.search = BadSearch(document, jobs, self)
        self.bones = BoneSearch(document, jobs, self)
        self.previewer = Previewer(document, self.view, self.prospects, jobs, self)
        self.filling = Filling(document, self.prospects, self.survey, jobs, self.do, self)
        self.smoothing = Smoothing(document, self.view, jobs, self.do, self)
        self.scene = Scene(document, self.view, theme)
        self.scene.set_trail_seconds(settings.get(TRAIL_SECONDS))
        self.plots = PlotPane(document, self.view, settings, theme, actions)
        self.trajectories = self.plots.trajectories
        self.timeline = Timeline(document, self.view, theme)
        self.time = TimeActions(document, self.view, self.player, self.timeline, settings, self)
        self.time.message.connect(self.message)
        self.markers = MarkerTable(document, self.view, theme)
        suspects = self.search.suspects
        self.repair = RepairPanel(document, self.view, suspects, settings, actions)
        self.smooth = SmoothPane(document, self.view, self.smoothing, settings, theme, actions)
        self.repairs = RepairTable(document, self.view)
        self.queue = QueuePane(
            document, self.view, self.prospects, self.survey, self.search, settings
        )
        self.gap_actions = GapActions(document, self.view, self.queue, self.push, self)
        self.bad_actions = BadActions(
            document, self.view, self.queue, self.search, self.filling, jobs, self.do, self
        )
        self.plan = PlanPane(document, self.view, self.repair, self.filling, actions)
        self.facts = ReportFacts(document)
        self.report = ReportPane(document, self.facts, self.view, jobs, theme, actions)
        self.proofs = Proofs(document, self.facts, self.report, self)
        self.comparing = CompanionActions(
            document, self.view, jobs, self.facts, self.report.refresh, settings, self
        )
        self.comparing.message.connect(self.message)
        self.naming = MarkerNaming(
            document,
            self.view,
            self.search,
            self.filling,
            self.do,
            jobs,
            settings,
            theme,
            actions,
            self,
        )
        self.markers.renamed.connect(self.naming.renaming.rename)
        self.markers.offer([actions[name] for name in ("rename", "this_is", "exchange_names")])
        self.naming.message.connect(self.message)
        self.naming.failed.connect(self.failed)
        source = document.source
        self.analog: AnalogPane | None = None
        if isinstance(source, C3DFile) and source.analog_labels and original.frames:
            self.analog = AnalogPane(source, self.view, jobs, theme)
            self.analog.failed.connect(self.failed)
        self.view.span_changed.connect(self.trajectories.set_span)
        if self.analog is not None:
            self.view.span_changed.connect(self.analog.plots.set_span)
        self.history = HistoryPane(document.undo_stack)
        self._themed = (
            self.scene,
            self.plots,
            self.timeline,
            self.markers,
            self.report,
            self.smooth,
        )
        self._refill_due = False
        arrange(self)
        self.repair.ways_changed.connect(self._preview)
        self.repair.left_open.clicked.connect(self._show_left_open)
        self.filling.started.connect(self._show_filling)
        self.filling.ended.connect(self._show_filling)
        self.filling.done.connect(self._show_done)
        self.search.changed.connect(self._show_suspects)
        self._preview()
        document.left_open_changed.connect(self.report.refresh)
        document.undo_stack.indexChanged.connect(self._forget_outcome)
        document.undo_stack.indexChanged.connect(self.recorder.move)
        document.undo_stack.cleanChanged.connect(self.recorder.export)
        # Disconnected by the time that a stack is destroyed, and tells that it is clean.
        document.undo_stack.cleanChanged.connect(self._show_proofs)
        document.undo_stack.indexChanged.connect(self._journal_timer.start)
        # A stack that is destroyed, because the program ends, tells that it is empty and clean.
        document.destroyed.connect(self.recorder.close)
        working = (self.previewer, self.report, self.survey, self.search, self.bones)
        for part in (*working, self.comparing, self.filling, self.smoothing, self.bad_actions):
            part.failed.connect(self.failed)
        self.taken_off = TakenOff(document.undo_stack, self)
        self.taken_off.message.connect(self.message)
        for teller in (self.gap_actions, self.bad_actions, self.filling, self.smoothing):
            teller.message.connect(self.taken_off.say)
        self._beginning = Beginning(document, self.view, self.queue, self.survey, self.search, self)
        # What goes on in the background must not hold up the first picture.
        self._paint_timer = QTimer(self)
        self._paint_timer.setSingleShot(True)
        self._paint_timer.timeout.connect(self._paint_again)
        document.samples_changed.connect(self._rest_from)
        self._begin_timer = QTimer(self)
        self._begin_timer.setSingleShot(True)
        self._begin_timer.setInterval(BEGIN_MS)
        self._begin_timer.timeout.connect(self._begin)
        self._begin_timer.start()

    def _begin(self) -> None:
        """Begin with what goes on by itself."""
        self.document.get_ready()
        self.recorder.get_ready()
        self.bones.start()
        if self.isVisible():
            if self._settings.get(SEARCHING):
                self.search.start()
            if self._settings.get(RANKING) and self.filling.job is None:
                self.survey.start()

    def paint_later(self) -> None:
        """Paint when other events have been handled: what was done took long enough."""
        self.setUpdatesEnabled(False)
        self._paint_timer.start()

    def _paint_again(self) -> None:
        self.setUpdatesEnabled(True)
        if self._begin_timer.isActive():
            # The first picture is still to come.
            self._begin_timer.start()

    def _rest_from(self, changed: tuple[Gap, ...]) -> None:
        if len(changed) > MANY_RUNS:
            self.paint_later()

    def set_theme(self, theme: Theme) -> None:
        """Paint with other colours from now on."""
        for part in self._themed:
            part.set_theme(theme)
        if self.analog is not None:
            self.analog.set_theme(theme)
        self.naming.pane.set_theme(theme)
        self.titles.set_theme(theme)

    def stop(self) -> None:
        """End what goes on by itself: the document is going away."""
        self._begin_timer.stop()
        self.bones.stop()
        self.comparing.stop()
        self.naming.search.stop()
        self.player.pause()
        self.previewer.stop()
        self.survey.stop()
        self.search.stop()
        self.bad_actions.stop()
        self.filling.stop()
        self.smoothing.stop()
        self.report.stop()
        if self.analog is not None:
            self.analog.stop()
        self.recorder.discard()

    @property
    def saved(self) -> bool:
        """Whether all edits are exported."""
        return self.document.undo_stack.isClean()

    def show_analog(self) -> None:
        """Bring the analog channels to the front, where the file has some."""
        if self.analog is None:
            self.message.emit(self.tr("This file has no analog channels."))
        else:
            self.show_pane(self.analog)

    def leave(self) -> None:
        """Stand back: another recording is looked at."""
        self.player.pause()
        self.survey.stop()
        self.search.stop()
        self.save_layout()
        self.put_windows_away()

    def enter(self) -> None:
        """Come to the front again, with the panes where the user had them last."""
        self.bring_windows_back()
        if not self._begin_timer.isActive():
            if self._settings.get(SEARCHING):
                self.search.start()
            if self._settings.get(RANKING):
                self.survey.start()
        self.restore_last_layout()

    # --- the 3D view -------------------------------------------------------------------------

    def select_all(self) -> None:
        """Select all markers; the current one stays the current one."""
        markers = range(self.document.original.markers)
        kept = self.view.selection[-1:]
        self.view.select((*(marker for marker in markers if marker not in kept), *kept))

    def step_trails(self, step: int) -> None:
        """Make trails longer (1) or shorter (-1), and remember how long they are."""
        self.scene.step_trails(step)
        seconds = self.scene.trail_seconds
        self._settings.set(TRAIL_SECONDS, seconds)
        self.message.emit(self.tr("Trails reach {0} s back and ahead.").format(f"{seconds:g}"))

    # --- gaps --------------------------------------------------------------------------------

    def apply(self, *, go_on: bool) -> None:
        """Make the previewed repair an edit, or fix the current problem; go on to the next."""
        run = self.view.suspect
        if run is not None and self.search.suspects.is_open(run):
            self.bad_actions.fix()
        elif go_on:
            self.gap_actions.apply_and_go_on()
        else:
            self.gap_actions.apply()

    def undo(self) -> None:
        """Take the last edit back, and say which."""
        stack = self.document.undo_stack
        # First: what follows from it may have more to say.
        self.message.emit(self.tr("Taken back: {0}.").format(shown(stack.undoText())))
        stack.undo()

    def redo(self) -> None:
        """Make the edit again that was taken back last, and say which."""
        stack = self.document.undo_stack
        self.message.emit(self.tr("Made again: {0}.").format(shown(stack.redoText())))
        stack.redo()

    def fill_all(self) -> None:
        """Fill every gap within the limits, in one undoable step; fix bad samples before, if so."""
        kinds, repair = self.repair.fix_first.kinds(), self.repair
        fill = partial(self.filling.fill_all, repair.method(), repair.limits.limits())
        if kinds and self.filling.job is None:
            self._refill_due = True
            self.bad_actions.fix_then(kinds, fill)
        else:
            fill()

    def show_plan(self) -> None:
        """Show what filling all gaps would do."""
        self.show_pane(self.plan)
        self.plan.compute()

    def pick_donors(self, on: bool) -> None:  # noqa: FBT001 - a slot of toggled(bool)
        """Let clicks on markers choose donors."""
        if on and not self.repair.takes_donors:
            self.message.emit(self.tr("This method takes no donors."))
        elif on:
            self.message.emit(self.tr("Click markers to choose donors; D ends it."))
        elif self.view.picking:
            self.message.emit("")
        self.view.set_picking(on and self.repair.takes_donors)

    def ask_why_open(self) -> None:
        """Ask why gaps stay open, where the user is; nothing waits for the answer."""
        gaps = self.gap_actions.to_explain()
        if gaps:
            dialog = ReasonDialog(self.document, gaps, self)
            dialog.given.connect(partial(self.gap_actions.explain, gaps))
            dialog.open()

    def _show_filling(self) -> None:
        self.repair.show_filling(running=self.filling.job is not None)
        if self._refill_due and self.filling.job is None:
            # What was filled before the bad samples were fixed.
            self._refill_due = False
            self.filling.refill()

    def _show_done(self, filled: int, left: int) -> None:
        text = self.tr("Gaps: {0} filled, {1} left open.").format(filled, left)
        self.repair.show_outcome(text, open_gaps=bool(left))

    def _forget_outcome(self) -> None:
        self.repair.show_outcome("", open_gaps=False)

    def _show_left_open(self) -> None:
        unfilled = self.facts.unfilled()
        left_open_dialog(self, self.document.original, unfilled, self.view.go_to).show()

    def _preview(self) -> None:
        self.previewer.choose(self.repair.method(), self.repair.compared())

    def _show_suspects(self) -> None:
        found = self.search.suspects.found
        self.timeline.set_suspects(found)
        self.trajectories.set_suspects(found)
        self.scene.set_suspects(found)
        self.repair.show_problem()

    def _look_at_journal(self) -> None:
        if self.recorder.poll():
            self._journal_timer.stop()

    def _show_proofs(self) -> None:
        self.proofs.show()

    def report_inputs(self) -> tuple[Any, ...]:
        """Return what `engine.write_report` needs, as it is now."""
        document = self.document
        return (
            document.share_original(),
            document.share(),
            document.skeleton,
            document.repair_rows(),
            self.facts.unfilled(),
            self.facts.about(),
        )

    # --- labels ------------------------------------------------------------------------------

    def rename(self) -> None:
        """Let the user type another name for the current marker."""
        marker = self.view.marker
        if marker is None:
            self.message.emit(self.tr("Select a marker first."))
        elif self.raise_pane(self.markers):
            # Later: what was behind another pane is enabled when it is seen.
            QTimer.singleShot(0, self.markers, lambda: self.markers.edit_name(marker))

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

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self.document.repairable and not self.arranged:
            # Sizes of panes mean nothing before the window has its own.
            QTimer.singleShot(0, self, self._size_panes)

    def _size_panes(self) -> None:
        size_panes(self)
        self.remember_first_layout()


def _do(document: Document, recorder: Recorder, command: EditSamples) -> None:
    """Do an undo command, and have it in the journal first."""
    recorder.push(command.text(), command.edits, command.correction, command.labels)
    document.undo_stack.push(command)


def _push(document: Document, recorder: Recorder, edits: list[Edit], text: str) -> None:
    """Make edits, in one undoable step."""
    _do(document, recorder, EditSamples(document, edits, text))
