"""The window with each of its panes in front."""

from mocapmend.ranking import Status
from mocapmend.views.filling import Filling
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap
from screens.stage import Stage, settle, wait_until, worth_a_look

PLOTS = ("plot_position", "plot_speed", "plot_acceleration", "plot_residual", "plot_bone")


def welcome(stage: Stage) -> None:
    """Show the window before a file is open: at first, and with files that were open."""
    stage.shoot("welcome")
    for path in (
        "/nowhere/a_rather_long_name_of_a_recording_that_was_moved_away.c3d",
        "/nowhere/b.trc",
    ):
        stage.settings.remember_file(path)
    stage.settings.remember_file(str(sample_recordings()[1][0]))
    stage.window.recent.changed.emit()
    stage.window.recent.look()
    stage.wait()
    stage.shoot("welcome_recent")


def ranked(stage: Stage) -> Workspace:
    """Open the recording with many gaps; wait until they are ranked, and bad samples are found."""
    workspace = stage.open_sample("sprint_basketball")
    wait_until(lambda: not workspace.survey.running and workspace.survey.portions > 1)
    wait_until(lambda: workspace.search.suspects.known)
    return workspace


def go_to(stage: Stage, gap: Gap) -> None:
    """Go to a gap and wait for its repairs."""
    workspace = stage.workspace
    workspace.view.go_to(gap)
    wait_until(lambda: workspace.view.preview is not None and not workspace.previewer.busy)


def repairing(stage: Stage) -> None:
    """Look for gaps, compare repairs and choose parameters and donors."""
    workspace = ranked(stage)
    workspace.zoom_all()
    stage.shoot("window")
    gap = worth_a_look(workspace)
    go_to(stage, gap)
    stage.shoot("preview")
    stage.show_pane(workspace.markers)
    stage.shoot("markers")
    stage.show_pane(workspace.queue)
    workspace.queue.filter.setText("no such marker")
    stage.shoot("queue_nothing_passes")
    workspace.queue.filter.clear()
    for method in ("local-frame", "bone-dictionary", "kalman"):
        _choose(workspace, method)
        stage.shoot(f"method_{method}")
    _choose(workspace, "local-frame")
    stage.do("pick_donors")
    for marker in workspace.view.selection:
        workspace.view.click((marker + 1) % workspace.document.original.markers)
    stage.shoot("picking_donors")
    stage.do("pick_donors")
    _choose(workspace, "pattern")
    stage.shoot("refused")
    stage.switch(compare=False)
    _choose(workspace, "auto")
    stage.shoot("one_method")
    stage.switch(compare=True)
    bar = workspace.repair.verticalScrollBar()
    bar.setValue(bar.maximum())
    stage.shoot("limits")
    bar.setValue(0)
    stage.do("never_fill")
    stage.shoot("never_filled")
    stage.do("undo")
    stage.do("widen")
    stage.shoot("widened")
    stage.do("undo")


def problems(stage: Stage) -> None:
    """Look at bad samples of every kind that is found, fix some, and see what became of them."""
    workspace = stage.workspace
    stage.show_pane(workspace.queue)
    found = {run.kind: run for run in workspace.search.suspects.found}
    for kind, run in sorted(found.items()):
        workspace.view.go_to_suspect(run)
        wait_until(lambda: not workspace.previewer.busy)
        stage.shoot(f"problem_{kind}")
    stage.do("fix_all")
    wait_until(lambda: workspace.search.suspects.known)
    fixed = next(row for row in range(9) if Status.FIXED in workspace.queue.status.itemData(row))
    workspace.queue.status.setCurrentIndex(fixed)
    workspace.view.go_to_suspect(workspace.search.suspects.fixed()[0])
    wait_until(lambda: not workspace.previewer.busy)
    stage.shoot("problems_fixed")
    workspace.queue.status.setCurrentIndex(0)
    stage.do("undo")


def _choose(workspace: Workspace, method: str) -> None:
    workspace.repair._choose(method)  # noqa: SLF001 - what a click on the list does
    settle()
    wait_until(lambda: not workspace.previewer.busy)


def filling(stage: Stage) -> None:
    """Plan, fill all gaps, and look at what became of them."""
    workspace = stage.workspace
    stage.show_pane(workspace.repairs)
    stage.shoot("repairs_none")
    stage.show_pane(workspace.history)
    stage.shoot("history_none")
    workspace.show_plan()
    stage.shoot("plan_in_work", wait=False)
    _wait_for(workspace.filling)
    stage.shoot("plan")
    workspace.fill_all()
    wait_until(lambda: workspace.document.undo_stack.count() > 0)
    stage.shoot("plan_done")
    stage.show_pane(workspace.repairs)
    workspace.view.go_to(min(workspace.document.repairs))
    stage.shoot("repairs")
    stage.do("clear_fill")
    stage.do("undo")
    stage.show_pane(workspace.history)
    stage.shoot("history")
    report(stage)
    stage.show_pane(workspace.timeline)
    stage.switch(before_after=True)
    stage.do("zoom_gap")
    stage.shoot("before_after")
    stage.switch(before_after=False)


def report(stage: Stage) -> None:
    """Show the pages of the report."""
    workspace = stage.workspace
    stage.show_pane(workspace.report)
    wait_until(lambda: workspace.report.report is not None and workspace.report.up_to_date)
    for page, name in enumerate(("tracking", "bones", "markers", "methods", "history")):
        workspace.report.tabs.setCurrentIndex(page)
        stage.shoot(f"report_{name}")
    workspace.report.tabs.setCurrentIndex(0)


def _wait_for(filling: Filling) -> None:
    wait_until(lambda: filling.job is None)


def smoothing(stage: Stage) -> None:
    """Look at what smoothing would do to a marker, and do it to a part of all."""
    workspace = stage.workspace
    stage.show_pane(workspace.timeline)
    workspace.view.select((3, 4))
    stage.do("show_smooth")
    for method in range(workspace.smooth.method.count()):
        workspace.smooth.method.setCurrentIndex(method)
        wait_until(lambda: not workspace.smoothing.busy)
        stage.shoot(f"smooth_{workspace.smooth.way.method}")
    workspace.smooth.method.setCurrentIndex(0)
    workspace.view.set_span((900, 1300))
    workspace.smooth.time.setCurrentIndex(1)
    workspace.smooth.markers.setCurrentIndex(1)
    stage.do("smooth")
    wait_until(lambda: workspace.smoothing.job is None)
    stage.do("zoom_span")
    stage.shoot("smoothed")
    stage.do("undo")
    workspace.smooth.markers.setCurrentIndex(0)
    workspace.view.set_span(None)
    workspace.zoom_all()
    stage.show_pane(workspace.repair)


def working(stage: Stage) -> None:
    """Fill all gaps by a slow method, and cancel that."""
    workspace = stage.workspace
    while workspace.document.undo_stack.canUndo():
        workspace.document.undo_stack.undo()
    _choose(workspace, "smbs")
    workspace.repair.limits.set_limits(None, 1000.0)
    stage.show_pane(workspace.timeline)
    workspace.fill_all()
    wait_until(lambda: workspace.filling.job is not None and workspace.filling.job.progress > 0.05)
    stage.shoot("working", wait=False)
    workspace.filling.stop()
    stage.wait()


def time(stage: Stage) -> None:
    """Zoom and select in time, in a recording with events."""
    workspace = stage.open_sample("gait_plug_in_gait")
    stage.shoot("gait")
    workspace.view.set_span((80, 150))
    workspace.view.set_visible(40, 200)
    workspace.go_to_frame(110)
    stage.shoot("selected_frames")
    stage.switch(most_missing_first=True)
    stage.do("select_all")
    stage.shoot("all_markers")
    stage.switch(most_missing_first=False)
    workspace.view.set_span(None)
    workspace.zoom_all()
    assert workspace.analog is not None
    stage.show_pane(workspace.analog)
    settle()
    stage.shoot("analog")
    workspace.analog.overlay.setChecked(True)
    stage.shoot("analog_overlay")
    stage.show_pane(workspace.timeline)


def plots(stage: Stage) -> None:
    """Plot each quantity, all of them, none, and a set for each marker."""
    workspace = stage.workspace
    names = workspace.document.names
    knees = [k for k, name in enumerate(names) if name.endswith(("KNE", "ANK", "TIB"))][:3]
    workspace.view.select(tuple(knees))
    for shown in PLOTS:
        stage.switch(**{name: name == shown for name in PLOTS})
        stage.shoot(shown)
    stage.switch(**dict.fromkeys(PLOTS, True))
    stage.shoot("plot_all")
    stage.switch(**dict.fromkeys(PLOTS, False))
    stage.shoot("plot_none")
    stage.switch(plot_position=True, separate=True)
    stage.shoot("plot_separate")
    stage.switch(separate=False, same_scale=True)
    stage.shoot("plot_same_scale")
    stage.switch(same_scale=False)
    stage.do("select_none")
    stage.shoot("nothing_selected")


def floating(stage: Stage) -> None:
    """Take panes out of the window: one with a title of its own, and one that shared a place."""
    workspace = stage.workspace
    for content, name in ((workspace.repair, "repair"), (workspace.queue, "queue")):
        pane = next(each for each in workspace.panes() if each.widget() is content)
        pane.setFloating(True)
        pane.move(stage.window.width() // 3, 120)
        settle()
        stage.shoot(f"floating_{name}")
        pane.setFloating(False)
    stage.do("first_layout")
