"""Recordings with noise for the tests of smoothing."""

import numpy as np
from synthetic import record, smooth_motion

from mocapmend_algorithms import Gap
from mocapmend_algorithms.smooth.registry import SMOOTHERS, parse_params

VARIANTS = [
    ("butterworth", {}),
    ("butterworth", {"cutoff_for": "marker", "rule": "winter"}),
    ("butterworth", {"cutoff_for": "all"}),
    ("butterworth", {"cutoff_hz": "10", "order": "6"}),
    ("savgol", {}),
    ("savgol", {"window_ms": "200", "order": "2"}),
    ("gcv", {}),
    ("gcv", {"keep_impacts": "false"}),
    ("gcv", {"noise_mm": "2"}),
    ("gcv", {"cutoff_hz": "6"}),
    ("kalman-smoother", {}),
    ("kalman-smoother", {"model": "acceleration"}),
    ("kalman-smoother", {"noise_mm": "2"}),
]
CHOOSE_ALONE = [variant for variant in VARIANTS if variant[1].get("cutoff_for") != "all"]
FIXED = [
    ("butterworth", {"cutoff_hz": "8"}),
    ("savgol", {"window_ms": "150"}),
]
"""Nothing is chosen by the samples."""


def smooth_with(variant, recording, runs, progress=lambda fraction: None):
    """Smooth with a method and parameters given as text."""
    smoother = SMOOTHERS[variant[0]]
    return smoother.function(recording, runs, parse_params(smoother, variant[1]), progress)


def whole(recording):
    """Every marker from the first frame to the last."""
    return [Gap(marker, 0, recording.frames) for marker in range(recording.markers)]


def noisy(frames=400, markers=2, *, seed=0, rate=100.0, noise=2.0, unit="mm"):
    """Slow motion with white noise of some millimetres: the recording, and the points without."""
    scale = {"mm": 1.0, "cm": 10.0, "m": 1000.0}[unit]
    clean = smooth_motion(frames, markers, seed=seed, rate=rate)
    jitter = np.random.default_rng(seed + 99).normal(0.0, noise, clean.shape)
    return record((clean + jitter) / scale, rate=rate, unit=unit), clean / scale


def rms(difference):
    """Root mean square of what is not missing."""
    return float(np.sqrt(np.nanmean(np.asarray(difference) ** 2)))
