"""The residual against the cut-off, by the filter itself and for noise that is known."""

import numpy as np

from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.smooth.low_pass import low_pass
from mocapmend_algorithms.smooth.residual_curve import residual_curve

RATE = 120.0


def recording_of(points: np.ndarray) -> Recording:
    return Recording(points[:, None], ("A",), RATE)


def waves(frames: int) -> np.ndarray:
    time = np.arange(frames)[:, None] / RATE
    return 200.0 * np.sin(2 * np.pi * np.array([0.7, 1.1, 1.6]) * time)


def test_it_is_what_the_filter_takes() -> None:
    noise = np.random.default_rng(1).normal(0.0, 1.0, (900, 3))
    points = waves(900) + noise
    curve = residual_curve(recording_of(points), Gap(0, 0, 900), 4)
    assert curve is not None
    for place in range(20, len(curve.cutoffs), 5):
        taken = points - low_pass(points, float(curve.cutoffs[place]), RATE, 4)
        inside = np.sqrt(np.mean(taken[60:-60] ** 2, axis=0))
        np.testing.assert_allclose(curve.residuals[place], inside, rtol=0.12)


def test_the_line_meets_zero_at_the_noise() -> None:
    sizes = np.array([0.5, 1.0, 4.0])
    noise = np.random.default_rng(2).normal(0.0, sizes, (3000, 3))
    curve = residual_curve(recording_of(waves(3000) + noise), Gap(0, 0, 3000), 4)
    assert curve is not None
    np.testing.assert_allclose(curve.noise, sizes, rtol=0.08)
    high = np.abs(curve.cutoffs / (RATE / 2) - 0.65) < 0.2
    np.testing.assert_allclose(curve.noise_line[high], curve.residuals[high], rtol=0.1)
    assert (np.diff(curve.noise_line, axis=0) < 0).all()


def test_pieces_count_by_their_length_and_short_ones_not_at_all() -> None:
    points = waves(400) + np.random.default_rng(3).normal(0.0, 1.0, (400, 3))
    whole = residual_curve(recording_of(points[:300]), Gap(0, 0, 300), 4)
    points[300] = np.nan
    points[310] = np.nan
    points[311:] = np.nan
    cut = residual_curve(recording_of(points), Gap(0, 0, 400), 4)
    assert whole is not None
    assert cut is not None
    np.testing.assert_allclose(cut.residuals, whole.residuals)
    assert residual_curve(recording_of(points), Gap(0, 300, 312), 4) is None
