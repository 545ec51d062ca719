"""Smoothing in the window: preview, residuals, applying, taking off, and that nothing is silent."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from holes import HOLES
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDoubleSpinBox, QLabel, QMessageBox
from pytestqt.qtbot import QtBot

from mocapmend.cli import main
from mocapmend.edits import Edit
from mocapmend.files import read_c3d
from mocapmend.report import describe
from mocapmend.settings import SMOOTHER, Settings
from mocapmend.smoothing import SmoothWay, found_nothing, runs_of
from mocapmend.state import SampleState
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.smooth.registry import SMOOTHERS

Open = Callable[[Path], MainWindow]
CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
MARKER = 5


@pytest.fixture
def workspace(open_in: Open, holed_walk: Path, qtbot: QtBot) -> Workspace:
    """Return the workspace of the walk, one marker selected, and the pane in front."""
    window = open_in(holed_walk)
    made = workspace_of(window)
    qtbot.waitUntil(lambda: made.arranged)
    made.view.select((MARKER,))
    choose(made, "butterworth")
    window.actions_by_id["show_smooth"].trigger()
    looked(made, qtbot)
    return made


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def looked(workspace: Workspace, qtbot: QtBot) -> None:
    """Wait for the preview."""
    qtbot.waitUntil(lambda: not workspace.smoothing.busy and workspace.smooth.isEnabled())
    assert workspace.smoothing.outlook is not None


def choose(workspace: Workspace, method: str) -> None:
    workspace.smooth.method.setCurrentIndex(workspace.smooth.method.findData(method))


def give(workspace: Workspace, cutoff: float) -> None:
    field = workspace.smooth.form.findChild(QDoubleSpinBox, "cutoff_hz")
    assert field is not None
    field.setValue(cutoff)


def said(window: MainWindow) -> str:
    return window.statusBar().currentMessage()


def notes(workspace: Workspace) -> str:
    return " ".join(label.text() for label in workspace.smooth.widget().findChildren(QLabel))


def smoothed_by_hand(workspace: Workspace, run: Gap, method: str = "butterworth") -> np.ndarray:
    """Return what the method itself makes of a run of what is shown."""
    smoother = SMOOTHERS[method]
    now = workspace.document.snapshot()
    (done,) = smoother.function(now, [run], smoother.params(), no_progress).runs
    return done.values


# --- looking ahead -------------------------------------------------------------------------------


def test_the_preview_is_what_applying_does(workspace: Workspace, qtbot: QtBot) -> None:
    whole = Gap(MARKER, 0, workspace.document.original.frames)
    (shown,) = workspace.view.smoothing
    assert shown.run == whole
    wanted = smoothed_by_hand(workspace, whole)
    np.testing.assert_array_equal(shown.values, wanted)
    table = workspace.smooth.table
    mm = workspace.document.original.mm
    row = [table.item(0, column).text() for column in range(4)]
    assert row[0] == workspace.document.names[MARKER]
    assert row[1] == " ".join(f"{hz:.1f}" for hz in shown.chosen["cutoff_hz"])
    assert row[2:] == [f"{shown.rms * mm:.2f}", f"{shown.largest * mm:.1f}"]
    workspace.smooth.apply()
    np.testing.assert_array_equal(workspace.document.points[:, MARKER], wanted)
    looked(workspace, qtbot)
    assert workspace.view.smoothing == (), "what is applied is no preview"
    assert table.item(0, 0).text().startswith("✔")


def test_the_preview_is_drawn_over_the_measured_curve(workspace: Workspace, qtbot: QtBot) -> None:
    give(workspace, 1.0)
    looked(workspace, qtbot)
    with_preview = workspace.trajectories.grab().toImage()
    workspace.view.set_smoothing(())
    assert workspace.trajectories.grab().toImage() != with_preview


def test_another_name_is_seen_in_the_pane(workspace: Workspace, qtbot: QtBot) -> None:
    looked(workspace, qtbot)
    assert workspace.view.marker is not None
    workspace.naming.renaming.rename(workspace.view.marker, "Hip")
    table = workspace.smooth.table
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    assert "Hip" in names


def test_there_is_no_preview_while_the_pane_is_behind(workspace: Workspace, qtbot: QtBot) -> None:
    assert workspace.view.smoothing
    workspace.show_pane(workspace.repair)
    qtbot.waitUntil(lambda: workspace.view.smoothing == ())
    workspace.show_pane(workspace.smooth)
    qtbot.waitUntil(lambda: len(workspace.view.smoothing) == 1)


def test_the_preview_follows_selection_span_and_parameters(
    workspace: Workspace, qtbot: QtBot
) -> None:
    workspace.view.select((3, 4, MARKER))
    looked(workspace, qtbot)
    assert [done.run.marker for done in workspace.view.smoothing] == [3, 4, MARKER]
    assert not workspace.smooth.time.model().item(1).isEnabled()
    workspace.view.set_span((40, 120))
    workspace.smooth.time.setCurrentIndex(1)
    looked(workspace, qtbot)
    assert {done.run[1:] for done in workspace.view.smoothing} == {(40, 120)}
    workspace.view.set_span(None)
    looked(workspace, qtbot)
    assert workspace.smooth.span is None
    give(workspace, 4.0)
    looked(workspace, qtbot)
    assert {tuple(d.chosen["cutoff_hz"]) for d in workspace.view.smoothing} == {(4.0, 4.0, 4.0)}


def test_what_cannot_be_computed_is_said_in_the_pane(workspace: Workspace, qtbot: QtBot) -> None:
    give(workspace, 60.0)
    qtbot.waitUntil(lambda: "below half the frame rate" in notes(workspace))
    assert workspace.view.smoothing == ()
    workspace.view.select(())
    qtbot.waitUntil(lambda: "Select a marker" in notes(workspace))


def test_only_the_markers_selected_last_have_a_preview(workspace: Workspace, qtbot: QtBot) -> None:
    workspace.select_all()
    looked(workspace, qtbot)
    assert len(workspace.view.smoothing) == 8
    assert "8 markers selected last" in notes(workspace)


def test_the_residual_is_plotted_and_a_click_gives_a_cutoff(
    workspace: Workspace, qtbot: QtBot
) -> None:
    plot = workspace.smooth.plot
    assert plot.isVisibleTo(workspace.smooth)
    assert plot.accessibleDescription().count("cut-off") == 3
    plain = plot.grab().toImage()
    place = QPoint(plot.width() // 2, plot.height() // 2)
    with qtbot.waitSignal(plot.picked) as picked:
        QTest.mouseClick(plot, Qt.MouseButton.LeftButton, pos=place)
    (hz,) = picked.args
    assert 0.5 < hz < 60.0
    assert workspace.smooth.way.params.cutoff_hz == hz
    looked(workspace, qtbot)
    assert plot.grab().toImage() != plain
    choose(workspace, "gcv")
    looked(workspace, qtbot)
    assert not plot.isVisibleTo(workspace.smooth)
    assert workspace.smooth.way.params.cutoff_hz is None
    choose(workspace, "butterworth")
    assert workspace.smooth.way.params.cutoff_hz == hz, "parameters last as long as the recording"


def test_the_method_is_remembered_and_the_scope_is_not(
    window: MainWindow, workspace: Workspace, settings: Settings, open_in: Open, gait: Path
) -> None:
    workspace.smooth.markers.setCurrentIndex(1)
    choose(workspace, "savgol")
    assert settings.get(SMOOTHER) == "savgol"
    again = workspace_of(open_in(gait))
    assert again.smooth.way == SmoothWay("savgol", SMOOTHERS["savgol"].params())
    assert again.smooth.markers.currentIndex() == 0


def test_little_to_smooth_is_said(open_in: Open, gait: Path, qtbot: QtBot) -> None:
    """The recording was filtered before it was written."""
    window = open_in(gait)
    workspace = workspace_of(window)
    workspace.view.select((0,))
    window.actions_by_id["show_smooth"].trigger()
    for method, remedy in (
        ("butterworth", "cut-off"),
        ("savgol", "window"),
        ("gcv", "cut-off"),
        ("kalman-smoother", "noise"),
    ):
        choose(workspace, method)
        looked(workspace, qtbot)
        assert "Next to nothing was found to smooth" in notes(workspace)
        assert f"give a {remedy}" in notes(workspace) or f"give the measurement {remedy}" in notes(
            workspace
        )
    workspace.smooth.apply()
    assert "Next to nothing was found to smooth in 1 of them." in said(window)


def test_a_cutoff_that_was_given_is_no_failure_to_find_one(workspace: Workspace) -> None:
    (done,) = workspace.view.smoothing
    rate = workspace.document.original.rate
    params = SMOOTHERS["butterworth"].params
    assert not found_nothing(done, params(cutoff_hz=59.0), rate)
    assert found_nothing(done, params(), rate) == (min(done.chosen["cutoff_hz"]) >= 0.325 * rate)


# --- applying and taking off ---------------------------------------------------------------------


def test_keys_smooth_and_take_off(window: MainWindow, workspace: Workspace, qtbot: QtBot) -> None:
    document, before = workspace.document, workspace.document.points.copy()
    QTest.keyClick(window, Qt.Key.Key_M, CTRL)
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == f"smooth {document.names[MARKER]} (butterworth)"
    assert (document.state[:, MARKER] == SampleState.SMOOTHED).any()
    assert "Markers smoothed: 1; samples moved by" in said(window)
    QTest.keyClick(window, Qt.Key.Key_M, CTRL | SHIFT)
    assert said(window) == "Smoothing taken off: stretches 1."
    assert document.undo_stack.undoText() == f"take smoothing off {document.names[MARKER]}"
    np.testing.assert_array_equal(document.points, before)
    assert not document.smoothed
    document.undo_stack.undo()
    assert document.smoothed
    document.undo_stack.undo()
    np.testing.assert_array_equal(document.points, before)
    QTest.keyClick(window, Qt.Key.Key_M, CTRL | SHIFT)
    assert said(window) == "There is no smoothing here."


def test_all_markers_are_smoothed_in_one_step(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    document = workspace.document
    workspace.smooth.markers.setCurrentIndex(1)
    workspace.smooth.apply()
    assert workspace.smoothing.job is not None
    workspace.smooth.apply()
    assert said(window) == "Smoothing is still going on."
    qtbot.waitUntil(lambda: workspace.smoothing.job is None)
    assert document.undo_stack.count() == 1
    assert {run.marker for run in document.smoothed} == set(range(document.original.markers))
    assert "Markers smoothed: 41" in said(window)
    workspace.smooth.take_off()
    assert not document.smoothed
    assert document.undo_stack.count() == 2


def test_cancelling_smooths_nothing(window: MainWindow, workspace: Workspace, qtbot: QtBot) -> None:
    workspace.smooth.markers.setCurrentIndex(1)
    workspace.smooth.apply()
    assert workspace.smoothing.job is not None
    workspace.smoothing.job.cancel()
    qtbot.waitUntil(lambda: workspace.smoothing.job is None)
    assert workspace.document.undo_stack.count() == 0
    assert said(window) == "Cancelled: nothing was smoothed."


def test_what_was_computed_before_an_edit_is_not_applied(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    workspace.smooth.markers.setCurrentIndex(1)
    workspace.smooth.apply()
    workspace.push([Edit.clear(min(workspace.document.gaps), reason="too long")], "leave open")
    workspace.push([Edit.clear(Gap(7, 100, 104))], "clear")
    qtbot.waitUntil(lambda: workspace.smoothing.job is None)
    assert not workspace.document.smoothed
    assert said(window) == "The recording was edited meanwhile: smooth again."


def test_impossible_parameters_are_refused(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    give(workspace, 60.0)
    workspace.smooth.apply()
    qtbot.waitUntil(lambda: bool(window.findChildren(QMessageBox)))
    (box,) = window.findChildren(QMessageBox)
    assert "This cannot be smoothed" in box.text()
    box.close()
    assert workspace.document.undo_stack.count() == 0


def test_nothing_is_smoothed_without_a_marker(window: MainWindow, workspace: Workspace) -> None:
    workspace.view.select(())
    workspace.smooth.apply()
    assert said(window) == "Nothing to smooth: select markers that are seen here."


def test_another_method_takes_the_place_of_the_first(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    workspace.smooth.apply()
    choose(workspace, "savgol")
    looked(workspace, qtbot)
    workspace.smooth.apply()
    (made,) = workspace.document.smoothed.values()
    assert made.method == "savgol"
    assert "taken off" not in said(window), "it was replaced"


def test_a_step_beneath_says_that_it_takes_smoothing_off(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    gap = min(HOLES.values())
    workspace.view.select((gap.marker,))
    looked(workspace, qtbot)
    workspace.smooth.apply()
    assert workspace.document.smoothed
    workspace.view.go_to(gap)
    qtbot.waitUntil(lambda: workspace.view.preview is not None)
    workspace.gap_actions.apply()
    assert not workspace.document.smoothed
    qtbot.waitUntil(lambda: "was taken off, stretches: 1" in said(window))
    workspace.document.undo_stack.undo()
    assert workspace.document.smoothed
    workspace.gap_actions.leave_open()
    qtbot.waitUntil(lambda: "was taken off" in said(window))


def test_a_file_that_came_smoothed_cannot_be_unsmoothed(
    window: MainWindow, workspace: Workspace, open_in: Open, tmp_path: Path, qtbot: QtBot
) -> None:
    workspace.smooth.apply()
    window.files.export(tmp_path / "out.c3d")
    qtbot.waitUntil(lambda: not window.files.writing)
    again = workspace_of(open_in(tmp_path / "out.c3d"))
    again.view.select((MARKER,))
    again.smooth.take_off()
    assert "came smoothed" in said(window)
    assert "is smoothed" in notes(again)


# --- never silent --------------------------------------------------------------------------------


def test_smoothing_is_seen_and_told_everywhere(
    window: MainWindow, workspace: Workspace, qtbot: QtBot
) -> None:
    document, lane = workspace.document, workspace.timeline
    plain = workspace.trajectories.grab().toImage()
    give(workspace, 6.0)
    looked(workspace, qtbot)
    workspace.smooth.apply()
    looked(workspace, qtbot)
    assert workspace.trajectories.grab().toImage() != plain
    name = document.names[MARKER]
    assert f"{name} is smoothed" in notes(workspace)
    assert "Butterworth, zero lag, 6.0 Hz" in notes(workspace)
    model = workspace.markers._model
    tip = model.data(model.index(MARKER, 0), Qt.ItemDataRole.ToolTipRole)
    assert "samples smoothed: Butterworth, zero lag, moved by" in tip
    top = lane.lane_top(MARKER)
    assert "smoothed, frames" in lane.tip_at(QPoint(lane.viewport().width() // 2, top + 2))
    about = workspace.facts.about()
    (row,) = about.put_right.smoothed
    assert (row.run.marker, row.cutoffs_hz, row.automatic) == (MARKER, (6.0, 6.0, 6.0), False)
    workspace.show_pane(workspace.report)
    workspace.report.tabs.setCurrentIndex(2)
    qtbot.waitUntil(lambda: workspace.report.report is not None and workspace.report.up_to_date)
    report = workspace.report.report
    assert report is not None
    paragraph = describe(report, about).paragraph
    assert f"1 marker ({document.labels[MARKER]}) was smoothed" in paragraph
    assert "zero-lag Butterworth low-pass filter (method “butterworth”)" in paragraph
    assert "The cut-off frequency was 6.0 Hz." in paragraph
    table = workspace.report.pages.findChild(type(workspace.markers.table))
    assert table is not None
    assert workspace.facts.edits()[0].filled == 0


# --- recipes -------------------------------------------------------------------------------------


def test_a_recipe_smooths_again_as_the_command_does(
    window: MainWindow,
    workspace: Workspace,
    open_in: Open,
    holed_walk: Path,
    tmp_path: Path,
    qtbot: QtBot,
) -> None:
    recipe, out = tmp_path / "recipe.json", tmp_path / "out.c3d"
    arguments = ["repair", str(holed_walk), "-o", str(out), "--method", "linear", "--max-gap", "40"]
    assert main([*arguments, "--smooth", "savgol", "--recipe", str(recipe)]) == 0
    window.proofs.replay(recipe)
    document = workspace.document
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2)
    assert document.undo_stack.undoText() == "replay the smoothing of recipe.json"
    assert "Stretches smoothed again: 41." in said(window)
    wanted = read_c3d(out).recording.points
    np.testing.assert_allclose(document.points, wanted, atol=1e-3)
    document.undo_stack.undo()
    assert not document.smoothed
    assert document.repairs


def test_a_recipe_with_corrections_smooths_at_last(
    open_in: Open, spoilt_walk: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    recipe, out = tmp_path / "recipe.json", tmp_path / "out.c3d"
    arguments = ["repair", str(spoilt_walk), "-o", str(out), "--method", "linear"]
    arguments += ["--max-gap", "40", "--fix", "spikes,swaps", "--smooth", "savgol"]
    assert main([*arguments, "--recipe", str(recipe)]) == 0
    window = open_in(spoilt_walk)
    document = workspace_of(window).document
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: bool(document.smoothed))
    assert document.doubts
    assert document.repairs
    wanted = read_c3d(out).recording.points
    np.testing.assert_allclose(document.points, wanted, atol=1e-3)
    pane = workspace_of(window).report
    qtbot.waitUntil(lambda: pane.report is not None)
    assert pane.report is not None
    paragraph = describe(pane.report, workspace_of(window).facts.about()).paragraph
    assert "by the detector “spikes”" in paragraph
    assert "100 samples of 2 markers were exchanged" in paragraph
    assert "41 markers were smoothed" in paragraph


# --- the scope -----------------------------------------------------------------------------------


def test_markers_that_are_not_seen_are_left_out() -> None:
    states = np.full((20, 3), SampleState.MEASURED, np.uint8)
    states[:10, 1] = SampleState.MISSING
    states[:, 2] = SampleState.BAD
    assert runs_of(states, (2, 1, 0), None) == [Gap(0, 0, 20), Gap(1, 0, 20)]
    assert runs_of(states, (0, 1), (0, 10)) == [Gap(0, 0, 10)]
