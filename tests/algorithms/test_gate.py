"""The innovation gate."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from synthetic import smooth_motion

from mocapmend_algorithms.fill.constant_velocity import bridge
from mocapmend_algorithms.fill.gate import _whitener, unbelievable

SIDE = np.arange(284, 300)


def noisy(seed, frames=600):
    rng = np.random.default_rng(seed)
    return smooth_motion(frames, 1, seed=seed)[:, 0] + rng.normal(0, 0.5, (frames, 3))


def test_the_innovation_is_the_distance_from_what_the_smoother_makes_of_the_others():
    values = np.random.default_rng(0).normal(0, 10, 12)
    frames = np.arange(12)
    row = _whitener(tuple(frames.tolist()))[5]
    others = np.delete(frames, 5)
    # Two samples beside a gap of one frame are met exactly by `bridge`, so a long way is taken:
    # the smoother's weights are those of the best linear estimate, here by generalised least
    # squares on the covariance of twice integrated noise.
    time = np.minimum.outer(frames, frames), np.maximum.outer(frames, frames)
    covariance = time[0] ** 2 * (3 * time[1] - time[0]) / 6 + np.eye(12)
    line = np.stack((np.ones(12), frames), axis=1)
    inverse = np.linalg.inv(covariance[np.ix_(others, others)])
    slope = np.linalg.solve(line[others].T @ inverse @ line[others], line[others].T @ inverse)
    fit = slope @ values[others]
    gain = covariance[5, others] @ inverse
    expected = line[5] @ fit + gain @ (values[others] - line[others] @ fit)
    spread = line[5] - gain @ line[others]
    variance = (
        covariance[5, 5]
        - gain @ covariance[others, 5]
        + spread @ np.linalg.solve(line[others].T @ inverse @ line[others], spread)
    )
    assert row @ values == pytest.approx((values[5] - expected) / np.sqrt(variance))
    assert bridge((-1, 1), 1, 1.0)[0].sum() == pytest.approx(1)


@given(
    seed=st.integers(0, 500),
    place=st.integers(0, 15),
    size=st.floats(30.0, 1e4),
    way=st.sampled_from([1, -1]),
)
def test_one_bad_sample_is_found_wherever_it_is(seed, place, size, way):
    points = noisy(seed)
    direction = np.random.default_rng(seed).normal(size=3)
    points[SIDE[place]] += way * size * direction / np.linalg.norm(direction)
    assert np.flatnonzero(unbelievable(points, SIDE, 5.0)).tolist() == [place]


@given(seed=st.integers(0, 500))
def test_good_samples_pass(seed):
    assert not unbelievable(noisy(seed), SIDE, 5.0).any()
    assert not unbelievable(smooth_motion(600, 1, seed=seed)[:, 0], SIDE, 5.0).any()


@given(
    seed=st.integers(0, 500),
    bad=st.lists(st.integers(0, 15), min_size=1, max_size=3, unique=True),
    scale=st.sampled_from([1e-3, 1.0, 1e3]),
    offset=st.sampled_from([0.0, 1e5]),
)
def test_units_and_places_do_not_matter(seed, bad, scale, offset):
    points = noisy(seed)
    points[SIDE[bad]] += 50 * np.random.default_rng(seed).normal(size=(len(bad), 3))
    marked = unbelievable(points, SIDE, 5.0)
    assert marked.sum() <= 3
    moved = scale * (points[:, [1, 2, 0]] + offset)
    np.testing.assert_array_equal(unbelievable(moved, SIDE, 5.0), marked)
    reverse = unbelievable(points[::-1], 599 - SIDE[::-1], 5.0)[::-1]
    np.testing.assert_array_equal(reverse, marked)


def test_where_nothing_is_known_everything_is_believed():
    points = noisy(1)
    points[299] += 500.0
    assert unbelievable(points, SIDE, 5.0).any()
    assert not unbelievable(points[270:310], SIDE - 270, 5.0).any()
    assert not unbelievable(points[284:300], SIDE - 284, 5.0).any()
    assert not unbelievable(points, SIDE[-5:], 5.0).any()
    assert not unbelievable(points, SIDE[:0], 5.0).any()
    assert not unbelievable(points, SIDE, 1e6).any()
