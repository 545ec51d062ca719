"""Closed forms of the interpolations."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, PchipInterpolator
from synthetic import fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap, find_gaps


def fill_one(variant, points, gap):
    (patch,) = fill_with(variant, record(punch(points, [gap])), [gap]).patches
    return patch.values


@pytest.mark.parametrize(
    ("hold", "expected"), [("before", [4] * 5), ("after", [10] * 5), ("nearest", [4, 4, 4, 10, 10])]
)
def test_constant_holds_an_edge(hold, expected):
    points = np.arange(20.0)[:, None, None] * np.ones((1, 3))
    values = fill_one(("constant", {"hold": hold}), points, Gap(0, 5, 10))
    np.testing.assert_array_equal(values[:, 0], expected)


def test_linear_is_numpy_interp():
    points = smooth_motion(60, 1)
    values = fill_one(("linear", {}), points, Gap(0, 20, 33))
    edges = [19, 33]
    for axis in range(3):
        expected = np.interp(np.arange(20, 33), edges, points[edges, 0, axis])
        np.testing.assert_allclose(values[:, axis], expected, rtol=1e-12)


@settings(max_examples=30)
@given(
    seed=st.integers(0, 10_000),
    before=st.integers(1, 30),
    length=st.integers(1, 40),
    after=st.integers(1, 30),
)
def test_cubic_recovers_cubic_polynomials(seed, before, length, after):
    if before + after < 4:
        after = 4 - before
    frames = before + length + after
    time = np.linspace(-1, 1, frames)
    factors = np.random.default_rng(seed).normal(0, 500, (4, 1, 3))
    points = sum(f * time[:, None, None] ** power for power, f in enumerate(factors))
    gap = Gap(0, before, before + length)
    values = fill_one(("cubic", {}), points, gap)
    # One sample on a side pins the curve down through the far end: digits are lost, not shape.
    np.testing.assert_allclose(values, points[gap.start : gap.stop, 0], atol=1e-3)


@pytest.mark.parametrize("length", [1, 12, 24, 60])
@pytest.mark.parametrize("seed", range(3))
def test_cubic_window_equals_the_spline_through_the_whole_recording(length, seed):
    points = smooth_motion(300, 1, seed=seed)
    points += np.random.default_rng(seed).normal(0, 0.1, points.shape)
    gap = Gap(0, 120, 120 + length)
    values = fill_one(("cubic", {}), points, gap)
    seen = np.delete(np.arange(300), np.s_[120 : 120 + length])
    whole = CubicSpline(seen, points[seen, 0])(np.arange(120, 120 + length))
    assert np.abs(values - whole).max() < 1e-6 * np.ptp(points)


def test_pchip_equals_the_curve_through_the_whole_recording():
    points = smooth_motion(100, 1)
    values = fill_one(("pchip", {}), points, Gap(0, 40, 60))
    seen = np.delete(np.arange(100), np.s_[40:60])
    whole = PchipInterpolator(seen, points[seen, 0])(np.arange(40, 60))
    np.testing.assert_allclose(values, whole, rtol=1e-9, atol=1e-9)


def test_pchip_does_not_overshoot():
    points = smooth_motion(100, 1)
    points[60:] += 300
    values = fill_one(("pchip", {}), points, Gap(0, 40, 60))
    low, high = np.sort(points[[39, 60], 0], axis=0)
    assert (values >= low - 1e-9).all()
    assert (values <= high + 1e-9).all()


def test_cubic_says_what_it_lacks():
    points = np.full((20, 1, 3), np.nan)
    points[[3, 9, 10]] = 1.0
    recording = record(points)
    gap = next(g for g in find_gaps(recording.present) if g.start == 4)
    (unfilled,) = fill_with(("cubic", {}), recording, [gap]).unfilled
    assert unfilled.reason == "a cubic curve needs 4 samples, and the marker has only 3"
    assert fill_with(("pchip", {}), recording, [gap]).patches
