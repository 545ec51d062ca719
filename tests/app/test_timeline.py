"""The timeline: events, selected frames, order of the lanes, fonts, accessibility."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QAccessible, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from mocapmend.document import Document
from mocapmend.files import Event
from mocapmend.settings import MOST_MISSING_FIRST, PLAY_SPEED, Settings
from mocapmend.theme import DARK
from mocapmend.views.event_lane import name_of, thinned
from mocapmend.views.main_window import MainWindow
from mocapmend.views.timeline import Timeline
from mocapmend.views.workspace import Workspace
from mocapmend.viewstate import ViewState

Open = Callable[[Path], MainWindow]
LEFT = Qt.MouseButton.LeftButton
SHIFT = Qt.KeyboardModifier.ShiftModifier
NOTHING = QPoint()
NONE = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def view(document: Document) -> ViewState:
    return ViewState(document.original.frames)


@pytest.fixture
def timeline(document: Document, view: ViewState, qtbot: QtBot) -> Timeline:
    made = Timeline(document, view, DARK)
    qtbot.addWidget(made)
    made.resize(900, 320)
    made.show()
    qtbot.waitExposed(made)
    return made


@pytest.fixture
def workspace(open_in: Open, gait: Path) -> Workspace:
    """Return the workspace of the gait recording, which has 12 events."""
    opened = open_in(gait).workspace
    assert opened is not None
    return opened


def drag(timeline: Timeline, start: float, stop: float, modifiers: Qt.KeyboardModifier) -> None:
    """Drag over the ruler from one frame to another."""
    kinds = (
        (QEvent.Type.MouseButtonPress, start, LEFT),
        (QEvent.Type.MouseMove, stop, Qt.MouseButton.NoButton),
    )
    for kind, frame, button in kinds:
        place = QPointF(timeline.axis.x_of(frame), 8.0)
        on_screen = timeline.viewport().mapToGlobal(place)
        event = QMouseEvent(kind, place, on_screen, button, LEFT, modifiers)
        QApplication.sendEvent(timeline.viewport(), event)


def turn(
    timeline: Timeline, angle: QPoint, pixels: QPoint = NOTHING, x: float | None = None
) -> None:
    """Turn the wheel over the timeline."""
    place = QPointF(timeline.axis.left + timeline.axis.width / 2 if x is None else x, 60.0)
    event = QWheelEvent(
        place,
        timeline.viewport().mapToGlobal(place),
        pixels,
        angle,
        Qt.MouseButton.NoButton,
        NONE,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(timeline.viewport(), event)


def test_dragging_with_shift_selects_frames_in_both_directions(
    timeline: Timeline, view: ViewState
) -> None:
    view.set_frame(7)
    drag(timeline, 40.5, 80.5, SHIFT)
    assert view.span == (40, 81)
    drag(timeline, 80.5, 40.5, SHIFT)
    assert view.span == (40, 81)
    drag(timeline, 200.5, 400.5, SHIFT)
    assert view.span == (200, view.frames)
    assert view.frame == 7
    drag(timeline, 10.5, 20.5, NONE)
    assert view.span == (200, view.frames)
    assert view.frame == 20


def test_the_selected_frames_are_a_band(timeline: Timeline, view: ViewState) -> None:
    before = timeline.viewport().grab().toImage()
    view.set_span((100, 150))
    after = timeline.viewport().grab().toImage()
    y = timeline.viewport().height() - 4
    for frame, inside in ((95, False), (125, True), (155, False)):
        x = round(timeline.axis.x_of(frame))
        assert (before.pixel(x, y) != after.pixel(x, y)) == inside


def test_an_empty_span_is_none_and_tells_of_it(view: ViewState, qtbot: QtBot) -> None:
    with qtbot.waitSignal(view.span_changed):
        view.set_span((-5, 12))
    assert view.span == (0, 12)
    with qtbot.waitSignal(view.span_changed):
        view.set_span((12, 12))
    assert view.span is None
    with qtbot.assertNotEmitted(view.span_changed):
        view.set_span(None)


def test_keys_select_frames_and_clear_them(workspace: Workspace, qtbot: QtBot) -> None:
    window, view = workspace.window(), workspace.view
    workspace.go_to_frame(50)
    qtbot.keyClick(window, Qt.Key.Key_I)
    assert view.span == (50, view.frames)
    workspace.go_to_frame(90)
    qtbot.keyClick(window, Qt.Key.Key_O)
    assert view.span == (50, 91)
    qtbot.keyClick(window, Qt.Key.Key_Z)
    assert view.visible == (50.0, 91.0)
    qtbot.keyClick(window, Qt.Key.Key_Escape)
    assert view.span is None
    qtbot.keyClick(window, Qt.Key.Key_O)
    assert view.span == (0, 91)


def test_escape_in_a_field_leaves_the_selected_frames(workspace: Workspace, qtbot: QtBot) -> None:
    workspace.view.set_span((50, 60))
    workspace.show_pane(workspace.markers)
    field = workspace.markers.filter
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    qtbot.keyClicks(field, "arm")
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert field.text() == ""
    assert workspace.view.span == (50, 60)


def test_pages_and_the_gap_by_key(workspace: Workspace, qtbot: QtBot) -> None:
    window, view = workspace.window(), workspace.view
    view.set_visible(50, 90)
    qtbot.keyClick(window, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert view.visible == (90.0, 130.0)
    qtbot.keyClick(window, Qt.Key.Key_Left, Qt.KeyboardModifier.ControlModifier)
    assert view.visible == (50.0, 90.0)
    gap = next(g for g in workspace.document.gaps if g.length > 20 and 60 < g.start < 200)
    view.select((gap.marker,))
    view.set_gap(gap)
    qtbot.keyClick(window, Qt.Key.Key_G)
    assert view.visible == (gap.start - gap.length, gap.stop + gap.length)


def test_what_lacks_its_object_says_so(workspace: Workspace, qtbot: QtBot) -> None:
    workspace.view.set_gap(None)
    for use in (workspace.time.frame_gap, workspace.time.zoom_to_span):
        with qtbot.waitSignal(workspace.message):
            use()


def test_events_by_key_and_by_click(workspace: Workspace, qtbot: QtBot) -> None:
    window, view, timeline = workspace.window(), workspace.view, workspace.timeline
    frames = [round(event.frame) for event in workspace.document.source.events]
    workspace.go_to_frame(0)
    for frame in frames:
        qtbot.keyClick(window, Qt.Key.Key_E)
        assert view.frame == frame
    qtbot.keyClick(window, Qt.Key.Key_E)
    assert view.frame == frames[0]
    qtbot.keyClick(window, Qt.Key.Key_E, SHIFT)
    assert view.frame == frames[-1]
    place = QPoint(round(timeline.axis.x_of(frames[3] + 0.5)) + 3, timeline._layout.ruler + 5)
    qtbot.mouseClick(timeline.viewport(), LEFT, pos=place)
    assert view.frame == frames[3]
    tip = timeline.tip_at(QPointF(place))
    first = workspace.document.original.first_frame
    assert tip == f"Right Foot Off, frame {frames[3] + first}, 0.74 s"


def test_a_file_without_events_has_no_lane_for_them(
    open_in: Open, sprint: Path, qtbot: QtBot
) -> None:
    workspace = open_in(sprint).workspace
    assert workspace is not None
    assert workspace.timeline._layout.events == 0
    with qtbot.waitSignal(workspace.message):
        workspace.time.step_event(1)


def test_labels_of_events_never_run_into_the_next_mark() -> None:
    names = ["Left Foot Strike", "Right Foot Off", "Left Foot Off"]
    assert thinned([0, 200, 400], names, len, 600) == names
    assert thinned([0, 20, 400], names, len, 600) == ["L", *names[1:]]
    assert thinned([0, 4, 400], names, len, 402) == ["", names[1], ""]
    assert thinned([], [], len, 600) == []


def test_an_event_is_named_by_what_the_file_has() -> None:
    assert name_of(Event("Foot Strike", "Left", 1.0, 0.0)) == "Left Foot Strike"
    assert name_of(Event("RHS", "", 1.0, 0.0)) == "RHS"
    assert name_of(Event("", "", 1.0, 0.0)) == "Event without a name"


def test_lanes_with_most_missing_first_is_remembered_and_keeps_its_order(
    workspace: Workspace, settings: Settings
) -> None:
    window, timeline, document = workspace.window(), workspace.timeline, workspace.document
    assert isinstance(window, MainWindow)
    window.actions_by_id["most_missing_first"].setChecked(True)
    assert settings.get(MOST_MISSING_FIRST)
    missing = np.isnan(document.points[:, :, 0]).sum(axis=0)

    def shown() -> list[int]:
        return sorted(range(document.original.markers), key=timeline.lane_top)

    order = shown()
    assert (np.diff(missing[order]) <= 0).all()
    assert timeline.marker_at(timeline.lane_top(order[2]) + 1) == order[2]
    workspace.gap_actions.reopen()
    assert shown() == order
    window.actions_by_id["most_missing_first"].setChecked(False)
    assert shown() == list(range(document.original.markers))


def test_the_speed_is_remembered(workspace: Workspace, settings: Settings) -> None:
    workspace.player.step_speed(1)
    assert settings.get(PLAY_SPEED) == 2.0
    assert workspace.player.speed == 2.0


@pytest.mark.parametrize("speed", [0.25, 0.3])
def test_a_remembered_speed_is_used(
    open_in: Open, gait: Path, settings: Settings, speed: float
) -> None:
    settings.set(PLAY_SPEED, speed)
    window = open_in(gait)
    assert window.workspace is not None
    assert window.workspace.player.speed == 0.25
    assert window.transport._speed.currentText() == "0.25 ×"


def test_a_larger_font_makes_room_for_itself(timeline: Timeline) -> None:
    layout = timeline._layout
    gutter, ruler, events = layout.gutter, layout.ruler, layout.events
    font = timeline.font()
    font.setPointSizeF(2 * font.pointSizeF())
    timeline.setFont(font)
    text = timeline.fontMetrics()
    assert layout.gutter > gutter
    assert layout.ruler >= text.height() > ruler - 6
    assert layout.events >= text.height() > events - 4
    assert timeline.axis.left == layout.gutter
    assert timeline.overview.height() >= text.height()
    for title in (timeline.overview.title, *layout.names):
        assert text.horizontalAdvance(title) < layout.gutter


def test_the_wheel_zooms_and_moves_sideways_with_the_fingers(
    timeline: Timeline, view: ViewState
) -> None:
    view.set_visible(100, 200)
    turn(timeline, QPoint(0, 120))
    start, stop = view.visible
    assert 70 < stop - start < 90
    view.set_visible(100, 200)
    turn(timeline, QPoint(60, 8), QPoint(30, 4))
    assert view.visible[0] == pytest.approx(100 - 30 * timeline.axis.frames_per_pixel)
    turn(timeline, QPoint(-60, 8), QPoint(-30, 4))
    assert view.visible == pytest.approx((100.0, 200.0))


def test_the_wheel_over_the_names_scrolls_the_lanes(timeline: Timeline, view: ViewState) -> None:
    visible = view.visible
    turn(timeline, QPoint(0, -120), x=5.0)
    assert timeline.verticalScrollBar().value() > 0
    assert view.visible == visible


def test_a_screen_reader_is_told_what_is_under_the_playhead(
    timeline: Timeline, view: ViewState, document: Document, qtbot: QtBot
) -> None:
    gap = next(g for g in document.gaps if g.length > 10 and g.kind(view.frames) == "interior")
    view.go_to(gap)
    first = document.original.first_frame
    missing = int(np.isnan(document.points[view.frame, :, 0]).sum())
    expected = f"Frame {view.frame + first}, {view.frame / 100:.2f} s: {missing} of 56"
    interface = QAccessible.queryAccessibleInterface(timeline)

    def told() -> str:
        return interface.text(QAccessible.Text.Description)

    qtbot.waitUntil(lambda: told().startswith(expected))
    name = document.original.labels[gap.marker]
    assert f"Current gap: {name}: missing from frame {gap.start + first}" in told()
    assert interface.text(QAccessible.Text.Name) == "Timeline"
    view.set_span((5, 10))
    end = f"Selected: frames {5 + first} to {9 + first}."
    qtbot.waitUntil(lambda: told().endswith(end))


def test_no_rest_of_a_time_looks_out_behind_the_number_of_the_playhead(
    timeline: Timeline, view: ViewState
) -> None:
    metrics, marks = timeline.fontMetrics(), timeline._marks
    texts = marks._seconds(metrics, view.visible)
    # The flag covers the beginning of a time: its end and its unit would be left.
    place = next(rect for rect, _ in texts if rect.left() > timeline.axis.left + 100)
    view.set_frame(int(timeline.axis.frame_at(place.left())))
    flag = marks._flag(metrics, view.frame)
    assert flag.right() < place.right() - 3
    picture = timeline.viewport().grab().toImage()
    ratio = picture.devicePixelRatio()
    rest = range(round((flag.right() + 2) * ratio), round(place.right() * ratio))
    line = range(2, round((timeline._layout.ruler - 6) * ratio))
    assert {picture.pixelColor(x, y).name() for x in rest for y in line} == {DARK.window}
    view.set_frame(0)
    picture = timeline.viewport().grab().toImage()
    assert {picture.pixelColor(x, y).name() for x in rest for y in line} != {DARK.window}
