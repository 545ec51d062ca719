"""The pull of predicted points to bone lengths."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize

from mocapmend_algorithms.fill.bones import Bones, pull


def limb(seed, frames=12, bones=3, off=20.0):
    rng = np.random.default_rng(seed)
    truth = rng.normal(0, 300, (frames, 3))
    length = rng.uniform(80, 300, bones)
    way = rng.normal(size=(frames, bones, 3))
    ends = truth[:, None] + length[:, None] * way / np.linalg.norm(way, axis=2)[:, :, None]
    predicted = truth + rng.normal(0, off, (frames, 3))
    return truth, predicted, Bones(ends, length, rng.uniform(1, 5, bones))


def errors(points, bones):
    return np.linalg.norm(points[:, None] - bones.ends, axis=2) - bones.length


def cost(point, predicted, sigma, bones, frame):
    away = np.sum((point - predicted[frame]) ** 2) / sigma[frame] ** 2
    count = np.sqrt(bones.spread.size)
    off = np.linalg.norm(point - bones.ends[frame], axis=1) - bones.length
    return away + np.nansum((off / bones.spread / count) ** 2)


@given(seed=st.integers(0, 300), bones=st.integers(1, 4), doubt=st.floats(0.1, 30))
def test_it_finds_the_least_that_scipy_finds_and_shrinks_the_bone_errors(seed, bones, doubt):
    _, predicted, limbs = limb(seed, 4, bones)
    sigma = np.linspace(doubt, 2 * doubt, 4)
    pulled, share = pull(predicted, sigma, limbs)
    weight = 1 / limbs.spread**2
    before, after = (np.sum(weight * errors(p, limbs) ** 2, axis=1) for p in (predicted, pulled))
    assert (after <= before).all()
    assert ((share > 0) & (share <= 1)).all()
    for frame in range(4):
        found = minimize(cost, predicted[frame], (predicted, sigma, limbs, frame), tol=1e-10)
        assert cost(pulled[frame], predicted, sigma, limbs, frame) <= found.fun * 1.01 + 1e-6


def test_one_loose_bone_pulls_along_itself_by_its_weight():
    bones = Bones(np.zeros((1, 1, 3)), np.array([100.0]), np.array([3.0]))
    pulled, share = pull(np.array([[0.0, 110.0, 0.0]]), np.array([4.0]), bones)
    # 16 of 16 + 9 parts of the way; across the bone nothing is learned.
    np.testing.assert_allclose(pulled, [[0.0, 110 - 10 * 16 / 25, 0.0]], atol=1e-6)
    assert share[0] == pytest.approx(np.sqrt((2 + 9 / 25) / 3))


def test_a_certain_prediction_is_not_moved_and_an_unseen_end_does_not_pull():
    _, predicted, bones = limb(3)
    still, share = pull(predicted, np.zeros(12), bones)
    np.testing.assert_allclose(still, predicted)
    np.testing.assert_allclose(share, 1.0)
    hidden = Bones(np.full_like(bones.ends, np.nan), bones.length, bones.spread)
    same, share = pull(predicted, np.full(12, 30.0), hidden)
    np.testing.assert_array_equal(same, predicted)
    np.testing.assert_allclose(share, 1.0)


def test_four_bones_that_share_the_skin_bring_a_far_prediction_home():
    truth, predicted, bones = limb(4, bones=4, off=60.0)
    pulled, _ = pull(predicted, np.full(12, 60.0), bones)
    before, after = (np.linalg.norm(p - truth, axis=1).mean() for p in (predicted, pulled))
    assert after < before / 5


def test_a_prediction_at_the_other_end_is_no_division_by_zero():
    bones = Bones(np.zeros((1, 2, 3)), np.array([100.0, 50.0]), np.array([1.0, 1.0]))
    pulled, _ = pull(np.zeros((1, 3)), np.array([10.0]), bones)
    assert np.isfinite(pulled).all()
