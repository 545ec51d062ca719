"""Exchanging samples and setting them aside."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import (
    Exchange,
    Move,
    corrected,
    exchange,
    exchanges_between,
    merged_runs,
    moved,
    moves,
    places_now,
    stored_places,
)

FRAMES, MARKERS = 12, 4


def numbered() -> Recording:
    """Make a recording in which each sample says where it was stored."""
    points = np.arange(FRAMES * MARKERS * 3, dtype=np.float64).reshape(FRAMES, MARKERS, 3)
    return Recording(points, ("A", "B", "C", "D"), 100.0)


@st.composite
def exchanges(draw: st.DrawFn) -> Exchange:
    first = draw(st.integers(0, MARKERS - 1))
    second = draw(st.integers(0, MARKERS - 1).filter(lambda marker: marker != first))
    start = draw(st.integers(0, FRAMES - 1))
    return Exchange(first, second, start, draw(st.integers(start + 1, FRAMES)))


def test_two_markers_change_places() -> None:
    recording = numbered()
    after = corrected(recording, [Exchange(0, 2, 3, 7)], ())
    assert np.array_equal(after.points[3:7, 0], recording.points[3:7, 2])
    assert np.array_equal(after.points[3:7, 2], recording.points[3:7, 0])
    untouched = np.ones((FRAMES, MARKERS), bool)
    untouched[3:7, [0, 2]] = False
    assert np.array_equal(after.points[untouched], recording.points[untouched])


def test_a_missing_sample_is_exchanged_like_any_other() -> None:
    points = numbered().points.copy()
    points[4:9, 1] = np.nan
    recording = numbered().with_points(points)
    after = corrected(recording, [Exchange(1, 3, 4, 9)], ())
    assert np.array_equal(after.points[4:9, 1], recording.points[4:9, 3])
    assert np.isnan(after.points[4:9, 3]).all()


def test_what_is_set_aside_is_missing_after_the_exchange() -> None:
    after = corrected(numbered(), [Exchange(0, 1, 0, 6)], [Gap(0, 2, 4)])
    assert np.isnan(after.points[2:4, 0]).all()
    assert np.count_nonzero(np.isnan(after.points)) == 6


@given(st.lists(exchanges(), max_size=6))
def test_exchanges_backwards_undo_them(given_exchanges: list[Exchange]) -> None:
    origins = stored_places((FRAMES, MARKERS))
    exchange(origins, given_exchanges)
    exchange(origins, reversed(given_exchanges))
    assert np.array_equal(origins, stored_places((FRAMES, MARKERS)))
    assert moves(origins) == []


@given(st.lists(exchanges(), max_size=6), st.lists(exchanges(), max_size=6))
def test_any_origins_become_any_others_by_exchanges(
    first: list[Exchange], second: list[Exchange]
) -> None:
    now, wanted = (stored_places((FRAMES, MARKERS)) for _ in range(2))
    exchange(now, first)
    exchange(wanted, second)
    found = exchanges_between(now, wanted)
    starts = [each.start for each in found]
    assert starts == sorted(starts)
    exchange(now, found)
    assert np.array_equal(now, wanted)
    assert exchanges_between(now, wanted) == []


@given(st.lists(exchanges(), max_size=6))
def test_moves_say_all(given_exchanges: list[Exchange]) -> None:
    origins, again = stored_places((FRAMES, MARKERS)), stored_places((FRAMES, MARKERS))
    exchange(origins, given_exchanges)
    found = moves(origins)
    moved(again, found)
    assert np.array_equal(again, origins)
    assert sorted(found) == found
    assert all(move.marker != move.origin for move in found)
    frames = np.arange(FRAMES)[:, None]
    assert np.array_equal(origins[frames, places_now(origins)], stored_places((FRAMES, MARKERS)))


@pytest.mark.parametrize(
    "wrong",
    [Exchange(1, 1, 0, 3), Exchange(0, 4, 0, 3), Exchange(0, 1, 3, 3), Exchange(0, 1, 5, 13)],
)
def test_an_impossible_exchange_is_refused(wrong: Exchange) -> None:
    with pytest.raises(ValueError, match=r"cannot be exchanged|not all in"):
        exchange(stored_places((FRAMES, MARKERS)), [wrong])


@pytest.mark.parametrize(
    "wrong",
    [
        [Move(0, 0, 3, 1)],
        [Move(0, 0, 3, 1), Move(1, 0, 2, 0)],
        [Move(0, 0, 30, 1), Move(1, 0, 30, 0)],
        [Move(0, 0, 3, 7)],
    ],
)
def test_moves_that_are_no_exchange_are_refused(wrong: list[Move]) -> None:
    with pytest.raises(ValueError, match=r"in two places|is not in"):
        moved(stored_places((FRAMES, MARKERS)), wrong)


def test_runs_that_touch_become_one() -> None:
    some = [Gap(1, 5, 8), Gap(0, 0, 2), Gap(1, 8, 9), Gap(1, 11, 12), Gap(1, 6, 7)]
    assert list(merged_runs(some)) == [Gap(0, 0, 2), Gap(1, 5, 9), Gap(1, 11, 12)]
