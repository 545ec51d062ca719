"""Playback keeps the time of the clock, at any speed, in a loop too."""

import pytest
from pytestqt.qtbot import QtBot

from mocapmend.views.player import SPEEDS, Player
from mocapmend.viewstate import ViewState

RATE = 120.0


class Clock:
    """A clock that tests turn."""

    def __init__(self) -> None:
        self.time = 1000.0

    def __call__(self) -> float:
        return self.time


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def view(qtbot: QtBot) -> ViewState:
    return ViewState(100_000)


@pytest.fixture
def player(view: ViewState, clock: Clock) -> Player:
    made = Player(view, RATE, clock=clock)
    made._timer.setInterval(10_000_000)
    return made


def play(player: Player, clock: Clock, seconds: float, steps: int) -> None:
    """Let time pass in steps of different length, with a tick after each."""
    begin = clock.time
    for step in range(1, steps + 1):
        clock.time = begin + seconds * (step / steps) ** 1.3
        player._tick()


@pytest.mark.parametrize("speed", SPEEDS)
def test_no_speed_drifts(player: Player, clock: Clock, view: ViewState, speed: float) -> None:
    player.set_speed(speed)
    player.toggle()
    play(player, clock, 100.0, 777)
    assert view.frame == pytest.approx(100.0 * RATE * speed, abs=1)


def test_changes_of_speed_lose_no_part_of_a_frame(
    player: Player, clock: Clock, view: ViewState
) -> None:
    player.toggle()
    for round_ in range(400):
        player.set_speed(SPEEDS[round_ % 2])
        play(player, clock, 0.013, 1)
    expected = 200 * 0.013 * RATE * (SPEEDS[0] + SPEEDS[1])
    assert view.frame == pytest.approx(expected, abs=1)


def test_a_loop_plays_the_selected_frames_and_keeps_time(
    player: Player, clock: Clock, view: ViewState
) -> None:
    player.set_loop(True)
    view.set_span((1000, 1037))
    view.set_frame(5)
    player.toggle()
    assert view.frame == 1000
    seen = set()
    for _ in range(2000):
        play(player, clock, 0.0161, 1)
        seen.add(view.frame)
    assert seen == set(range(1000, 1037))
    assert player.playing
    assert view.frame == pytest.approx(1000 + 2000 * 0.0161 * RATE % 37, abs=1)
    view.set_span(None)
    play(player, clock, 1.0, 10)
    assert view.frame > 1037


def test_without_a_loop_it_stops_at_the_end_and_begins_again(
    player: Player, clock: Clock, view: ViewState
) -> None:
    view.set_frame(view.frames - 10)
    player.toggle()
    play(player, clock, 1.0, 5)
    assert not player.playing
    assert view.frame == view.frames - 1
    player.toggle()
    assert view.frame == 0


def test_a_loop_without_a_selection_begins_again_at_the_end(
    player: Player, clock: Clock, view: ViewState
) -> None:
    player.set_loop(True)
    view.set_frame(view.frames - 12)
    player.toggle()
    play(player, clock, 0.2, 5)
    assert player.playing
    assert view.frame == 12


def test_scrubbing_while_it_plays_goes_on_from_there(
    player: Player, clock: Clock, view: ViewState
) -> None:
    player.toggle()
    play(player, clock, 1.0, 10)
    view.set_frame(5000)
    play(player, clock, 0.0, 1)
    play(player, clock, 2.0, 10)
    assert view.frame == pytest.approx(5000 + 2 * RATE, abs=1)
