"""Several recordings, each in a tab with its own edits, view and journal."""

from collections.abc import Callable
from pathlib import Path

import pytest
from crash_window import edit_of
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from mocapmend.views.documents import shortened
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace

Open = Callable[[Path], MainWindow]
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
BUTTONS = QMessageBox.StandardButton


@pytest.fixture
def both(open_in: Open, sprint: Path, gait: Path) -> MainWindow:
    """Return the window with the sprint and the gait open; the gait is seen."""
    open_in(sprint)
    return open_in(gait)


@pytest.fixture
def answers(monkeypatch: pytest.MonkeyPatch) -> tuple[list[QMessageBox.StandardButton], list[str]]:
    """Return the answers to give to questions, and the texts that were asked."""
    to_give: list[QMessageBox.StandardButton] = []
    asked: list[str] = []

    def answer(_parent: object, _title: str, text: str, *_: object) -> QMessageBox.StandardButton:
        asked.append(text)
        return to_give.pop(0)

    monkeypatch.setattr(QMessageBox, "question", answer)
    return to_give, asked


def workspaces(window: MainWindow) -> list[Workspace]:
    return list(window.documents)


def current(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def edit(workspace: Workspace) -> None:
    workspace.push([edit_of(workspace.document.gaps[3], 1)], "edit")


def test_a_bar_of_tabs_is_seen_where_there_is_a_choice(
    open_in: Open, sprint: Path, gait: Path
) -> None:
    window = open_in(sprint)
    assert not window.documents.tabBar().isVisible()
    assert not window.actions_by_id["next_document"].isEnabled()
    open_in(gait)
    assert window.documents.tabBar().isVisible()
    assert window.actions_by_id["next_document"].isEnabled()
    window.files.close()
    assert not window.documents.tabBar().isVisible()
    assert current(window).document.source.path == sprint


def test_all_follows_the_current_tab(both: MainWindow, sprint: Path, gait: Path) -> None:
    first, second = workspaces(both)
    edit(first)
    assert not both.actions_by_id["undo"].isEnabled()
    assert both.windowTitle().startswith(gait.name)
    assert "frames" in both._facts.text()
    facts = both._facts.text()
    both.documents.setCurrentWidget(first)
    assert both.actions_by_id["undo"].text() == "Undo edit"
    assert both.isWindowModified()
    assert both.windowTitle().startswith(sprint.name)
    assert both._facts.text() != facts
    first.go_to_frame(100)
    assert both.transport._frame.value() == 100 + first.document.original.first_frame
    both.documents.setCurrentWidget(second)
    first.go_to_frame(200)
    assert both.transport._frame.value() == second.view.frame + second.document.original.first_frame
    both.actions_by_id["labels"].trigger()
    assert "labels" in first.scene.layers
    assert "labels" in second.scene.layers


def test_edits_belong_to_one_tab(both: MainWindow, qtbot: QtBot) -> None:
    first, second = workspaces(both)
    edit(first)
    assert [each.saved for each in (first, second)] == [False, True]
    assert [both.documents.tabText(k) for k in (0, 1)] == [
        "sprint_basketball.c3d *",
        "gait_plug_in_gait.c3d",
    ]
    assert both.documents.tabToolTip(0) == str(first.document.source.path)
    both.documents.setCurrentWidget(first)
    qtbot.keyClick(both, Qt.Key.Key_Z, CTRL)
    assert both.documents.tabText(0) == "sprint_basketball.c3d"


def test_a_file_is_never_open_twice(
    both: MainWindow, qtbot: QtBot, sprint: Path, tmp_path: Path
) -> None:
    link = tmp_path / "link.c3d"
    try:
        link.symlink_to(sprint)
    except OSError:
        link = sprint
    for path in (sprint, link):
        both.documents.setCurrentIndex(1)
        both.open(path)
        qtbot.waitUntil(lambda: both.jobs.running == 0, timeout=20_000)
        assert both.documents.count() == 2
        assert current(both).document.source.path == sprint
    assert "is open already" in both.statusBar().currentMessage()


def test_keys_go_round_the_tabs(both: MainWindow, qtbot: QtBot) -> None:
    first, second = workspaces(both)
    for key, modifiers in (
        (Qt.Key.Key_Tab, CTRL),
        (Qt.Key.Key_Backtab, CTRL | SHIFT),
        (Qt.Key.Key_PageDown, CTRL),
        (Qt.Key.Key_PageUp, CTRL),
    ):
        qtbot.keyClick(both, key, modifiers)
        assert current(both) is first, key
        both.documents.setCurrentWidget(second)


def test_a_player_pauses_when_its_tab_is_left(both: MainWindow) -> None:
    first, second = workspaces(both)
    second.view.set_frame(0)
    second.player.toggle()
    both.documents.setCurrentWidget(first)
    assert not second.player.playing


def test_closing_a_tab_asks_about_its_edits(
    both: MainWindow, answers: tuple[list[QMessageBox.StandardButton], list[str]]
) -> None:
    to_give, asked = answers
    first, second = workspaces(both)
    edit(first)
    to_give += [BUTTONS.Cancel, BUTTONS.Discard]
    both.documents.tabCloseRequested.emit(0)
    assert workspaces(both) == [first, second]
    assert current(both) is first, "it is seen while it is asked about"
    both.documents.tabCloseRequested.emit(0)
    assert workspaces(both) == [second]
    assert len(asked) == 2
    both.documents.tabCloseRequested.emit(0)
    assert both.workspace is None
    assert both.stack.currentWidget() is both.welcome


def test_closing_the_window_asks_for_each_and_closes_none_before_all(
    both: MainWindow, qtbot: QtBot, answers: tuple[list[QMessageBox.StandardButton], list[str]]
) -> None:
    to_give, asked = answers
    first, second = workspaces(both)
    edit(first)
    edit(second)
    to_give += [BUTTONS.Discard, BUTTONS.Cancel]
    both.close()
    assert both.isVisible()
    assert [text.split()[0] for text in asked] == [
        "sprint_basketball.c3d",
        "gait_plug_in_gait.c3d",
    ]
    assert workspaces(both) == [first, second]
    assert not first.saved
    to_give += [BUTTONS.Discard, BUTTONS.Discard]
    both.close()
    assert len(asked) == 4, "what was given up is asked about again"
    qtbot.waitUntil(lambda: not both.isVisible())


def test_the_layout_is_shared(both: MainWindow, qtbot: QtBot) -> None:
    first, second = workspaces(both)
    qtbot.waitUntil(lambda: second.arranged)
    both.documents.setCurrentWidget(first)
    qtbot.waitUntil(lambda: first.arranged)
    first.panes()[0].close()
    both.documents.setCurrentWidget(second)
    assert not second.panes()[0].isVisible()


def test_a_floating_pane_goes_with_its_tab(both: MainWindow, qtbot: QtBot) -> None:
    first, second = workspaces(both)
    qtbot.waitUntil(lambda: second.arranged)
    pane = second.panes()[0]
    pane.setFloating(True)
    assert pane.isVisible()
    both.documents.setCurrentWidget(first)
    assert not pane.isVisible()
    both.documents.setCurrentWidget(second)
    assert pane.isVisible()
    assert pane.isFloating()


def test_files_of_one_name_are_told_apart(open_in: Open, gait: Path, tmp_path: Path) -> None:
    for folder in ("monday", "tuesday"):
        (tmp_path / folder).mkdir()
        path = tmp_path / folder / "a & b.c3d"
        path.write_bytes(gait.read_bytes())
        window = open_in(path)
    texts = [window.documents.tabText(k) for k in (0, 1)]
    assert texts == ["a && b.c3d — monday", "a && b.c3d — tuesday"]


def test_long_names_lose_their_middle() -> None:
    assert shortened("walk.c3d") == "walk.c3d"
    assert shortened("a" * 50 + "b" * 50 + ".c3d") == "a" * 20 + "…" + "b" * 16 + ".c3d"
