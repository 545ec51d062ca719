"""The action table is the one source of menus, shortcuts and their help."""

from collections import Counter
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import SIGNAL

from mocapmend.action_table import ACTIONS, MENUS
from mocapmend.actions import key_texts
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
    shown = [action for title in titles for action in title.menu().actions()]
    shown += [action for entry in shown if entry.menu() for action in entry.menu().actions()]
    listed = {action.objectName() for action in shown}
    for spec in ACTIONS:
        assert spec.id in listed
        action = window.actions_by_id[spec.id]
        assert action.receivers(SIGNAL("toggled(bool)")) + action.receivers(
            SIGNAL("triggered(bool)")
        )


def test_without_a_file_only_what_needs_none_is_enabled(window: MainWindow) -> None:
    for spec in ACTIONS:
        assert window.actions_by_id[spec.id].isEnabled() == (spec.needs == "nothing")


def test_with_a_file_everything_but_undo_is_enabled(
    open_in: Callable[[Path], MainWindow], gait: Path
) -> None:
    window = open_in(gait)
    disabled = {s.id for s in ACTIONS if not window.actions_by_id[s.id].isEnabled()}
    assert disabled == {"undo", "redo", "next_document", "previous_document"}


def test_every_action_can_be_triggered_on_an_open_file(
    open_in: Callable[[Path], MainWindow], gait: Path
) -> None:
    window = open_in(gait)
    leaves = {"open", "export", "save_report", "close", "quit", "log", "about", "shortcuts"}
    leaves |= {"check_copy", "save_recipe", "save_plan", "load_plan", "replay_recipe"}
    leaves |= {"palette", "save_layout", "tour", "compare_with"}
    for spec in ACTIONS:
        if spec.id not in leaves:
            window.actions_by_id[spec.id].trigger()
    assert window.workspace is not None
