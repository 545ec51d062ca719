"""Kalman smoother of each coordinate alone, with the noises estimated from the samples.

The model is that of `fill.kalman`, a velocity that changes at random (white acceleration), or a
smoother one, an acceleration that changes at random (white jerk). How fast the motion changes and
how large the measurement noise is are both estimated: the ratio of the two is the one of a grid
that makes the samples most likely, whatever the first state (de Jong 1991, Annals of Statistics
19(2):1073-1083).

Where every frame is seen, what the Rauch-Tung-Striebel smoother of these models makes of the
samples is a cubic and a quintic smoothing spline (Wahba 1978; see `spline`), and they are worked
out as such. What differs from `gcv` is how much is smoothed: by likelihood instead of
cross-validation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.spline import (
    LEAST,
    by_axis,
    cutoff_grid,
    penalty,
    roughness,
)
from mocapmend_algorithms.smooth.stretches import check_runs, smooth_runs

STATES = {"velocity": 2, "acceleration": 3}
SMALLEST = np.finfo(np.float64).tiny


@dataclass(frozen=True)
class KalmanSmootherParams:
    """Parameters of `kalman_smoother`."""

    model: Literal["velocity", "acceleration"] = option(
        "velocity",
        label="Constant",
        text="What is carried from frame to frame: the velocity, or the acceleration too, which "
        "makes a smoother curve and rounds off more of an impact.",
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


def _smooth(
    samples: list[FloatArray], *, rate: float, states: int, noise: float | None
) -> tuple[list[FloatArray], dict[str, Any]]:
    grid = cutoff_grid(rate)
    ratios = np.array([penalty(cutoff, rate, states) for cutoff in grid])
    rough, determinants = _likelihood(samples, ratios.tolist(), states)
    freedom = sum(len(one) - states for one in samples)
    # Variance of the measurement, per axis, where it is not known.
    variance = ratios[:, None] * rough / freedom
    if noise is None:
        unlikely = freedom * np.log(np.maximum(rough, SMALLEST))
    else:
        unlikely = ratios[:, None] * rough / noise**2 - freedom * np.log(ratios)[:, None]
    best = np.argmin(unlikely + determinants[:, None], axis=0).tolist()
    smoothed = [by_axis(one, ratios[best].tolist(), states) for one in samples]
    found = np.sqrt(variance[best, range(len(best))]).tolist()
    return smoothed, {
        "cutoff_hz": [grid[place] for place in best],
        "noise": found if noise is None else [noise] * len(best),
    }


def _likelihood(
    samples: Sequence[FloatArray], ratios: Sequence[float], states: int
) -> tuple[FloatArray, FloatArray]:
    """Return the roughness of all pieces, (ratios, axes), and their log-determinants, (ratios,).

    With q the density of the process noise and r / q the ratio, minus twice the log-likelihood is,
    but for a constant, roughness / q + degrees of freedom x log q + log-determinant.
    """
    rough = np.zeros((len(ratios), samples[0].shape[1]))
    determinants = np.zeros(len(ratios))
    for row, ratio in enumerate(ratios):
        for one in samples:
            square, determinant = roughness(one, ratio, states)
            rough[row] += square
            determinants[row] += determinant
    return rough, determinants
