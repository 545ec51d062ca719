"""What is computed from trials, against sums made by hand."""

import numpy as np
import pytest
from gap_case_samples import case, trial

from mocapmend.bench.gaps import tables
from mocapmend.bench.gaps.figures import (
    Band,
    Trials,
    band,
    best_single,
    coverage_interval,
    geometric_mean,
    pooled,
    ratios,
)
from mocapmend.bench.gaps.protocols import Protocol
from mocapmend.bench.gaps.tables import best_published_mm, reference_mm
from mocapmend.bench.gaps.targets import targets

P3, P4 = Protocol("P3"), Protocol("P4")


def test_ratios_are_over_the_complete_cases_that_have_a_peer() -> None:
    tried = [
        trial(case("a", tits=5.0, rigid=2.0), "auto", [3.0, 4.0]),
        trial(case("b", tits=5.0), "auto", [10.0]),
        trial(case("open", tits=5.0), "auto", [10.0], left_open=1),
        trial(case("alone"), "auto", [10.0]),
        trial(case("nothing", tits=5.0), "auto", []),
    ]
    rmse = np.sqrt(12.5)
    np.testing.assert_allclose(ratios(tried, reference_mm), [rmse / 5, 2.0])
    np.testing.assert_allclose(ratios(tried, best_published_mm), [rmse / 2, 2.0])
    assert geometric_mean(np.array([0.5, 8.0])) == pytest.approx(2.0)
    assert geometric_mean(np.empty(0)) is None


def test_an_error_of_nothing_can_be_divided() -> None:
    exact = trial(case("a", tits=0.0), "auto", [0.0, 0.0])
    np.testing.assert_array_equal(ratios([exact], reference_mm), [1.0])


def test_the_table_of_a_protocol() -> None:
    first = case("a", tits=4.0, rigid=1.0)
    second = case("b", tits=4.0)
    third = case("c", tits=4.0)
    tried = Trials(
        [
            trial(first, "linear", [2.0, 2.0], [1.0, 3.0], seconds=1.0),
            trial(second, "linear", [8.0], [np.nan], seconds=2.0),
            trial(third, "linear", [5.0], [5.0], left_open=3, seconds=6.0),
        ]
    )
    (row,) = tables.protocols(tried).as_json()
    assert row == {
        "protocol": "P3",
        "method": "linear",
        "cases": 3,
        "filled_cases": 2,
        "left_open": pytest.approx(3 / 7),
        "mean_rmse_mm": pytest.approx(5.0),
        "median_rmse_mm": 5.0,
        "mean_cpu_s": pytest.approx(3.0),
        "compared": 2,
        "to_reference": pytest.approx(1.0),
        "to_reference_p90": pytest.approx(0.5 + 0.9 * 1.5),
        "target": "",
        "to_best": pytest.approx(2.0),
        "to_best_p90": pytest.approx(2.0),
        "coverage": pytest.approx(2 / 3),
        # Radii 1, 3, 5: 1 + 1/0.1, 3, 5. One radius that holds two of 2, 2, 5: 2, 2, 2 + 3/0.1.
        "band_score": pytest.approx(19 / 36),
        "unstated": pytest.approx(1 / 4),
    }
    (held,) = tables.references(tried).as_json()
    assert (held["cases"], held["with_reference"], held["mean_rmse_mm"]) == (3, 3, 4.0)
    assert held["best_mean_rmse_mm"] == pytest.approx(3.0)


def test_a_method_that_leaves_everything_open_has_a_row_of_nothing() -> None:
    tried = Trials([trial(case("a", tits=4.0), "linear", [], left_open=5)])
    for grid in (tables.protocols(tried), tables.overall(tried), tables.cases(tried, {"a": "A"})):
        (row,) = grid.as_json()
        assert row["left_open"] in (1.0, 5)
        assert row.get("to_best") is None
        assert row.get("coverage") is None
        assert "nan" not in grid.as_markdown()


def test_a_band_is_scored_against_one_radius_that_holds_as_many_samples() -> None:
    found = band([trial(case("a"), "auto", [1.0, 2.0, 3.0, 4.0], [2.0, 2.0, 2.0, 5.0])])
    # 2 + 2 + (2 + 1/0.1) + 5 against 3 + 3 + 3 + (3 + 1/0.1).
    assert found == Band(4, 4, 3, pytest.approx(21.0), pytest.approx(22.0))
    assert (found.coverage, found.to_constant) == (0.75, pytest.approx(21 / 22))
    outside = band([trial(case("a"), "auto", [2.0, 4.0], [1.0, np.inf])])
    assert outside == Band(2, 1, 0, pytest.approx(11.0), pytest.approx(20.0))
    assert outside.unstated == 0.5
    assert pooled([found, outside]) == Band(6, 5, 3, pytest.approx(32.0), pytest.approx(42.0))
    assert (Band().coverage, Band().to_constant, Band().unstated) == (None, None, None)


def test_the_interval_of_the_coverage_is_over_recordings() -> None:
    inside = trial(case("a", recording="a"), "auto", [0.5] * 50)
    outside = trial(case("b", recording="b"), "auto", [2.0] * 50)
    assert coverage_interval([inside, outside]) == (0.0, 1.0)
    assert coverage_interval([inside, inside]) is None
    both = [trial(case(name, recording=name), "auto", [0.5, 0.5, 0.5, 2.0]) for name in "abc"]
    assert coverage_interval(both) == (0.75, 0.75)


def test_the_best_single_method_fills_what_the_method_fills() -> None:
    first, second = case("a"), case("b")
    tried = Trials(
        [
            *(trial(each, "auto", [4.0]) for each in (first, second)),
            *(trial(each, "linear", [8.0]) for each in (first, second)),
            trial(first, "cubic", [1.0]),
            trial(second, "cubic", [16.0]),
            trial(first, "pchip", [0.1]),
            trial(second, "pchip", [0.1], left_open=1),
        ]
    )
    assert best_single(tried, P3, "auto") == ("cubic", pytest.approx(1.0))
    assert best_single(tried, P3, "linear") == ("auto", pytest.approx(2.0))
    assert best_single(tried, P4, "auto") == (None, None)


def test_the_targets_of_auto() -> None:
    easy = case("a", "P3", "a", tits=4.0)
    hard = case("b", "P4", "b", tits=8.0, rigid=2.0)
    short = case("c", "P6", "c", length=10, spline=1.0, rigid=3.0)
    tried = Trials(
        [
            trial(easy, "rigid", [4.0], seconds=1.0),
            trial(hard, "rigid", [2.0], seconds=2.0),
            trial(short, "rigid", [3.0], seconds=1.0),
            trial(easy, "auto", [2.0] * 10, [2.0] * 9 + [1.9], seconds=4.0),
            trial(hard, "auto", [4.5] * 10, [5.0] * 10, seconds=4.0),
            trial(short, "auto", [0.5] * 10, [0.4] * 5 + [0.6] * 5, seconds=8.0),
        ]
    )
    rows = {str(row["what"]) + "|" + str(row["against"]): row for row in targets(tried).as_json()}
    figures = {key: (row["figure"], row["target"], row["met"]) for key, row in rows.items()}
    mean, inside = "geometric mean of the RMSE ratios", "share of samples inside r90"
    tits, best = "Tits 2018 MocapRecovery", "best method: rigid"
    assert figures == {
        f"P3: {mean}|{tits}": (pytest.approx(0.5), "<= 0.55", True),
        f"P4: {mean}|{tits}": (pytest.approx(4.5 / 8), "<= 0.75", True),
        f"P6 10 samples: {mean}|cubic spline or 3-donor rigid body": (
            pytest.approx(0.5), "<= 1", True,
        ),
        # Of 0.5, 0.5 and 2.25.
        "all: 90th percentile of the RMSE ratios|best published method": (
            pytest.approx(0.5 + 0.8 * 1.75), "<= 1.5", False,
        ),
        f"P4: cases with more than 2 times the RMSE|{tits} or 3-donor rigid body": (
            1.0, "<= 0", False,
        ),
        f"P3: {mean}|{best}": (pytest.approx(0.5), "<= 1.1", True),
        f"P4: {mean}|{best}": (pytest.approx(2.25), "<= 1.1", False),
        f"P6 10 samples: {mean}|{best}": (pytest.approx(1 / 6), "<= 1.1", True),
        f"all: {inside}|bootstrap over recordings: 0.500 to 1.000": (
            pytest.approx(0.8), ">= 0.88, <= 0.92", False,
        ),
        f"P3: {inside}|": (pytest.approx(0.9), ">= 0.82, <= 0.96", True),
        f"P4: {inside}|": (pytest.approx(1.0), ">= 0.82, <= 0.96", False),
        f"P6 10 samples: {inside}|": (pytest.approx(0.5), ">= 0.82, <= 0.96", False),
        # Radii: 18 + 1.9 + 0.1/0.1, 50, 5 x 0.4 + 5 x 0.1/0.1 + 5 x 0.6. One: 10 x 2, 45, 5.
        "all: interval score|constant bands": (
            pytest.approx((20.9 + 50 + 10) / (20 + 45 + 5)), "<= 1", False,
        ),
        "all: geometric mean of the ratios of CPU time|rigid": (
            pytest.approx((4 * 2 * 8) ** (1 / 3)), "<= 5", True,
        ),
        "all: median of the ratios of CPU time|rigid": (pytest.approx(4.0), "<= 5", True),
    }  # fmt: skip


def test_only_cases_far_worse_than_the_better_peer_count() -> None:
    own = {"a": 7.9, "b": 8.1, "c": 9.0}
    tried = [trial(case(k, "P4", tits=4.0, rigid=9.0), "auto", [rmse]) for k, rmse in own.items()]
    tried.append(trial(case("d", "P3", tits=1.0), "auto", [9.0]))
    (row,) = [row for row in targets(Trials(tried)).as_json() if "2 times" in str(row["what"])]
    assert (row["cases"], row["figure"], row["met"]) == (3, 2.0, False)


def test_auto_alone_has_targets_without_figures() -> None:
    rows = targets(Trials([trial(case("a"), "auto", [], left_open=2)])).as_json()
    assert {row["met"] for row in rows} == {None}
    assert {row["figure"] for row in rows} == {None}
