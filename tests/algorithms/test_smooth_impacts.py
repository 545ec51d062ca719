"""Impacts are smoothed less, bursts of jitter are not."""

import numpy as np
import pytest
from smooth_samples import noisy, rms, smooth_with, whole
from synthetic import record

from mocapmend_algorithms.smooth.impacts import lighter_at_impacts
from mocapmend_algorithms.smooth.spline import by_axis, penalty

EVEN = {"keep_impacts": "false"}


def strikes(rate, *, noise, unit=1.0):
    """A heel that falls at 2 m/s and stands at once, every second: with noise, and without."""
    time = np.arange(round(8 * rate)) / rate
    phase = time % 1.0
    height = np.where(phase < 0.75, 30 - 30 * np.cos(2 * np.pi * phase / 1.5), 0.0)
    falling = (phase >= 0.75) & (phase < 0.78)
    height[falling] = 30 * (1 - (phase[falling] - 0.75) / 0.03)
    clean = np.stack([300 * np.sin(time), 20 * np.cos(2 * time), height], axis=1)[:, None]
    jitter = np.random.default_rng(0).normal(0, noise, clean.shape)
    return (clean + jitter) * unit, clean * unit


@pytest.mark.parametrize("rate", [100.0, 250.0])
@pytest.mark.parametrize("noise", [0.3, 1.0])
def test_impacts_are_kept(rate, noise):
    points, clean = strikes(rate, noise=noise)
    recording = record(points, rate=rate)
    runs = whole(recording)
    (kept,) = smooth_with(("gcv", {}), recording, runs).runs
    (even,) = smooth_with(("gcv", EVEN), recording, runs).runs
    struck = np.abs(np.arange(len(points)) / rate % 1.0 - 0.765) < 0.05
    left = [rms(done.values[struck] - clean[struck, 0]) for done in (kept, even)]
    # At 100 Hz a fall of 30 ms is three frames: there is little to go by.
    assert left[0] < (0.4 if rate > 200 else 0.96) * left[1]
    assert rms(kept.values - clean[:, 0]) < 0.97 * rms(even.values - clean[:, 0])
    assert kept.chosen["cutoff_hz"] == even.chosen["cutoff_hz"]
    assert 0 < kept.chosen["share_at_impacts"] < 0.1
    assert "share_at_impacts" not in even.chosen


def test_what_the_motion_needs_is_found_at_each_place():
    """One corner in a straight line: lighter there, and as chosen elsewhere."""
    time = np.arange(400)
    clean = np.maximum(time - 200.0, 0)[:, None] * [8.0, -6.0, 3.0]
    samples = clean + np.random.default_rng(1).normal(0, 0.5, clean.shape)
    cutoffs, noise = np.full(3, 4.0), np.full(3, 0.5)
    curve, share = lighter_at_impacts(samples, cutoffs, noise, 100.0, 3)
    even = by_axis(samples, [penalty(4.0, 100.0, 3)] * 3, 3)
    near = slice(190, 211)
    assert rms(curve[near] - clean[near]) < 0.5 * rms(even[near] - clean[near])
    far = np.r_[0:150, 250:400]
    np.testing.assert_array_equal(curve[far], even[far])
    assert 0.01 < share < 0.15


def test_noise_alone_has_no_impacts():
    samples = np.random.default_rng(2).normal(0, 2.0, (5000, 3))
    _, share = lighter_at_impacts(samples, np.full(3, 5.0), np.full(3, 2.0), 120.0, 3)
    assert share < 0.02


def test_a_burst_of_jitter_is_smoothed():
    recording, clean = noisy(600, 1, noise=0.3, rate=120.0)
    points = recording.points.copy()
    burst = slice(300, 330)
    points[burst] += np.random.default_rng(3).normal(0, 4.0, points[burst].shape)
    broken = recording.with_points(points)
    inside = slice(305, 325)
    left = {}
    for name, params in (("kept", {}), ("even", EVEN)):
        (done,) = smooth_with(("gcv", params), broken, whole(broken)).runs
        left[name] = rms(done.values[inside] - clean[inside, 0])
    before = rms(points[inside] - clean[inside])
    assert left["kept"] < 0.7 * before
    assert left["kept"] < 1.3 * left["even"]
