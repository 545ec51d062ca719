"""Keys and clicks do what the user means, wherever the focus is."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QPushButton, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from mocapmend.settings import METHOD, RECENT_FILES, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace

Open = Callable[[Path], MainWindow]
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def opened(open_in: Open, sprint: Path, settings: Settings, qtbot: QtBot) -> MainWindow:
    """Return the window with the sprint recording and its first preview, by a quick method."""
    settings.set(METHOD, "cubic")
    window = open_in(sprint)
    qtbot.waitUntil(lambda: workspace_of(window).view.preview is not None, timeout=20_000)
    return window


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def edits(window: MainWindow) -> int:
    return workspace_of(window).document.undo_stack.index()


def type_into(qtbot: QtBot, widget: QWidget, text: str, *keys: Qt.Key) -> None:
    widget.setFocus()
    qtbot.waitUntil(widget.hasFocus)
    qtbot.keyClicks(widget, text)
    for key in keys:
        qtbot.keyClick(widget, key)


def test_enter_in_the_frame_box_goes_there_and_applies_nothing(
    opened: MainWindow, qtbot: QtBot
) -> None:
    box = opened.transport.findChild(QSpinBox)
    box.setFocus()
    box.selectAll()
    type_into(qtbot, box, "500", Qt.Key.Key_Return)
    assert workspace_of(opened).view.frame == 500
    assert edits(opened) == 0
    assert not box.hasFocus()
    qtbot.keyClick(opened, Qt.Key.Key_N)
    assert workspace_of(opened).view.frame > 500


def test_enter_in_the_filter_applies_nothing(opened: MainWindow, qtbot: QtBot) -> None:
    workspace_of(opened).show_pane(workspace_of(opened).markers)
    type_into(qtbot, workspace_of(opened).markers.filter, "arm", Qt.Key.Key_Return)
    assert edits(opened) == 0


def test_filtering_keeps_the_selection(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    selected = workspace.view.selection
    workspace.show_pane(workspace.markers)
    field = workspace.markers.filter
    type_into(qtbot, field, "no such marker")
    assert workspace.view.selection == selected
    assert workspace.markers.table.model().rowCount() == 0
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert field.text() == ""
    rows = workspace.markers.table.selectionModel().selectedRows()
    assert tuple(row.row() for row in rows) == selected


def test_the_wheel_turns_only_a_field_that_has_the_focus(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    methods = workspace.repair._method
    methods.setCurrentIndex(methods.findData("kalman"))
    fields = [*workspace.repair.findChildren(QAbstractSpinBox), methods]
    assert len(fields) >= 4
    before = [field.property("value") for field in fields]
    for field in fields:
        turn(field)
    assert [field.property("value") for field in fields] == before
    workspace.repair.limits._limit_gap.setChecked(True)
    limit = workspace.repair.limits._max_gap
    limit.setFocus()
    qtbot.waitUntil(limit.hasFocus)
    turn(limit)
    assert limit.value() == 25


def turn(widget: QWidget) -> None:
    """Turn the wheel by a notch over a widget."""
    middle = QPointF(widget.rect().center())
    event = QWheelEvent(
        middle,
        widget.mapToGlobal(middle),
        QPoint(),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def button(window: MainWindow, text: str) -> QPushButton:
    found = workspace_of(window).repair.findChildren(QPushButton)
    return next(one for one in found if one.text() == text)


def test_space_after_a_click_on_apply_plays(opened: MainWindow, qtbot: QtBot) -> None:
    qtbot.mouseClick(button(opened, "Apply"), LEFT)
    assert edits(opened) == 1
    qtbot.mouseClick(button(opened, "Apply"), LEFT)
    assert edits(opened) == 1
    qtbot.keyClick(opened, Qt.Key.Key_Space)
    assert workspace_of(opened).player.playing
    assert edits(opened) == 1


def test_a_focused_button_is_pressed_by_enter(opened: MainWindow, qtbot: QtBot) -> None:
    fill_all = button(opened, "Fill all")
    fill_all.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(fill_all, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: edits(opened) == 1, timeout=20_000)
    assert len(workspace_of(opened).document.repairs) > 100


def test_apply_and_go_on_walks_through_the_gaps(opened: MainWindow, qtbot: QtBot) -> None:
    view = workspace_of(opened).view
    first = view.gap
    qtbot.keyClick(opened, Qt.Key.Key_Return, Qt.KeyboardModifier.ShiftModifier)
    assert first in workspace_of(opened).document.repairs
    assert view.gap is not None
    assert view.gap != first


def test_a_click_on_a_repair_makes_it_the_one_that_del_clears(
    opened: MainWindow, qtbot: QtBot
) -> None:
    workspace = workspace_of(opened)
    document, timeline, view = workspace.document, workspace.timeline, workspace.view
    workspace.fill_all()
    qtbot.waitUntil(lambda: edits(opened) == 1, timeout=20_000)
    repaired = next(gap for gap in document.repairs if gap.marker > 5 and gap.length > 10)
    view.frame_span(repaired.start, repaired.stop)
    x = round(timeline.axis.x_of((repaired.start + repaired.stop) / 2))
    place = QPoint(x, timeline.lane_top(repaired.marker) + 2)
    qtbot.mouseClick(timeline.viewport(), LEFT, pos=place)
    assert view.gap == repaired
    qtbot.keyClick(opened, Qt.Key.Key_Delete)
    assert repaired in document.gaps
    assert edits(opened) == 2


def test_a_gap_out_of_sight_is_not_repaired(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    gap = workspace.view.gap
    assert gap is not None
    workspace.view.select(((gap.marker + 1) % workspace.document.original.markers,))
    assert workspace.view.gap is None
    qtbot.keyClick(opened, Qt.Key.Key_Return)
    assert edits(opened) == 0


def test_next_gap_starts_from_the_playhead(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.go_to_frame(500)
    qtbot.keyClick(opened, Qt.Key.Key_N)
    gap = workspace.view.gap
    assert gap is not None
    starts = [other.start for other in workspace.document.gaps if other.start >= 500]
    assert gap.start == min(starts)


def test_the_plots_turn_the_page_while_playing(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.view.set_visible(100, 160)
    workspace.view.set_frame(150)
    workspace.player.set_speed(4.0)
    workspace.player.toggle()
    qtbot.waitUntil(lambda: workspace.view.frame > 200, timeout=20_000)
    workspace.player.pause()
    start, stop = workspace.view.visible
    assert start <= workspace.view.frame < stop
    assert np.isclose(stop - start, 60)


def test_the_outcome_of_filling_goes_with_its_undo(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.fill_all()
    qtbot.waitUntil(lambda: edits(opened) == 1, timeout=20_000)
    assert workspace.repair.left_open.isVisibleTo(workspace.repair)
    workspace.document.undo_stack.undo()
    assert not workspace.repair.left_open.isVisibleTo(workspace.repair)


def test_a_file_that_is_gone_leaves_the_recent_files(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    gone = str(tmp_path / "gone.c3d")
    opened.settings.remember_file(gone)
    opened.files.open(Path(gone))
    qtbot.waitUntil(lambda: opened.jobs.running == 0)
    assert gone not in opened.settings.get(RECENT_FILES)
