"""Why gaps stay open: decided and undone by keys, typed, and carried wherever the gaps go."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from holes import HOLES
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend import unsaved
from mocapmend.cli import main
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files import read_c3d
from mocapmend.files.record_values import LONGEST_TEXT
from mocapmend.files.records import LEFT_OPEN, NEVER_FILLED
from mocapmend.journal import find_abandoned, resume
from mocapmend.settings import Settings
from mocapmend.state import SampleState
from mocapmend.views.catalogue.reasons import USUAL
from mocapmend.views.main_window import MainWindow
from mocapmend.views.reason_dialog import ReasonDialog
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap, no_progress

Open = Callable[[Path], MainWindow]
ALT, SHIFT = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.ShiftModifier
NEVER, LEFT, OTHER = HOLES["interior"], HOLES["trailing"], HOLES["leading"]
WHY = "das Band hat <ihn> verdeckt & 遮挡"


@pytest.fixture
def walk(holed_walk: Path, tmp_path: Path) -> Path:
    """Return a copy of the walk with gaps in a folder of its own."""
    path = tmp_path / "walk.c3d"
    path.write_bytes(holed_walk.read_bytes())
    return path


@pytest.fixture
def opened(open_in: Open, walk: Path) -> MainWindow:
    """Return the window with the walk."""
    return open_in(walk)


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def press_x(window: MainWindow, gap: Gap, qtbot: QtBot, *modifiers: Qt.KeyboardModifier) -> None:
    workspace_of(window).view.go_to(gap)
    qtbot.keyClick(window, Qt.Key.Key_X, *modifiers)


def asked(window: MainWindow, qtbot: QtBot, gap: Gap) -> ReasonDialog:
    """Ask for the reason of a gap."""
    press_x(window, gap, qtbot, ALT)
    return dialog_of(window)


def dialog_of(window: MainWindow) -> ReasonDialog:
    (dialog,) = [each for each in window.findChildren(ReasonDialog) if each.isVisible()]
    return dialog


def answer(dialog: ReasonDialog, reason: str, qtbot: QtBot) -> None:
    """Type over what is in the field, and press Enter."""
    dialog.field.selectAll()
    qtbot.keyClick(dialog.field, Qt.Key.Key_Delete)
    dialog.field.insert(reason)
    qtbot.keyClick(dialog.field, Qt.Key.Key_Return)
    assert not dialog.isVisible()


def say(window: MainWindow, gap: Gap, reason: str, qtbot: QtBot) -> None:
    answer(asked(window, qtbot, gap), reason, qtbot)


def texts(document: Document) -> list[str]:
    stack = document.undo_stack
    return [stack.text(index) for index in range(stack.count())]


# --- the decisions are edits -----------------------------------------------------------------


def test_what_x_does_is_undone_and_redone(opened: MainWindow, qtbot: QtBot) -> None:
    document = workspace_of(opened).document
    name = document.names[LEFT.marker]
    with qtbot.assertNotEmitted(document.samples_changed):
        press_x(opened, LEFT, qtbot)
        assert opened.isWindowModified()
        assert opened.documents.tabText(0) == "walk.c3d *"
        assert opened.actions_by_id["undo"].text() == f"Undo leave a gap of {name} open"
        press_x(opened, LEFT, qtbot)
        assert document.set_aside == {}
        assert opened.isWindowModified(), "two steps from the file, whatever they come to"
        opened.actions_by_id["undo"].trigger()
        assert document.set_aside == {LEFT: LEFT_OPEN}
        opened.actions_by_id["undo"].trigger()
        assert document.set_aside == {}
        assert not opened.isWindowModified()
        opened.actions_by_id["redo"].trigger()
        assert document.set_aside == {LEFT: LEFT_OPEN}
    history = workspace_of(opened).history
    assert [history.row_text(row) for row in range(3)] == [
        "As opened",
        f"1. leave a gap of {name} open",
        f"2. take up a gap of {name} again (undone)",
    ]


def test_the_queue_and_the_report_follow_undo(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    press_x(opened, LEFT, qtbot)
    qtbot.waitUntil(lambda: LEFT not in workspace.queue.model.gaps)
    assert [entry.gap for entry in workspace.report_inputs()[4]] == [LEFT]
    workspace.document.undo_stack.undo()
    qtbot.waitUntil(lambda: LEFT in workspace.queue.model.gaps)
    assert workspace.report_inputs()[4] == []


def test_the_report_counts_no_samples_of_it(opened: MainWindow, qtbot: QtBot) -> None:
    facts = workspace_of(opened).facts
    for _ in range(2):
        press_x(opened, LEFT, qtbot)
    for _ in range(2):
        press_x(opened, NEVER, qtbot, SHIFT)
    assert [(row.runs, row.filled, row.cleared) for row in facts.edits()] == [(1, 0, 0)] * 4


def test_an_export_holds_it_until_it_is_undone(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    workspace = workspace_of(opened)
    press_x(opened, LEFT, qtbot)
    opened.files.export(tmp_path / "out.c3d")
    qtbot.waitUntil(lambda: not opened.files.writing, timeout=20_000)
    assert not opened.isWindowModified()
    assert workspace.facts.proof
    workspace.document.undo_stack.undo()
    assert opened.isWindowModified()
    assert workspace.facts.proof == ()


def test_a_crash_keeps_them(
    opened: MainWindow, qtbot: QtBot, settings: Settings, tmp_path: Path
) -> None:
    press_x(opened, LEFT, qtbot)
    press_x(opened, OTHER, qtbot)
    press_x(opened, NEVER, qtbot, SHIFT)
    say(opened, NEVER, WHY, qtbot)
    opened.actions_by_id["undo"].trigger()
    opened.actions_by_id["redo"].trigger()
    lost = workspace_of(opened).document
    (journal,) = settings.journal_folder.iterdir()
    copy = tmp_path / "after" / "copy.journal"
    copy.parent.mkdir()
    copy.write_bytes(journal.read_bytes())
    (found,) = find_abandoned(copy.parent, no_progress)
    assert found.edits == 4
    document = Document(lost.source, None)
    file, _ = resume(copy, document)
    file.close()
    assert document.set_aside == {LEFT: LEFT_OPEN, OTHER: LEFT_OPEN}
    assert document.unsaved().never == {NEVER: WHY}
    assert texts(document) == texts(lost)
    document.undo_stack.setIndex(0)
    assert (document.set_aside, document.never) == ({}, [])


# --- the reason ------------------------------------------------------------------------------


def test_an_open_gap_is_left_open_for_the_reason_in_one_step(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    dialog = asked(opened, qtbot, LEFT)
    assert "frames 331 – 343" in dialog.about.text()
    assert "Left open from now on" in dialog.about.text()
    answer(dialog, f"  {WHY} ", qtbot)
    assert document.set_aside == {LEFT: WHY}
    assert workspace.view.gap != LEFT, "on to the next, as X does"
    assert texts(document) == [f"say why a gap of {document.names[LEFT.marker]} stays open"]
    document.undo_stack.undo()
    assert document.set_aside == {}


def test_a_reason_is_given_later_changed_and_taken_back(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    press_x(opened, LEFT, qtbot)
    dialog = asked(opened, qtbot, LEFT)
    assert dialog.field.text() == "", "nothing is known yet"
    answer(dialog, WHY, qtbot)
    assert document.set_aside == {LEFT: WHY}
    assert workspace.view.gap == LEFT
    dialog = asked(opened, qtbot, LEFT)
    assert dialog.field.selectedText() == WHY
    qtbot.keyClick(dialog.field, Qt.Key.Key_Return)
    assert document.undo_stack.count() == 2, "the same reason is no step"
    say(opened, LEFT, "", qtbot)
    assert document.set_aside == {LEFT: LEFT_OPEN}
    document.undo_stack.undo()
    assert document.set_aside == {LEFT: WHY}
    press_x(opened, LEFT, qtbot, SHIFT)
    assert document.never_reason(LEFT) == WHY, "the same holds for never"


def test_escape_changes_nothing(opened: MainWindow, qtbot: QtBot) -> None:
    dialog = asked(opened, qtbot, LEFT)
    dialog.field.insert(WHY)
    qtbot.keyClick(dialog.field, Qt.Key.Key_Escape)
    assert not dialog.isVisible()
    assert workspace_of(opened).document.undo_stack.count() == 0


def test_a_gap_that_is_never_filled_gets_a_reason(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    press_x(opened, NEVER, qtbot, SHIFT)
    samples = document.revision
    dialog = asked(opened, qtbot, NEVER)
    assert "Never to be filled" in dialog.about.text()
    answer(dialog, WHY, qtbot)
    assert document.revision == samples
    assert document.never_reason(NEVER) == WHY
    assert "Kept open: das Band hat &lt;ihn&gt;" in workspace.repair._promise.text()
    document.undo_stack.undo()
    assert document.never_reason(NEVER) == NEVER_FILLED
    assert "Kept open" not in workspace.repair._promise.text()


def test_the_gaps_of_a_selected_time_get_one_reason(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document, view = workspace.document, workspace.view
    press_x(opened, LEFT, qtbot)
    view.select((OTHER.marker, NEVER.marker, LEFT.marker))
    view.set_span((0, 200))
    qtbot.keyClick(opened, Qt.Key.Key_X, SHIFT)
    assert document.never == [OTHER, NEVER]
    view.set_span((0, 343))
    qtbot.keyClick(opened, Qt.Key.Key_X, ALT)
    dialog = dialog_of(opened)
    assert dialog.about.text().startswith("3 gaps")
    answer(dialog, WHY, qtbot)
    assert document.unsaved().never == {OTHER: WHY, NEVER: WHY}
    assert document.set_aside == {LEFT: WHY}
    assert texts(document)[-1] == "say why 3 gaps stay open"
    say(opened, LEFT, "another", qtbot)
    assert document.set_aside == {LEFT: "another"}, "all three again"
    document.undo_stack.undo()
    view.set_span(None)
    say(opened, LEFT, "another", qtbot)
    view.set_span((0, 343))
    qtbot.keyClick(opened, Qt.Key.Key_X, ALT)
    qtbot.keyClick(dialog_of(opened).field, Qt.Key.Key_Return)
    assert document.set_aside == {LEFT: "another"}
    assert document.never_reason(NEVER) == WHY, "an empty field does not take several back"


def test_open_gaps_are_left_alone_where_others_are_kept(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    document, view = workspace.document, workspace.view
    press_x(opened, LEFT, qtbot)
    view.select((NEVER.marker, LEFT.marker))
    view.set_span((0, 343))
    qtbot.keyClick(opened, Qt.Key.Key_X, ALT)
    answer(dialog_of(opened), WHY, qtbot)
    assert document.set_aside == {LEFT: WHY}


def test_without_a_gap_nobody_is_asked(opened: MainWindow, qtbot: QtBot) -> None:
    workspace_of(opened).view.set_gap(None)
    qtbot.keyClick(opened, Qt.Key.Key_X, ALT)
    assert opened.findChildren(ReasonDialog) == []
    assert opened.statusBar().currentMessage() == "There is no gap here."


def test_a_gap_that_was_filled_meanwhile_stays_filled(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    dialog = asked(opened, qtbot, LEFT)
    filled = Edit(
        LEFT, np.ones((LEFT.length, 3)), np.full(LEFT.length, SampleState.FILLED, np.uint8)
    )
    workspace.push([filled], "something else")
    answer(dialog, WHY, qtbot)
    assert texts(workspace.document) == ["something else"]


# --- the dialog ------------------------------------------------------------------------------


def test_usual_reasons_are_chosen_by_arrows_and_clicks(opened: MainWindow, qtbot: QtBot) -> None:
    dialog = asked(opened, qtbot, LEFT)
    for _ in range(2):
        qtbot.keyClick(dialog.field, Qt.Key.Key_Down)
    assert dialog.field.text() == USUAL[1]
    qtbot.keyClick(dialog.field, Qt.Key.Key_Up)
    assert dialog.field.text() == USUAL[0]
    qtbot.keyClicks(dialog.field, ", mostly")
    assert dialog.usual.selectedItems() == []
    place = dialog.usual.visualItemRect(dialog.usual.item(3)).center()
    qtbot.mouseClick(dialog.usual.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert dialog.field.text() == USUAL[3]
    qtbot.keyClick(dialog.field, Qt.Key.Key_Return)
    assert workspace_of(opened).document.set_aside == {LEFT: USUAL[3]}


def test_a_usual_reason_is_english_in_the_record(
    chinese: None, open_in: Open, walk: Path, qtbot: QtBot
) -> None:
    window = open_in(walk)
    dialog = asked(window, qtbot, LEFT)
    qtbot.keyClick(dialog.field, Qt.Key.Key_Down)
    assert dialog.field.text() == "标记点全程被遮挡"
    qtbot.keyClick(dialog.field, Qt.Key.Key_Return)
    assert workspace_of(window).document.set_aside == {LEFT: USUAL[0]}
    assert asked(window, qtbot, LEFT).field.text() == "标记点全程被遮挡"


def test_a_reason_is_no_longer_than_a_record_takes(opened: MainWindow, qtbot: QtBot) -> None:
    say(opened, LEFT, "长" * (LONGEST_TEXT + 1), qtbot)
    assert workspace_of(opened).document.set_aside == {LEFT: "长" * LONGEST_TEXT}


# --- where it goes ---------------------------------------------------------------------------


def test_it_travels_with_the_file_the_recipe_and_the_report(
    opened: MainWindow, walk: Path, qtbot: QtBot, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    press_x(opened, NEVER, qtbot, SHIFT)
    say(opened, NEVER, WHY, qtbot)
    say(opened, LEFT, "长" * LONGEST_TEXT, qtbot)
    out, recipe, report = (tmp_path / name for name in ("out.c3d", "recipe.json", "report.html"))
    opened.files.export(out)
    qtbot.waitUntil(lambda: not opened.files.writing, timeout=20_000)
    kept = {NEVER: WHY, LEFT: "长" * LONGEST_TEXT}
    assert {gap: entry.reason for gap, entry in read_c3d(out).kept_open.items()} == kept

    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    again = tmp_path / "again.c3d"
    assert main(["replay", str(recipe), str(walk), "-o", str(again)]) == 0
    assert again.read_bytes() == out.read_bytes()

    assert [(entry.gap, entry.reason) for entry in workspace.report_inputs()[4]] == [
        (LEFT, kept[LEFT]),
        (NEVER, WHY),
    ]
    assert main(["report", str(walk), str(out), "-o", str(report)]) == 0
    assert "&lt;ihn&gt; verdeckt &amp; 遮挡" in report.read_text(encoding="utf-8")
    capsys.readouterr()
    assert main(["info", str(out)]) == 0
    assert WHY in capsys.readouterr().out
    workspace._show_left_open()
    tables = [table for table in workspace.findChildren(QTableWidget) if table.columnCount() == 3]
    assert WHY in {table.item(row, 2).text() for table in tables for row in range(table.rowCount())}


def test_the_plan_shows_it_at_once(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.show_plan()
    press_x(opened, NEVER, qtbot, SHIFT)
    say(opened, NEVER, WHY, qtbot)
    model = workspace.plan.model

    def listed() -> set[str]:
        return {model.index(row, 4).data() for row in range(model.rowCount())}

    qtbot.waitUntil(lambda: f"○ stays open: {WHY}" in listed())


def test_a_recipe_that_changes_a_reason_is_one_step_in_the_window(
    opened: MainWindow, open_in: Open, qtbot: QtBot, tmp_path: Path
) -> None:
    document = workspace_of(opened).document
    press_x(opened, NEVER, qtbot, SHIFT)
    say(opened, NEVER, WHY, qtbot)
    say(opened, LEFT, WHY, qtbot)
    recipe = tmp_path / "recipe.json"
    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    document.undo_stack.setIndex(1)
    press_x(opened, LEFT, qtbot)
    opened.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 3, timeout=20_000)
    assert document.set_aside == {LEFT: WHY}
    assert document.unsaved().never == {NEVER: WHY}
    document.undo_stack.undo()
    assert document.set_aside == {LEFT: LEFT_OPEN}
    assert document.unsaved().never == {NEVER: NEVER_FILLED}
    opened.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 3, timeout=20_000)
    opened.proofs.replay(recipe)
    qtbot.waitUntil(
        lambda: opened.statusBar().currentMessage() == "The recipe has nothing to do here.",
        timeout=20_000,
    )
    assert document.undo_stack.count() == 3


def test_a_recipe_leaves_open_what_the_file_protected(
    open_in: Open, opened: MainWindow, walk: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    press_x(opened, NEVER, qtbot, SHIFT)
    marked, recipe = tmp_path / "marked.c3d", tmp_path / "recipe.json"
    opened.files.export(marked)
    qtbot.waitUntil(lambda: not opened.files.writing, timeout=20_000)
    window = open_in(marked)
    document = workspace_of(window).document
    press_x(window, NEVER, qtbot, SHIFT)
    press_x(window, NEVER, qtbot)
    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    document.undo_stack.setIndex(0)
    window.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 1, timeout=20_000)
    assert (document.never, document.set_aside) == ([], {NEVER: LEFT_OPEN})


def test_a_recipe_leaves_open_what_was_filled_since(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    workspace, recipe = workspace_of(opened), tmp_path / "recipe.json"
    document = workspace.document
    press_x(opened, LEFT, qtbot)
    unsaved.write_recipe(document.unsaved(), recipe, no_progress)
    document.undo_stack.undo()
    filled = Edit(
        LEFT, np.ones((LEFT.length, 3)), np.full(LEFT.length, SampleState.FILLED, np.uint8)
    )
    workspace.push([filled], "a fill")
    opened.proofs.replay(recipe)
    qtbot.waitUntil(lambda: document.undo_stack.index() == 2, timeout=20_000)
    assert document.set_aside == {LEFT: LEFT_OPEN}
    document.undo_stack.undo()
    assert LEFT not in document.gaps


def test_a_fill_of_all_gaps_notes_its_own_reasons_beside_the_users(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    document = workspace.document
    say(opened, LEFT, WHY, qtbot)
    workspace.view.go_to(LEFT)
    workspace.repair._method.setCurrentIndex(workspace.repair._method.findData("linear"))
    with qtbot.waitSignal(workspace.filling.done, timeout=20_000):
        workspace.fill_all()
    assert LEFT in document.left_open, "a straight line needs both sides"
    assert document.open_reason(LEFT) == WHY
    opened.actions_by_id["leave_open"].trigger()
    assert document.open_reason(LEFT) == document.left_open[LEFT]
