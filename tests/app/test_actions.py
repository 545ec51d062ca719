"""The action table is the one source of menus, shortcuts and their help."""

from collections import Counter
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import SIGNAL
from PySide6.QtWidgets import QTableWidget

from mocapmend.actions import ACTIONS, MENUS, key_texts, text_of
from mocapmend.views.dialogs import shortcuts_dialog
from mocapmend.views.main_window import MainWindow


def test_ids_and_keys_are_unique(window: MainWindow) -> None:
    assert len({spec.id for spec in ACTIONS}) == len(ACTIONS)
    keys = Counter(
        key for action in window.actions_by_id.values() for key in set(key_texts(action))
    )
    assert {key for key, count in keys.items() if count > 1} == set()
    for action in window.actions_by_id.values():
        assert len(key_texts(action)) == len(set(key_texts(action)))


def test_every_action_is_in_its_menu_and_does_something(window: MainWindow) -> None:
    titles = window.menuBar().actions()
    assert len(titles) == len(MENUS)
    listed = {action.objectName() for title in titles for action in title.menu().actions()}
    for spec in ACTIONS:
        assert spec.id in listed
        signal = SIGNAL("toggled(bool)") if spec.checkable else SIGNAL("triggered(bool)")
        assert window.actions_by_id[spec.id].receivers(signal) > 0


def test_without_a_file_only_what_needs_none_is_enabled(window: MainWindow) -> None:
    for spec in ACTIONS:
        assert window.actions_by_id[spec.id].isEnabled() == (spec.needs == "nothing")


def test_with_a_file_everything_but_undo_is_enabled(
    open_in: Callable[[Path], MainWindow], gait: Path
) -> None:
    window = open_in(gait)
    disabled = {s.id for s in ACTIONS if not window.actions_by_id[s.id].isEnabled()}
    assert disabled == {"undo", "redo"}


def test_every_action_can_be_triggered_on_an_open_file(
    open_in: Callable[[Path], MainWindow], gait: Path
) -> None:
    window = open_in(gait)
    leaves = {"open", "export", "save_report", "close", "quit", "log", "about", "shortcuts"}
    leaves |= {"check_copy", "save_recipe", "save_plan", "load_plan", "replay_recipe"}
    for spec in ACTIONS:
        if spec.id not in leaves:
            window.actions_by_id[spec.id].trigger()
    assert window.workspace is not None


def test_the_help_lists_every_shortcut(window: MainWindow) -> None:
    dialog = shortcuts_dialog(window, window.actions_by_id)
    table = dialog.findChild(QTableWidget)
    assert table is not None
    rows = {
        (table.item(row, 1).text(), table.item(row, 2).text()) for row in range(table.rowCount())
    }
    for spec in ACTIONS:
        if spec.keys:
            keys = ", ".join(key_texts(window.actions_by_id[spec.id]))
            assert (text_of(spec), keys) in rows
    dialog.close()
