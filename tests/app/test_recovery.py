"""The window offers edits that a crash has left, and keeps them until the user decides."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from crash_window import edit_of, gaps_to_fill
from PySide6.QtWidgets import QMessageBox, QTableWidget
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.engine import load
from mocapmend.journal import Recorder, find_abandoned
from mocapmend.journal.file import JournalFile
from mocapmend.settings import Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.recovery_dialog import RecoveryDialog
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import no_progress

Open = Callable[[Path], MainWindow]
Leave = Callable[[Path, int], Document]


@pytest.fixture
def leave_edits(settings: Settings, qtbot: QtBot) -> Leave:
    """Return a function that leaves edits of a recording as a crash does, with the last undone."""

    def leave(path: Path, count: int) -> Document:
        document = Document(*load(path, no_progress))
        recorder = Recorder(settings.journal_folder, document.source, pytest.fail)
        for number, gap in enumerate(gaps_to_fill(document)[: count + 1], start=1):
            edits = [edit_of(gap, number)]
            recorder.push(f"edit {number}", edits)
            document.undo_stack.push(EditSamples(document, edits, f"edit {number}"))
        document.undo_stack.undo()
        recorder.move(count)
        recorder.close()
        return document

    return leave


@pytest.fixture
def copy(tmp_path: Path, sprint: Path) -> Path:
    """Return a copy of a recording that may be changed."""
    path = tmp_path / "copy.c3d"
    path.write_bytes(sprint.read_bytes())
    return path


def journals(settings: Settings) -> list[Path]:
    return sorted(settings.journal_folder.glob("*"))


def dialogs(window: MainWindow) -> list[RecoveryDialog]:
    return [each for each in window.findChildren(RecoveryDialog) if each.isVisible()]


def offered(window: MainWindow, qtbot: QtBot) -> RecoveryDialog:
    qtbot.waitUntil(lambda: len(dialogs(window)) == 1, timeout=20_000)
    return dialogs(window)[0]


def names_in(dialog: RecoveryDialog) -> list[str]:
    table = dialog._table
    return [table.item(row, 0).text() for row in range(table.rowCount())]


def error_in(window: MainWindow, qtbot: QtBot) -> str:
    def boxes() -> list[QMessageBox]:
        return [box for box in window.findChildren(QMessageBox) if box.isVisible()]

    qtbot.waitUntil(lambda: len(boxes()) == 1, timeout=20_000)
    (box,) = boxes()
    box.close()
    return f"{box.text()} {box.informativeText()}"


def workspace_of(window: MainWindow, qtbot: QtBot) -> Workspace:
    qtbot.waitUntil(lambda: window.workspace is not None, timeout=20_000)
    assert window.workspace is not None
    return window.workspace


def start(window: MainWindow, recording: Path | None = None) -> None:
    """Do what `application.run` does once the window is made."""
    if recording is not None:
        window.open(recording)
    window.get_ready()


def nothing_is_offered(window: MainWindow, qtbot: QtBot) -> bool:
    """Wait for what is going on, then say that nobody was asked anything."""
    qtbot.waitUntil(lambda: window.jobs.running == 0, timeout=20_000)
    return not dialogs(window)


def test_recovered_edits_are_as_they_were(
    window: MainWindow, qtbot: QtBot, settings: Settings, sprint: Path, leave_edits: Leave
) -> None:
    lost = leave_edits(sprint, 3)
    start(window)
    dialog = offered(window, qtbot)
    texts = [dialog._table.item(0, column).text() for column in range(2)]
    assert texts == [sprint.name, "3"]
    dialog.recover_button.click()
    document = workspace_of(window, qtbot).document
    assert document.points.tobytes() == lost.points.tobytes()
    assert document.state.tobytes() == lost.state.tobytes()
    assert window.isWindowModified()
    assert window.statusBar().currentMessage() == f"Recovered 3 edits of {sprint.name}"
    assert window.actions_by_id["undo"].text() == "Undo edit 3"
    window.actions_by_id["redo"].trigger()
    assert document.undo_stack.index() == 4
    for _ in range(4):
        window.actions_by_id["undo"].trigger()
    assert document.points.tobytes() == document.original.points.tobytes()
    assert not window.isWindowModified()
    (journal,) = journals(settings)
    assert JournalFile.claim(journal) is None, "the recovered edits are protected"


def test_recovered_edits_are_recovered_again_after_the_next_crash(
    window: MainWindow, qtbot: QtBot, settings: Settings, sprint: Path, leave_edits: Leave
) -> None:
    leave_edits(sprint, 2)
    start(window)
    offered(window, qtbot).recover_button.click()
    workspace = workspace_of(window, qtbot)
    gap = workspace.document.gaps[20]
    workspace.push([edit_of(gap, 9)], "one more")
    copy = settings.journal_folder / "copy.journal"
    copy.write_bytes(journals(settings)[0].read_bytes())
    (found,) = find_abandoned(settings.journal_folder, no_progress)
    assert found.journal == copy
    assert found.edits == 3


def test_later_asks_again_at_the_next_start(
    window: MainWindow, qtbot: QtBot, settings: Settings, sprint: Path, leave_edits: Leave
) -> None:
    leave_edits(sprint, 1)
    before = [path.read_bytes() for path in journals(settings)]
    for _ in range(2):
        window.files.recovery.offer()
        offered(window, qtbot).later_button.click()
        assert dialogs(window) == []
    assert [path.read_bytes() for path in journals(settings)] == before
    assert window.workspace is None


def test_discarding_deletes_what_is_chosen_and_asks_for_the_rest(
    window: MainWindow,
    qtbot: QtBot,
    settings: Settings,
    sprint: Path,
    gait: Path,
    leave_edits: Leave,
) -> None:
    leave_edits(sprint, 1)
    leave_edits(gait, 2)
    start(window)
    dialog = offered(window, qtbot)
    assert sorted(names_in(dialog)) == sorted([sprint.name, gait.name])
    row = names_in(dialog).index(sprint.name)
    dialog._table.selectRow(row)
    dialog.discard_button.click()
    assert names_in(dialog) == [gait.name]
    (left,) = find_abandoned(settings.journal_folder, no_progress)
    assert left.subject.path == gait
    dialog.discard_button.click()
    assert dialogs(window) == []
    assert journals(settings) == []


def test_opening_a_recording_offers_its_edits_alone(
    open_in: Open, qtbot: QtBot, sprint: Path, gait: Path, leave_edits: Leave
) -> None:
    lost = leave_edits(sprint, 2)
    leave_edits(gait, 1)
    window = open_in(sprint)
    dialog = offered(window, qtbot)
    assert names_in(dialog) == [sprint.name]
    dialog.recover_button.click()
    document = workspace_of(window, qtbot).document
    assert document.points.tobytes() == lost.points.tobytes()
    assert document.undo_stack.index() == 2


def test_a_recording_named_at_the_start_does_not_hide_other_edits(
    window: MainWindow, qtbot: QtBot, sprint: Path, gait: Path, leave_edits: Leave
) -> None:
    leave_edits(gait, 1)
    leave_edits(sprint, 1)
    start(window, sprint)
    dialog = offered(window, qtbot)
    assert sorted(names_in(dialog)) == sorted([sprint.name, gait.name])
    assert workspace_of(window, qtbot).document.source.path == sprint
    dialog._table.selectRow(names_in(dialog).index(sprint.name))
    dialog.recover_button.click()
    assert workspace_of(window, qtbot).document.undo_stack.index() == 1
    assert nothing_is_offered(window, qtbot)


def test_a_recording_that_was_moved_gets_its_edits_where_it_is_opened(
    window: MainWindow, qtbot: QtBot, settings: Settings, copy: Path, leave_edits: Leave
) -> None:
    leave_edits(copy, 2)
    moved = copy.rename(copy.with_name("moved.c3d"))
    start(window)
    offered(window, qtbot).recover_button.click()
    assert "not there any more" in error_in(window, qtbot)
    assert len(journals(settings)) == 1
    window.open(moved)
    offered(window, qtbot).recover_button.click()
    assert workspace_of(window, qtbot).document.undo_stack.index() == 2


def test_a_changed_recording_does_not_get_the_edits_and_they_are_kept(
    window: MainWindow, qtbot: QtBot, settings: Settings, copy: Path, leave_edits: Leave
) -> None:
    leave_edits(copy, 2)
    raw = bytearray(copy.read_bytes())
    raw[-512:] = bytes(512)
    copy.write_bytes(raw)
    start(window)
    offered(window, qtbot).recover_button.click()
    assert "was changed since" in error_in(window, qtbot)
    assert window.workspace is None
    assert len(find_abandoned(settings.journal_folder, no_progress)) == 1


def test_recovered_edits_come_beside_what_is_open(
    open_in: Open, qtbot: QtBot, sprint: Path, gait: Path, leave_edits: Leave
) -> None:
    window = open_in(gait)
    workspace = workspace_of(window, qtbot)
    workspace.push([edit_of(workspace.document.gaps[3], 1)], "mine")
    leave_edits(sprint, 1)
    window.files.recovery.offer()
    dialog = offered(window, qtbot)
    assert names_in(dialog) == [sprint.name], "edits of a living window are not offered"
    dialog.recover_button.click()
    qtbot.waitUntil(lambda: window.documents.count() == 2, timeout=20_000)
    assert workspace_of(window, qtbot).document.source.path == sprint
    window.documents.setCurrentWidget(workspace)
    assert workspace.document.undo_stack.index() == 1


def test_all_edits_are_recovered_each_in_a_tab(
    window: MainWindow, qtbot: QtBot, sprint: Path, gait: Path, leave_edits: Leave
) -> None:
    leave_edits(sprint, 2)
    leave_edits(gait, 1)
    start(window)
    dialog = offered(window, qtbot)
    qtbot.waitUntil(dialog.recover_button.isDefault)
    assert isinstance(dialog.focusWidget(), QTableWidget), "no button takes Enter unasked"
    dialog.recover_all_button.click()
    qtbot.waitUntil(lambda: window.documents.count() == 2, timeout=20_000)
    edits = {
        each.document.source.path: each.document.undo_stack.index() for each in window.documents
    }
    assert edits == {sprint: 2, gait: 1}
    assert nothing_is_offered(window, qtbot)


def test_edits_taken_by_another_window_are_an_error(
    window: MainWindow, qtbot: QtBot, settings: Settings, sprint: Path, leave_edits: Leave
) -> None:
    leave_edits(sprint, 1)
    start(window)
    dialog = offered(window, qtbot)
    other = JournalFile.claim(journals(settings)[0])
    assert other is not None
    dialog.recover_button.click()
    assert "Another window" in error_in(window, qtbot)
    assert window.workspace is None
    other.close()


def test_damage_is_told(
    window: MainWindow, qtbot: QtBot, settings: Settings, sprint: Path, leave_edits: Leave
) -> None:
    leave_edits(sprint, 3)
    (journal,) = journals(settings)
    journal.write_bytes(journal.read_bytes().replace(b"edit 3", b"edit X"))
    start(window)
    offered(window, qtbot).recover_button.click()
    assert "damaged" in error_in(window, qtbot)
    assert workspace_of(window, qtbot).document.undo_stack.count() == 2


def test_a_recording_without_edits_has_no_journal_and_a_closed_one_none_left(
    open_in: Open, qtbot: QtBot, settings: Settings, sprint: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = open_in(sprint)
    assert nothing_is_offered(window, qtbot)
    assert journals(settings) == []
    workspace = workspace_of(window, qtbot)
    workspace.push([edit_of(workspace.document.gaps[3], 1)], "edit")
    assert len(journals(settings)) == 1
    monkeypatch.setattr(QMessageBox, "question", lambda *_: QMessageBox.StandardButton.Discard)
    window.files.close()
    assert window.workspace is None
    assert journals(settings) == []


def test_an_edit_is_on_the_disk_before_it_is_made(
    open_in: Open, qtbot: QtBot, settings: Settings, sprint: Path
) -> None:
    workspace = workspace_of(open_in(sprint), qtbot)
    edits: list[int] = []

    def count(_: object) -> None:
        edits.append(sum(path.read_bytes().count(b'"step"') for path in journals(settings)))

    workspace.document.samples_changed.connect(count)
    gap = workspace.document.gaps[3]
    for number in (1, 2):
        workspace.push([edit_of(gap, number)], "edit")
    assert edits == [1, 2]


def test_a_window_that_is_destroyed_unasked_leaves_its_edits(
    qtbot: QtBot, settings: Settings, sprint: Path
) -> None:
    window = MainWindow(settings)
    window.open(sprint)
    workspace = workspace_of(window, qtbot)
    for number in (1, 2):
        workspace.push([edit_of(workspace.document.gaps[3], number)], "edit")
    window.jobs.shut_down()
    with qtbot.waitSignal(window.destroyed):
        window.deleteLater()
    (found,) = find_abandoned(settings.journal_folder, no_progress)
    assert found.edits == 2


def test_exported_edits_are_not_offered(
    open_in: Open, qtbot: QtBot, settings: Settings, sprint: Path, tmp_path: Path
) -> None:
    window = open_in(sprint)
    workspace = workspace_of(window, qtbot)
    gap = next(gap for gap in workspace.document.gaps if gap.length > 3)
    workspace.push([edit_of(gap, 1)], "edit")
    window.files.export(tmp_path / "out.c3d")
    qtbot.waitUntil(lambda: not window.isWindowModified(), timeout=20_000)
    folder = tmp_path / "after a crash"
    folder.mkdir()
    (folder / "copy.journal").write_bytes(journals(settings)[0].read_bytes())
    assert find_abandoned(folder, no_progress) == []
    workspace.document.undo_stack.undo()
    (folder / "copy.journal").write_bytes(journals(settings)[0].read_bytes())
    assert len(find_abandoned(folder, no_progress)) == 1, "undone after the export: unsaved"


def test_a_journal_that_cannot_be_written_is_told_once(
    open_in: Open, qtbot: QtBot, settings: Settings, sprint: Path
) -> None:
    settings.journal_folder.write_text("no folder")
    window = open_in(sprint)
    workspace = workspace_of(window, qtbot)
    for number in range(1, 4):
        workspace.push([edit_of(workspace.document.gaps[3], number)], "edit")
    assert "not protected against a crash" in error_in(window, qtbot)
    assert not [box for box in window.findChildren(QMessageBox) if box.isVisible()]
    assert workspace.document.undo_stack.count() == 3
    assert np.isfinite(workspace.document.points).any()
