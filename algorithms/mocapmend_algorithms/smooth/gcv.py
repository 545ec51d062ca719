"""Quintic smoothing spline with generalised cross-validation (Woltring's GCVSPL).

W86 = Woltring 1986, A Fortran package for generalized, cross-validatory spline smoothing and
differentiation, Advances in Engineering Software 8(2):104-113. How much is smoothed is chosen by
generalised cross-validation (Craven and Wahba 1979; W86's mode 2), or by the noise of the samples
where it is known (the unbiased risk; W86's mode 3).

W86 smooths as much everywhere; by default, impacts are smoothed less here (see `impacts`).

W86 calls 1 / (1 + p w^6) the spline's response: that of a Butterworth filter of order 3 that goes
forwards and backwards. The cut-off that is told is where this halves the power.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.impacts import lighter_at_impacts
from mocapmend_algorithms.smooth.spline import (
    LEAST,
    by_axis,
    cutoff_grid,
    degrees_left,
    lowest_cutoff,
    penalty,
    residuals,
)
from mocapmend_algorithms.smooth.stretches import check_runs, smooth_runs

QUINTIC = 3


@dataclass(frozen=True)
class GcvParams:
    """Parameters of `gcv`."""

    cutoff_hz: float | None = option(
        None,
        label="Cut-off",
        text="Motion faster than this is taken for noise: where the power is halved. Automatic: "
        "generalised cross-validation, or the measurement noise where it is given.",
        minimum=0.01,
        maximum=100_000.0,
        unit="Hz",
    )
    noise_mm: float | None = option(
        None,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate: about so much is smoothed away. "
        "Automatic: generalised cross-validation.",
        minimum=0.001,
        maximum=1000.0,
        unit="mm",
    )
    keep_impacts: bool = option(
        True,  # noqa: FBT003 - the default of a form
        label="Keep impacts",
        text="Smooths less where the motion is much faster than elsewhere, as at a foot strike or "
        "a kick. Off: as much everywhere, as Woltring's program does.",
    )


def gcv(
    recording: Recording, runs: Sequence[Run], params: GcvParams, progress: Progress, /
) -> SmoothResult:
    """Smooth runs with a quintic spline.

    Parameters
    ----------
    recording : Recording
        Not changed.
    runs : sequence of Run
        Where samples may change.
    params : GcvParams
        With `cutoff_hz` and `noise_mm` None, the smoothing is chosen by generalised
        cross-validation.
    progress : Progress
        Called before each run.

    Returns
    -------
    SmoothResult
        `chosen` holds `cutoff_hz` and the estimated `noise` per axis, and with `keep_impacts`
        the `share_at_impacts`, from 0 to 1, of samples that are smoothed less.

    Raises
    ------
    ValueError
        If both the cut-off and the noise are given, or one is impossible, or the runs are
        outside the recording or overlap.
    """
    check_runs(recording, runs)
    _check(params, recording.rate)
    return smooth_runs(
        recording,
        runs,
        method="gcv",
        params=params,
        least=LEAST,
        smooth=partial(_smooth, rate=recording.rate, mm=recording.mm, params=params),
        progress=progress,
    )


def _smooth(
    samples: list[FloatArray], *, rate: float, mm: float, params: GcvParams
) -> tuple[list[FloatArray], dict[str, Any]]:
    grid = cutoff_grid(rate) if params.cutoff_hz is None else (params.cutoff_hz,)
    noise = None if params.noise_mm is None else params.noise_mm / mm
    penalties = tuple(penalty(cutoff, rate, QUINTIC) for cutoff in grid)
    left = np.sum([degrees_left(len(one), penalties, QUINTIC) for one in samples], axis=0)
    squares = np.array(
        [sum(np.sum(residuals(one, p, QUINTIC) ** 2, axis=0) for one in samples) for p in penalties]
    )
    best = choose(squares, left, noise)
    spread = np.sqrt(squares[best, range(len(best))] / left[best])
    cutoffs = [grid[place] for place in best]
    chosen: dict[str, Any] = {"cutoff_hz": cutoffs, "noise": spread.tolist()}
    if not params.keep_impacts:
        chosen_penalties = [penalties[place] for place in best]
        return [by_axis(one, chosen_penalties, QUINTIC) for one in samples], chosen
    both = [lighter_at_impacts(one, np.array(cutoffs), spread, rate, QUINTIC) for one in samples]
    shares, sizes = [share for _, share in both], [len(one) for one in samples]
    chosen["share_at_impacts"] = float(np.average(shares, weights=sizes))
    return [curve for curve, _ in both], chosen


def choose(squares: FloatArray, left: FloatArray, noise: float | None) -> list[int]:
    """Choose the smoothing of each trajectory.

    Parameters
    ----------
    squares : ndarray, shape (penalties, trajectories)
        Sums of squared residuals.
    left : ndarray, shape (penalties,)
        Degrees of freedom that are left; see `spline.degrees_left`.
    noise : float or None
        Standard deviation of a coordinate; None for generalised cross-validation.

    Returns
    -------
    list of int
        The place of the penalty that minimises squares / left^2, or squares - 2 noise^2 left.
    """
    score = (
        squares / left[:, None] ** 2 if noise is None else squares - 2 * noise**2 * left[:, None]
    )
    return [int(place) for place in np.argmin(score, axis=0)]


def _check(params: GcvParams, rate: float) -> None:
    cutoff, noise = params.cutoff_hz, params.noise_mm
    if cutoff is not None and noise is not None:
        raise ValueError("give cutoff_hz or noise_mm, not both: each says how much to smooth")
    if noise is not None and not noise > 0:
        raise ValueError(f"noise_mm must be above 0 mm, not {noise:g}")
    lowest = lowest_cutoff(rate)
    if cutoff is not None and not lowest <= cutoff < rate / 2:
        raise ValueError(
            f"cutoff_hz must be from {lowest:.2g} Hz to below half the frame rate, "
            f"{rate / 2:g} Hz, not {cutoff:g}"
        )
