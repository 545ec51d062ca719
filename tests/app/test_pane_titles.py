"""A pane has its name in a tab or in a title, and a title has buttons that are seen."""

from collections.abc import Callable
from pathlib import Path

import pytest
from icon_colours import is_of
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QMainWindow
from pytestqt.qtbot import QtBot

from mocapmend.theme import DARK, LIGHT
from mocapmend.views.main_window import MainWindow
from mocapmend.views.pane_titles import TITLE_BUTTONS, PaneTitles
from mocapmend.views.workspace import Workspace


@pytest.mark.parametrize("name", TITLE_BUTTONS)
def test_title_buttons_follow_the_theme_and_stay_when_the_pane_floats(
    qtbot: QtBot, name: str
) -> None:
    window = QMainWindow()
    qtbot.addWidget(window)
    pane = QDockWidget("pane", window)
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, pane)
    button = pane.findChild(QAbstractButton, name)
    assert isinstance(button, QAbstractButton)
    titles = PaneTitles(window, DARK)
    titles.add(pane)
    assert is_of(button.icon(), DARK.text)
    titles.set_theme(LIGHT)
    assert is_of(button.icon(), LIGHT.text)
    pane.setFloating(True)
    qtbot.waitUntil(lambda: is_of(button.icon(), LIGHT.text))


@pytest.fixture
def panes(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> dict[str, QDockWidget]:
    """Return the panes of a recording by their names."""
    workspace = open_in(gait).workspace
    assert workspace is not None
    qtbot.waitUntil(lambda: workspace.arranged)
    return {pane.objectName(): pane for pane in workspace.panes()}


def has_title(pane: QDockWidget) -> bool:
    return pane.titleBarWidget() is None


def test_panes_with_tabs_have_no_title(panes: dict[str, QDockWidget]) -> None:
    assert [name for name, pane in panes.items() if has_title(pane)] == []


def test_a_pane_that_is_left_alone_has_a_title(panes: dict[str, QDockWidget], qtbot: QtBot) -> None:
    panes["markers"].close()
    qtbot.waitUntil(lambda: has_title(panes["queue"]))
    panes["markers"].toggleViewAction().trigger()
    qtbot.waitUntil(lambda: not has_title(panes["queue"]))


def test_a_pane_out_of_the_window_has_a_frame(panes: dict[str, QDockWidget], qtbot: QtBot) -> None:
    queue = panes["queue"]
    queue.setFloating(True)
    qtbot.waitUntil(lambda: has_title(queue) and has_title(panes["markers"]))
    assert not queue.windowFlags() & Qt.WindowType.FramelessWindowHint
    queue.setFloating(False)
    qtbot.waitUntil(lambda: not has_title(queue) and not has_title(panes["markers"]))


def test_a_pane_moved_to_the_tabs_of_others_has_none(
    panes: dict[str, QDockWidget], qtbot: QtBot
) -> None:
    repair, smooth = panes["repair"], panes["smooth"]
    workspace = repair.parentWidget()
    assert isinstance(workspace, Workspace)
    workspace.tabifyDockWidget(panes["queue"], repair)
    qtbot.waitUntil(lambda: has_title(smooth) and not has_title(repair))
    workspace.tabifyDockWidget(panes["queue"], smooth)
    qtbot.waitUntil(lambda: not has_title(smooth))
    workspace.restore_first_layout()
    assert not has_title(repair)
