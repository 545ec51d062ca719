"""Keys can be changed, never to those of another action, and all that tells them follows."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from pytestqt.qtbot import QtBot

from mocapmend.action_table import ACTIONS
from mocapmend.actions import key_texts, text_of
from mocapmend.settings import SHORTCUTS, Settings
from mocapmend.views.action_button import ActionButton
from mocapmend.views.main_window import MainWindow
from mocapmend.views.shortcuts_dialog import ShortcutsDialog


@pytest.fixture
def dialog(window: MainWindow, qtbot: QtBot) -> ShortcutsDialog:
    """Return the list of the keys, as "?" shows it."""
    window.show_shortcuts()
    (made,) = window.findChildren(ShortcutsDialog)
    return made


def rows(dialog: ShortcutsDialog) -> list[tuple[str, str]]:
    table = dialog.table
    return [
        (table.item(row, 1).text(), table.item(row, 2).text()) for row in range(table.rowCount())
    ]


def go_to(dialog: ShortcutsDialog, name: str) -> None:
    dialog.field.clear()
    ids = [spec.id for spec in dialog._specs]
    dialog.table.setCurrentCell(ids.index(name), 0)
    assert dialog.current == name


def keys(window: MainWindow, name: str) -> list[str]:
    return key_texts(window.actions_by_id[name])


def test_the_help_lists_every_action(window: MainWindow, dialog: ShortcutsDialog) -> None:
    assert rows(dialog) == [
        (text_of(spec), ", ".join(key_texts(window.actions_by_id[spec.id]))) for spec in ACTIONS
    ]


def test_it_is_searched_by_name_and_by_key(dialog: ShortcutsDialog) -> None:
    dialog.field.setText("trail of the")
    assert [text for text, _ in rows(dialog)] == ["Trail of the selection"]
    dialog.field.setText("]")
    assert [text for text, _ in rows(dialog)] == ["Faster"]
    dialog.field.setText("ctrl+shift+z")
    assert [text for text, _ in rows(dialog)] == ["Redo"]
    dialog.field.setText("xyzzy")
    assert rows(dialog) == []
    assert not dialog.edit.isEnabled()


def test_a_key_is_set_and_remembered(
    window: MainWindow, dialog: ShortcutsDialog, settings: Settings, qtbot: QtBot
) -> None:
    go_to(dialog, "next_gap")
    qtbot.keyClick(dialog.edit, Qt.Key.Key_J, Qt.KeyboardModifier.ControlModifier)
    dialog.set_button.click()
    assert keys(window, "next_gap") == ["Ctrl+J"]
    assert window.actions_by_id["next_gap"].toolTip() == "Next gap or problem (Ctrl+J)"
    assert ("Next gap or problem", "Ctrl+J (changed)") in rows(dialog)
    other = MainWindow(settings)
    assert keys(other, "next_gap") == ["Ctrl+J"]
    other.close()
    other.deleteLater()


def test_a_changed_key_works_and_the_old_one_does_not(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    workspace = window.workspace
    assert workspace is not None
    window.shortcuts.choose("next_gap", [QKeySequence("J")])
    qtbot.keyClick(window, Qt.Key.Key_N)
    assert workspace.view.gap is None
    qtbot.keyClick(window, Qt.Key.Key_J)
    assert workspace.view.gap is not None
    tips = [each.toolTip() for each in workspace.repair.findChildren(ActionButton)]
    assert "Next gap or problem (J)" in tips


def test_a_key_of_another_action_is_refused(window: MainWindow, dialog: ShortcutsDialog) -> None:
    go_to(dialog, "next_gap")
    dialog.edit.setKeySequence(QKeySequence("Ctrl+R"))
    assert dialog.answer.text() == (
        "Ctrl+R belongs to “Save report…”. Choose another key, or change that one first."
    )
    assert not dialog.set_button.isEnabled()
    assert not dialog.add_button.isEnabled()
    dialog.edit.setKeySequence(QKeySequence("N"))
    assert dialog.answer.text() == "", "its own key is no conflict"


def test_keys_are_added_taken_away_and_reset(window: MainWindow, dialog: ShortcutsDialog) -> None:
    go_to(dialog, "labels")
    dialog.edit.setKeySequence(QKeySequence("Ctrl+L"))
    dialog.add_button.click()
    assert keys(window, "labels") == ["L", "Ctrl+L"]
    dialog.none_button.click()
    assert keys(window, "labels") == []
    assert window.actions_by_id["labels"].toolTip() == "Marker labels"
    go_to(dialog, "trails")
    dialog.edit.setKeySequence(QKeySequence("L"))
    dialog.set_button.click()
    go_to(dialog, "labels")
    dialog.reset_button.click()
    assert "“Trail of the selection”" in dialog.answer.text()
    assert keys(window, "labels") == []
    go_to(dialog, "trails")
    dialog.reset_button.click()
    assert keys(window, "trails") == ["T"]
    go_to(dialog, "labels")
    dialog.reset_button.click()
    assert keys(window, "labels") == ["L"]
    assert not dialog.reset_button.isEnabled()
    assert window.settings.get(SHORTCUTS) == {}


def test_all_are_reset(window: MainWindow, dialog: ShortcutsDialog) -> None:
    before = rows(dialog)
    window.shortcuts.choose("labels", [QKeySequence("T")])
    window.shortcuts.choose("trails", [QKeySequence("L")])
    dialog.reset_all_button.click()
    assert rows(dialog) == before
    assert window.settings.get(SHORTCUTS) == {}


@pytest.mark.usefixtures("qapp")
def test_nonsense_in_the_settings_is_left_alone(settings: Settings) -> None:
    settings.set(SHORTCUTS, {"labels": 5, "gone_action": ["X"], "trails": ["Ctrl+T"], "play": [1]})
    window = MainWindow(settings)
    assert [keys(window, name) for name in ("labels", "trails", "play")] == [
        ["L"],
        ["Ctrl+T"],
        ["Space"],
    ]
    window.close()
    window.deleteLater()
