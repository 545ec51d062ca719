"""The measured uncertainty."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.selftest import TrialFinder, calibrate, turn

R90_PER_SIGMA = 2.5002777108094
"""Radius of the 90 % ball of an isotropic 3-D Gaussian with unit SD: sqrt(chi2.ppf(0.9, 3))."""

KNOTS = np.array([-3, -2, -1, 6, 7, 8])


@settings(max_examples=60)
@given(
    seed=st.integers(0, 10_000),
    frames=st.integers(10, 150),
    share=st.sampled_from([0.0, 0.02, 0.1, 0.3]),
)
def test_trials_are_fully_observed(seed, frames, share):
    observed = np.random.default_rng(seed).random((frames, 3)) >= share
    trials = TrialFinder(observed).find(1, KNOTS, 6)
    if trials is None:
        return
    needed = np.arange(-3, 9)
    assert observed[trials.frames[:, None] + needed, trials.markers[:, None]].all()
    assert len(set(zip(trials.frames, trials.markers, strict=True))) == trials.frames.size <= 64
    assert not trials.own or set(trials.markers) == {1}
    assert 1 <= trials.disjoint


def test_holes_between_the_knots_do_not_matter():
    observed = np.zeros((400, 1), dtype=bool)
    observed[:, 0] = np.arange(400) % 10 != 0
    trials = TrialFinder(observed).find(0, np.array([-8, 4]), 3)
    # -8, 0, 1, 2 and 4 must be seen: one start in ten fails for each.
    assert not np.isin(trials.frames % 10, [8, 0, 9, 6]).any()


def test_other_markers_stand_in():
    observed = np.ones((100, 4), dtype=bool)
    observed[20:, 2] = False
    own = TrialFinder(observed).find(1, KNOTS, 6)
    assert own.own
    assert own.frames.size == 32
    assert own.frames[[0, -1]].tolist() == [3, 91]
    others = TrialFinder(observed).find(2, KNOTS, 6)
    assert not others.own
    assert set(others.markers) >= {0, 1, 3}
    assert TrialFinder(observed[:12]).find(2, KNOTS, 6) is None


def test_turn():
    time = np.concatenate((np.arange(-4, 0), np.arange(6, 10)))
    line = np.stack((2.0 * time, -time, 0.0 * time), axis=1)[:, None]
    assert turn(time, line, 6) == pytest.approx(0)
    corner = np.abs(time - 2.5)[:, None, None] * [[[1.0, 0, 0]]]
    # The velocity is -1 before and +1 after, and 0 on the chord.
    assert turn(time, corner, 6) == pytest.approx(6 * np.sqrt(2))
    assert turn(np.array([-1, 6]), line[3:5], 6) == pytest.approx(0)


def test_gaussian_errors_give_the_gaussian_radius():
    rng = np.random.default_rng(0)
    profile = np.array([1.0, 2.0, 3.0, 2.0, 1.0])
    turns = rng.uniform(1, 5, 20_000)
    errors = np.linalg.norm(rng.normal(size=(20_000, 5, 3)), axis=2) * profile * turns[:, None]
    for shape in (None, profile):
        calibration = calibrate(errors, turns, 10_000, shape)
        radius = calibration.r90 / calibration.sigma
        np.testing.assert_allclose(radius, R90_PER_SIGMA, rtol=0.06)
    # The floor makes easy windows a little less easy than their turn says.
    scaled = calibration.scale(5.0) * calibration.sigma
    np.testing.assert_allclose(scaled, 5 * profile, rtol=0.1)


def test_few_trials_widen_the_radius_only():
    errors = np.random.default_rng(1).exponential(size=(20, 4))
    turns = np.ones(20)
    few, many = calibrate(errors, turns, 4), calibrate(errors, turns, 1000)
    assert (few.r90 > many.r90).all()
    np.testing.assert_array_equal(few.sigma, many.sigma)


def test_exact_fills_have_no_error():
    calibration = calibrate(np.zeros((10, 3)), np.zeros(10), 10)
    assert calibration.scale(7.0) == 1.0
    assert not calibration.sigma.any()
    assert not calibration.r90.any()


def test_a_gap_in_a_swing_is_less_sure_than_one_at_rest():
    time = np.arange(2000) / 100
    swing = np.where(time < 10, 0, np.sin(2 * np.pi * 1.5 * (time - 10)))
    points = 300 * swing[:, None, None] * np.ones(3)
    points += np.random.default_rng(2).normal(0, 0.2, points.shape)
    gaps = [Gap(0, 500, 512), Gap(0, 1500, 1512)]
    rest, moving = fill_with(("cubic", {}), record(punch(points, gaps)), gaps).patches
    assert moving.expected_error > 3 * rest.expected_error


@pytest.mark.parametrize("variant", [("linear", {}), ("cubic", {}), ("kalman", {})], ids=str)
def test_expected_errors_and_radii_hold_on_synthetic_motion(variant):
    squares, expected, inside = [], [], []
    for seed in range(6):
        points = smooth_motion(1500, 2, seed=seed)
        rng = np.random.default_rng(seed)
        gaps = [Gap(m, s, s + 15) for m in (0, 1) for s in (100 + rng.integers(0, 60, 8)).cumsum()]
        gaps = [Gap(g.marker, int(g.start), int(g.stop)) for g in gaps if g.stop < 1480]
        for patch in fill_with(variant, record(punch(points, gaps)), gaps).patches:
            truth = points[patch.gap.start : patch.gap.stop, patch.gap.marker]
            error = np.linalg.norm(patch.values - truth, axis=1)
            squares.append(np.mean(error**2))
            expected.append(patch.expected_error**2)
            inside.append(np.mean(error <= patch.r90))
    assert np.sqrt(np.mean(squares)) == pytest.approx(np.sqrt(np.mean(expected)), rel=0.3)
    assert 0.82 <= np.mean(inside) <= 0.98


@pytest.mark.shared
@pytest.mark.parametrize("variant", [("linear", {}), ("cubic", {}), ("pchip", {}), ("kalman", {})])
def test_radii_cover_real_motion(variant, shared):
    rng = np.random.default_rng(0)
    inside = {length: [] for length in (5, 12, 24, 60, 120)}
    for name in ("127_07", "132_32", "132_43", "135_07", "141_16", "143_22"):
        points = np.load(shared / "cmu_markers" / f"{name}.npz")["pos"].astype(np.float64)
        frames, markers = points.shape[:2]
        for length, hits in inside.items():
            if frames < length + 40:
                continue
            for _ in range(12):
                start = int(rng.integers(1, frames - length - 1))
                gap = Gap(int(rng.integers(markers)), start, start + length)
                (patch,) = fill_with(
                    variant, record(punch(points, [gap]), rate=120.0), [gap]
                ).patches
                error = patch.values - points[gap.start : gap.stop, gap.marker]
                hits.append(np.mean(np.linalg.norm(error, axis=1) <= patch.r90))
    pooled = np.mean([np.mean(hits) for hits in inside.values()])
    assert 0.85 <= pooled <= 0.95, {length: np.mean(hits) for length, hits in inside.items()}
