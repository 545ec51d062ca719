"""A screen reader has a name for whatever can have the keyboard or is painted by us."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QComboBox,
    QDockWidget,
    QMainWindow,
    QScrollArea,
    QStackedWidget,
    QTabWidget,
    QWidget,
)
from pytestqt.qtbot import QtBot

from mocapmend.journal import Abandoned
from mocapmend.journal.history import Subject
from mocapmend.views.dialogs import left_open_dialog
from mocapmend.views.main_window import MainWindow
from mocapmend.views.palette import Palette
from mocapmend.views.palette_entries import entries
from mocapmend.views.reason_dialog import ReasonDialog
from mocapmend.views.recovery_dialog import RecoveryDialog
from mocapmend.views.refine_dialog import RefineDialog
from mocapmend.views.shortcuts_dialog import ShortcutsDialog
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Unfilled

FRAMES = (QScrollArea, QStackedWidget, QTabWidget, QMainWindow, QDockWidget)
"""They hold what has names, and are none themselves."""


def is_part(widget: QWidget) -> bool:
    """Say whether a widget is Qt's own, inside one that has a name."""
    parent = widget.parentWidget()
    if isinstance(parent, QAbstractScrollArea) and parent.viewport() is widget:
        return True
    popup = parent is not None and isinstance(parent.parentWidget(), QComboBox)
    return popup or widget.objectName().startswith("qt_")


def nameless(root: QWidget) -> set[str]:
    """Return the classes and places of all widgets below one that have no name."""
    found = set()
    for widget in (root, *root.findChildren(QWidget)):
        painted = type(widget).__module__.startswith("mocapmend") and (
            "paintEvent" in vars(type(widget))
        )
        focusable = widget.focusPolicy() != Qt.FocusPolicy.NoFocus
        if not (painted or focusable) or isinstance(widget, FRAMES) or is_part(widget):
            continue
        if widget.focusProxy() is not None:
            continue
        interface = QAccessible.queryAccessibleInterface(widget)
        if not interface.text(QAccessible.Text.Name):
            place, parent = [type(widget).__name__], widget.parentWidget()
            while parent is not None and parent is not root:
                place.append(type(parent).__name__)
                parent = parent.parentWidget()
            found.add(" < ".join(place))
    return found


def test_the_empty_window(window: MainWindow, qtbot: QtBot, tmp_path: Path) -> None:
    window.settings.remember_file(str(tmp_path / "gone.c3d"))
    window.recent.look()
    qtbot.waitUntil(lambda: bool(window.recent.gone))
    assert nameless(window) == set()


def test_the_window_with_recordings(
    open_in: Callable[[Path], MainWindow], gait: Path, sprint: Path, qtbot: QtBot
) -> None:
    open_in(gait)
    window = open_in(sprint)
    workspace = window.workspace
    assert workspace is not None
    qtbot.waitUntil(lambda: workspace.arranged)
    assert nameless(window) == set()


def test_the_tour(window: MainWindow) -> None:
    window.start_tour()
    assert window._tour is not None
    assert nameless(window._tour.callout) == set()
    window._tour.end()


@pytest.mark.parametrize(
    "kind", ["palette", "shortcuts", "recovery", "reason", "left open", "refine"]
)
def test_dialogs(
    open_in: Callable[[Path], MainWindow], gait: Path, tmp_path: Path, kind: str
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    document = window.workspace.document
    if kind == "palette":
        dialog: QWidget = Palette(entries(window), window)
    elif kind == "shortcuts":
        dialog = ShortcutsDialog(window.shortcuts, window)
    elif kind == "recovery":
        subject = Subject.of(document.source)
        dialog = RecoveryDialog(window, [Abandoned(tmp_path / "a.journal", subject, 2, 0.0)])
    elif kind == "refine":
        out = tmp_path / "out.c3d"
        dialog = RefineDialog(document.source, out, window.settings, window, edited=False)
    elif kind == "reason":
        dialog = ReasonDialog(document, {document.gaps[0]: None}, window)
    else:
        unfilled = [Unfilled(Gap(0, 1, 3), "too long")]
        dialog = left_open_dialog(window, document.original, unfilled, lambda _: None)
    dialog.show()
    assert nameless(dialog) == set()
    dialog.close()
