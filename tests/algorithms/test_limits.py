"""Which gaps stay open, and what the user is told."""

import math

import numpy as np
import pytest
from synthetic import punch, record, smooth_motion

from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.fill.limits import Limits, fill_within
from mocapmend_algorithms.fill.registry import METHODS, Method

SHORT, FIFTH, LONG, VERY_LONG = (
    Gap(0, 40, 45),
    Gap(0, 80, 100),
    Gap(0, 130, 151),
    Gap(0, 200, 260),
)
GAPS = [SHORT, FIFTH, LONG, VERY_LONG]


def stub(method_id, error_mm, asked=None, *, fills_edges=False):
    """A method whose 3-D RMS error is known, or unknown (NaN)."""

    def function(recording, gaps, params, progress, /):
        if asked is not None:
            asked.extend(gaps)
        sigma = {gap: error_mm / math.sqrt(3) / recording.mm for gap in gaps}
        return FillResult(
            tuple(
                Patch(g, np.zeros((g.length, 3)), *[np.full(g.length, sigma[g])] * 2) for g in gaps
            )
        )

    return Method(method_id, "Stub", "Interpolation", function, type(None), "", fills_edges)


def outcome(method, limits, *, gaps=GAPS, unit="mm"):
    recording = record(punch(smooth_motion(300, 1), gaps), unit=unit)
    result = fill_within(recording, gaps, method, None, limits, no_progress)
    left = {unfilled.gap: unfilled.reason for unfilled in result.unfilled}
    assert [gap for gap in gaps if gap in left] == list(left)
    assert {patch.gap for patch in result.patches} | set(left) == set(gaps)
    return left


@pytest.mark.parametrize("method_id", ["constant", "linear", "cubic", "pchip", "woltring"])
def test_by_default_interpolation_stops_at_a_fifth_of_a_second(method_id):
    asked = []
    left = outcome(stub(method_id, 1.0, asked), Limits())
    assert asked == [SHORT, FIFTH]
    assert left == {
        LONG: "21 frames (210 ms) is longer than the default limit of 20 frames (200 ms)",
        VERY_LONG: "60 frames (600 ms) is longer than the default limit of 20 frames (200 ms)",
    }


@pytest.mark.parametrize("method_id", ["cubic", "kalman"])
@pytest.mark.parametrize("unit", ["mm", "m"])
def test_by_default_errors_above_20_mm_stay_open(method_id, unit):
    left = outcome(stub(method_id, 34.2), Limits(), gaps=[SHORT], unit=unit)
    assert left == {SHORT: "the expected error of 34 mm is above the default limit of 20 mm"}
    assert not outcome(stub(method_id, 19.9), Limits(), gaps=[SHORT], unit=unit)


@pytest.mark.parametrize("limits", [Limits(), Limits(max_error_mm=40)])
def test_an_interpolation_without_an_estimate_stops_at_a_fifth_of_a_second(limits):
    left = outcome(stub("cubic", math.nan), limits)
    assert list(left) == [LONG, VERY_LONG]
    if not limits.default:
        assert left[LONG] == (
            "its error could not be estimated, and 21 frames (210 ms) is longer than the "
            "20 frames (200 ms) allowed in that case"
        )


@pytest.mark.parametrize("limits", [Limits(), Limits(max_error_mm=40)])
@pytest.mark.parametrize("method_id", ["auto", "rigid", "pca-r2", "kalman", "cyclic"])
def test_a_model_that_could_not_be_tested_fills_nothing(method_id, limits):
    left = outcome(stub(method_id, math.nan), limits)
    assert list(left) == GAPS
    assert set(left.values()) == {
        "its error could not be estimated: there is nothing like it to test this method on"
    }
    assert not outcome(stub(method_id, 5.0), limits)


def test_a_length_limit_replaces_the_guards():
    asked = []
    left = outcome(stub("cubic", 500.0, asked), Limits(max_gap=28))
    assert asked == [SHORT, FIFTH, LONG]
    assert left == {VERY_LONG: "60 frames (600 ms) is longer than the limit of 28 frames (280 ms)"}
    assert not outcome(stub("cubic", math.nan), Limits(max_gap=1000))


def test_a_length_limit_of_zero_fills_nothing():
    asked = []
    left = outcome(stub("kalman", 1.0, asked), Limits(max_gap=0))
    assert not asked
    assert list(left) == GAPS
    assert left[SHORT] == "5 frames (50 ms) is longer than the limit of 0 frames (0 ms)"


def test_an_error_limit_replaces_the_guards():
    assert not outcome(stub("cubic", 34.0), Limits(max_error_mm=40))
    left = outcome(stub("cubic", 34.0), Limits(max_error_mm=33.9))
    assert list(left) == GAPS
    assert left[LONG] == "the expected error of 34.0 mm is above the limit of 33.9 mm"
    assert list(outcome(stub("cubic", math.nan), Limits(max_error_mm=40))) == [LONG, VERY_LONG]


def test_an_infinite_error_limit_fills_all():
    assert not outcome(stub("cubic", 1e6), Limits(max_error_mm=math.inf))
    assert not outcome(stub("cubic", math.nan), Limits(max_error_mm=math.inf))


def test_both_limits_hold():
    left = outcome(stub("cubic", 30.0), Limits(max_gap=30, max_error_mm=25))
    assert "longer" in left.pop(VERY_LONG)
    assert list(left) == [SHORT, FIFTH, LONG]
    assert all("expected error" in reason for reason in left.values())
    assert list(outcome(stub("cubic", 30.0), Limits(max_gap=30, max_error_mm=35))) == [VERY_LONG]


def test_the_methods_own_reasons_pass():
    gap = Gap(0, 0, 50)
    recording = record(punch(smooth_motion(100, 1), [gap]), first_frame=1)
    for method in (m for m in METHODS.values() if not m.fills_edges):
        result = fill_within(recording, [gap], method, method.params(), Limits(), no_progress)
        assert result.unfilled == (
            Unfilled(gap, "the marker is never seen before frame 51: this method needs both sides"),
        )
    left = outcome(stub("cubic", 1.0, fills_edges=True), Limits(), gaps=[gap])
    assert "longer" in left[gap]
    hold = METHODS["cubic"].params(edges="hold")
    (left,) = fill_within(recording, [gap], METHODS["cubic"], hold, Limits(), no_progress).unfilled
    assert "longer" in left.reason


@pytest.mark.parametrize(
    ("rate", "frames"),
    [(25.0, 5), (60.0, 12), (65.05, 13), (100.0, 20), (120.0, 24), (1000.0, 200)],
)
def test_a_fifth_of_a_second_in_frames(rate, frames):
    gaps = [Gap(0, 300, 300 + frames), Gap(1, 300, 301 + frames)]
    recording = record(punch(smooth_motion(900, 2, rate=rate), gaps), rate=rate)
    asked = []
    fill_within(recording, gaps, stub("cubic", 1.0, asked), None, Limits(), no_progress)
    assert asked == gaps[:1]


def test_real_methods_within_the_limits():
    # An up and down of 2 s on a wandering path: periodic, but no method is exact to 20 mm.
    wave = np.sin(np.arange(1000) / 100 * np.pi)[:, None, None] * [[300.0, 200.0, 900.0]]
    points = wave + 0.1 * smooth_motion(1000, 1)
    gaps = [Gap(0, 100, 110), Gap(0, 500, 640)]
    recording = record(punch(points, gaps))
    gaps = find_gaps(recording.present)
    for method in (m for m in METHODS.values() if not m.fills_edges):
        result = fill_within(recording, gaps, method, method.params(), Limits(), no_progress)
        assert [u.gap for u in result.unfilled][-1] == gaps[1]
        everything = Limits(max_error_mm=math.inf)
        result = fill_within(recording, gaps, method, method.params(), everything, no_progress)
        assert [p.gap for p in result.patches] == gaps
