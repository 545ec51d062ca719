"""The command palette finds and does everything that the menus offer, and says what it cannot."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from pytestqt.qtbot import QtBot

from mocapmend.action_table import ACTIONS
from mocapmend.views.main_window import MainWindow
from mocapmend.views.palette import Entry, Palette
from mocapmend.views.palette_entries import entries

Open = Callable[[Path], MainWindow]


def opened(window: MainWindow, qtbot: QtBot) -> Palette:
    qtbot.keyClick(
        window,
        Qt.Key.Key_P,
        Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
    )
    (palette,) = [each for each in window.findChildren(Palette) if each.isVisible()]
    return palette


def by_text(window: MainWindow) -> dict[str, Entry]:
    return {entry.text: entry for entry in entries(window)}


def test_every_action_is_offered_with_its_menu_and_keys(window: MainWindow) -> None:
    found = entries(window)
    assert len(found) == len(ACTIONS) - 1
    assert by_text(window)["Marker labels"].place == "View › Show in 3D"
    assert by_text(window)["Marker labels"].keys == "L"
    assert by_text(window)["Light"].place == "View › Theme"
    window.shortcuts.choose("labels", [QKeySequence("Ctrl+L")])
    assert by_text(window)["Marker labels"].keys == "Ctrl+L"


def test_enter_does_what_is_chosen(open_in: Open, gait: Path, qtbot: QtBot) -> None:
    window = open_in(gait)
    palette = opened(window, qtbot)
    qtbot.keyClicks(palette.field, "next gap")
    assert palette.texts()[0] == "Next gap or problem"
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert not palette.isVisible()
    assert window.workspace is not None
    assert window.workspace.view.gap is not None


def test_up_and_down_choose(window: MainWindow, qtbot: QtBot) -> None:
    palette = opened(window, qtbot)
    qtbot.keyClicks(palette.field, "view theme")
    assert palette.texts() == ["As the system", "Light", "Dark"]
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Up, Qt.Key.Key_Return):
        qtbot.keyClick(palette.field, key)
    assert window.theme.name == "light"


def test_what_is_not_possible_says_why_and_is_not_done(window: MainWindow, qtbot: QtBot) -> None:
    palette = opened(window, qtbot)
    qtbot.keyClicks(palette.field, "next gap")
    assert palette.hint.text() == "Open a recording first."
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert palette.isVisible()
    qtbot.keyClicks(palette.field, " xyzzy")
    assert "Nothing fits" in palette.hint.text()
    qtbot.keyClick(palette.field, Qt.Key.Key_Escape)
    assert not palette.isVisible()


def test_reasons_fit_the_recording(open_in: Open, gait: Path) -> None:
    found = by_text(open_in(gait))
    assert found["Undo"].refusal == "There is nothing to undo."
    assert found["Next recording"].refusal == "Only one recording is open."
    assert found["Next gap or problem"].refusal == ""


def test_panes_layouts_and_recent_files_are_offered(
    open_in: Open, gait: Path, sprint: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(gait)
    workspace = window.workspace
    assert workspace is not None
    qtbot.waitUntil(lambda: workspace.arranged)
    window.layouts.save("wide")
    window.settings.remember_file(str(sprint))
    window.settings.remember_file(str(tmp_path / "none.c3d"))
    window.recent.look()
    qtbot.waitUntil(lambda: bool(window.recent.gone))
    found = by_text(window)
    assert found["wide"].place == "Layout"
    assert "gone" in found["none.c3d"].refusal
    found["Report"].run()
    qtbot.waitUntil(workspace.report.isVisible)
    found[sprint.name].run()
    qtbot.waitUntil(lambda: window.documents.count() == 2, timeout=20_000)


@pytest.mark.parametrize("name", ["view", "gap"])
def test_entries_of_a_menu_are_found_by_its_name(window: MainWindow, name: str) -> None:
    palette = Palette(entries(window), window)
    palette.field.setText(name)
    assert len(palette.texts()) > 5
    palette.close()
