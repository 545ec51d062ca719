"""The constant-velocity filter against other implementations and closed forms."""

import numpy as np
import pytest
from filterpy.common import Q_continuous_white_noise
from filterpy.kalman import KalmanFilter
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, make_smoothing_spline
from synthetic import fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.constant_velocity import bridge, constant_rate, prediction
from mocapmend_algorithms.fill.kalman_settings import process_noise

CLEAN = (*range(-16, 0), *range(30, 46))
RATIOS = st.floats(-4, 4).map(lambda power: 10.0**power)


@st.composite
def windows(draw):
    """Irregular windows: knots on both sides of a gap, and its length."""
    length = draw(st.integers(1, 60))
    steps = st.lists(st.integers(1, 9), min_size=0, max_size=12)
    before = -1 - np.cumsum([0, *draw(steps)])[::-1]
    after = length + np.cumsum([0, *draw(steps)])
    return (*before.tolist(), *after.tolist()), length


def dense_smoother(knots, at, ratio):
    """Mean weights and SD from one least-squares problem over the states of all frames.

    Its unknowns are [f, v] at every frame of interest, its rows the samples and the steps between
    frames, each divided by its standard deviation.
    """
    time = np.unique([*knots, *at])
    n = 2 * len(time)
    seen = np.searchsorted(time, knots)
    samples = np.zeros((len(knots), n))
    samples[np.arange(len(knots)), 2 * seen] = ratio**-0.5
    rows = [samples]
    for index, dt in enumerate(np.diff(time).astype(float)):
        covariance = np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])
        step = np.zeros((2, n))
        step[:, 2 * index : 2 * index + 4] = [[-1, -dt, 1, 0], [0, -1, 0, 1]]
        rows.append(np.linalg.solve(np.linalg.cholesky(covariance), step))
    q, r = np.linalg.qr(np.concatenate(rows))
    places = 2 * np.searchsorted(time, at)
    solution = np.linalg.inv(r)[places]
    weights = solution @ q[: len(knots)].T * ratio**-0.5
    return weights, np.linalg.norm(solution, axis=1)


def carried(smooth, knots, length):
    """Add what the smoother leaves over at the edges; smooth has both edges as first and last."""
    after = np.searchsorted(knots, 0)
    residual = np.eye(len(knots))[[after - 1, after]] - smooth[[0, -1]]
    start, stop = knots[after - 1], knots[after]
    share = ((np.arange(length) - start) / (stop - start))[:, None]
    return smooth[1:-1] + (1 - share) * residual[0] + share * residual[1]


def filterpy_run(knots, values, frames, ratio):
    """Filter frame by frame; a far-off start with a huge covariance stands in for ignorance."""
    kalman = KalmanFilter(dim_x=2, dim_z=1)
    kalman.F = np.array([[1.0, 1.0], [0.0, 1.0]])
    kalman.H = np.array([[1.0, 0.0]])
    kalman.Q = Q_continuous_white_noise(2, dt=1.0, spectral_density=1.0)
    kalman.R = np.array([[ratio]])
    kalman.P = np.eye(2) * 1e7
    seen = dict(zip(knots, values, strict=True))
    means, covariances = [], []
    for frame in frames:
        kalman.predict()
        kalman.update(np.array([[seen[frame]]]) if frame in seen else None)
        means.append(kalman.x.copy())
        covariances.append(kalman.P.copy())
    return kalman, np.array(means), np.array(covariances)


@settings(max_examples=60)
@given(window=windows(), ratio=RATIOS)
def test_bridge_is_the_best_linear_estimate(window, ratio):
    knots, length = window
    after = np.searchsorted(knots, 0)
    at = [knots[after - 1], *range(length), knots[after]]
    smooth, sigma = dense_smoother(knots, at, ratio)
    weights, spread = bridge(knots, length, ratio)
    np.testing.assert_allclose(weights, carried(smooth, knots, length), atol=1e-7)
    np.testing.assert_allclose(spread, sigma[1:-1], rtol=1e-6)


@pytest.mark.parametrize("ratio", [0.01, 1.0, 100.0])
def test_bridge_agrees_with_filterpy(ratio):
    values = np.random.default_rng(0).normal(0, 30, len(CLEAN)).cumsum()
    frames = range(CLEAN[0], CLEAN[-1] + 1)
    kalman, means, covariances = filterpy_run(CLEAN, values, frames, ratio)
    smooth, smooth_covariance, _, _ = kalman.rts_smoother(means, covariances)
    edges = slice(15, 15 + 32)
    expected = smooth[edges, 0, 0]
    residual = values[[15, 16]] - expected[[0, -1]]
    share = np.arange(1, 31) / 31
    expected = expected[1:-1] + (1 - share) * residual[0] + share * residual[1]
    weights, sigma = bridge(CLEAN, 30, ratio)
    np.testing.assert_allclose(weights @ values, expected, atol=1e-2)
    np.testing.assert_allclose(sigma, np.sqrt(smooth_covariance[edges, 0, 0][1:-1]), rtol=1e-3)


@pytest.mark.parametrize("step", [1, 3])
def test_prediction_agrees_with_filterpy(step):
    values = np.random.default_rng(1).normal(0, 30, len(CLEAN)).cumsum()
    taken = list(range(-16, 0))[::-step][::-1]
    seen = values[np.array(taken) + 16]
    _, means, covariances = filterpy_run(taken, seen, range(taken[0], 30), 2.0)
    weights, sigma = prediction(CLEAN, 30, 2.0, step)
    np.testing.assert_allclose(weights @ values, means[-30:, 0, 0], atol=1e-2)
    np.testing.assert_allclose(sigma, np.sqrt(covariances[-30:, 0, 0]), rtol=1e-3)
    assert not weights[:, 16:].any()


def test_without_noise_the_bridge_is_the_natural_spline():
    values = smooth_motion(46, 1)[:32, 0]
    weights, _ = bridge(CLEAN, 30, 1e-9)
    expected = CubicSpline(CLEAN, values, bc_type="natural")(np.arange(30))
    np.testing.assert_allclose(weights @ values, expected, rtol=1e-6, atol=1e-6)


def test_with_noise_the_bridge_is_the_smoothing_spline_carried_to_the_edges():
    values = np.random.default_rng(2).normal(0, 30, len(CLEAN)).cumsum()
    spline = make_smoothing_spline(CLEAN, values, lam=50.0)
    residual = values[[15, 16]] - spline([-1, 30])
    share = np.arange(1, 31) / 31
    expected = spline(np.arange(30)) + (1 - share) * residual[0] + share * residual[1]
    np.testing.assert_allclose(bridge(CLEAN, 30, 50.0)[0] @ values, expected, rtol=1e-6)


def test_with_all_noise_the_bridge_is_a_straight_line():
    weights, _ = bridge(CLEAN, 30, 1e12)
    expected = np.zeros((30, 32))
    expected[:, 16] = np.arange(1, 31) / 31
    expected[:, 15] = 1 - expected[:, 16]
    np.testing.assert_allclose(weights, expected, atol=1e-5)


def test_two_samples_predict_along_their_line():
    weights, _ = prediction((-4, -1, 5), 5, 1.0, 1)
    np.testing.assert_allclose(weights @ [10.0, 16.0, 0.0], 16 + 2 * np.arange(1, 6))


def test_the_velocity_is_that_over_the_fixed_interval():
    # L21 eqs. 2 to 4: f moves on by v dt, and v is the change over the interval, divided by it;
    # what lies between is not looked at.
    values = np.random.default_rng(5).normal(0, 30, 8)
    weights, _ = prediction((*range(-8, 0), 5), 5, 1.0, 7)
    velocity = (values[7] - values[0]) / 7
    expected = values[7] + velocity * np.arange(1, 6)
    np.testing.assert_allclose(weights @ [*values, 0.0], expected)


@pytest.mark.parametrize(
    ("frames", "step", "expected"),
    [
        (np.arange(-8, 0), 1, [-8, -7, -6, -5, -4, -3, -2, -1]),
        (np.arange(-8, 0), 3, [-7, -4, -1]),
        (np.array([-9, -8, -3, -1]), 3, [-8, -1]),
        (np.array([-3, -1]), 50, [-3, -1]),
    ],
)
def test_constant_rate_sampling(frames, step, expected):
    np.testing.assert_array_equal(frames[constant_rate(frames, step)], expected)


def test_process_noise_is_recovered():
    rng = np.random.default_rng(3)
    rate, density = 200.0, 4e5
    # Twice integrated white noise, sampled exactly (variance of position and velocity per step).
    step = 1 / rate
    factor = np.linalg.cholesky(
        density * np.array([[step**3 / 3, step**2 / 2], [step**2 / 2, step]])
    )
    kicks = rng.normal(size=(40_000, 3, 2)) @ factor.T
    velocity = np.cumsum(kicks[:, :, 1], axis=0)
    moves = kicks[1:, :, 0] + velocity[:-1] * step
    points = np.cumsum(moves, axis=0)[:, None]
    assert process_noise(points[:, 0], rate) == pytest.approx(density, rel=0.1)


def test_process_noise_of_short_stretches():
    points = np.full((30, 1, 3), np.nan)
    assert process_noise(points[:, 0], 100.0) == 0.0
    points[4:7] = [[[0, 0, 0]], [[1, 0, 0]], [[0, 0, 0]]]
    assert process_noise(points[:, 0], 100.0) == pytest.approx(4 / 3 * 1.5 * 100**3)


def test_noisy_samples_make_it_choose_more_noise():
    gaps = [Gap(0, start, start + 10) for start in range(100, 500, 40)]
    clean = smooth_motion(600, 1)
    noisy = clean + np.random.default_rng(4).normal(0, 3, clean.shape)
    chosen = []
    for points in (clean, noisy):
        notes = fill_with(("kalman", {}), record(punch(points, gaps)), gaps).notes
        chosen.append(np.median([notes[gap]["noise_mm"] for gap in gaps]))
    assert chosen[1] > 10 * chosen[0]


def test_two_sided_beats_causal():
    gaps = [Gap(0, start, start + 20) for start in range(100, 900, 40)]
    points = smooth_motion(1000, 1)
    recording = record(punch(points, gaps))

    def error(direction):
        patches = fill_with(("kalman", {"direction": direction}), recording, gaps).patches
        return np.mean([(p.values - points[p.gap.start : p.gap.stop, 0]) ** 2 for p in patches])

    assert error("two-sided") < error("causal") / 4


def test_causal_needs_two_samples_before():
    points = smooth_motion(50, 1)
    gap = Gap(0, 1, 6)
    (unfilled,) = fill_with(
        ("kalman", {"direction": "causal"}), record(punch(points, [gap])), [gap]
    ).unfilled
    assert unfilled.reason == (
        "the filter needs 2 samples before the gap, and the marker has only 1"
    )
