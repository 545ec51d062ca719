"""Samples that a marker jumps to."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from synthetic import smooth_motion

from mocapmend_algorithms.detection import jump_threshold, jumps, wrong_samples


def line(frames):
    points = np.zeros((frames, 1, 3))
    points[:, 0, 0] = np.arange(frames)
    return points


def test_a_jump_is_marked_where_it_arrives():
    points = line(20)
    points[7, 0, 1] = 30.0
    points[15] = np.nan
    assert np.flatnonzero(jumps(points, 10.0)[:, 0]).tolist() == [7, 8]
    assert not jumps(points, 31.0).any()
    assert np.flatnonzero(jumps(points, np.array([0.5]))[:, 0]).tolist() == [
        *range(1, 15),
        *range(17, 20),
    ]


def test_of_a_spike_only_the_spike_is_wrong():
    points = line(40)
    points[7, 0, 1] = 30.0
    points[20:23, 0, 2] = -30.0
    assert np.flatnonzero(wrong_samples(points, 10.0, 5)[:, 0]).tolist() == [7, 20, 21, 22]
    assert np.flatnonzero(wrong_samples(points, 10.0, 2)[:, 0]).tolist() == [7]


def test_beside_a_gap_the_side_that_goes_on_is_right():
    points = line(60)
    points[20:30] = np.nan
    points[[19, 30, 31], 0, 1] = 30.0
    assert np.flatnonzero(wrong_samples(points, 10.0, 5)[:, 0]).tolist() == [19, 30, 31]


def test_where_all_pieces_are_short_nothing_is_judged():
    points = line(6)
    points[3:, 0, 1] = 30.0
    assert not wrong_samples(points, 10.0, 5).any()


def test_a_marker_that_stays_where_it_jumped_to_is_not_wrong():
    points = line(60)
    points[30:, 0, 1] = 30.0
    assert not wrong_samples(points, 10.0, 5).any()


@given(
    seed=st.integers(0, 1000),
    at=st.sets(st.integers(1, 49).map(lambda place: 6 * place), max_size=20),
    missing=st.booleans(),
)
def test_the_threshold_is_that_of_the_motion_whatever_a_few_samples_do(seed, at, missing):
    clean = smooth_motion(300, 2, seed=seed)
    threshold = jump_threshold(clean)
    fastest = np.linalg.norm(np.diff(clean, axis=0), axis=2).max(axis=0)
    assert (threshold > 2 * fastest).all()
    assert not jumps(clean, threshold).any()
    spiked = clean.copy()
    chosen = sorted(at)
    spiked[chosen, 0] += 5000.0
    if missing:
        spiked[120:140] = np.nan
        chosen = [frame for frame in chosen if not 120 <= frame < 140]
    known = jump_threshold(spiked)
    np.testing.assert_allclose(known, threshold, rtol=0.5)
    wrong = wrong_samples(spiked, known, 2)
    assert np.flatnonzero(wrong[:, 0]).tolist() == chosen
    assert not wrong[:, 1].any()


@pytest.mark.parametrize("frames", [0, 1, 2, 15])
def test_short_and_still_recordings_have_no_jumps(frames):
    points = line(frames) * 1e3
    assert np.isinf(jump_threshold(points)).all()
    assert not wrong_samples(points, jump_threshold(points), 5).any()
    still = np.zeros((100, 1, 3))
    assert np.isinf(jump_threshold(still)).all()
