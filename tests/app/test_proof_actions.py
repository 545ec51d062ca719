"""Recipes and checks in the window."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFileDialog, QLabel, QMessageBox, QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend.files.sidecar import sidecar_path
from mocapmend.views.action_button import ActionButton
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

Open = Callable[[Path], MainWindow]
CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def copy(tmp_path: Path, gait: Path) -> Path:
    """Return a copy of the gait recording in a folder of its own."""
    path = tmp_path / "walk.c3d"
    path.write_bytes(gait.read_bytes())
    return path


@pytest.fixture
def choose(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """Choose what the dialogs propose; note where they begin."""
    begun: list[str] = []

    def agree(_parent: object, _title: str, start: str, *_: str) -> tuple[str, str]:
        begun.append(start)
        return start, ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", agree)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", agree)
    yield begun


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def quiet(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: window.jobs.running == 0, timeout=20_000)


def act(window: MainWindow, name: str, qtbot: QtBot) -> None:
    window.actions_by_id[name].trigger()
    quiet(window, qtbot)


def fill(window: MainWindow, method: str, longest: int, qtbot: QtBot) -> None:
    workspace = workspace_of(window)
    repair, before = workspace.repair, workspace.document.undo_stack.count()
    repair._method.setCurrentIndex(repair._method.findData(method))
    repair.limits._limit_gap.setChecked(True)
    repair.limits._max_gap.setValue(longest)
    workspace.fill_all()
    qtbot.waitUntil(lambda: workspace.document.undo_stack.count() > before, timeout=20_000)


def revert(window: MainWindow, number: int) -> None:
    workspace = workspace_of(window)
    workspace.view.go_to(sorted(workspace.document.repairs)[number])
    workspace.gap_actions.reopen()


def error_in(window: MainWindow, qtbot: QtBot) -> str:
    def boxes() -> list[QMessageBox]:
        return [box for box in window.findChildren(QMessageBox) if box.isVisible()]

    qtbot.waitUntil(lambda: len(boxes()) == 1, timeout=20_000)
    (box,) = boxes()
    box.close()
    return f"{box.text()} {box.informativeText()}"


def check_of(window: MainWindow, qtbot: QtBot) -> tuple[str, list[tuple[str, ...]]]:
    """Wait for the dialog of a check; return its text and its rows, and close it."""

    def shown() -> list[QDialog]:
        return [
            each
            for each in window.findChildren(QDialog)
            if each.isVisible() and each.windowTitle().startswith("Check of")
        ]

    qtbot.waitUntil(lambda: len(shown()) == 1, timeout=20_000)
    (dialog,) = shown()
    table = dialog.findChild(QTableWidget)
    rows = [
        tuple(table.item(row, column).text() for column in range(4))
        for row in range(table.rowCount())
    ]
    text = dialog.findChild(QLabel).text()
    dialog.close()
    return text, rows


def export(window: MainWindow, out: Path, qtbot: QtBot) -> Path:
    window.files.export(out)
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    assert not window.isWindowModified()
    return out


def edit(window: MainWindow, qtbot: QtBot) -> None:
    """Fill by two methods; revert one of these repairs."""
    fill(window, "linear", 3, qtbot)
    fill(window, "pchip", 12, qtbot)
    revert(window, 2)


# --- recipes ---------------------------------------------------------------------------------


def test_a_recipe_makes_the_same_file_again(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    edit(window, qtbot)
    act(window, "save_recipe", qtbot)
    recipe = tmp_path / "walk_recipe.json"
    assert window.statusBar().currentMessage() == f"Recipe written to {recipe}"
    first = export(window, tmp_path / "first.c3d", qtbot)
    repairs = len(workspace_of(window).document.repairs)

    window.files.close()
    window = open_in(copy)
    document = workspace_of(window).document
    act(window, "replay_recipe", qtbot)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 1)
    assert choose == [str(recipe), str(recipe)]
    assert window.statusBar().currentMessage() == f"{repairs} edits made again."
    second = export(window, tmp_path / "second.c3d", qtbot)
    assert second.read_bytes() == first.read_bytes()
    assert main(["replay", str(recipe), str(copy), "-o", str(tmp_path / "third.c3d")]) == 0
    assert (tmp_path / "third.c3d").read_bytes() == first.read_bytes()
    document.undo_stack.undo()
    assert document.points.tobytes() == document.original.points.tobytes()
    assert document.repairs == {}


@pytest.mark.parametrize("name", ["repaired_gait", "repaired_sprint"])
def test_a_recipe_for_a_repaired_file_reverts_too(
    open_in: Open, name: str, qtbot: QtBot, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    path: Path = request.getfixturevalue(name)
    recipe = tmp_path / "recipe.json"
    window = open_in(path)
    revert(window, 5)
    revert(window, 7)
    workspace = workspace_of(window)
    fill(window, "pchip", 40, qtbot)
    revert(window, 9)
    window.files.ask_where = lambda *_: recipe  # type: ignore[method-assign]
    act(window, "save_recipe", qtbot)
    first = export(window, tmp_path / "first.c3d", qtbot)
    points = workspace.document.points.copy()

    window.files.close()
    window = open_in(path)
    document = workspace_of(window).document
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 1, timeout=20_000)
    assert document.points.tobytes() == points.tobytes()
    second = export(window, tmp_path / "second.c3d", qtbot)
    assert second.read_bytes() == first.read_bytes()
    assert read_c3d(second).repairs == read_c3d(first).repairs
    places = [sidecar_path(out) for out in (first, second)]
    assert [place.exists() for place in places] == ["sprint" in name] * 2
    if places[0].exists():
        assert places[0].read_bytes() == places[1].read_bytes()


def test_a_recipe_that_does_not_fit_changes_nothing(
    open_in: Open, sprint: Path, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    fill(window, "linear", 3, qtbot)
    act(window, "save_recipe", qtbot)
    workspace_of(window).document.undo_stack.setClean()
    window = open_in(sprint)
    document = workspace_of(window).document
    window.proofs.replay(tmp_path / "walk_recipe.json")
    assert "does not fit this file" in error_in(window, qtbot)
    quiet(window, qtbot)
    assert document.undo_stack.count() == 0
    assert document.points.tobytes() == document.original.points.tobytes()


@pytest.mark.parametrize("raw", [b"", b"\x00\xff", b"[]", b'{"mocapmend_recipe": 1}'])
def test_what_is_no_recipe_is_refused(
    open_in: Open, gait: Path, qtbot: QtBot, tmp_path: Path, raw: bytes
) -> None:
    window = open_in(gait)
    path = tmp_path / "recipe.json"
    path.write_bytes(raw)
    window.proofs.replay(path)
    assert "This is not a recipe" in error_in(window, qtbot)
    window.proofs.replay(tmp_path / "none.json")
    assert "none.json" in error_in(window, qtbot)
    assert workspace_of(window).document.undo_stack.count() == 0


def test_a_recipe_of_another_file_that_fits_is_told(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    edit(window, qtbot)
    act(window, "save_recipe", qtbot)
    workspace_of(window).document.undo_stack.setClean()
    other = tmp_path / "other.c3d"
    raw = bytearray(copy.read_bytes())
    raw[-1] ^= 1
    other.write_bytes(raw)
    window = open_in(other)
    window.proofs.replay(tmp_path / "walk_recipe.json")
    quiet(window, qtbot)
    qtbot.waitUntil(lambda: workspace_of(window).document.undo_stack.count() == 1)
    assert "made for another file" in window.statusBar().currentMessage()


def test_edits_during_a_replay_win(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    edit(window, qtbot)
    act(window, "save_recipe", qtbot)
    stack = workspace_of(window).document.undo_stack
    count = stack.count()
    window.proofs.replay(tmp_path / "walk_recipe.json")
    revert(window, 0)
    quiet(window, qtbot)
    assert stack.count() == count + 1
    assert "edited meanwhile" in window.statusBar().currentMessage()


def test_a_recipe_without_edits_has_nothing_to_do(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot
) -> None:
    window = open_in(copy)
    act(window, "save_recipe", qtbot)
    act(window, "replay_recipe", qtbot)
    assert window.statusBar().currentMessage() == "The recipe has nothing to do here."
    assert not window.isWindowModified()


def test_a_replay_outlives_its_recording(
    open_in: Open, copy: Path, sprint: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    edit(window, qtbot)
    act(window, "save_recipe", qtbot)
    workspace_of(window).document.undo_stack.setClean()
    window.proofs.replay(tmp_path / "walk_recipe.json")
    window.files.close()
    quiet(window, qtbot)
    assert window.workspace is None
    assert not [box for box in window.findChildren(QMessageBox) if box.isVisible()]


# --- checks ----------------------------------------------------------------------------------


def test_the_file_that_was_just_exported_is_proposed_and_passes(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    fill(window, "linear", 3, qtbot)
    (tmp_path / "elsewhere").mkdir()
    out = export(window, tmp_path / "elsewhere" / "fixed.c3d", qtbot)
    document = workspace_of(window).document
    qtbot.keyClick(window, Qt.Key.Key_K, CTRL)
    text, rows = check_of(window, qtbot)
    assert choose == [str(out)]
    assert "✔ Check passed" in text
    assert "These differences are allowed" in text
    assert "parameter" in text
    assert str(copy) in text
    first = document.original.first_frame
    expected = [
        (
            document.original.labels[gap.marker],
            str(gap.start + first),
            str(gap.stop - 1 + first),
            str(gap.length),
        )
        for gap in sorted(document.repairs)
    ]
    assert sorted(rows) == sorted(expected)
    assert f"{sum(gap.length for gap in document.repairs)} marker samples" in text
    assert f"in {len(expected)} runs" in text


def test_a_flipped_byte_fails(open_in: Open, copy: Path, qtbot: QtBot, tmp_path: Path) -> None:
    window = open_in(copy)
    fill(window, "linear", 3, qtbot)
    out = export(window, tmp_path / "fixed.c3d", qtbot)
    raw = bytearray(out.read_bytes())
    raw[-1] ^= 1
    out.write_bytes(raw)
    window.proofs.check(out)
    text, rows = check_of(window, qtbot)
    assert "✘ Check failed" in text
    assert "These are not" in text
    assert rows


def test_a_file_that_is_no_copy_is_told(
    open_in: Open, copy: Path, sprint: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    window.proofs.check(sprint)
    assert "✘" in check_of(window, qtbot)[0]
    window.proofs.check(tmp_path / "none.c3d")
    assert "none.c3d" in error_in(window, qtbot)
    window.proofs.check(copy)
    text, rows = check_of(window, qtbot)
    assert "the same, byte for byte" in text
    assert rows == []


@pytest.mark.parametrize("there", [True, False])
def test_before_an_export_the_likely_copy_is_proposed(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, there: bool
) -> None:
    window = open_in(copy)
    likely = copy.with_name("walk_repaired.c3d")
    if there:
        likely.write_bytes(copy.read_bytes())
    window.actions_by_id["check_copy"].trigger()
    assert choose == [str(likely if there else copy.parent)]
    quiet(window, qtbot)


def test_an_export_that_is_no_copy_is_not_proposed(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    export(window, tmp_path / "walk.trc", qtbot)
    window.actions_by_id["check_copy"].trigger()
    assert choose == [str(tmp_path)]
    assert str(tmp_path) in error_in(window, qtbot), "a folder is chosen, which is no recording"


def test_only_copies_of_c3d_files_can_be_checked(
    open_in: Open, gait: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    out = tmp_path / "gait.trc"
    assert main(["repair", str(gait), "-o", str(out)]) == 0
    window = open_in(out)
    qtbot.keyClick(window, Qt.Key.Key_3, CTRL)
    assert not window.actions_by_id["check_copy"].isEnabled()
    assert not check_button(window, qtbot).isEnabled()
    window = open_in(gait)
    qtbot.keyClick(window, Qt.Key.Key_3, CTRL)
    assert window.actions_by_id["check_copy"].isEnabled()
    assert check_button(window, qtbot).isEnabled()


def check_button(window: MainWindow, qtbot: QtBot) -> ActionButton:
    report = workspace_of(window).report
    qtbot.waitUntil(report.isEnabled)
    return report.findChild(ActionButton)


# --- the proof of the last export ------------------------------------------------------------


def test_the_report_pane_tells_the_proof_of_the_last_export(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    workspace = workspace_of(window)
    shown = workspace.report._proof
    assert shown.text() == "Not exported yet."
    fill(window, "linear", 3, qtbot)
    export(window, tmp_path / "fixed.c3d", qtbot)
    assert shown.text().startswith("✔ fixed.c3d: Check passed:")
    assert "MOCAPMEND" in shown.toolTip(), "the tool tip says where the repair record is"
    fill(window, "pchip", 12, qtbot)
    assert shown.text() == "Edited since fixed.c3d was exported."
    assert shown.toolTip() == ""
    assert workspace.report_inputs()[-1].proof == ()
    workspace.document.undo_stack.undo()
    assert shown.text().startswith("✔ fixed.c3d: Check passed:")
    quiet(window, qtbot)
    act(window, "save_report", qtbot)
    page = (tmp_path / "walk_report.html").read_text("utf-8")
    proof = page[page.index("Check of the written file") :]
    gaps = len(workspace.document.repairs)
    assert f"marker samples in {gaps} runs changed" in proof
    assert "parameter group MOCAPMEND" in proof


def test_edits_during_an_export_are_not_proved(
    open_in: Open, copy: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    workspace = workspace_of(window)
    fill(window, "linear", 3, qtbot)
    window.files.export(tmp_path / "early.c3d")
    revert(window, 0)
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    assert workspace.report._proof.text() == "Edited since early.c3d was exported."
    assert workspace.proofs.last_export == tmp_path / "early.c3d"


# --- corrections -----------------------------------------------------------------------------


def correct(window: MainWindow, qtbot: QtBot) -> None:
    """Exchange two markers for a while, set samples aside, fill what is open then."""
    workspace = workspace_of(window)
    view = workspace.view
    view.select((3, 7))
    view.set_span((40, 90))
    workspace.bad_actions.exchange()
    workspace.bad_actions.exchange()
    view.select((3, 9))
    view.set_span((60, 63))
    workspace.bad_actions.set_aside()
    view.set_span(None)
    fill(window, "linear", 4, qtbot)


def test_a_recipe_with_corrections_makes_them_first(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    correct(window, qtbot)
    act(window, "save_recipe", qtbot)
    recipe = tmp_path / "walk_recipe.json"
    first = export(window, tmp_path / "first.c3d", qtbot)
    window.files.close()
    window = open_in(copy)
    document = workspace_of(window).document
    act(window, "replay_recipe", qtbot)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2)
    assert document.undo_stack.text(0) == f"correct as in {recipe.name}"
    assert document.undo_stack.text(1) == f"replay {recipe.name}"
    second = export(window, tmp_path / "second.c3d", qtbot)
    assert second.read_bytes() == first.read_bytes()
    document.undo_stack.setIndex(0)
    assert document.points.tobytes() == document.original.points.tobytes()
    assert not document.doubts
    assert document.layers.moves == []


def test_its_corrections_replace_those_of_the_user(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(copy)
    correct(window, qtbot)
    wanted = workspace_of(window).document.layers
    act(window, "save_recipe", qtbot)
    workspace = workspace_of(window)
    workspace.document.undo_stack.setIndex(0)
    workspace.view.select((3, 9))
    workspace.view.set_frame(20)
    workspace.bad_actions.exchange()
    workspace.bad_actions.exchange()
    workspace.bad_actions.set_aside()
    act(window, "replay_recipe", qtbot)
    assert workspace.document.layers.is_same(wanted)
    workspace.document.undo_stack.undo()
    workspace.document.undo_stack.undo()
    assert set(workspace.document.doubts) == {Gap(3, 20, 21), Gap(9, 20, 21)}


def test_a_recipe_without_corrections_leaves_those_of_the_user(
    open_in: Open, copy: Path, choose: list[str], qtbot: QtBot
) -> None:
    window = open_in(copy)
    fill(window, "linear", 3, qtbot)
    act(window, "save_recipe", qtbot)
    workspace = workspace_of(window)
    workspace.document.undo_stack.setIndex(0)
    workspace.view.select((9,))
    workspace.view.set_frame(20)
    workspace.bad_actions.set_aside()
    act(window, "replay_recipe", qtbot)
    assert set(workspace.document.doubts) == {Gap(9, 20, 21)}
    assert workspace.document.repairs
