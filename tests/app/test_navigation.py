"""From gap to gap in the order of time."""

from hypothesis import given
from hypothesis import strategies as st

from mocapmend.navigation import in_time_order, neighbour
from mocapmend_algorithms import Gap

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
