"""The main job in the window, by keyboard and by mouse, on a real recording."""

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QFileDialog, QMessageBox, QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend.cli import main
from mocapmend.files import check_files, read_c3d
from mocapmend.settings import MAX_GAP_MS, RECENT_FILES, Settings
from mocapmend.state import SampleState
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

Open = Callable[[Path], MainWindow]


@pytest.fixture
def opened(open_in: Open, sprint: Path) -> MainWindow:
    """Return the window with the sprint recording."""
    return open_in(sprint)


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def wait_for_preview(qtbot: QtBot, workspace: Workspace) -> None:
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)


def choose_cubic(workspace: Workspace) -> None:
    """Choose a method that fills all gaps in a moment, up to 24 frames."""
    repair = workspace.repair
    repair._method.setCurrentIndex(repair._method.findData("cubic"))
    repair.limits._limit_gap.setChecked(True)
    assert repair.limits.max_gap() == 24


def close_pair(workspace: Workspace) -> tuple[Gap, Gap]:
    """Return two short gaps of a marker with a few samples between them."""
    return next(
        (one, other)
        for one, other in pairwise(workspace.document.gaps)
        if one.marker == other.marker
        and one.start > 0
        and other.start - one.stop < 5
        and one.length + other.length < 20
    )


def test_the_whole_job_by_keyboard(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path, sprint: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace = workspace_of(opened)
    document, view = workspace.document, workspace.view
    first = view.gap
    assert first is not None
    assert first.kind(view.frames) == "interior"
    wait_for_preview(qtbot, workspace)
    before = document.points.copy()

    qtbot.keyClick(opened, Qt.Key.Key_N)
    gap = view.gap
    assert gap is not None
    assert gap != first
    assert gap.start <= view.frame < gap.stop
    assert view.marker == gap.marker
    wait_for_preview(qtbot, workspace)
    qtbot.keyClick(opened, Qt.Key.Key_P)
    assert view.gap == first
    wait_for_preview(qtbot, workspace)
    assert document.points.tobytes() == before.tobytes(), "a preview changes nothing"

    method = workspace.repair.method()[0]
    qtbot.keyClick(opened, Qt.Key.Key_M)
    assert workspace.repair.method()[0] != method
    qtbot.waitUntil(
        lambda: view.preview is not None and view.preview.method == workspace.repair.method()[0],
        timeout=20_000,
    )
    qtbot.keyClick(opened, Qt.Key.Key_Return)
    assert first in document.repairs
    assert opened.isWindowModified()
    assert np.isfinite(document.points[first.start : first.stop, first.marker]).all()

    qtbot.keyClick(opened, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert document.points.tobytes() == before.tobytes()
    assert not opened.isWindowModified()
    qtbot.keyClick(
        opened,
        Qt.Key.Key_Z,
        Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
    )
    assert first in document.repairs

    out = tmp_path / "repaired.c3d"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), ""))
    qtbot.keyClick(opened, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: not opened.isWindowModified(), timeout=20_000)
    report = check_files(sprint, out)
    assert report.passed
    assert report.changed_samples == first.length
    repaired = read_c3d(out).recording.points
    assert np.allclose(repaired, document.points, atol=1e-3, equal_nan=True)


def test_a_preview_beyond_the_limit_says_so(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    wait_for_preview(qtbot, workspace)
    assert "Above the limit" not in workspace.repair._promise.text()
    gaps = [g for g in workspace.document.gaps if g.kind(workspace.view.frames) == "interior"]
    workspace.view.go_to(max(gaps, key=lambda gap: gap.length))
    wait_for_preview(qtbot, workspace)
    assert "Above the limit of 20 mm" in workspace.repair._promise.text()
    workspace.repair.limits._limit_error.setChecked(False)
    assert "Above the limit" not in workspace.repair._promise.text()


def test_fill_all_is_one_undoable_step(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    before = document.points.copy()
    gaps = document.gaps
    choose_cubic(workspace)
    qtbot.keyClick(opened, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 1, timeout=20_000)
    filled = set(gaps) - set(document.gaps)
    assert filled
    assert all(gap.length <= 24 for gap in filled)
    assert all(gap in document.repairs for gap in filled)
    qtbot.waitUntil(lambda: not workspace.repair.left_open.visibleRegion().isEmpty())
    qtbot.mouseClick(workspace.repair.left_open, Qt.MouseButton.LeftButton)
    longer = [gap for gap in gaps if gap not in filled and gap.length < document.original.frames]
    table = next(
        table for table in workspace.findChildren(QTableWidget) if table.rowCount() == len(longer)
    )
    table.activated.emit(table.model().index(3, 0))
    assert workspace.view.gap == longer[3]
    table.window().close()
    document.undo_stack.undo()
    assert document.points.tobytes() == before.tobytes()
    assert document.undo_stack.count() == 1


def test_window_and_command_line_write_the_same_bytes(
    opened: MainWindow, qtbot: QtBot, sprint: Path, tmp_path: Path
) -> None:
    workspace = workspace_of(opened)
    choose_cubic(workspace)
    # One of two gaps that are close: if the second leant on the first, the bytes would differ.
    workspace.view.go_to(close_pair(workspace)[0])
    wait_for_preview(qtbot, workspace)
    workspace.gap_actions.apply()
    workspace.fill_all()
    qtbot.waitUntil(lambda: workspace.document.undo_stack.count() == 2, timeout=20_000)
    by_window, by_command = tmp_path / "window.c3d", tmp_path / "command.c3d"
    opened.files.export(by_window)
    qtbot.waitUntil(lambda: not opened.isWindowModified(), timeout=20_000)
    limits = ["--method", "cubic", "--max-gap", "24", "--max-error", "20"]
    assert main(["repair", str(sprint), "-o", str(by_command), *limits]) == 0
    assert by_window.read_bytes() == by_command.read_bytes()


def test_a_preview_never_leans_on_other_fills(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    view = workspace.view
    close = close_pair(workspace)
    view.go_to(close[1])
    wait_for_preview(qtbot, workspace)
    alone = view.preview
    view.go_to(close[0])
    wait_for_preview(qtbot, workspace)
    workspace.gap_actions.apply()
    view.go_to(close[1])
    wait_for_preview(qtbot, workspace)
    again = view.preview
    assert alone is not None
    assert again is not None
    assert alone.patch is not None
    assert again.patch is not None
    assert again.patch.values.tobytes() == alone.patch.values.tobytes()
    assert again.patch.sigma.tobytes() == alone.patch.sigma.tobytes()


def test_filling_all_leaves_what_was_repaired_meanwhile(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document, gap = workspace.document, workspace.view.gap
    choose_cubic(workspace)
    wait_for_preview(qtbot, workspace)
    workspace.fill_all()
    workspace.gap_actions.apply()
    assert list(document.repairs) == [gap]
    own = document.repairs[gap]
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2, timeout=20_000)
    assert len(document.repairs) > 100
    assert document.repairs[gap] is own
    document.undo_stack.undo()
    assert list(document.repairs) == [gap]


def test_only_the_last_choice_is_previewed(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    wait_for_preview(qtbot, workspace)
    seen: list[str] = []
    workspace.view.preview_changed.connect(lambda p: seen.append(p.method) if p else None)
    for _ in range(4):
        workspace.repair.step_method(1)
        workspace.previewer._timer.stop()
        workspace.previewer._compute_next()
    last = workspace.repair.method()[0]
    qtbot.waitUntil(lambda: opened.jobs.running == 0, timeout=20_000)
    assert seen == [last]


def test_edits_during_an_export_stay_unsaved(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    workspace = workspace_of(opened)
    wait_for_preview(qtbot, workspace)
    opened.files.export(tmp_path / "early.c3d")
    workspace.gap_actions.apply()
    qtbot.waitUntil(lambda: not opened.files.writing, timeout=20_000)
    assert opened.isWindowModified()


def test_closing_waits_for_the_file_that_is_written(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    out = tmp_path / "out.c3d"
    opened.files.export(out)
    opened.close()
    assert opened.isVisible()
    qtbot.waitUntil(lambda: not opened.isVisible(), timeout=20_000)
    assert out.exists()


def test_opening_a_file_does_not_change_the_remembered_limit(
    open_in: Open, sprint: Path, gait: Path, settings: Settings
) -> None:
    settings.set(MAX_GAP_MS, 155.0)
    window = open_in(sprint)
    assert workspace_of(window).repair.limits.max_gap() == 18
    window = open_in(gait)
    assert workspace_of(window).repair.limits.max_gap() == 15
    assert settings.get(MAX_GAP_MS) == 155.0
    workspace_of(window).repair.limits._max_gap.setValue(30)
    assert settings.get(MAX_GAP_MS) == 300.0


def test_the_limit_is_shown_in_ms_too(opened: MainWindow) -> None:
    spin = workspace_of(opened).repair.limits._max_gap
    spin.setValue(33)
    assert spin.text() == "≤ 33 frames (275 ms)"


def test_a_click_on_the_timeline_scrubs_and_selects(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    timeline, view = workspace.timeline, workspace.view
    gap = next(g for g in workspace.document.gaps if 10 < g.length < 100 and g.marker > 3)
    y = timeline.lane_top(gap.marker) + 2
    x = round(timeline.axis.x_of((gap.start + gap.stop) / 2))
    qtbot.mouseClick(timeline.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(x, y))
    assert view.marker == gap.marker
    assert view.gap == gap
    assert gap.start <= view.frame < gap.stop


def test_dragging_on_the_timeline_scrubs(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    viewport, left = workspace.timeline.viewport(), workspace.timeline.axis.left
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=QPoint(left + 5, 10))
    qtbot.mouseMove(viewport, QPoint(left + 200, 10))
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=QPoint(left + 200, 10))
    assert workspace.view.frame == int(workspace.timeline.axis.frame_at(left + 200))


def test_a_click_in_3d_picks_the_marker_under_it(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    scene, view = workspace.scene, workspace.view
    pixels = scene._project(scene._current_points())
    alone = next(
        marker
        for marker in range(len(pixels))
        if np.isfinite(pixels[marker, 0])
        and scene.rect().adjusted(20, 20, -20, -20).contains(QPointF(*pixels[marker]).toPoint())
        and np.nanmin(np.hypot(*(np.delete(pixels, marker, axis=0) - pixels[marker]).T)) > 6
    )
    place = QPointF(*pixels[alone]).toPoint()
    qtbot.mouseClick(scene, Qt.MouseButton.LeftButton, pos=place)
    assert view.selection == (alone,)
    corner = QPoint(scene.width() - 2, 2)
    qtbot.mouseClick(scene, Qt.MouseButton.LeftButton, pos=corner)
    assert view.selection == ()


def test_selecting_in_the_list_selects_everywhere(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.show_pane(workspace.markers)
    table = workspace.markers.table
    row = table.visualRect(table.model().index(5, 0)).center()
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=row)
    assert workspace.view.selection == (5,)
    workspace.view.select((7,))
    rows = workspace.markers.table.selectionModel().selectedRows()
    assert [row.row() for row in rows] == [7]
    assert len(workspace.trajectories.lanes()) == 3


def test_playing_reaches_the_end_and_stops(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.player.set_speed(4.0)
    workspace.view.set_frame(workspace.view.frames - 60)
    qtbot.keyClick(opened, Qt.Key.Key_Space)
    assert workspace.player.playing
    qtbot.waitUntil(lambda: not workspace.player.playing, timeout=20_000)
    assert workspace.view.frame == workspace.view.frames - 1


def test_the_report_shows_before_and_after(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    pane = workspace.report
    qtbot.waitUntil(lambda: pane.report is not None, timeout=20_000)
    first = pane.report
    assert first is not None
    assert np.array_equal(first.success_before.instantaneous, first.success_after.instantaneous)
    choose_cubic(workspace)
    workspace.fill_all()
    qtbot.waitUntil(lambda: pane.report is not first and pane.report is not None, timeout=20_000)
    second = pane.report
    assert second is not None
    assert second.success_after.running_mean[-1] > second.success_before.running_mean[-1]
    # What is out of sight is drawn when it is seen.
    workspace.show_pane(pane)
    pane.tabs.setCurrentIndex(1)
    qtbot.waitUntil(lambda: pane.pages.bones.table.rowCount() == len(second.bones))


def test_a_repair_can_be_turned_back_into_a_gap(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    gap = workspace.view.gap
    assert gap is not None
    wait_for_preview(qtbot, workspace)
    qtbot.keyClick(opened, Qt.Key.Key_Return)
    assert gap not in workspace.document.gaps
    qtbot.keyClick(opened, Qt.Key.Key_Delete)
    assert gap in workspace.document.gaps
    assert workspace.document.undo_stack.count() == 2


def test_a_closed_pane_comes_back(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    qtbot.waitUntil(lambda: workspace.arranged)
    markers, repair = workspace.panes()[:2]
    markers.close()
    repair.setFloating(True)
    opened.menus.panes.aboutToShow.emit()
    listed = {action.text(): action for action in opened.menus.panes.actions()}
    assert not listed["Markers"].isChecked()
    listed["Markers"].trigger()
    assert markers.isVisible()
    markers.close()
    listed["Arrange as at first"].trigger()
    assert markers.isVisible()
    assert not repair.isFloating()


def test_the_layout_is_remembered(open_in: Open, qtbot: QtBot, sprint: Path, gait: Path) -> None:
    window = open_in(sprint)
    qtbot.waitUntil(lambda: workspace_of(window).arranged)
    workspace_of(window).panes()[0].close()
    window = open_in(gait)
    qtbot.waitUntil(lambda: workspace_of(window).arranged)
    assert not workspace_of(window).panes()[0].isVisible()


def test_a_dropped_file_is_opened(window: MainWindow, qtbot: QtBot, sprint: Path) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(sprint))])
    window.dropEvent(
        QDropEvent(
            QPointF(10, 10),
            Qt.DropAction.CopyAction,
            data,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
    )
    qtbot.waitUntil(lambda: window.workspace is not None, timeout=20_000)
    assert str(sprint.resolve()) in window.settings.get(RECENT_FILES)


def test_unsaved_repairs_are_guarded(
    opened: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace = workspace_of(opened)
    wait_for_preview(qtbot, workspace)
    workspace.gap_actions.apply()
    asked: list[str] = []

    def answer(*_args: object) -> QMessageBox.StandardButton:
        asked.append("asked")
        return QMessageBox.StandardButton.Cancel

    monkeypatch.setattr(QMessageBox, "question", answer)
    opened.close()
    assert asked == ["asked"]
    assert opened.isVisible()
    opened.files.close()
    assert opened.workspace is workspace


def test_the_original_is_replaced_only_after_a_yes(
    open_in: Open, qtbot: QtBot, sprint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    copy = tmp_path / "copy.c3d"
    copy.write_bytes(sprint.read_bytes())
    window = open_in(copy)
    workspace = workspace_of(window)
    wait_for_preview(qtbot, workspace)
    workspace.gap_actions.apply()
    monkeypatch.setattr(window.files, "_confirm", lambda *_: False)
    window.files.export(copy)
    assert copy.read_bytes() == sprint.read_bytes()
    monkeypatch.setattr(window.files, "_confirm", lambda *_: True)
    window.files.export(copy)
    qtbot.waitUntil(lambda: window.workspace is not workspace, timeout=20_000)
    assert check_files(sprint, copy).passed
    assert copy.read_bytes() != sprint.read_bytes()


def test_a_filled_sample_is_told_from_a_measured_one(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    gap = workspace.view.gap
    assert gap is not None
    wait_for_preview(qtbot, workspace)
    workspace.gap_actions.apply()
    inside = workspace.document.state[gap.start : gap.stop, gap.marker]
    assert (inside == SampleState.FILLED).all()
    assert len(workspace.document.runs(gap.marker, SampleState.FILLED)) == 1
