"""The settings of the constant-velocity filter among which the self-tests choose."""

from functools import partial

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.constant_velocity import bridge, prediction
from mocapmend_algorithms.fill.window import Candidate

INTERVALS_MS = (0.0, 25.0, 50.0, 100.0)
RATIOS = (1.0, 0.01, 0.1, 10.0, 100.0, 1000.0)
CAUSAL_RATIOS = (1.0, 0.01, 100.0)
LEAST_RATIO, MOST_RATIO = 1e-6, 1e6
VELOCITY_LAG_S = 0.1

Steps = tuple[int, ...]


def velocity_steps(interval_ms: float | None, rate: float) -> Steps:
    """Return the intervals of the constant-rate sampling (L21 eq. 4) to try, in frames.

    Parameters
    ----------
    interval_ms : float or None
        The interval; None: from that between consecutive frames to 100 ms.
    rate : float
        Frames per second (Hz).
    """
    intervals = INTERVALS_MS if interval_ms is None else (interval_ms,)
    return tuple(sorted({max(1, round(ms / 1000 * rate)) for ms in intervals}))


def two_sided(
    points: FloatArray, rate: float, mm: float, noise_mm: float | None
) -> list[Candidate]:
    """Return settings of the smoother.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        The marker's trajectory, NaN where missing.
    rate : float
        Frames per second (Hz).
    mm : float
        Millimetres per length unit.
    noise_mm : float or None
        Standard deviation of a measured coordinate; None: several are tried.
    """
    unit = _unit(points, rate) * mm
    return [
        Candidate(
            partial(_solve, ratio=ratio, step=1, causal=False),
            partial(_shape, ratio=ratio, step=1, causal=False),
            {"noise_mm": _noise(noise_mm, ratio, unit)},
        )
        for ratio in _ratios(noise_mm, unit, RATIOS)
    ]


def causal(
    points: FloatArray, rate: float, mm: float, noise_mm: float | None, steps: Steps
) -> list[Candidate]:
    """Return settings of the filter that looks back only.

    Parameters
    ----------
    points, rate, mm, noise_mm
        As for `two_sided`.
    steps : tuple of int
        See `velocity_steps`.
    """
    unit = _unit(points, rate) * mm
    return [
        Candidate(
            partial(_solve, ratio=ratio, step=step, causal=True),
            partial(_shape, ratio=ratio, step=step, causal=True),
            {
                "noise_mm": _noise(noise_mm, ratio, unit),
                "velocity_interval_ms": step * 1000 / rate,
            },
        )
        for step in steps
        for ratio in _ratios(noise_mm, unit, CAUSAL_RATIOS)
    ]


def _unit(points: FloatArray, rate: float) -> float:
    """Return the noise of ratio 1: only the ratio of the two noises matters for the values."""
    return float(np.sqrt(process_noise(points, rate) / rate**3))


def _ratios(noise_mm: float | None, unit: float, several: tuple[float, ...]) -> tuple[float, ...]:
    if noise_mm is None:
        return several
    ratio = (noise_mm / unit) ** 2 if unit > 0 else MOST_RATIO
    return (float(np.clip(ratio, LEAST_RATIO, MOST_RATIO)),)


def _noise(noise_mm: float | None, ratio: float, unit: float) -> float:
    return noise_mm if noise_mm is not None else float(np.sqrt(ratio) * unit)


def process_noise(points: FloatArray, rate: float) -> float:
    """Estimate the spectral density of a marker's acceleration.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        Its trajectory, NaN where missing.
    rate : float
        Frames per second (Hz).

    Returns
    -------
    float
        In length unit^2 / s^3 per axis, from the change of velocity within 0.1 s (var of the
        second difference over h is 2 q h^3 / 3); 0 where the marker is never seen long enough.
    """
    for lag in (max(1, round(VELOCITY_LAG_S * rate)), 1):
        change = points[2 * lag :] - 2 * points[lag:-lag] + points[: -2 * lag]
        square = np.sum(change**2, axis=1)
        square = square[~np.isnan(square)]
        if square.size:
            return float(np.mean(square) / 3 * 1.5 * (rate / lag) ** 3)
    return 0.0


def _weights(
    knots: IntArray, length: int, *, ratio: float, step: int, causal: bool
) -> tuple[FloatArray, FloatArray]:
    frames = tuple(knots.tolist())
    return prediction(frames, length, ratio, step) if causal else bridge(frames, length, ratio)


def _solve(
    knots: IntArray, values: FloatArray, length: int, *, ratio: float, step: int, causal: bool
) -> FloatArray:
    weights, _ = _weights(knots, length, ratio=ratio, step=step, causal=causal)
    after = int(np.searchsorted(knots, 0))
    first, last = (after - 2, after - 1) if causal else (after - 1, after)
    slope = (values[last] - values[first]) / (knots[last] - knots[first])
    # A straight line passes unchanged, so taking one out first costs nothing and saves digits.
    around = values - values[first] - (knots - knots[first])[:, None] * slope
    line = values[first] + (np.arange(length) - knots[first])[:, None] * slope
    filled: FloatArray = weights @ around + line
    return filled


def _shape(knots: IntArray, length: int, *, ratio: float, step: int, causal: bool) -> FloatArray:
    return _weights(knots, length, ratio=ratio, step=step, causal=causal)[1]
