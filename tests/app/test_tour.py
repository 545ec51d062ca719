"""The tour shows the real widgets, can be left at any moment, and is shown once."""

from collections.abc import Callable
from pathlib import Path
from weakref import ref

import pytest
from PySide6.QtCore import QRect, Qt
from pytestqt.qtbot import QtBot

from mocapmend.settings import TOUR_SHOWN, Settings
from mocapmend.views import application
from mocapmend.views.callout import Callout, placed
from mocapmend.views.main_window import MainWindow
from mocapmend.views.tables import in_sight
from mocapmend.views.tour import Tour


def tour_of(window: MainWindow) -> Tour:
    assert window._tour is not None
    return window._tour


def is_over(window: MainWindow, qtbot: QtBot) -> bool:
    qtbot.waitUntil(lambda: window._tour is None)
    return not window.findChildren(Callout)


def test_a_window_does_not_begin_it_by_itself(window: MainWindow) -> None:
    assert window._tour is None
    assert not window.settings.get(TOUR_SHOWN)


def test_every_step_leads_to_the_next(window: MainWindow, qtbot: QtBot) -> None:
    window.actions_by_id["tour"].trigger()
    tour = tour_of(window)
    qtbot.waitUntil(tour.callout.isVisible)
    assert window.settings.get(TOUR_SHOWN)
    qtbot.mouseClick(tour.callout.next_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: tour.step == 1, timeout=20_000)
    assert window.workspace is not None
    for step in range(2, 6):
        qtbot.mouseClick(tour.callout.next_button, Qt.MouseButton.LeftButton)
        assert tour.step == step
        qtbot.waitUntil(lambda: tour.callout.points)
    qtbot.mouseClick(tour.callout.next_button, Qt.MouseButton.LeftButton)
    assert is_over(window, qtbot)


def test_doing_what_it_says_goes_on(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    window.start_tour()
    tour = tour_of(window)
    assert tour.step == 1, "something is open already"
    for key, step in ((Qt.Key.Key_M, 1), (Qt.Key.Key_N, 2), (Qt.Key.Key_M, 3)):
        qtbot.keyClick(window, key)
        assert tour.step == step
    window.files.close()
    assert tour.step == 0
    tour.end()
    assert is_over(window, qtbot)


def pointing_at_plots(window: MainWindow, qtbot: QtBot) -> bool:
    """Wait until the tour points at the plots of the recording that is seen."""
    assert window.workspace is not None
    plots = window.workspace.trajectories
    qtbot.waitUntil(lambda: tour_of(window).callout._target is plots)
    return tour_of(window).step == 2


def close(window: MainWindow, qtbot: QtBot) -> None:
    """Close the recording that is seen, and wait until it is gone."""
    assert window.workspace is not None
    plots = ref(window.workspace.trajectories)
    window.files.close()
    qtbot.waitUntil(lambda: plots() is None, timeout=20_000)


def test_it_points_into_the_recording_that_is_seen_and_keeps_no_other(
    open_in: Callable[[Path], MainWindow], gait: Path, sprint: Path, qtbot: QtBot
) -> None:
    open_in(sprint)
    window = open_in(gait)
    window.jobs._garbage.timer.stop()
    window.start_tour()
    tour_of(window)._show(2)
    for _ in range(2):
        assert pointing_at_plots(window, qtbot)
        window.documents.step(1)
    close(window, qtbot)
    assert pointing_at_plots(window, qtbot)
    tour_of(window).end()
    assert is_over(window, qtbot)
    close(window, qtbot)


@pytest.mark.parametrize("how", ["escape", "button"])
def test_it_is_skipped(window: MainWindow, qtbot: QtBot, how: str) -> None:
    window.start_tour()
    tour = tour_of(window)
    qtbot.waitUntil(tour.callout.isVisible)
    if how == "escape":
        qtbot.keyClick(window, Qt.Key.Key_Escape)
    else:
        qtbot.mouseClick(tour.callout.skip_button, Qt.MouseButton.LeftButton)
    assert is_over(window, qtbot)


def test_it_can_be_begun_again(window: MainWindow, qtbot: QtBot) -> None:
    window.start_tour()
    first = tour_of(window)
    window.start_tour()
    qtbot.waitUntil(lambda: len(window.findChildren(Callout)) == 1)
    assert tour_of(window) is not first
    tour_of(window).end()
    assert is_over(window, qtbot)


@pytest.mark.parametrize(("shown", "named", "begins"), [
    (False, False, True),
    (True, False, False),
    (False, True, False),
])  # fmt: skip
def test_the_program_begins_it_once(
    settings: Settings, gait: Path, shown: bool, named: bool, begins: bool
) -> None:
    settings.set(TOUR_SHOWN, shown)
    assert application.wants_tour(settings, gait if named else None) == begins


ROOM = QRect(0, 0, 1000, 700)


@pytest.mark.parametrize("target", [
    QRect(400, 10, 100, 30),
    QRect(400, 650, 100, 30),
    QRect(0, 0, 200, 700),
    QRect(800, 0, 200, 700),
    QRect(0, 500, 1000, 200),
    QRect(980, 0, 20, 20),
])  # fmt: skip
def test_it_stands_beside_what_it_is_about_and_inside_the_window(target: QRect) -> None:
    place, tip = placed(target, 300, 150, ROOM)
    box = QRect(place.x(), place.y(), 300, 150)
    assert ROOM.contains(box)
    assert not box.adjusted(2, 2, -2, -2).intersects(target.adjusted(2, 2, -2, -2))
    assert box.adjusted(-5, -5, 5, 5).contains(tip)


def test_without_room_beside_it_stands_inside() -> None:
    place, tip = placed(ROOM, 300, 150, ROOM)
    assert ROOM.contains(QRect(place.x(), place.y(), 300, 150))
    assert ROOM.contains(tip)


def test_it_points_at_nothing_that_is_behind_another_pane(
    open_in: Callable[[Path], MainWindow], gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    workspace = window.workspace
    assert workspace is not None
    workspace.show_pane(workspace.report)
    qtbot.waitUntil(lambda: in_sight(workspace.report) and not in_sight(workspace.timeline))
    window.start_tour()
    callout = tour_of(window).callout
    qtbot.waitUntil(callout.isVisible)
    assert in_sight(workspace.timeline)
    assert window.rect().contains(callout.geometry())
    tour_of(window).end()
    assert is_over(window, qtbot)
