"""What the command palette offers: all actions, the recent files, the panes and the layouts."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication

from mocapmend.action_table import ACTIONS, ActionSpec
from mocapmend.actions import key_texts, menu_name, submenu_of
from mocapmend.views.palette import Entry

if TYPE_CHECKING:
    from mocapmend.views.main_window import MainWindow

translate = QCoreApplication.translate


def entries(window: "MainWindow") -> list[Entry]:
    """Return all that can be done in a window, and what cannot be done just now."""
    return [*_actions(window), *_panes(window), *_layouts(window), *_recent(window)]


def _actions(window: "MainWindow") -> Iterator[Entry]:
    for spec in ACTIONS:
        action = window.actions_by_id[spec.id]
        if spec.id == "palette":
            continue
        place = menu_name(spec.menu)
        if spec.submenu:
            place = f"{place} › {submenu_of(spec)}"
        keys = ", ".join(key_texts(action))
        refusal = "" if action.isEnabled() else _refusal(spec, window)
        yield Entry(action.text(), place, keys, action.trigger, refusal)


def _refusal(spec: ActionSpec, window: "MainWindow") -> str:
    if window.workspace is None:
        return translate("Palette", "Open a recording first.")
    if spec.needs == "c3d":
        return translate("Palette", "Only C3D recordings can be checked.")
    if spec.needs == "several":
        return translate("Palette", "Only one recording is open.")
    if spec.needs == "markers" and not window.workspace.document.repairable:
        return translate("Palette", "This recording has no markers.")
    if spec.id == "undo":
        return translate("Palette", "There is nothing to undo.")
    if spec.id == "redo":
        return translate("Palette", "There is nothing to redo.")
    return translate("Palette", "This is not possible now.")


def _panes(window: "MainWindow") -> Iterator[Entry]:
    workspace = window.workspace
    if workspace is None:
        return
    place = translate("Palette", "Pane")
    for pane in workspace.panes():
        show = partial(workspace.show_pane, pane.widget())
        yield Entry(pane.windowTitle(), place, "", show)


def _layouts(window: "MainWindow") -> Iterator[Entry]:
    refusal = ""
    if not window.actions_by_id["first_layout"].isEnabled():
        refusal = translate("Palette", "Open a recording first.")
    for name in window.layouts.names:
        place = translate("Palette", "Layout")
        yield Entry(name, place, "", partial(window.layouts.choose, name), refusal)


def _recent(window: "MainWindow") -> Iterator[Entry]:
    place = translate("Palette", "Recent file")
    for text in window.recent.paths:
        path = Path(text)
        gone = text in window.recent.gone
        refusal = translate("Palette", "This file is gone: {0}").format(text) if gone else ""
        yield Entry(path.name, place, "", partial(window.open, path), refusal)
