"""The history lists the steps, marks the exported one and goes to any of them."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from crash_window import edit_of
from PySide6.QtCore import Qt
from PySide6.QtGui import QUndoCommand, QUndoStack
from PySide6.QtWidgets import QStyleOptionViewItem
from pytestqt.qtbot import QtBot

from mocapmend.views.history_pane import HistoryPane
from mocapmend.views.main_window import MainWindow


@pytest.fixture
def pane(qtbot: QtBot) -> HistoryPane:
    """Return a history of three steps."""
    stack = QUndoStack()
    made = HistoryPane(stack)
    made.stack_kept = stack
    qtbot.addWidget(made)
    for text in ("fill A", "fill B", "clear A"):
        stack.push(QUndoCommand(text))
    return made


def texts(pane: HistoryPane) -> list[str]:
    return [pane.row_text(row) for row in range(pane.model().rowCount())]


def test_steps_are_numbered_after_the_recording_as_opened(pane: HistoryPane) -> None:
    assert texts(pane) == ["As opened", "1. fill A", "2. fill B", "3. clear A"]


def test_undone_and_exported_steps_say_so(pane: HistoryPane) -> None:
    pane.stack().undo()
    pane.stack().setClean()
    pane.stack().undo()
    assert texts(pane)[1:] == [
        "1. fill A",
        "2. fill B (undone) ✔ exported",
        "3. clear A (undone)",
    ]
    pane.stack().setIndex(0)
    assert texts(pane)[0] == "As opened"


def test_what_is_painted_is_the_text(pane: HistoryPane) -> None:
    pane.stack().undo()
    shown = []
    for row in range(4):
        option = QStyleOptionViewItem()
        pane.itemDelegate().initStyleOption(option, pane.model().index(row, 0))
        shown.append(option.text)
    assert shown == texts(pane)


def test_a_click_goes_to_a_step(pane: HistoryPane, qtbot: QtBot) -> None:
    pane.resize(300, 200)
    pane.show()
    for row in (1, 3, 0):
        place = pane.visualRect(pane.model().index(row, 0)).center()
        qtbot.mouseClick(pane.viewport(), Qt.MouseButton.LeftButton, pos=place)
        assert pane.stack().index() == row


def test_the_pane_goes_through_the_samples(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    workspace = window.workspace
    assert workspace is not None
    before = workspace.document.points.copy()
    for gap in workspace.document.gaps[2:4]:
        workspace.push([edit_of(gap, 1)], "edit")
    after = workspace.document.points.copy()
    qtbot.waitUntil(lambda: workspace.arranged)
    window.actions_by_id["show_history"].trigger()
    qtbot.waitUntil(workspace.history.hasFocus)
    for _ in range(2):
        qtbot.keyClick(workspace.history, Qt.Key.Key_Up)
    assert np.array_equal(workspace.document.points, before, equal_nan=True)
    for _ in range(2):
        qtbot.keyClick(workspace.history, Qt.Key.Key_Down)
    assert np.array_equal(workspace.document.points, after, equal_nan=True)
    assert not np.array_equal(before, after, equal_nan=True)
