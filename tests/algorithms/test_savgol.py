"""The moving polynomial against scipy, and the window that cross-validation chooses."""

import numpy as np
import pytest
from scipy.signal import savgol_coeffs, savgol_filter
from smooth_samples import noisy, rms, smooth_with, whole
from synthetic import record

from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.savgol import half_power, odd_frames


def test_windows_are_the_nearest_odd_numbers():
    assert [odd_frames(110, rate) for rate in (30, 50, 100, 1000)] == [3, 5, 11, 109]
    assert [odd_frames(1000 * frames / 100, 100) for frames in (5, 6.9, 7.1)] == [5, 7, 7]


def test_the_same_as_scipy():
    recording, _ = noisy(300, 1)
    variant = ("savgol", {"window_ms": "110", "order": "2"})
    (done,) = smooth_with(variant, recording, whole(recording)).runs
    same = savgol_filter(recording.points[:, 0], 11, 2, axis=0)
    np.testing.assert_allclose(done.values, same, atol=1e-9)
    assert done.chosen["window_frames"] == [11, 11, 11]


@pytest.mark.parametrize("order", [1, 2, 3, 5])
def test_polynomials_pass_unchanged(order):
    time = np.linspace(-1, 1, 200)[:, None, None]
    points = 100 * time ** np.arange(order + 1)[-3:] * np.ones((200, 1, 1))
    points = np.broadcast_to(points.sum(axis=2, keepdims=True), (200, 1, 3)).copy()
    recording = record(points)
    (done,) = smooth_with(("savgol", {"order": str(order)}), recording, whole(recording)).runs
    np.testing.assert_allclose(done.values, points[:, 0], atol=1e-9)


def test_the_cutoff_is_where_the_window_halves_the_power():
    for window, order in ((11, 2), (21, 3), (31, 4)):
        frequency = half_power(window, order)
        weights = savgol_coeffs(window, order)
        at = np.arange(window) - window // 2
        gain = abs(np.sum(weights * np.cos(2 * np.pi * frequency * at)))
        assert gain == pytest.approx(np.sqrt(0.5), abs=0.01)


def test_the_window_is_nearly_the_best():
    recording, clean = noisy(800, 3)
    for done in smooth_with(("savgol", {}), recording, whole(recording)).runs:
        marker = done.run.marker
        truth, samples = clean[:, marker], recording.points[:, marker]
        best = min(rms(savgol_filter(samples, w, 3, axis=0) - truth) for w in range(5, 61, 2))
        assert rms(done.values - truth) < 1.1 * best


def test_windows_longer_than_a_stretch_leave_it():
    recording, _ = noisy(100, 1)
    (left,) = smooth_with(("savgol", {"window_ms": "1200"}), recording, whole(recording)).untouched
    assert left.stretch == Gap(0, 0, 100)
    assert left.reason == "Only 100 samples on end: this needs at least 121."


@pytest.mark.parametrize(
    ("params", "message"),
    [
        ({"window_ms": "40"}, "window_ms must be at least 80 ms at 50 Hz: order 3 needs 5 frames"),
        ({"window_ms": "5"}, "and 5 ms are 1"),
        ({"order": "0"}, "order must be at least 1, not 0"),
        ({"window_ms": "0"}, "window_ms must be at least 1"),
    ],
)
def test_impossible_parameters_are_refused(params, message):
    recording, _ = noisy(100, 1, rate=50.0)
    with pytest.raises(ValueError, match=message):
        smooth_with(("savgol", params), recording, whole(recording))
