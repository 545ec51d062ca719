"""Measures against closed forms."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from synthetic import record, smooth_motion

from mocapmend_algorithms.metrics import (
    bone_lengths,
    bone_spread,
    error_summary,
    smoothness,
    success_curves,
    tracked,
)


def test_tracked_is_present_not_bad_and_near_the_reference():
    points = np.zeros((2, 4, 3))
    points[0, 0] = np.nan
    points[1, 2, 1] = 9.9
    points[1, 3, 1] = 10.1
    bad = np.zeros((2, 4), dtype=bool)
    bad[0, 1] = True
    reference = np.zeros((2, 4, 3))
    reference[0, 3] = np.nan
    good = tracked(record(points), bad=bad, reference=record(reference))
    np.testing.assert_array_equal(good, [[0, 0, 1, 1], [1, 1, 1, 0]])
    metres = tracked(record(points / 1000, unit="m"), bad=bad, reference=reference / 1000)
    np.testing.assert_array_equal(metres, good)
    np.testing.assert_array_equal(tracked(points)[0], [0, 1, 1, 1])
    assert tracked(points, reference=reference, tolerance=20.0)[1].all()


def test_bare_coordinates_need_a_tolerance():
    with pytest.raises(ValueError, match="give the tolerance"):
        tracked(np.zeros((2, 1, 3)), reference=np.zeros((2, 1, 3)))


def test_the_three_curves():
    good = np.array([[1, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=bool)
    curves = success_curves(good)
    np.testing.assert_allclose(curves.instantaneous, [1, 0.5, 1, 0.5])
    np.testing.assert_allclose(curves.running_mean, [1, 0.75, 2.5 / 3, 0.75])
    np.testing.assert_allclose(curves.survival, [1, 0.5, 0.5, 0])
    all_three = success_curves(good, counted=np.ones(3, dtype=bool))
    np.testing.assert_allclose(all_three.instantaneous, np.array([2, 1, 2, 1]) / 3)


def test_a_segment_is_tracked_when_all_its_markers_are():
    good = np.array([[1, 1, 1, 0], [1, 0, 1, 0]], dtype=bool)
    curves = success_curves(good, segments=[[0, 1], [2, 3], [3]])
    np.testing.assert_allclose(curves.instantaneous, [1, 0.5])


@pytest.mark.parametrize("segments", [None, [[0], [1]]])
def test_nothing_to_count_is_nan(segments):
    curves = success_curves(np.zeros((5, 2), dtype=bool), segments=segments)
    assert np.isnan(curves.instantaneous).all()
    assert curves.survival.shape == (5,)


@given(hnp.arrays(bool, hnp.array_shapes(min_dims=2, max_dims=2, max_side=20)))
def test_survival_only_falls_and_never_exceeds_the_share(good):
    counted = np.ones(good.shape[1], dtype=bool)
    curves = success_curves(good, counted=counted)
    assert (np.diff(curves.survival) <= 0).all()
    assert (curves.survival <= curves.instantaneous).all()
    assert curves.running_mean[-1] == pytest.approx(good.mean())


def test_bones():
    points = np.zeros((3, 3, 3))
    points[:, 1, 0] = [90, 100, 110]
    points[:, 2, 1] = [5, np.nan, np.nan]
    lengths = bone_lengths(points, np.array([[0, 1], [0, 2], [0, 0]]))
    np.testing.assert_array_equal(lengths[:, 0], [90, 100, 110])
    spread = bone_spread(lengths)
    assert spread[0] == pytest.approx(100 * np.std([90, 100, 110]) / 100)
    assert np.isnan(spread[1:]).all()
    assert bone_lengths(points, np.empty((0, 2), dtype=int)).shape == (3, 0)
    assert bone_spread(np.empty((3, 0))).shape == (0,)
    assert np.isnan(bone_spread(np.empty((0, 2)))).all()


@given(frames=st.integers(1, 700), seed=st.integers(0, 99))
def test_bone_lengths_are_the_distances_of_their_ends(frames, seed):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(frames, 5, 3))
    points[rng.random((frames, 5)) < 0.2] = np.nan
    bones = rng.integers(0, 5, (4, 2))
    expected = np.linalg.norm(points[:, bones[:, 0]] - points[:, bones[:, 1]], axis=2)
    np.testing.assert_allclose(bone_lengths(points, bones), expected, rtol=1e-12)


def test_error_summary():
    reference = smooth_motion(50, 2)
    points = reference + np.array([3.0, 0, 4.0])
    mask = np.zeros((50, 2), dtype=bool)
    mask[10:20, 1] = True
    points[10:12, 1] = np.nan
    summary = error_summary(points, reference, mask)
    assert (summary.samples, summary.left_open) == (8, 2)
    for value in (summary.rmse, summary.mean, summary.median, summary.p95):
        assert value == pytest.approx(5)
    nothing = error_summary(points, reference, np.zeros_like(mask))
    assert nothing.samples == 0
    assert np.isnan(nothing.rmse)


def test_smoothness():
    time = np.arange(20.0)
    points = (time**2)[:, None, None] * [[[1.0, 2.0, 2.0]]]
    assert smoothness(points) == pytest.approx(4 * 9)
    points[::3] = np.nan
    assert np.isnan(smoothness(points))
