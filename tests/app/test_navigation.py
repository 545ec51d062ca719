"""From gap to gap in the order of time."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.navigation import in_time_order, neighbour, place_to_begin
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.limits import default_frames

GAPS = in_time_order([Gap(1, 5, 9), Gap(0, 20, 30), Gap(2, 5, 6), Gap(3, 0, 100)], frames=100)


def test_markers_that_are_never_seen_are_passed_over() -> None:
    assert GAPS == [Gap(1, 5, 9), Gap(2, 5, 6), Gap(0, 20, 30)]


def test_next_and_previous_go_around_the_ends() -> None:
    assert neighbour(GAPS, 5, 1, 1) == Gap(2, 5, 6)
    assert neighbour(GAPS, 20, 0, 1) == Gap(1, 5, 9)
    assert neighbour(GAPS, 5, 1, -1) == Gap(0, 20, 30)
    assert neighbour(GAPS, 12, -1, 1) == Gap(0, 20, 30)
    assert neighbour(GAPS, 12, -1, -1) == Gap(2, 5, 6)


def test_without_gaps_there_is_nowhere_to_go() -> None:
    assert neighbour([], 0, 0, 1) is None


@given(st.sets(st.tuples(st.integers(0, 3), st.integers(0, 50)), min_size=1))
def test_stepping_visits_every_gap_once_and_returns(places: set[tuple[int, int]]) -> None:
    ordered = in_time_order([Gap(m, s, s + 1) for m, s in places], frames=100)
    for step in (1, -1):
        seen, gap = [], ordered[0]
        for _ in ordered:
            seen.append(gap)
            after = neighbour(ordered, gap.start, gap.marker, step)
            assert after is not None
            gap = after
        assert sorted(seen) == sorted(ordered)
        assert gap == ordered[0]


def begin(
    gaps: list[Gap], frames: int = 100, labels: tuple[str, ...] = ("A", "B", "*2")
) -> Gap | None:
    points = np.ones((frames, len(labels), 3))
    for gap in gaps:
        points[gap.start : gap.stop, gap.marker] = np.nan
    corners = np.array([(g.marker, g.start, g.stop) for g in gaps], np.int64).reshape(-1, 3)
    return place_to_begin(Recording(points, labels, 100.0), corners)


def test_it_begins_at_the_longest_of_the_short_gaps() -> None:
    assert begin([Gap(0, 10, 13), Gap(1, 20, 25), Gap(1, 40, 45)]) == Gap(1, 20, 25)
    longest = default_frames(100.0)
    assert begin([Gap(0, 10, 11 + longest), Gap(1, 60, 62)]) == Gap(1, 60, 62)


def test_it_does_not_begin_where_little_is_seen() -> None:
    ends, fragment = [Gap(0, 0, 5), Gap(0, 96, 100)], Gap(2, 30, 35)
    assert begin([*ends, fragment]) is None
    hardly_seen = [Gap(1, 1, 4), Gap(1, 5, 80)]
    assert begin([*hardly_seen, Gap(0, 50, 51)]) is None
    assert begin([]) is None
