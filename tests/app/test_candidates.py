"""Repairs of a gap side by side: computed in the background, chosen by number, kept."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from holes import HOLES
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QComboBox, QWidget
from pytestqt.qtbot import QtBot

from mocapmend.prospects import Way
from mocapmend.settings import COMPARE, METHOD, Settings
from mocapmend.views.candidate_list import METHODS
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace

Open = Callable[[Path], MainWindow]
GAP = HOLES["interior"]


@pytest.fixture
def opened(open_in: Open, holed_walk: Path) -> MainWindow:
    """Return the window with the walk at its gap between measured samples."""
    window = open_in(holed_walk)
    workspace_of(window).view.go_to(GAP)
    return window


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def all_known(workspace: Workspace, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: len(workspace.view.candidates) == len(METHODS), timeout=30_000)


def errors(workspace: Workspace) -> list[str]:
    table = workspace.repair._candidates
    items = [table.item(row, 2) for row in range(table.rowCount())]
    return [item.text() for item in items if item is not None]


def test_every_method_is_computed_and_the_least_error_has_a_star(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    assert "…" in errors(workspace)
    all_known(workspace, qtbot)
    numbers = [number for number, _ in workspace.view.candidates]
    previews = [preview for _, preview in workspace.view.candidates]
    assert numbers == [1, 2, 3, 4, 5, 6, 7]
    assert [preview.method for preview in previews] == list(METHODS)
    assert all(preview.gap == GAP for preview in previews)
    known = [preview.expected_error for preview in previews]
    best = int(np.nanargmin(known))
    texts = errors(workspace)
    assert [text.startswith("★") for text in texts] == [row == best for row in range(len(METHODS))]
    assert texts[best] == f"★ {known[best]:.1f} mm"


def test_number_keys_choose_and_enter_applies(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    all_known(workspace, qtbot)
    qtbot.keyClick(opened, Qt.Key.Key_6)
    assert workspace.repair.method().method == "cubic"
    preview = workspace.view.preview
    assert preview is not None, "what is known is shown at once"
    assert preview is workspace.view.candidates[5][1]
    qtbot.keyClick(opened, Qt.Key.Key_Return)
    assert workspace.document.repairs[GAP].method == "cubic"
    assert workspace.view.candidates == ()
    assert errors(workspace) == [""] * len(METHODS)
    qtbot.keyClick(opened, Qt.Key.Key_Delete)
    assert len(workspace.view.candidates) == len(METHODS), "and shown again after the undo"


def test_a_click_in_the_list_chooses(opened: MainWindow, qtbot: QtBot, settings: Settings) -> None:
    workspace = workspace_of(opened)
    table = workspace.repair._candidates
    place = table.visualRect(table.model().index(3, 1)).center()
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place))
    assert workspace.repair.method().method == METHODS[3]
    assert settings.get(METHOD) == METHODS[3]


def test_a_method_that_is_not_compared_gets_a_row_of_its_own(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    workspace.repair._choose("pchip")
    table = workspace.repair._candidates
    assert table.rowCount() == len(METHODS) + 1
    assert table.currentRow() == len(METHODS)
    qtbot.waitUntil(lambda: len(workspace.view.candidates) == len(METHODS) + 1, timeout=30_000)
    qtbot.keyClick(opened, Qt.Key.Key_1)
    assert workspace.repair.method().method == "auto"
    assert table.rowCount() == len(METHODS)
    qtbot.keyClick(opened, Qt.Key.Key_8)
    assert workspace.repair.method().method == "auto", "there is no eighth"


def test_leaving_a_gap_drops_what_was_on_its_way(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    other = HOLES["trailing"]
    workspace.view.go_to(other)
    all_known(workspace, qtbot)
    assert {preview.gap for _, preview in workspace.view.candidates} == {other}
    workspace.view.go_to(GAP)
    all_known(workspace, qtbot)
    workspace.view.go_to(other)
    assert len(workspace.view.candidates) == len(METHODS), "nothing is computed twice"
    assert not workspace.previewer.busy


def test_comparing_is_switched_off_and_on(
    window: MainWindow, open_in: Open, holed_walk: Path, settings: Settings, qtbot: QtBot
) -> None:
    window.actions_by_id["compare"].setChecked(False)
    workspace = workspace_of(open_in(holed_walk))
    assert not settings.get(COMPARE)
    workspace.view.go_to(GAP)
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    assert workspace.view.candidates == ()
    assert not workspace.previewer.busy
    assert not workspace.repair._candidates.isVisible()
    qtbot.keyClick(window, Qt.Key.Key_Q)
    assert settings.get(COMPARE)
    assert workspace.repair._candidates.isVisible()
    all_known(workspace, qtbot)


def test_parameters_last_while_other_methods_are_looked_at(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    edges = workspace.repair.findChild(QComboBox, "edges")
    assert edges is not None
    edges.setCurrentIndex(edges.findData("leave"))
    way = workspace.repair.method()
    assert way.params.edges == "leave"
    qtbot.keyClick(opened, Qt.Key.Key_6)
    assert workspace.repair.compared()[0] == way
    qtbot.keyClick(opened, Qt.Key.Key_1)
    assert workspace.repair.method() == way != Way.default("auto")


def test_donors_are_picked_by_clicking_markers(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    view, labels = workspace.view, workspace.document.original.labels
    selection = view.selection
    qtbot.keyClick(opened, Qt.Key.Key_D)
    assert view.picking
    for marker in (3, 7, GAP.marker, 3, 12):
        view.click(marker)
    view.click(None)
    assert workspace.repair.method().params.donors == (labels[7], labels[12])
    assert view.selection == selection
    qtbot.keyClick(opened, Qt.Key.Key_D)
    assert not view.picking
    view.click(3)
    assert view.selection == (3,)
    view.click(4, add=True)
    assert view.selection == (3, 4)
    view.click(4, add=True)
    assert view.selection == (3,)
    view.click(None, add=True)
    assert view.selection == (3,)
    view.click(None)
    assert view.selection == ()


def test_a_method_without_donors_says_so(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    qtbot.keyClick(opened, Qt.Key.Key_6)
    told: list[str] = []
    workspace.message.connect(told.append)
    qtbot.keyClick(opened, Qt.Key.Key_D)
    assert told == ["This method takes no donors."]
    assert not workspace.view.picking


def pixels(widget: QWidget, colour: str) -> int:
    """Count the pixels of about a colour."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    shape = image.height(), image.width(), 4
    seen = np.frombuffer(image.constBits(), np.uint8).reshape(shape)[..., 2::-1].astype(int)
    wanted = QColor(colour)
    far = np.abs(seen - (wanted.red(), wanted.green(), wanted.blue())).max(axis=2)
    return int((far < 24).sum())


def test_candidates_are_drawn_in_plots_and_in_3d(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    all_known(workspace, qtbot)
    theme = workspace.trajectories._painter.theme
    views = (workspace.trajectories, workspace.scene)
    assert [number for number, _ in workspace.view.others] == [2, 3, 4, 5, 6, 7]
    with_them = [pixels(view, theme.candidate) for view in views]
    workspace.view.set_candidates(())
    without = [pixels(view, theme.candidate) for view in views]
    assert with_them[0] > without[0] + 50
    assert with_them[1] > without[1] + 10
