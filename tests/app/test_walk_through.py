"""The main job from beginning to end, once by keyboard alone and once by mouse alone."""

from collections.abc import Callable
from pathlib import Path

import pytest
from holes import HOLES
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractItemView, QFileDialog, QMenu, QPushButton, QTabBar, QWidget
from pytestqt.qtbot import QtBot

from mocapmend.files import check_files, read_c3d
from mocapmend.settings import RANKING, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.queue_pane import QueuePane
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

Open = Callable[[Path], MainWindow]
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def ranked(settings: Settings) -> None:
    """Let the program rank the gaps, as it does for users."""
    settings.set(RANKING, True)


@pytest.fixture
def dialogs(monkeypatch: pytest.MonkeyPatch, holed_walk: Path, tmp_path: Path) -> dict[str, Path]:
    """Answer the file dialogs; return what they are answered with."""
    files = {"export": tmp_path / "repaired.c3d", "report": tmp_path / "report.html"}

    def save(parent: object, title: str, *_: object) -> tuple[str, str]:
        return str(files["report" if "report" in title.lower() else "export"]), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", save)
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: ([str(holed_walk)], ""))
    return files


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def worst(queue: QueuePane) -> Gap:
    problem = queue.worst()
    assert problem is not None
    return problem.gap


def ready(window: MainWindow, qtbot: QtBot) -> Workspace:
    """Wait until the recording is there and all its gaps are ranked."""
    qtbot.waitUntil(lambda: window.workspace is not None, timeout=30_000)
    workspace = workspace_of(window)
    qtbot.waitUntil(lambda: workspace.survey.portions >= 4, timeout=90_000)
    qtbot.waitUntil(lambda: not workspace.previewer.busy, timeout=30_000)
    return workspace


def proved(window: MainWindow, files: dict[str, Path], original: Path, qtbot: QtBot) -> None:
    """Check that the export holds the repairs and nothing else, and that there is a report."""
    qtbot.waitUntil(lambda: not window.isWindowModified(), timeout=30_000)
    qtbot.waitUntil(lambda: not window.files.writing, timeout=60_000)
    found = check_files(original, files["export"])
    assert found.passed
    assert found.changed_samples == sum(gap.length for gap in HOLES.values())
    assert read_c3d(files["export"]).repaired == tuple(sorted(HOLES.values()))
    text = files["report"].read_text("utf-8")
    assert "holed_walk.c3d" in text
    assert "<svg" in text


def test_the_main_job_by_keyboard(
    window: MainWindow, ranked: None, dialogs: dict[str, Path], holed_walk: Path, qtbot: QtBot
) -> None:
    qtbot.keyClick(window, Qt.Key.Key_O, CTRL)
    workspace = ready(window, qtbot)
    view, document = workspace.view, workspace.document
    first = view.gap
    assert first == worst(workspace.queue), "the user is taken to the worst problem"

    # Compare: every number shows another repair, then the best one is accepted.
    for number, preview in view.candidates:
        qtbot.keyClick(window, Qt.Key(Qt.Key.Key_0 + number))
        assert view.preview is preview
    best = min(view.candidates, key=lambda pair: pair[1].expected_error)[0]
    qtbot.keyClick(window, Qt.Key(Qt.Key.Key_0 + best))
    qtbot.keyClick(window, Qt.Key.Key_Return, SHIFT)
    assert first in document.repairs
    second = view.gap
    assert second == worst(workspace.queue)
    assert second != first

    # The rest by the plan: first what it would do, then doing it.
    qtbot.keyClick(window, Qt.Key.Key_1)
    workspace.repair.limits.set_limits(None, 1000.0)
    qtbot.keyClick(window, Qt.Key.Key_Return, CTRL | SHIFT)
    qtbot.waitUntil(lambda: workspace.plan.model.rowCount() == 2, timeout=30_000)
    qtbot.waitUntil(lambda: workspace.filling.job is None, timeout=60_000)
    assert document.undo_stack.count() == 1
    qtbot.keyClick(window, Qt.Key.Key_Return, CTRL)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2, timeout=60_000)
    assert set(document.repairs) == set(HOLES.values())
    assert workspace.queue.worst() is None

    # Look at it once more, take it back and do it again.
    qtbot.keyClick(window, Qt.Key.Key_Z, CTRL)
    assert list(document.repairs) == [first]
    qtbot.keyClick(window, Qt.Key.Key_Z, CTRL | SHIFT)
    assert len(document.repairs) == 3

    qtbot.keyClick(window, Qt.Key.Key_3, CTRL)
    qtbot.waitUntil(workspace.report.isVisible)
    qtbot.keyClick(window, Qt.Key.Key_S, CTRL)
    qtbot.waitUntil(lambda: not window.isWindowModified(), timeout=30_000)
    qtbot.keyClick(window, Qt.Key.Key_R, CTRL)
    proved(window, dialogs, holed_walk, qtbot)


def test_the_main_job_by_mouse(
    window: MainWindow, ranked: None, dialogs: dict[str, Path], holed_walk: Path, qtbot: QtBot
) -> None:
    click_menu(window, "open", qtbot)
    workspace = ready(window, qtbot)
    view, document = workspace.view, workspace.document
    queue = workspace.queue
    click_row(queue.table, 1, qtbot)
    second = view.gap
    assert second == queue.model.gaps[1]
    click_row(queue.table, 0, qtbot)
    first = view.gap
    assert first == worst(queue)
    qtbot.waitUntil(lambda: not workspace.previewer.busy, timeout=30_000)

    for number, preview in view.candidates:
        click_row(workspace.repair._candidates, number - 1, qtbot)
        assert view.preview is preview
    best = min(view.candidates, key=lambda pair: pair[1].expected_error)[0]
    click_row(workspace.repair._candidates, best - 1, qtbot)
    click_button(workspace, "Apply", qtbot)
    assert first in document.repairs
    click_button(workspace, "Next ▶", qtbot)
    assert view.gap == second

    workspace.repair.limits.set_limits(None, 1000.0)
    click_row(workspace.repair._candidates, 0, qtbot)
    click_tab(workspace, "Plan", qtbot)
    qtbot.waitUntil(lambda: workspace.plan.model.rowCount() == 2, timeout=30_000)
    click_button(workspace.plan, "Fill all", qtbot)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2, timeout=60_000)
    assert set(document.repairs) == set(HOLES.values())

    click_tab(workspace, "Report", qtbot)
    qtbot.waitUntil(workspace.report.isVisible)
    click_menu(window, "export", qtbot)
    qtbot.waitUntil(lambda: not window.isWindowModified(), timeout=30_000)
    click_menu(window, "save_report", qtbot)
    proved(window, dialogs, holed_walk, qtbot)


def click(widget: QWidget, place: QPoint, qtbot: QtBot) -> None:
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place)


def click_row(table: QAbstractItemView, row: int, qtbot: QtBot) -> None:
    index = table.model().index(row, 1)
    table.scrollTo(index)
    click(table.viewport(), table.visualRect(index).center(), qtbot)


def click_button(inside: QWidget, text: str, qtbot: QtBot) -> None:
    buttons = [each for each in inside.findChildren(QPushButton) if each.text() == text]
    button = next(each for each in buttons if each.isVisible() and each.isEnabled())
    click(button, button.rect().center(), qtbot)


def click_tab(workspace: Workspace, title: str, qtbot: QtBot) -> None:
    for bar in workspace.findChildren(QTabBar):
        for place in range(bar.count()):
            if bar.tabText(place) == title and bar.isVisible():
                click(bar, bar.tabRect(place).center(), qtbot)
                return
    raise AssertionError(f"there is no tab {title}")


def click_menu(window: MainWindow, name: str, qtbot: QtBot) -> None:
    """Open the menu of an action and click the action in it."""
    action: QAction = window.actions_by_id[name]
    menu = next(each for each in action.associatedObjects() if isinstance(each, QMenu))
    bar = window.menuBar()
    click(bar, bar.actionGeometry(menu.menuAction()).center(), qtbot)
    qtbot.waitUntil(menu.isVisible)
    click(menu, menu.actionGeometry(action).center(), qtbot)
    qtbot.waitUntil(lambda: not menu.isVisible())
