"""Layouts have names, and the window comes back where it was, or where it can be seen."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QInputDialog
from pytestqt.qtbot import QtBot

from mocapmend.settings import LAYOUTS, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace


@pytest.fixture
def opened(open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot) -> MainWindow:
    """Return the window with the gait recording and arranged panes."""
    window = open_in(gait)
    qtbot.waitUntil(lambda: workspace_of(window).arranged)
    return window


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def listed(window: MainWindow) -> list[str]:
    window.menus.layouts.aboutToShow.emit()
    return [each.text() for each in window.menus.layouts.actions() if not each.isSeparator()]


def test_a_layout_is_named_chosen_and_deleted(
    opened: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    markers = workspace_of(opened).panes()[0]
    assert listed(opened) == ["Save this layout…", "Arrange as at first"]
    markers.close()
    monkeypatch.setattr(QInputDialog, "getText", lambda *_: (" A & B ", True))
    opened.actions_by_id["save_layout"].trigger()
    opened.actions_by_id["first_layout"].trigger()
    assert markers.isVisible()
    assert listed(opened) == ["Save this layout…", "Arrange as at first", "A && B", "Delete"]
    opened.menus.layouts.actions()[-2].trigger()
    assert not markers.isVisible()
    opened.menus.layouts.actions()[-1].menu().actions()[0].trigger()
    assert listed(opened) == ["Save this layout…", "Arrange as at first"]


def test_no_name_is_no_layout(opened: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    for answer in (("", True), ("  ", True), ("name", False)):
        monkeypatch.setattr(QInputDialog, "getText", lambda *_, answer=answer: answer)
        opened.layouts.ask_and_save()
    assert opened.layouts.names == []


@pytest.mark.parametrize("state", ["AAAA", "no base 64!", 5])
def test_a_layout_that_does_not_fit_is_told(opened: MainWindow, state: object) -> None:
    opened.settings.set(LAYOUTS, {"old": state})
    before = workspace_of(opened).layout_state()
    opened.layouts.choose("old")
    assert "does not fit" in opened.statusBar().currentMessage()
    assert workspace_of(opened).layout_state() == before


def reopened(window: MainWindow, settings: Settings, qtbot: QtBot) -> MainWindow:
    window.close()
    again = MainWindow(settings)
    again.show()
    qtbot.waitExposed(again)
    return again


def test_a_maximised_window_comes_back_maximised(
    window: MainWindow, settings: Settings, qtbot: QtBot
) -> None:
    window.showMaximized()
    again = reopened(window, settings, qtbot)
    assert again.isMaximized()
    again.close()
    again.deleteLater()


def test_a_window_comes_back_where_it_was(
    window: MainWindow, settings: Settings, qtbot: QtBot
) -> None:
    window.resize(700, 500)
    window.move(20, 30)
    again = reopened(window, settings, qtbot)
    assert (again.size(), again.pos()) == (window.size(), window.pos())
    again.close()
    again.deleteLater()


@pytest.mark.parametrize("place", [QPoint(-5000, -5000), QPoint(9000, 100), QPoint(100, 9000)])
def test_a_window_that_would_be_off_the_screen_comes_back_on_it(
    window: MainWindow, settings: Settings, qtbot: QtBot, place: QPoint
) -> None:
    window.resize(700, 500)
    window.move(place)
    again = reopened(window, settings, qtbot)
    room = again.screen().availableGeometry()
    assert room.contains(again.geometry().topLeft())
    assert room.contains(again.geometry().center())
    again.close()
    again.deleteLater()
