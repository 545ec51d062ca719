"""What mouse, keyboard and switches do in the 3D view."""

from collections.abc import Callable
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from mocapmend.document import Document
from mocapmend.settings import SHOWN, TRAIL_SECONDS, Settings
from mocapmend.theme import DARK
from mocapmend.views import scene_picture
from mocapmend.views.action_calls import SWITCHES
from mocapmend.views.main_window import MainWindow
from mocapmend.views.scene import Scene
from mocapmend.viewstate import ViewState

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
PLAIN, CONTROL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def view(document: Document) -> ViewState:
    return ViewState(document.original.frames)


@pytest.fixture
def scene(document: Document, view: ViewState, qtbot: QtBot) -> Scene:
    made = Scene(document, view, DARK)
    qtbot.addWidget(made)
    made.resize(800, 500)
    made.show()
    qtbot.waitExposed(made)
    return made


def places(scene: Scene) -> np.ndarray:
    scene.grab()
    return scene._project(scene._current_points())


def drag(
    scene: Scene,
    start: QPoint,
    stop: QPoint,
    button: Qt.MouseButton,
    keys: Qt.KeyboardModifier = PLAIN,
    *,
    release: bool = True,
) -> None:
    QTest.mousePress(scene, button, keys, start)
    # The test library's moves press no button.
    for at in ((start + stop) / 2, stop):
        move(scene, at, button, keys)
    if release:
        QTest.mouseRelease(scene, button, keys, stop)


def move(scene: Scene, at: QPoint, button: Qt.MouseButton, keys: Qt.KeyboardModifier) -> None:
    place = QPointF(at)
    kind = QEvent.Type.MouseMove
    none = Qt.MouseButton.NoButton
    QApplication.sendEvent(scene, QMouseEvent(kind, place, place, none, button, keys))


def half(scene: Scene) -> tuple[QPoint, QPoint, set[int]]:
    """Return a box over the left half of the picture, and the markers in it."""
    pixels = places(scene)
    middle = round(float(np.nanmedian(pixels[:, 0])))
    inside = np.flatnonzero((pixels[:, 0] >= 1) & (pixels[:, 0] <= middle))
    seen = (pixels[inside, 1] >= 1) & (pixels[inside, 1] <= 499)
    # A null point would be taken as the middle of the widget.
    return QPoint(1, 1), QPoint(middle, 499), set(inside[seen].tolist())


def test_a_right_drag_selects_the_markers_in_the_box(scene: Scene, view: ViewState) -> None:
    start, stop, inside = half(scene)
    outside = next(m for m in np.flatnonzero(np.isfinite(places(scene)[:, 0])) if m not in inside)
    view.select((int(outside),))
    before = scene.camera.yaw, scene.camera.pitch
    drag(scene, start, stop, RIGHT)
    assert 3 < len(inside) < view_markers(scene)
    assert set(view.selection) == inside
    assert (scene.camera.yaw, scene.camera.pitch) == before


def view_markers(scene: Scene) -> int:
    return int(np.isfinite(places(scene)[:, 0]).sum())


@pytest.mark.parametrize("button", [LEFT, RIGHT])
def test_a_control_drag_adds_the_box_to_the_selection(
    scene: Scene, view: ViewState, button: Qt.MouseButton
) -> None:
    start, stop, inside = half(scene)
    seen = np.flatnonzero(np.isfinite(places(scene)[:, 0])).tolist()
    outside = next(marker for marker in seen if marker not in inside)
    both = (outside, min(inside))
    view.select(both)
    drag(scene, start, stop, button, CONTROL)
    assert view.selection[:2] == both
    assert set(view.selection) == inside | {outside}
    assert len(view.selection) == len(set(view.selection))


def test_the_box_is_seen_while_it_is_drawn_and_escape_abandons_it(
    scene: Scene, view: ViewState
) -> None:
    start, stop, _ = half(scene)
    view.select((2,))
    empty = scene.grab().toImage()
    drag(scene, start, stop, RIGHT, release=False)
    assert scene.grab().toImage() != empty
    QTest.keyClick(scene, Qt.Key.Key_Escape)
    assert scene.grab().toImage() == empty
    move(scene, stop + QPoint(-50, -50), RIGHT, PLAIN)
    QTest.mouseRelease(scene, RIGHT, PLAIN, stop)
    assert view.selection == (2,)
    assert scene.grab().toImage() == empty


def test_a_plain_drag_turns_and_one_with_shift_moves(scene: Scene, view: ViewState) -> None:
    view.select((2,))
    yaw = scene.camera.yaw
    drag(scene, QPoint(100, 100), QPoint(160, 100), LEFT)
    assert scene.camera.yaw != yaw
    yaw = scene.camera.yaw
    before = places(scene)
    drag(scene, QPoint(100, 100), QPoint(160, 120), LEFT, SHIFT)
    moved = places(scene) - before
    assert scene.camera.yaw == yaw
    assert np.nanmedian(moved[:, 0]) > 20
    assert view.selection == (2,)


def test_a_click_selects_and_with_control_toggles(
    scene: Scene, view: ViewState, qtbot: QtBot
) -> None:
    pixels = places(scene)
    inside = [m for m in range(len(pixels)) if np.isfinite(pixels[m, 0])]
    lone = [
        m
        for m in inside
        if np.nanmin(np.hypot(*np.delete(pixels - pixels[m], m, axis=0).T)) > 4
        and scene.rect().contains(QPointF(*pixels[m]).toPoint())
    ]
    one, other = lone[:2]
    qtbot.mouseClick(scene, LEFT, PLAIN, QPointF(*pixels[one]).toPoint())
    assert view.selection == (one,)
    qtbot.mouseClick(scene, LEFT, CONTROL, QPointF(*pixels[other]).toPoint())
    assert view.selection == (one, other)
    qtbot.mouseClick(scene, LEFT, CONTROL, QPointF(*pixels[one]).toPoint())
    assert view.selection == (other,)
    qtbot.mouseClick(scene, RIGHT, PLAIN, QPointF(*pixels[one]).toPoint())
    assert view.selection == (other,)
    qtbot.mouseClick(scene, LEFT, PLAIN, QPoint(2, 2))
    assert view.selection == ()


def test_the_body_that_is_not_followed_stays_where_it_was(scene: Scene, view: ViewState) -> None:
    before = places(scene)
    scene.set_follow(on=False)
    assert np.allclose(places(scene), before, equal_nan=True)
    scene.set_follow(on=False)
    assert np.allclose(places(scene), before, equal_nan=True)
    view.set_frame(view.frames - 1)
    apart = np.nanmedian(np.abs(places(scene) - before))
    scene.set_follow(on=True)
    assert np.nanmedian(np.abs(places(scene) - before)) < apart


@pytest.mark.parametrize("layer", sorted(set(SHOWN) - {"follow", "companion"}))
def test_every_layer_is_seen_when_it_is_on(scene: Scene, view: ViewState, layer: str) -> None:
    scene.layers.clear()
    view.set_frame(150)
    view.select((0, 1))
    empty = scene.grab().toImage()
    scene.set_layer(layer, on=True)
    shown = scene.grab().toImage()
    assert shown != empty
    scene.set_layer(layer, on=False)
    assert scene.grab().toImage() == empty


def test_trails_have_lengths_to_step_through(scene: Scene) -> None:
    assert scene.trail_seconds == TRAIL_SECONDS.default
    lengths = scene_picture.TRAIL_SECONDS
    for _ in lengths:
        scene.step_trails(1)
    assert scene.trail_seconds == lengths[-1]
    for _ in lengths:
        scene.step_trails(-1)
    assert scene.trail_seconds == lengths[0]
    scene.set_trail_seconds(1.7)
    scene.step_trails(1)
    assert scene.trail_seconds == 5.0
    scene.set_trail_seconds(1e9)
    assert scene.trail_seconds == lengths[-1]


def test_keys_do_what_the_mouse_does(scene: Scene, view: ViewState) -> None:
    camera = scene.camera
    yaw, pitch, distance = camera.yaw, camera.pitch, camera.distance
    scene.turn(1, 1)
    assert (camera.yaw - yaw, camera.pitch - pitch) == (15.0, 15.0)
    scene.turn(-1, -1)
    assert (camera.yaw, camera.pitch) == (yaw, pitch)
    scene.approach(1)
    assert camera.distance < distance
    scene.approach(-1)
    assert camera.distance == pytest.approx(distance)
    for _ in range(100):
        scene.approach(-1)
    assert np.isfinite(places(scene)).any()


def test_keys_select_what_is_in_view_as_a_box_does(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    scene, view = window.workspace.scene, window.workspace.view
    qtbot.waitUntil(lambda: window.workspace.arranged)

    def in_view() -> tuple[int, ...]:
        x, y = places(scene).T
        inside = (x >= 0) & (x <= scene.width()) & (y >= 0) & (y <= scene.height())
        return tuple(np.flatnonzero(inside).tolist())

    whole = in_view()
    qtbot.keyClick(window, Qt.Key.Key_A)
    assert view.selection == whole
    scene.centre_on(whole[0])
    scene.approach(5)
    near = in_view()
    assert whole[0] in near
    far = next(marker for marker in whole if marker not in near)
    view.select((far,))
    qtbot.keyClick(window, Qt.Key.Key_A, SHIFT)
    assert view.selection == (far, *near)
    qtbot.keyClick(window, Qt.Key.Key_A)
    assert view.selection == near


@pytest.mark.parametrize("follow", [True, False])
def test_a_marker_is_centred_where_it_is_seen(
    scene: Scene, view: ViewState, document: Document, follow: bool
) -> None:
    scene.set_follow(follow)
    gap = document.gaps[0]
    view.set_frame(gap.start)
    before = places(scene)
    scene.centre_on(gap.marker)
    scene.centre_on(None)
    assert np.array_equal(places(scene), before, equal_nan=True)
    seen = int(np.flatnonzero(np.isfinite(before[:, 0]))[0])
    scene.centre_on(seen)
    assert np.allclose(places(scene)[seen], [400, 250])


def test_a_click_finds_the_marker_of_the_frame_that_is_not_painted_yet(
    scene: Scene, view: ViewState
) -> None:
    scene.set_follow(on=True)
    places(scene)
    view.set_frame(view.frames - 1)
    scene._aim()
    pixels = scene._project(scene._current_points())
    seen = int(np.flatnonzero(np.isfinite(pixels[:, 0]))[0])
    view.set_frame(0)
    places(scene)
    view.set_frame(view.frames - 1)
    assert scene.pick(QPointF(*pixels[seen])) is not None


# --- in the window ---------------------------------------------------------------------------


def test_the_switches_of_the_view_are_remembered(
    open_in: Callable[[Path], MainWindow],
    gait: Path,
    sprint: Path,
    settings: Settings,
    qtbot: QtBot,
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    for name, shown in SHOWN.items():
        assert window.actions_by_id[name].isChecked() == shown.default
        window.actions_by_id[name].trigger()
    window.actions_by_id["longer_trails"].trigger()
    assert window.workspace.scene.trail_seconds == 1.0
    again = MainWindow(settings)
    qtbot.addWidget(again)
    for name, shown in SHOWN.items():
        assert again.actions_by_id[name].isChecked() != shown.default
    changed = window.workspace.scene.layers
    window = open_in(sprint)
    assert window.workspace is not None
    assert window.workspace.scene.layers == changed
    assert window.workspace.scene.trail_seconds == 1.0
    assert not window.workspace.scene.follow


def test_every_switch_of_the_view_has_a_setting() -> None:
    assert set(SHOWN) == {"follow", "companion", *get_args(scene_picture.Layer)}
    assert set(SHOWN) <= set(SWITCHES)


def test_all_markers_are_selected_and_none(
    open_in: Callable[[Path], MainWindow], gait: Path
) -> None:
    window = open_in(gait)
    assert window.workspace is not None
    view = window.workspace.view
    window.workspace.gap_actions.step(1)
    gap, current = view.gap, view.marker
    assert gap is not None
    window.actions_by_id["select_all"].trigger()
    markers = window.workspace.document.original.markers
    assert sorted(view.selection) == list(range(markers))
    assert view.marker == current
    assert view.gap == gap
    window.actions_by_id["select_none"].trigger()
    assert view.selection == ()
    window.actions_by_id["select_all"].trigger()
    assert view.selection == tuple(range(markers))
