"""Zero-lag Butterworth low-pass filter.

The samples pass a Butterworth filter forwards and backwards, so that nothing is delayed. Two
passes of a filter of order n attenuate as one of order 2 n would, and the frequency that one pass
halves in power the two quarter. `order` is that of both passes together (the "fourth-order
zero-lag filter" of the field has two passes of order 2), and `cutoff_hz` is where both passes
together halve the power (-3 dB): each pass is designed for the higher frequency that Winter's
correction gives,

    tan(pi f_pass / rate) = tan(pi f_cutoff / rate) / (sqrt(2) - 1)^(1 / order).

W09 = Winter 2009, Biomechanics and Motor Control of Human Movement, 4th ed., section 3.4.4.2; for
order 4 the factor is his 0.802. A program without the correction has to be given a cut-off
higher by 1 / 0.802 for the same curve.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothResult
from mocapmend_algorithms.smooth.residual_analysis import (
    candidates,
    choose_cutoffs,
    noise_variance,
)
from mocapmend_algorithms.smooth.stretches import check_runs, cut, smooth_runs, sort_pieces

LEAST_TO_CHOOSE = 32
"""Samples on end from which a cut-off can be chosen."""
PAD_PERIODS = 1.0
"""Periods of the cut-off by which the samples are continued at their ends."""
SPECTRUM = 2048
"""Frequencies by which means over all of them are taken."""


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
    if params.cutoff_hz is None:
        least = max(least, LEAST_TO_CHOOSE)
    if params.cutoff_hz is None and params.cutoff_for == "all":
        chooser.look_at_all(recording, runs, least, part(progress, 0.0, 0.5))
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
        smooth=smooth,
        progress=progress,
    )


def low_pass(samples: FloatArray, cutoff: float, rate: float, order: int) -> FloatArray:
    """Filter samples forwards and backwards.

    Parameters
    ----------
    samples : ndarray, shape (samples, ...)
        Without a gap, more than one; each column is filtered.
    cutoff : float
        Where both passes together halve the power, in Hz, below half the rate.
    rate : float
        Samples per second (Hz).
    order : int
        Of both passes together, even.

    Returns
    -------
    ndarray, shape (samples, ...)
    """
    from scipy.signal import sosfiltfilt

    sections = _sections(cutoff, rate, order)
    pad = min(len(samples) - 1, int(np.ceil(PAD_PERIODS * rate / cutoff)))
    filtered: FloatArray = sosfiltfilt(sections, samples, axis=0, padlen=pad)
    return filtered


@lru_cache(maxsize=256)
def _sections(cutoff: float, rate: float, order: int) -> FloatArray:
    from scipy.signal import butter

    sections: FloatArray = butter(
        order // 2, pass_cutoff(cutoff, rate, order), fs=rate, output="sos"
    )
    return sections


def pass_cutoff(cutoff: float, rate: float, order: int) -> float:
    """Return the cut-off of each of two passes that together have the given one, in Hz."""
    correction = (np.sqrt(2) - 1) ** (1 / order)
    return float(rate / np.pi * np.arctan(np.tan(np.pi * cutoff / rate) / correction))


@lru_cache(maxsize=8)
def white_noise(
    cutoffs: tuple[float, ...], rate: float, order: int
) -> tuple[FloatArray, FloatArray]:
    """Say what the filter does to white noise.

    Parameters
    ----------
    cutoffs : tuple of float
        In Hz.
    rate, order
        As for `low_pass`.

    Returns
    -------
    taken : ndarray, shape (cutoffs,)
        Share of its power that is in the residual.
    passed : ndarray, shape (cutoffs,)
        Mean of the response over all frequencies.
    """
    warped = np.tan(np.pi / 2 * (np.arange(SPECTRUM) + 0.5) / SPECTRUM)
    edges = np.tan(
        np.pi * np.array([pass_cutoff(cutoff, rate, order) for cutoff in cutoffs]) / rate
    )
    response = 1 / (1 + (warped / edges[:, None]) ** order)
    return np.mean((1 - response) ** 2, axis=1), np.mean(response, axis=1)


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
        sizes = [len(one) for one in samples]
        squares = np.average([self._squares(one) for one in samples], axis=0, weights=sizes)
        return squares if self._params.cutoff_for == "axis" else squares.mean(axis=1)[:, None]

    def _squares(self, samples: FloatArray) -> FloatArray:
        """Return the mean square residuals, shape (frequencies, 3)."""
        order, rate = self._params.order, self._rate
        return np.array(
            [
                np.mean((samples - low_pass(samples, cutoff, rate, order)) ** 2, axis=0)
                for cutoff in self._frequencies.tolist()
            ]
        )


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
