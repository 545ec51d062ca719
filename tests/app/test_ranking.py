"""Problems in order, and what is kept of the repairs that were tried."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.prospects import Preview, Prospects, Way
from mocapmend.ranking import Problem, Status, by_harm, rank
from mocapmend_algorithms import Gap, Recording, find_gaps, no_progress
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled


def patch(gap: Gap, sigma: float) -> Patch:
    return Patch(
        gap, np.zeros((gap.length, 3)), np.full(gap.length, sigma), np.full(gap.length, sigma)
    )


def problem(gap: Gap, sigma: float) -> Problem:
    way = Way.default("cubic")
    return Problem(gap, Status.OPEN, Preview(gap, *way, patch(gap, sigma)), tried=True)


def test_harm_is_error_times_length_and_the_unknown_comes_last() -> None:
    short, long, unknown = Gap(0, 5, 6), Gap(1, 0, 100), Gap(2, 3, 5)
    one, other = problem(short, 10.0), problem(long, 1.0)
    assert math.isclose(one.harm, 10.0 * math.sqrt(3.0))
    assert math.isclose(other.harm, 100.0 * math.sqrt(3.0))
    third = Problem(unknown, Status.OPEN)
    assert math.isnan(third.harm)
    assert [p.gap for p in by_harm([third, one, other])] == [long, short, unknown]


@given(st.lists(st.tuples(st.integers(0, 4), st.integers(0, 9)), unique=True))
def test_what_is_alike_is_in_the_order_of_time(places: list[tuple[int, int]]) -> None:
    problems = [problem(Gap(marker, start, start + 2), 1.0) for marker, start in places]
    in_time = sorted(problems, key=lambda p: (p.gap.start, p.gap.marker))
    assert by_harm(problems) == in_time


def test_the_best_is_the_least_known_error() -> None:
    prospects, gap = Prospects(), Gap(0, 4, 8)
    ways = [Way.default(name) for name in ("linear", "cubic", "pchip", "rigid")]
    assert not prospects.tried(gap)
    for way, sigma in zip(ways, (2.0, 1.0, math.nan), strict=False):
        prospects.add(way, [gap], FillResult((patch(gap, sigma),)))
    prospects.add(ways[3], [gap], FillResult((), (Unfilled(gap, "too few donors"),)))
    best = prospects.best(gap)
    assert best is not None
    assert best.method == "cubic"
    refused = prospects.get(gap, ways[3])
    assert refused is not None
    assert (refused.patch, refused.reason) == (None, "too few donors")
    other = Gap(0, 20, 22)
    result, unknown = prospects.result(ways[3], [other, gap])
    assert (result.unfilled, unknown) == ((Unfilled(gap, "too few donors"),), [other])


def test_ranking_puts_the_long_loss_of_a_moving_marker_first() -> None:
    seconds = np.arange(300) / 100.0
    points = np.stack(
        [
            np.stack((a * np.sin(7 * seconds + a), a * np.cos(5 * seconds), seconds), axis=1)
            for a in (1.0, 50.0, 100.0, 200.0)
        ],
        axis=1,
    )
    points[100:104, 0] = points[50:54, 3] = points[150:210, 3] = np.nan
    recording = Recording(points, ("a", "b", "c", "d"), 100.0)
    shares: list[float] = []
    found = rank(recording, find_gaps(recording.present), shares.append)
    assert found[0].gap == Gap(3, 150, 210)
    assert all(p.tried for p in found)
    assert shares == sorted(shares)
    assert rank(recording, [], no_progress) == []
