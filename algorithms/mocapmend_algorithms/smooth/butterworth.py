"""Zero-lag Butterworth low-pass filter, its cut-off given or chosen by residual analysis.

`order` and `cutoff_hz` are those of both passes together, with Winter's correction; see
`low_pass`.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.low_pass import low_pass, residual_squares, white_noise
from mocapmend_algorithms.smooth.residual_analysis import (
    candidates,
    choose_cutoffs,
    noise_variance,
)
from mocapmend_algorithms.smooth.stretches import check_runs, cut, smooth_runs, sort_pieces

LEAST_TO_CHOOSE = 32
"""Samples on end from which a cut-off can be chosen; shorter pieces of the run have the same."""


@dataclass(frozen=True)
class ButterworthParams:
    """Parameters of `butterworth`."""

    cutoff_hz: float | None = option(
        None,
        label="Cut-off",
        text="Motion faster than this is taken for noise: where the power is halved. Automatic: "
        "residual analysis.",
        minimum=0.01,
        maximum=100_000.0,
        unit="Hz",
    )
    cutoff_for: Literal["axis", "marker", "all"] = option(
        "axis",
        label="Choose for",
        text="Automatic cut-off only: one for each axis of each marker, one for each marker, or "
        "one for all that is smoothed.",
    )
    rule: Literal["least-error", "winter"] = option(
        "least-error",
        label="Rule",
        text="Automatic cut-off only. Least error: the cut-off with the least expected error, "
        "given the noise that residual analysis finds. Winter: where the residual equals the "
        "noise, which smooths more.",
    )
    order: int = option(
        4,
        label="Order",
        text="Of the filter that goes forwards and backwards, both ways together: an even "
        "number. Higher cuts more sharply and rings more beside impacts.",
        minimum=2,
        maximum=12,
    )


def butterworth(
    recording: Recording, runs: Sequence[Run], params: ButterworthParams, progress: Progress, /
) -> SmoothResult:
    """Smooth runs with a zero-lag low-pass filter.

    Parameters
    ----------
    recording : Recording
        Not changed.
    runs : sequence of Run
        Where samples may change.
    params : ButterworthParams
        With `cutoff_hz` None, cut-offs are chosen by residual analysis.
    progress : Progress
        Called before each run.

    Returns
    -------
    SmoothResult
        `chosen` holds `cutoff_hz` per axis, and `noise` where cut-offs were chosen.

    Raises
    ------
    ValueError
        If the order is not even or the cut-off not below half the frame rate, or the runs are
        outside the recording or overlap.
    """
    check_runs(recording, runs)
    _check(params, recording.rate)
    chooser = _Chooser(params, recording.rate)
    least = 2 * params.order + 1
    least_longest = max(least, LEAST_TO_CHOOSE) if params.cutoff_hz is None else least
    if params.cutoff_hz is None and params.cutoff_for == "all":
        chooser.look_at_all(recording, runs, least_longest, part(progress, 0.0, 0.5))
        progress = part(progress, 0.5, 1.0)

    def smooth(samples: list[FloatArray]) -> tuple[list[FloatArray], dict[str, Any]]:
        cutoffs, chosen = chooser.choose(samples)
        return [_by_axis(one, cutoffs, recording.rate, params.order) for one in samples], chosen

    return smooth_runs(
        recording,
        runs,
        method="butterworth",
        params=params,
        least=least,
        least_longest=least_longest,
        smooth=smooth,
        progress=progress,
    )


class _Chooser:
    """Chooses the cut-offs of a run."""

    def __init__(self, params: ButterworthParams, rate: float) -> None:
        self._params = params
        self._rate = rate
        self._frequencies = candidates(rate)
        self._of_all: FloatArray | None = None

    def look_at_all(
        self, recording: Recording, runs: Sequence[Run], least: int, progress: Progress
    ) -> None:
        """Analyse all runs together, for one cut-off."""
        total, count = np.zeros(self._frequencies.size), 0
        for number, run in enumerate(runs):
            progress(number / len(runs))
            for piece in sort_pieces(recording, run, least)[0]:
                total += piece.samples * self._squares(cut(recording, run, piece)).mean(axis=1)
                count += piece.samples
        self._of_all = total[:, None] / max(count, 1)

    def choose(self, samples: Sequence[FloatArray]) -> tuple[FloatArray, dict[str, Any]]:
        """Return a cut-off per axis and what to tell of it."""
        if self._params.cutoff_hz is not None:
            cutoffs = np.full(3, self._params.cutoff_hz)
            return cutoffs, {"cutoff_hz": cutoffs.tolist()}
        squares = self._of_all if self._of_all is not None else self._of_run(samples)
        taken, passed = white_noise(tuple(self._frequencies), self._rate, self._params.order)
        noise = noise_variance(squares, taken, self._frequencies, self._rate)
        places = choose_cutoffs(squares, noise, passed, self._params.rule)
        cutoffs = np.broadcast_to(self._frequencies[places], 3)
        spread = np.broadcast_to(np.sqrt(noise), 3)
        return cutoffs, {"cutoff_hz": cutoffs.tolist(), "noise": spread.tolist()}

    def _of_run(self, samples: Sequence[FloatArray]) -> FloatArray:
        long = [one for one in samples if len(one) >= LEAST_TO_CHOOSE]
        sizes = [len(one) for one in long]
        squares = np.average([self._squares(one) for one in long], axis=0, weights=sizes)
        return squares if self._params.cutoff_for == "axis" else squares.mean(axis=1)[:, None]

    def _squares(self, samples: FloatArray) -> FloatArray:
        """Return the mean square residuals, shape (frequencies, 3)."""
        cutoffs = self._frequencies.tolist()
        return residual_squares(samples, cutoffs, self._rate, self._params.order)


def _by_axis(samples: FloatArray, cutoffs: FloatArray, rate: float, order: int) -> FloatArray:
    columns = [
        low_pass(column, cutoff, rate, order)
        for column, cutoff in zip(samples.T, cutoffs.tolist(), strict=True)
    ]
    return np.stack(columns, axis=1)


def _check(params: ButterworthParams, rate: float) -> None:
    if params.order < 2 or params.order % 2:
        raise ValueError(f"order must be an even number from 2, not {params.order}")
    cutoff = params.cutoff_hz
    if cutoff is not None and not 0 < cutoff < rate / 2:
        raise ValueError(
            f"cutoff_hz must be above 0 and below half the frame rate, {rate / 2:g} Hz, "
            f"not {cutoff:g}"
        )
