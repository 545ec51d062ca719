"""DonorDistances between markers, and which of them are the best donors."""

import numpy as np
import pytest
from donor_samples import body, scattered
from hypothesis import given, settings
from hypothesis import strategies as st

from mocapmend_algorithms.fill.donors import (
    MOST_FRAMES,
    DonorDistances,
    Donors,
    by_label,
    edges_seen,
)
from mocapmend_algorithms.gaps import Gap


def measured(points):
    return DonorDistances(points, ~np.isnan(points[:, :, 0]))


def clipped(apart):
    """Distances without the extremes of one in a hundred frames at each end."""
    known = np.sort(apart[~np.isnan(apart)])
    low, high = np.round(np.array([0.01, 0.99]) * (known.size - 1)).astype(int)
    return np.clip(known, known[low], known[high])


@pytest.mark.parametrize("share", [0.0, 0.4])
def test_distances_are_those_of_the_frames_with_both(share):
    points = scattered(body(300, 7), share)
    known = measured(points).to(2)
    assert known.markers.tolist() == [0, 1, 3, 4, 5, 6]
    for marker, spread, mean in zip(known.markers, known.spread, known.distance, strict=True):
        apart = clipped(np.linalg.norm(points[:, marker] - points[:, 2], axis=1))
        assert mean == pytest.approx(apart.mean(), rel=1e-12)
        assert spread == pytest.approx(apart.std(), rel=1e-9)


def test_a_spike_does_not_hide_a_rigid_pair():
    points = body(300, 7)
    before = measured(points).to(0)
    points[150, 3] += 2000.0
    after = measured(points).to(0)
    assert after.spread[2] < before.spread[2] + 1.0


def test_long_recordings_are_measured_on_some_frames():
    points = body(5000, 3)
    known = measured(points).to(0)
    apart = np.linalg.norm(points[:, 1:] - points[:, :1], axis=2)
    some = apart[np.linspace(0, 4999, MOST_FRAMES).astype(int)]
    means = [clipped(column).mean() for column in some.T]
    np.testing.assert_allclose(known.distance, means, rtol=1e-12)
    np.testing.assert_allclose(known.distance, apart.mean(axis=0), rtol=0.01)


def test_markers_that_are_hardly_seen_together_are_no_donors():
    points = body(100, 4)
    points[2:, 1] = np.nan
    points[:50, 2] = np.nan
    points[50:, 3] = np.nan
    distances = measured(points)
    assert distances.to(0).markers.tolist() == [2, 3]
    assert distances.to(2).markers.tolist() == [0]


def test_samples_that_may_not_be_looked_at_are_not():
    points = body(100, 4)
    observed = np.ones((100, 4), dtype=bool)
    observed[20:60, 1] = False
    before = DonorDistances(points, observed).to(0)
    points[20:60, 1] += 1e4
    after = DonorDistances(points, observed).to(0)
    np.testing.assert_array_equal(after.spread, before.spread)
    np.testing.assert_array_equal(after.distance, before.distance)


def test_the_best_donors_are_rigid_and_near():
    donors = Donors(np.array([4, 7, 9]), np.array([1.0, 3.0, 2.0]), np.array([900.0, 50.0, 90.0]))
    assert donors.best(2).tolist() == [0, 2]
    assert donors.best(9).tolist() == [0, 2, 1]
    assert donors.best(3, nearness=0.02).tolist() == [2, 1, 0]
    assert donors[donors.best(1)].markers.tolist() == [4]


@settings(max_examples=30)
@given(height=st.floats(0, 60), order=st.permutations(range(3)))
def test_three_markers_in_one_line_are_no_triangle(height, order):
    # The first three are the stiffest; the fourth makes a triangle with any two of them.
    places = np.array([[50.0, 0, 0], [150, 0, 0], [60, height, 0]])[order]
    shape = np.concatenate(([[0.0, 0, 90]], places, [[100, 80, 0]]))
    points = np.tile(shape, (50, 1, 1))
    points[:, 4] += np.random.default_rng(0).normal(0, 3, (50, 3))
    distances = measured(points)
    known = distances.to(0)
    corners = known.markers[distances.triangle(known)]
    assert (4 in corners) == (height <= 5.0)
    assert corners.size == 3


def test_where_all_are_in_one_line_the_best_are_taken():
    shape = np.array([[0.0, 50, 0], [1, 0, 0], [50, 0, 0], [90, 0, 0], [90, 0, 0]])
    points = np.tile(shape, (50, 1, 1)) + np.arange(50)[:, None, None]
    distances = measured(points)
    known = distances.to(0)
    assert distances.triangle(known).tolist() == known.best(3).tolist()


def test_labels_are_found_in_the_order_given():
    assert by_label(["A", "B", "C"], ["C", "A"]).tolist() == [2, 0]
    assert by_label(["A"], []).size == 0


@pytest.mark.parametrize(
    ("gap", "seen"),
    [
        (Gap(0, 3, 5), [False, True, False]),
        (Gap(0, 0, 5), [True, True, False]),
        (Gap(0, 3, 8), [False, True, True]),
        (Gap(0, 0, 8), [True, True, True]),
    ],
)
def test_the_frames_beside_a_gap(gap, seen):
    observed = np.ones((8, 3), dtype=bool)
    observed[2, 0] = observed[5, 2] = False
    assert edges_seen(observed, gap).tolist() == seen
