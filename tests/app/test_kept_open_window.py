"""Gaps that the user keeps open, from the window to the file and back."""

from collections.abc import Callable
from pathlib import Path

import pytest
from holes import HOLES
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend import engine, unsaved
from mocapmend.cli import main
from mocapmend.files import check_files, read_c3d
from mocapmend.files.records import LEFT_OPEN, NEVER_FILLED
from mocapmend.ranking import Status
from mocapmend.state import SampleState
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap, no_progress

Open = Callable[[Path], MainWindow]
SHIFT = Qt.KeyboardModifier.ShiftModifier
NEVER, LEFT, OTHER = HOLES["interior"], HOLES["trailing"], HOLES["leading"]


@pytest.fixture
def walk(holed_walk: Path, tmp_path: Path) -> Path:
    """Return a copy of the walk with gaps in a folder of its own."""
    path = tmp_path / "walk.c3d"
    path.write_bytes(holed_walk.read_bytes())
    return path


@pytest.fixture
def marked(walk: Path, tmp_path: Path) -> Path:
    """Return the walk with a gap that is never to be filled, and another one left open."""
    source = read_c3d(walk)
    kept = (
        engine.kept_gap(source, NEVER, never=True, reason="the marker fell off"),
        engine.kept_gap(source, LEFT, never=False, reason=LEFT_OPEN),
    )
    out = tmp_path / "marked.c3d"
    engine.export(source, engine.Changes((), (), kept), out, False, False, no_progress)
    return out


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def press_x(window: MainWindow, gap: Gap, qtbot: QtBot, *modifiers: Qt.KeyboardModifier) -> None:
    workspace_of(window).view.go_to(gap)
    qtbot.keyClick(window, Qt.Key.Key_X, *modifiers)


def export(window: MainWindow, out: Path, qtbot: QtBot) -> Path:
    window.files.export(out)
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    return out


def test_from_the_window_to_the_file_and_back(
    open_in: Open, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(walk)
    press_x(window, NEVER, qtbot, SHIFT)
    press_x(window, LEFT, qtbot)
    out = export(window, tmp_path / "out.c3d", qtbot)
    assert not window.isWindowModified()
    assert check_files(walk, out).passed
    source = read_c3d(out)
    assert source.repairs == ()
    assert {gap: kept.reason for gap, kept in source.kept_open.items()} == {
        NEVER: NEVER_FILLED,
        LEFT: LEFT_OPEN,
    }

    workspace = workspace_of(open_in(out))
    document = workspace.document
    assert document.never == [NEVER]
    assert document.set_aside == {LEFT: LEFT_OPEN}
    assert (document.state[NEVER.start : NEVER.stop, NEVER.marker] == SampleState.NEVER).all()
    assert document.gaps == [OTHER, LEFT]
    assert not window.isWindowModified()
    problems = workspace.queue.model._list
    assert dict(zip(problems.gaps, map(Status, problems.status), strict=True)) == {
        OTHER: Status.OPEN,
        LEFT: Status.LEFT,
        NEVER: Status.NEVER,
    }
    assert [(entry.gap, entry.reason) for entry in workspace.report_inputs()[4]] == [
        (LEFT, LEFT_OPEN),
        (NEVER, NEVER_FILLED),
    ]


def test_an_export_without_edits_is_the_same_file(
    open_in: Open, marked: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(marked)
    assert export(window, tmp_path / "copy.c3d", qtbot).read_bytes() == marked.read_bytes()
    assert workspace_of(window).document.never_reason(NEVER) == "the marker fell off"


def test_they_are_taken_off_undone_and_exported_again(
    open_in: Open, marked: Path, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(marked)
    document = workspace_of(window).document
    press_x(window, NEVER, qtbot, SHIFT)
    press_x(window, LEFT, qtbot)
    assert document.gaps == [OTHER, NEVER, LEFT]
    assert window.isWindowModified()
    freed = export(window, tmp_path / "freed.c3d", qtbot)
    assert freed.read_bytes() == walk.read_bytes(), "there is nothing to record"
    document.undo_stack.undo()
    assert document.set_aside == {LEFT: LEFT_OPEN}
    document.undo_stack.undo()
    assert document.never == [NEVER]
    again = export(window, tmp_path / "again.c3d", qtbot)
    assert again.read_bytes() == marked.read_bytes()


def test_the_ends_of_a_protected_gap_that_cover_measured_samples_are_not_recorded(
    open_in: Open, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(walk)
    workspace_of(window).view.go_to(NEVER)
    qtbot.keyClick(window, Qt.Key.Key_W)
    wide = workspace_of(window).view.gap
    assert wide is not None
    assert wide.length == NEVER.length + 2
    qtbot.keyClick(window, Qt.Key.Key_X, SHIFT)
    assert workspace_of(window).document.never == [wide]
    source = read_c3d(export(window, tmp_path / "out.c3d", qtbot))
    assert list(source.kept_open) == [NEVER]
    assert source.recording.points.tobytes() == read_c3d(walk).recording.points.tobytes()


def test_the_plan_and_what_comes_of_it_count_them(
    open_in: Open, marked: Path, qtbot: QtBot
) -> None:
    workspace = workspace_of(open_in(marked))
    workspace.repair._method.setCurrentIndex(workspace.repair._method.findData("pca-r2"))
    workspace.repair.limits._limit_error.setChecked(False)
    workspace.show_plan()
    summary, model = workspace.plan.summary, workspace.plan.model
    qtbot.waitUntil(lambda: "2 would be filled" in summary.text(), timeout=20_000)
    assert "1 would stay open" in summary.text()
    listed = {model.gap(row): model.index(row, 4).data() for row in range(model.rowCount())}
    assert listed == {
        NEVER: "○ stays open: the marker fell off",
        LEFT: "✔ filled",
        OTHER: "✔ filled",
    }
    with qtbot.waitSignal(workspace.filling.done, timeout=20_000) as done:
        workspace.fill_all()
    assert done.args == [2, 1]
    assert NEVER not in workspace.document.left_open
    workspace._show_left_open()
    dialog = workspace.findChild(QDialog)
    assert dialog is not None
    table = dialog.findChild(QTableWidget)
    assert table is not None
    assert [table.item(row, 2).text() for row in range(table.rowCount())] == ["the marker fell off"]


def test_a_recipe_of_the_window_gives_the_same_bytes_headless_and_in_the_window(
    open_in: Open, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(walk)
    press_x(window, NEVER, qtbot, SHIFT)
    press_x(window, LEFT, qtbot)
    first = export(window, tmp_path / "first.c3d", qtbot)
    recipe, second = tmp_path / "recipe.json", tmp_path / "second.c3d"
    document = workspace_of(window).document
    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    assert main(["replay", str(recipe), str(walk), "-o", str(second)]) == 0
    assert second.read_bytes() == first.read_bytes()

    document.undo_stack.setIndex(0)
    assert document.set_aside == {}
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 1, timeout=20_000)
    assert document.never == [NEVER]
    assert document.set_aside == {LEFT: LEFT_OPEN}
    assert window.statusBar().currentMessage() == "2 edits made again."
    third = export(window, tmp_path / "third.c3d", qtbot)
    assert third.read_bytes() == first.read_bytes()
    document.undo_stack.undo()
    assert NEVER in document.gaps
    assert document.set_aside == {}, "one step did both"


def test_a_recipe_frees_what_the_file_protects(
    open_in: Open, marked: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(marked)
    document = workspace_of(window).document
    press_x(window, NEVER, qtbot, SHIFT)
    press_x(window, LEFT, qtbot)
    recipe = tmp_path / "recipe.json"
    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    document.undo_stack.setIndex(0)
    assert document.set_aside == {LEFT: LEFT_OPEN}
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 1, timeout=20_000)
    assert document.never == []
    assert document.set_aside == {}
    document.undo_stack.undo()
    assert document.never == [NEVER]
    assert document.set_aside == {LEFT: LEFT_OPEN}


def test_a_replay_leaves_alone_what_the_user_protects(
    open_in: Open, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    out, recipe = tmp_path / "out.c3d", tmp_path / "recipe.json"
    words = ["--method", "linear", "--max-error", "inf", "--recipe", str(recipe)]
    assert main(["repair", str(walk), "-o", str(out), *words]) == 0
    window = open_in(walk)
    document = workspace_of(window).document
    press_x(window, NEVER, qtbot, SHIFT)
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: "recipe" in window.statusBar().currentMessage(), timeout=20_000)
    assert document.never == [NEVER]
    assert NEVER not in document.repairs
