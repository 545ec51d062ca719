"""The banded spline against the dense one, scipy, and Kalman smoothers."""

import numpy as np
import pytest
from filterpy.kalman import KalmanFilter
from scipy.interpolate import make_smoothing_spline
from scipy.stats import multivariate_normal
from smooth_samples import noisy, smooth_with, whole
from synthetic import record

from mocapmend_algorithms.fill import woltring
from mocapmend_algorithms.smooth.gcv import choose
from mocapmend_algorithms.smooth.spline import (
    OVERLAP,
    SQUARE,
    by_axis,
    cutoff_grid,
    degrees_left,
    penalty,
    residuals,
    roughness,
)

FRAMES = 60
PENALTIES = (1e-3, 1.0, 50.0, 1e5, 1e8)


@pytest.fixture(scope="module")
def samples():
    recording, _ = noisy(FRAMES, 1)
    return recording.points[:, 0] - recording.points[0, 0]


@pytest.fixture(scope="module")
def dense():
    """The spline of the gap filler, which takes any knots."""
    return woltring.spline(tuple(range(FRAMES)), 1)


@pytest.mark.parametrize("p", PENALTIES)
def test_the_quintic_is_that_of_the_gap_filler(samples, dense, p):
    shrink = 1 / (1 + p * dense.penalties)
    curve = dense.modes @ (shrink[:, None] * (dense.modes.T @ samples))
    np.testing.assert_allclose(samples - residuals(samples, p, 3), curve, atol=1e-7)
    assert degrees_left(FRAMES, (p,), 3)[0] == pytest.approx(FRAMES - shrink.sum(), rel=1e-6)


@pytest.mark.parametrize("p", PENALTIES)
def test_the_cubic_is_that_of_scipy(samples, p):
    time = np.arange(FRAMES, dtype=float)
    for column in samples.T:
        same = make_smoothing_spline(time, column, lam=p)(time)
        np.testing.assert_allclose(column - residuals(column[:, None], p, 2)[:, 0], same, atol=1e-6)


@pytest.mark.parametrize("order", [2, 3])
def test_the_trace_is_that_of_the_matrix(order):
    identity = np.eye(FRAMES)
    for p, left in zip(PENALTIES, degrees_left(FRAMES, PENALTIES, order), strict=True):
        assert left == pytest.approx(np.trace(residuals(identity, p, order)), rel=1e-6)


@pytest.mark.parametrize("order", [2, 3])
@pytest.mark.parametrize("rate", [25.0, 120.0, 1000.0])
def test_far_from_the_ends_each_sample_leaves_what_waves_leave_on_average(order, rate):
    """Szegő's theorem: the pivots go to the geometric mean of the matrix' spectrum."""
    penalties = tuple(penalty(cutoff, rate, order) for cutoff in cutoff_grid(rate))
    waves = np.pi * (np.arange(200_000) + 0.5) / 200_000
    overlap, square = (
        diagonals[order][0]
        + 2.0 * diagonals[order][1:] @ np.cos(np.outer(range(1, order + 1), waves))
        for diagonals in (OVERLAP, SQUARE)
    )
    mean = [np.mean(p * square / (overlap + p * square)) for p in penalties]
    for samples in (4_000, 100_000):
        more = degrees_left(samples + 100, penalties, order) - degrees_left(
            samples, penalties, order
        )
        np.testing.assert_allclose(more / 100, mean, rtol=1e-5)


@pytest.mark.parametrize(("order", "passes"), [(2, 1), (3, 2)])
def test_polynomials_pass_unchanged(order, passes):
    curve = np.arange(200.0)[:, None] ** np.arange(passes + 1)
    np.testing.assert_allclose(residuals(curve, 1e6, order), 0.0, atol=1e-6)


@pytest.mark.parametrize("order", [2, 3])
def test_the_power_is_halved_at_the_cutoff(order):
    for cutoff in (1.0, 3.0, 6.0):
        wave = np.cos(2 * np.pi * cutoff * np.arange(4001)[:, None] / 120)
        curve = by_axis(wave, [penalty(cutoff, 120, order)], order)
        np.testing.assert_allclose(curve[1900:2100], wave[1900:2100] / np.sqrt(2), atol=1e-3)


@pytest.mark.parametrize("rate", [25.0, 120.0, 1000.0])
@pytest.mark.parametrize("order", [2, 3])
def test_the_slowest_curve_has_its_digits(rate, order):
    time = np.arange(3000)[:, None]
    p = penalty(cutoff_grid(rate)[-1], rate, order)
    # A wave that goes on beyond the ends is multiplied alike, but for what the ends bend.
    wave = 1000 * np.sin(2 * np.pi * time / 1000)
    curve = wave - residuals(wave, p, order)
    shifted = (wave + 1e6 + 5 * time) - residuals(wave + 1e6 + 5 * time, p, order)
    np.testing.assert_allclose(shifted - 1e6 - 5 * time, curve, atol=1e-3)


def test_cross_validation_is_that_of_the_gap_filler(samples, dense):
    grid = dense.grid()
    chosen, criteria = woltring.choose_smoothing(dense, samples[:, None], None)
    left = degrees_left(FRAMES, tuple(grid.tolist()), 3)
    squares = np.array([np.sum(residuals(samples, p, 3) ** 2) for p in grid])
    kept = left > 1e-3
    np.testing.assert_allclose((squares / left**2)[kept], criteria[kept, 0], rtol=1e-4)
    (place,) = choose(squares[:, None], left, None)
    assert grid[place] == chosen[0]


def test_known_noise_is_smoothed_away():
    recording, _ = noisy(1000, 1, noise=3.0)
    (done,) = smooth_with(("gcv", {"noise_mm": "3"}), recording, whole(recording)).runs
    np.testing.assert_allclose(done.chosen["noise"], 3.0, rtol=0.1)
    (less,) = smooth_with(("gcv", {"noise_mm": "1"}), recording, whole(recording)).runs
    assert less.rms < 0.5 * done.rms


@pytest.mark.parametrize("method", ["gcv", "kalman-smoother"])
@pytest.mark.parametrize("noise", [0.5, 2.0, 5.0])
def test_the_noise_is_found(method, noise):
    recording, _ = noisy(1000, 2, noise=noise, rate=120.0)
    for done in smooth_with((method, {}), recording, whole(recording)).runs:
        np.testing.assert_allclose(done.chosen["noise"], noise, rtol=0.2)


def test_a_given_cutoff_is_used():
    recording, _ = noisy(300, 1)
    variant = ("gcv", {"cutoff_hz": "6", "keep_impacts": "false"})
    (done,) = smooth_with(variant, recording, whole(recording)).runs
    points = recording.points[:, 0]
    curve = by_axis(points - points[0], [penalty(6.0, 100.0, 3)] * 3, 3) + points[0]
    np.testing.assert_allclose(done.values, curve, atol=1e-9)
    assert done.chosen["cutoff_hz"] == [6.0, 6.0, 6.0]


@pytest.mark.parametrize(
    ("params", "message"),
    [
        ({"cutoff_hz": "6", "noise_mm": "1"}, "give cutoff_hz or noise_mm, not both"),
        ({"cutoff_hz": "50"}, "cutoff_hz must be from 0.19 Hz to below half the frame rate, 50 Hz"),
        ({"cutoff_hz": "0.1"}, "not 0.1"),
    ],
)
def test_impossible_cutoffs_are_refused(params, message):
    recording, _ = noisy(100, 1)
    with pytest.raises(ValueError, match=message):
        smooth_with(("gcv", params), recording, whole(recording))


@pytest.mark.parametrize("method", ["gcv", "kalman-smoother"])
def test_impossible_noise_is_refused(method):
    recording, _ = noisy(100, 1)
    with pytest.raises(ValueError, match="noise_mm must be at least"):
        smooth_with((method, {"noise_mm": "-1"}), recording, whole(recording))
    with pytest.raises(ValueError, match="model must be one of velocity, acceleration"):
        smooth_with(("kalman-smoother", {"model": "jerk"}), recording, whole(recording))


def moves(states):
    """Transition and process noise of a velocity, or acceleration, that changes at random."""
    if states == 2:
        return np.array([[1, 1], [0, 1.0]]), np.array([[1 / 3, 1 / 2], [1 / 2, 1]])
    ahead = np.array([[1, 1, 1 / 2], [0, 1, 1], [0, 0, 1.0]])
    return ahead, np.array([[1 / 20, 1 / 8, 1 / 6], [1 / 8, 1 / 3, 1 / 2], [1 / 6, 1 / 2, 1]])


@pytest.mark.parametrize("states", [2, 3])
@pytest.mark.parametrize("ratio", [0.1, 10.0, 1000.0])
def test_the_curve_is_that_of_the_rauch_tung_striebel_smoother(samples, states, ratio):
    peer = KalmanFilter(dim_x=states, dim_z=1)
    peer.F, peer.Q = moves(states)
    peer.H = np.eye(1, states)
    peer.R *= ratio
    # filterpy predicts before its first update.
    peer.x, peer.P = np.zeros(states), 1e8 * np.eye(states)
    means, covariances, _, _ = peer.batch_filter(samples[:, 0])
    same = peer.rts_smoother(means, covariances)[0][:, 0]
    curve = by_axis(samples[:, :1], [ratio], states)[:, 0]
    np.testing.assert_allclose(curve, same, atol=1e-3)


@pytest.mark.parametrize("states", [2, 3])
def test_the_likelihood_is_that_of_the_differences(samples, states):
    """Of a walk that is built up from its noise, the differences forget where it began."""
    ahead, process = moves(states)
    root = np.linalg.cholesky(process)
    drive = np.zeros((states, FRAMES * states))
    walk = np.zeros((FRAMES, FRAMES * states))
    for frame in range(1, FRAMES):
        drive = ahead @ drive
        drive[:, frame * states : (frame + 1) * states] += root
        walk[frame] = drive[0]
    for ratio in (0.1, 10.0, 1000.0):
        covariance = walk @ walk.T + ratio * np.eye(FRAMES)
        mixed = np.diff(np.diff(covariance, n=states, axis=0), n=states, axis=1)
        bent = np.diff(samples[:, 0], n=states)
        likely = multivariate_normal(np.zeros(bent.size), mixed).logpdf(bent)
        rough, determinant = roughness(samples[:, :1], ratio, states)
        ours = -0.5 * (rough[0] + determinant + bent.size * np.log(2 * np.pi))
        assert ours == pytest.approx(likely, rel=1e-6)


def test_the_noises_of_a_random_walk_are_found():
    rng = np.random.default_rng(0)
    ahead, process = moves(2)
    steps = rng.multivariate_normal(np.zeros(2), process, (3, 3000))
    state, path = np.zeros((3, 2)), []
    for frame in range(3000):
        state = state @ ahead.T + steps[:, frame]
        path.append(state[:, 0])
    noise = 4.0
    walk = np.array(path)[:, None]
    recording = record(walk + rng.normal(0, noise, walk.shape))
    (done,) = smooth_with(("kalman-smoother", {}), recording, whole(recording)).runs
    np.testing.assert_allclose(done.chosen["noise"], noise, rtol=0.05)
    best = penalty(1.0, 100.0, 2) ** 0.25
    np.testing.assert_allclose(done.chosen["cutoff_hz"], best / noise**0.5, rtol=0.15)
