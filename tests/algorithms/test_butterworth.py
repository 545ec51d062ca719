"""The zero-lag filter against scipy and closed forms, and residual analysis on known noise."""

import numpy as np
import pytest
from scipy.signal import butter, filtfilt
from smooth_samples import rms, smooth_with, whole
from synthetic import record

from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.low_pass import (
    low_pass,
    pass_cutoff,
    residual_squares,
    response,
    white_noise,
)
from mocapmend_algorithms.smooth.residual_analysis import candidates, noise_variance


def sine(frequency, rate, frames):
    """A wave in the columns of a marker, a quarter apart."""
    phase = 2 * np.pi * frequency * np.arange(frames)[:, None] / rate
    return 100 * np.sin(phase + np.arange(3))


def banded(bandwidth, rate, frames, *, seed=0):
    """Motion that has all frequencies up to a bandwidth, about 50 mm across; (frames, 1, 3)."""
    rng = np.random.default_rng(seed)
    frequencies = np.arange(0.3, bandwidth, 0.3)
    phase = rng.uniform(0, 2 * np.pi, (frequencies.size, 3))
    time = np.arange(frames)[:, None, None] / rate
    waves = np.sin(2 * np.pi * frequencies[:, None] * time + phase) / frequencies[:, None]
    return 20 * waves.sum(axis=1)[:, None]


def test_winters_correction():
    # Winter's factor for two passes of order 2, where the frequencies are far below half the rate.
    assert 6 / pass_cutoff(6, 1e6, 4) == pytest.approx(0.802, abs=5e-4)
    assert pass_cutoff(6, 100, 4) < pass_cutoff(6, 100, 2)
    assert pass_cutoff(49.9, 100, 4) < 50


@pytest.mark.parametrize("order", [2, 4, 6, 8])
@pytest.mark.parametrize("rate", [25.0, 120.0, 1000.0])
def test_the_power_is_halved_at_the_cutoff_and_nothing_is_delayed(order, rate):
    for share in (0.05, 0.2, 0.35):
        cutoff = share * rate
        samples = sine(cutoff, rate, 2000)
        filtered = low_pass(samples, cutoff, rate, order)
        middle = slice(800, 1200)
        np.testing.assert_allclose(filtered[middle], samples[middle] / np.sqrt(2), atol=1e-6)


@pytest.mark.parametrize("order", [2, 4, 8])
def test_other_waves_are_multiplied_by_the_response(order):
    for frequency in (1.0, 5.0, 20.0, 40.0):
        samples = sine(frequency, 100, 4000)
        gain = response(np.array([frequency]), [8.0], 100, order)[0, 0]
        filtered = low_pass(samples, 8.0, 100, order)
        np.testing.assert_allclose(filtered[1900:2100], gain * samples[1900:2100], atol=1e-5)


def test_the_same_as_scipy_with_the_corrected_cutoff():
    samples = banded(10, 120, 500)[:, 0] + np.random.default_rng(1).normal(size=(500, 3))
    recording = record(samples[:, None], rate=120)
    variant = ("butterworth", {"cutoff_hz": "6"})
    (done,) = smooth_with(variant, recording, whole(recording)).runs
    b, a = butter(2, pass_cutoff(6, 120, 4), fs=120)
    same = filtfilt(b, a, samples, axis=0, padlen=20)
    np.testing.assert_allclose(done.values, same, atol=1e-6)
    assert done.chosen == {"cutoff_hz": [6.0, 6.0, 6.0]}


@pytest.mark.parametrize("order", [2, 4, 6])
def test_residuals_by_sines_are_those_of_the_filter(order):
    samples = banded(12, 100, 600)[:, 0] + np.random.default_rng(1).normal(size=(600, 3))
    cutoffs = [2.0, 6.0, 15.0, 40.0]
    by_filter = [
        np.mean((samples - low_pass(samples, one, 100, order)) ** 2, axis=0) for one in cutoffs
    ]
    np.testing.assert_allclose(residual_squares(samples, cutoffs, 100, order), by_filter, rtol=0.02)


def test_what_the_filter_takes_of_white_noise():
    noise = np.random.default_rng(0).normal(0, 3, (200_000, 3))
    cutoffs = (5.0, 20.0, 45.0)
    taken, passed = white_noise(cutoffs, 100, 4)
    np.testing.assert_allclose(
        residual_squares(noise, cutoffs, 100, 4).mean(axis=1), 9 * taken, rtol=0.02
    )
    impulse = np.zeros((2001, 1))
    impulse[1000] = 1.0
    own = [low_pass(impulse, one, 100, 4)[1000, 0] for one in cutoffs]
    np.testing.assert_allclose(passed, own, rtol=1e-3)


@pytest.mark.parametrize("rate", [50.0, 120.0, 250.0, 1000.0])
@pytest.mark.parametrize("noise", [0.5, 2.0, 5.0])
def test_residual_analysis_finds_the_noise(rate, noise):
    frames = 3000
    samples = banded(8, rate, frames)[:, 0]
    samples = samples + np.random.default_rng(2).normal(0, noise, samples.shape)
    frequencies = candidates(rate)
    cutoffs = tuple(frequencies.tolist())
    taken, _ = white_noise(cutoffs, rate, 4)
    squares = residual_squares(samples, cutoffs, rate, 4)
    found = np.sqrt(noise_variance(squares, taken, frequencies, rate))
    np.testing.assert_allclose(found, noise, rtol=0.08)


@pytest.mark.parametrize("rate", [60.0, 120.0, 500.0])
@pytest.mark.parametrize("bandwidth", [3.0, 6.0, 12.0])
def test_the_cutoff_is_nearly_as_good_as_the_best(rate, bandwidth):
    clean = banded(bandwidth, rate, round(12 * rate))
    samples = clean + np.random.default_rng(3).normal(0, 2, clean.shape)
    recording = record(samples, rate=rate)
    (done,) = smooth_with(("butterworth", {}), recording, whole(recording)).runs
    best = [
        min(
            rms(low_pass(samples[:, 0, axis], one, rate, 4) - clean[:, 0, axis])
            for one in candidates(rate)
        )
        for axis in range(3)
    ]
    found = [rms(done.values[:, axis] - clean[:, 0, axis]) for axis in range(3)]
    assert max(np.array(found) / best) < 1.1
    np.testing.assert_allclose(done.chosen["noise"], 2.0, rtol=0.1)


def test_faster_motion_has_higher_cutoffs_and_winters_are_lower():
    chosen = {}
    for bandwidth in (3.0, 6.0, 12.0):
        samples = banded(bandwidth, 120, 2000)
        recording = record(samples + np.random.default_rng(4).normal(0, 2, samples.shape), rate=120)
        for rule in ("least-error", "winter"):
            (done,) = smooth_with(("butterworth", {"rule": rule}), recording, whole(recording)).runs
            chosen[rule, bandwidth] = np.array(done.chosen["cutoff_hz"])
    for rule in ("least-error", "winter"):
        assert (chosen[rule, 3.0] < chosen[rule, 6.0]).all()
        assert (chosen[rule, 6.0] < chosen[rule, 12.0]).all()
    for bandwidth in (3.0, 6.0, 12.0):
        assert (chosen["winter", bandwidth] <= chosen["least-error", bandwidth]).all()


def test_one_cutoff_for_each_marker_or_for_all():
    clean = np.concatenate([banded(3, 120, 1000), banded(12, 120, 1000)], axis=1)
    recording = record(clean + np.random.default_rng(5).normal(0, 2, clean.shape), rate=120)

    def cutoffs(kind):
        result = smooth_with(("butterworth", {"cutoff_for": kind}), recording, whole(recording))
        return [done.chosen["cutoff_hz"] for done in result.runs]

    slow, fast = cutoffs("marker")
    assert len(set(slow)) == len(set(fast)) == 1
    assert slow[0] < fast[0]
    one, other = cutoffs("all")
    assert one == other
    assert len(set(one)) == 1
    assert slow[0] <= one[0] <= fast[0]


def test_short_pieces_share_the_cutoff_of_long_ones():
    clean = banded(6, 120, 400)
    points = clean + np.random.default_rng(6).normal(0, 2, clean.shape)
    points[[20, 25]] = np.nan
    recording = record(points, rate=120)
    result = smooth_with(("butterworth", {}), recording, whole(recording))
    assert [left.stretch for left in result.untouched] == [Gap(0, 21, 25)]
    assert (result.runs[0].shifts[:20] > 0).all()
    (left,) = smooth_with(
        ("butterworth", {}), record(points[:25], rate=120), [Gap(0, 0, 20)]
    ).untouched
    assert "Only 20 samples on end: this needs at least 32" in left.reason


@pytest.mark.parametrize(
    ("params", "message"),
    [
        ({"cutoff_hz": "50"}, "cutoff_hz must be above 0 and below half the frame rate, 50 Hz"),
        ({"cutoff_hz": "60"}, "below half the frame rate, 50 Hz, not 60"),
        ({"order": "3"}, "order must be an even number from 2, not 3"),
        ({"order": "0"}, "order must be at least 2, not 0"),
        ({"cutoff_hz": "-1"}, "cutoff_hz must be at least"),
        ({"rule": "magic"}, "rule must be one of least-error, winter"),
    ],
)
def test_impossible_parameters_are_refused(params, message):
    recording = record(banded(6, 100, 100))
    with pytest.raises(ValueError, match=message):
        smooth_with(("butterworth", params), recording, whole(recording))
