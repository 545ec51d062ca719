"""Gaussian-process regression against a dense closed form and scikit-learn."""

import numpy as np
import pytest
from scipy.spatial.distance import cdist
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, DotProduct, Matern

from mocapmend_algorithms.fill import gaussian
from mocapmend_algorithms.fill.gaussian import Kernel, Times, regress

RATE = 50.0
KERNELS = [
    Kernel(linear=5.0, pose=0.5, temporal=((0.01, 0.04), (0.1, 10.0)), noise=1e-3),
    Kernel(linear=0.5, pose=2.0, temporal=((0.1, 0.1), (0.1, 1.0)), noise=1e-4, smooth=True),
    Kernel(linear=0.0, pose=1.0, temporal=(), noise=1e-2),
]
BLOCKS = [np.arange(4, 9), np.arange(20, 21), np.arange(7, 16), np.arange(33, 40)]


def lesson(*, asked=10, features=5, seed=0):
    """Frames, poses and samples, and where values are wanted."""
    rng = np.random.default_rng(seed)
    frames = np.sort(rng.choice(300, 40, replace=False))
    wanted = np.sort(rng.choice(np.setdiff1d(np.arange(300), frames), asked, replace=False))
    poses = rng.normal(0, 3, (40 + asked, features))
    values = 50 + 10 * poses[:40, :3] + rng.normal(0, 1, (40, 3))
    return frames, wanted, poses[:40], values, poses[40:]


def covariance(kernel, one, other, samples):
    """The kernel by scikit-learn's parts; `one` and `other` are poses and seconds."""
    scale = np.mean(np.sum(samples**2, axis=1))
    typical = np.median(cdist(samples, samples)[:, ::3])
    total = kernel.linear * DotProduct(0.0)(one[0], other[0]) / scale
    total += Matern(np.sqrt(kernel.pose) * typical, nu=1.5)(one[0], other[0])
    for variance, seconds in kernel.temporal:
        nu = 2.5 if kernel.smooth else 1.5
        total += variance * Matern(seconds, nu=nu)(one[1], other[1])
    return total


def posterior(kernel, known, values, asked, samples, mean):
    """Rasmussen and Williams 2006, eqs. 2.25 and 2.26, without any trick."""
    inner = covariance(kernel, known, known, samples) + kernel.noise * np.eye(values.shape[0])
    cross = covariance(kernel, asked, known, samples)
    prior = np.diagonal(covariance(kernel, asked, asked, samples))
    predicted = mean + cross @ np.linalg.solve(inner, values - mean)
    variance = prior - np.einsum("ij,ji->i", cross, np.linalg.solve(inner, cross.T))
    return predicted, np.sqrt(variance + kernel.noise)


def at(poses, frames):
    return poses, frames[:, None] / RATE


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("blocks", [[], BLOCKS], ids=["no blocks", "blocks"])
def test_values_and_spread_are_those_of_the_closed_form(kernel, blocks):
    frames, wanted, poses, values, asked = lesson()
    times = Times(frames, wanted, RATE, blocks)
    (found,) = regress(times, poses, values, asked, [kernel])
    # What is typical is taken of every third sample, in the order of the samples inside.
    expected, spread = posterior(
        kernel, at(poses, frames), values, at(asked, wanted), poses[times.order], values.mean(0)
    )
    np.testing.assert_allclose(found.values, expected, atol=1e-7)
    np.testing.assert_allclose(found.spread, spread, rtol=1e-6)


@pytest.mark.parametrize("kernel", KERNELS)
def test_what_is_left_out_is_predicted_as_if_it_had_never_been_there(kernel):
    frames, wanted, poses, values, asked = lesson()
    times = Times(frames, wanted, RATE, BLOCKS)
    (found,) = regress(times, poses, values, asked, [kernel])
    for block, left, spread in zip(BLOCKS, found.left_out, found.left_out_spread, strict=True):
        rest = np.setdiff1d(np.arange(frames.size), block)
        predicted, sigma = posterior(
            kernel,
            at(poses[rest], frames[rest]),
            values[rest],
            at(poses[block], frames[block]),
            poses[times.order],
            values.mean(axis=0),
        )
        np.testing.assert_allclose(left, values[block] - predicted, atol=1e-7)
        np.testing.assert_allclose(spread, sigma, rtol=1e-6)


@pytest.mark.parametrize("smooth", [False, True])
def test_it_is_scikit_learns_regression_on_time(smooth):
    frames, wanted, poses, values, asked = lesson()
    kernel = Kernel(0.0, 1.0, ((2.0, 0.3), (0.5, 2.0)), 1e-3, smooth)
    (found,) = regress(Times(frames, wanted, RATE, []), 0 * poses, values, 0 * asked, [kernel])
    nu = 2.5 if smooth else 1.5
    theirs = ConstantKernel(1.0) + 2.0 * Matern(0.3, nu=nu) + 0.5 * Matern(2.0, nu=nu)
    regressor = GaussianProcessRegressor(theirs, alpha=1e-3, optimizer=None)
    regressor.fit(frames[:, None] / RATE, values - values.mean(axis=0))
    mean, spread = regressor.predict(wanted[:, None] / RATE, return_std=True)
    np.testing.assert_allclose(found.values, mean + values.mean(axis=0), atol=1e-7)
    np.testing.assert_allclose(found.spread**2, spread[:, 0] ** 2 + 1e-3, rtol=1e-6)


def test_it_is_scikit_learns_regression_on_the_pose():
    frames, wanted, poses, values, asked = lesson()
    kernel = Kernel(linear=3.0, pose=0.7, temporal=(), noise=1e-2)
    (found,) = regress(Times(frames, wanted, RATE, []), poses, values, asked, [kernel])
    scale = np.mean(np.sum(poses**2, axis=1))
    typical = np.median(cdist(poses, poses)[:, ::3])
    theirs = ConstantKernel(3.0 / scale) * DotProduct(0.0, "fixed")
    theirs += Matern(np.sqrt(0.7) * typical, nu=1.5)
    regressor = GaussianProcessRegressor(theirs, alpha=1e-2, optimizer=None)
    regressor.fit(poses, values - values.mean(axis=0))
    mean, spread = regressor.predict(asked, return_std=True)
    np.testing.assert_allclose(found.values, mean + values.mean(axis=0), atol=1e-7)
    np.testing.assert_allclose(found.spread**2, spread[:, 0] ** 2 + 1e-2, rtol=1e-6)


def test_many_values_in_parts_are_the_same(monkeypatch):
    frames, wanted, poses, values, asked = lesson(asked=50)
    whole = regress(Times(frames, wanted, RATE, BLOCKS), poses, values, asked, KERNELS)
    monkeypatch.setattr(gaussian, "MOST_ASKED", 7)
    times = Times(frames, wanted, RATE, BLOCKS)
    assert [part.size for part in times.parts] == [7] * 7 + [1]
    for one, other in zip(whole, regress(times, poses, values, asked, KERNELS), strict=True):
        np.testing.assert_allclose(other.values, one.values, rtol=1e-9)
        np.testing.assert_allclose(other.spread, one.spread, rtol=1e-9)
        for a, b in zip(one.left_out, other.left_out, strict=True):
            np.testing.assert_allclose(b, a, rtol=1e-9)


def test_the_spread_of_many_is_a_line_between_a_few():
    frames, wanted, poses, values, asked = lesson(asked=50)
    times = Times(frames, wanted, RATE, [])
    (found,) = regress(times, poses, values, asked, KERNELS[:1])
    _, spread = posterior(
        KERNELS[0], at(poses, frames), values, at(asked, wanted), poses, values.mean(axis=0)
    )
    assert times.few.size == 16
    assert set(times.few) >= {0, 49}
    np.testing.assert_allclose(
        found.spread, np.interp(np.arange(50), times.few, spread[times.few]), rtol=1e-6
    )


def test_nothing_asked_and_nothing_moving_are_no_trap():
    frames, _, poses, values, _ = lesson()
    nothing = np.zeros(0, dtype=np.int64)
    (found,) = regress(Times(frames, nothing, RATE, BLOCKS), poses, values, poses[:0], KERNELS[:1])
    assert found.values.shape == (0, 3)
    assert found.spread.shape == (0,)
    same = np.tile(poses[:1], (40, 1)) + 1e-9 * poses
    (found,) = regress(Times(frames, frames[:3], RATE, BLOCKS), same, values, same[:3], KERNELS[2:])
    np.testing.assert_allclose(found.values, np.tile(values.mean(axis=0), (3, 1)), atol=1e-3)


def test_a_pose_far_away_from_all_others_is_no_trap():
    frames, wanted, poses, values, asked = lesson()
    poses[:20] = 1e-9 * poses[:20] + 1e9
    poses[20:] = 1e-9 * poses[20:]
    for kernel in KERNELS:
        (found,) = regress(Times(frames, wanted, RATE, BLOCKS), poses, values, asked, [kernel])
        assert np.isfinite(found.values).all()
        assert np.isfinite(found.spread).all()
        assert all(np.isfinite(left).all() for left in found.left_out)
