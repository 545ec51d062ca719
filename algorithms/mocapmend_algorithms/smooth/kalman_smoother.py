"""Kalman smoother of each coordinate alone, with the noises estimated from the samples.

The model is that of `fill.kalman`, a velocity that changes at random (white acceleration), or a
smoother one, an acceleration that changes at random (white jerk). How fast the motion changes and
how large the measurement noise is are both estimated: the ratio of the two is the one that makes
the samples most likely (of the values of a grid), given that nothing is known of the first state.

Smoothers and splines are two views of one thing: with these models the curves are a cubic and a
quintic smoothing spline (Wahba 1978, J. R. Stat. Soc. B 40(3):364-372). What differs from `gcv` is
how the smoothing is chosen, by likelihood instead of cross-validation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.cutoffs import cutoff_grid
from mocapmend_algorithms.smooth.stretches import check_runs, smooth_runs
from mocapmend_algorithms.smooth.walk_equations import walk

LEAST = 8
STATES = {"velocity": 2, "acceleration": 3}
TINY = 1e-12
"""Of the spread of a coordinate: less noise than that cannot be told from none."""


@dataclass(frozen=True)
class KalmanSmootherParams:
    """Parameters of `kalman_smoother`."""

    model: Literal["velocity", "acceleration"] = option(
        "acceleration",
        label="Constant",
        text="What is carried from frame to frame: the velocity, or the acceleration too, which "
        "makes a smoother curve.",
    )
    noise_mm: float | None = option(
        None,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate. Automatic: estimated together with "
        "how fast the motion changes.",
        minimum=0.001,
        maximum=1000.0,
        unit="mm",
    )


def kalman_smoother(
    recording: Recording, runs: Sequence[Run], params: KalmanSmootherParams, progress: Progress, /
) -> SmoothResult:
    """Smooth runs with a Kalman smoother.

    Parameters
    ----------
    recording : Recording
        Not changed.
    runs : sequence of Run
        Where samples may change.
    params : KalmanSmootherParams
        With `noise_mm` None, both noises are estimated for each axis.
    progress : Progress
        Called before each run.

    Returns
    -------
    SmoothResult
        `chosen` holds per axis the `noise` of the measurement, and the `cutoff_hz` at which the
        smoother halves the power far from the ends.

    Raises
    ------
    ValueError
        If the model is unknown or the noise not positive, or the runs are outside the recording
        or overlap.
    """
    check_runs(recording, runs)
    if params.model not in STATES:
        raise ValueError(f"model must be one of {', '.join(STATES)}, not {params.model!r}")
    if params.noise_mm is not None and not params.noise_mm > 0:
        raise ValueError(f"noise_mm must be above 0 mm, not {params.noise_mm:g}")
    noise = None if params.noise_mm is None else params.noise_mm / recording.mm
    states = STATES[params.model]
    return smooth_runs(
        recording,
        runs,
        method="kalman-smoother",
        params=params,
        least=LEAST,
        smooth=partial(_smooth, rate=recording.rate, states=states, noise=noise),
        progress=progress,
    )


def noise_ratio(cutoff: float, rate: float, states: int) -> float:
    """Return the r / q of a smoother that halves the power at a frequency.

    Far from the ends, a wave of angular frequency w (per frame) is multiplied by about
    1 / (1 + r / q w^(2 states)).

    Parameters
    ----------
    cutoff, rate : float
        In Hz.
    states : int
        2 with a velocity, 3 with an acceleration.
    """
    return float((np.sqrt(2) - 1) / (2 * np.pi * cutoff / rate) ** (2 * states))


def _smooth(
    samples: list[FloatArray], *, rate: float, states: int, noise: float | None
) -> tuple[list[FloatArray], dict[str, Any]]:
    grid = cutoff_grid(rate)
    ratios = [noise_ratio(cutoff, rate, states) for cutoff in grid]
    figures = [_figures(samples, states, ratio) for ratio in ratios]
    freedom = sum(len(one) for one in samples) - states * len(samples)
    # The sum that the curve minimises, in units of the measurement variance.
    squares = np.array([square for square, _ in figures])
    determinants = np.array([determinant for _, determinant in figures])[:, None]
    if noise is None:
        floor = max((TINY * np.ptp(one, axis=0) ** 2).max() for one in samples)
        unlikely = freedom * np.log(np.maximum(squares, max(floor, np.finfo(float).tiny)))
    else:
        unlikely = squares / noise**2
    best = np.argmin(unlikely + determinants, axis=0)
    smoothed = [
        np.stack(
            [
                walk(len(one), states, ratios[place]).positions(one[:, [axis]])[:, 0]
                for axis, place in enumerate(best.tolist())
            ],
            axis=1,
        )
        for one in samples
    ]
    found = np.sqrt(np.maximum(squares[best, range(best.size)], 0) / freedom).tolist()
    cutoffs = [grid[place] for place in best.tolist()]
    return smoothed, {
        "cutoff_hz": cutoffs,
        "noise": found if noise is None else [noise] * len(cutoffs),
    }


def _figures(samples: Sequence[FloatArray], states: int, ratio: float) -> tuple[FloatArray, float]:
    """Return the sum that the curve minimises, per axis, and the log-determinant of its odds.

    With S = sum of v^2 + (r / q) sum of w' Q^-1 w, minus twice the log-likelihood is, but for a
    constant, S / r + (frames - states) log(r / ratio) + log |N| + frames log(ratio), with N the
    matrix of `walk_equations`.
    """
    square, determinant = np.zeros(samples[0].shape[1]), 0.0
    for one in samples:
        solver = walk(len(one), states, ratio)
        square += np.sum(one * (one - solver.positions(one)), axis=0)
        determinant += solver.log_determinant + states * np.log(ratio)
    return square, determinant
