"""Constant-velocity Kalman filter and smoother of one marker (L21).

L21 = Wang, Lü, Mu 2021, Techniques of Automation and Applications 40(4):116-119. The state is
[f, v], position and velocity, and f_t = f_(t-1) + v dt (eqs. 2, 3); the velocity changes at random
(white acceleration). The three axes are filtered alike, so one 2 x 2 covariance serves all, and
what the filter makes of a window is a fixed matrix times the observed samples.

Two-sided, the default: filters from both sides are combined in the gap, and what is left over at
the two edge samples is carried linearly into it. Causal: the filter from the left alone, as a live
system would show; it does not meet the edges.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.constant_velocity import bridge, prediction
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.fill.window import (
    Candidate,
    WindowMethod,
    fill_windows,
)
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

REACH = 16
INTERVALS_MS = (0.0, 25.0, 50.0, 100.0)
RATIOS = (1.0, 0.01, 0.1, 10.0, 100.0, 1000.0)
CAUSAL_RATIOS = (1.0, 0.01, 100.0)
LEAST_RATIO, MOST_RATIO = 1e-6, 1e6
VELOCITY_LAG_S = 0.1

Steps = tuple[int, ...]


@dataclass(frozen=True)
class KalmanParams:
    """Parameters of `kalman`."""

    direction: Literal["two-sided", "causal"] = option(
        "two-sided",
        label="Direction",
        text="Two-sided uses the samples before and after the gap; causal only those before, "
        "as a live system must.",
    )
    noise_mm: float | None = option(
        None,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate. More noise means that more samples "
        "beside the gap share in its velocity. Automatic: chosen by self-tests for each gap.",
        minimum=0.0,
        maximum=1000.0,
        unit="mm",
    )
    velocity_interval_ms: float | None = option(
        None,
        label="Velocity interval",
        text="Causal only: the fixed interval over which the velocity is taken; 0 takes it "
        "between consecutive frames. Automatic: chosen by self-tests for each gap.",
        minimum=0.0,
        maximum=1000.0,
        unit="ms",
    )


def kalman(
    recording: Recording, gaps: Sequence[Gap], params: KalmanParams, progress: Progress, /
) -> FillResult:
    """Fill gaps with the constant-velocity model.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        Those at the beginning and the end of the recording stay open.
    params : KalmanParams
        What is None is chosen per gap by self-tests.
    progress : Progress
        Called before each gap.

    Returns
    -------
    FillResult
        `sigma` is the smoother's, multiplied by a factor that the self-tests measure.
    """
    causal = params.direction == "causal"
    steps = _steps(params.velocity_interval_ms, recording.rate) if causal else (1,)
    method = WindowMethod(
        lambda points: _candidates(points, recording, params, steps),
        "the filter",
        reach=max(REACH, 4 * max(steps)),
        least_before=2 if causal else 1,
    )
    return fill_windows(recording, gaps, method, progress)


def _steps(interval_ms: float | None, rate: float) -> Steps:
    intervals = INTERVALS_MS if interval_ms is None else (interval_ms,)
    return tuple(sorted({max(1, round(ms / 1000 * rate)) for ms in intervals}))


def _candidates(
    points: FloatArray, recording: Recording, params: KalmanParams, steps: Steps
) -> list[Candidate]:
    causal = params.direction == "causal"
    rate = recording.rate
    # Only the ratio of the two noises matters; the second turns a ratio into millimetres.
    unit = np.sqrt(process_noise(points, rate) / rate**3) * recording.mm
    ratios: tuple[float, ...] = CAUSAL_RATIOS if causal else RATIOS
    if params.noise_mm is not None:
        ratio = (params.noise_mm / unit) ** 2 if unit > 0 else MOST_RATIO
        ratios = (float(np.clip(ratio, LEAST_RATIO, MOST_RATIO)),)
    return [
        Candidate(
            partial(_solve, ratio=ratio, step=step, causal=causal),
            partial(_shape, ratio=ratio, step=step, causal=causal),
            _notes(params, ratio, unit, step * 1000 / rate),
        )
        for step in steps
        for ratio in ratios
    ]


def _notes(params: KalmanParams, ratio: float, unit: float, interval_ms: float) -> dict[str, Any]:
    noise = params.noise_mm if params.noise_mm is not None else float(np.sqrt(ratio) * unit)
    notes: dict[str, Any] = {"noise_mm": noise}
    if params.direction == "causal":
        notes["velocity_interval_ms"] = interval_ms
    return notes


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
