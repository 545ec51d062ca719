"""Candidates of `auto` that look at the marker alone: Gaussian processes over time.

They see the samples beside the gap and nothing else, so that donors that come and go beside it
cost them none. In short gaps of a marker with poor donors nothing does better.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.gaussian import Kernel, of_time
from mocapmend_algorithms.fill.lessons import BORDERS


def regress(case: Case, kernels: Sequence[Kernel]) -> list[Candidate]:
    """Fill a gap from the marker's own samples beside it.

    Parameters
    ----------
    case : Case
        The gap.
    kernels : sequence of Kernel
        What is believed of the marker's motion; only their functions of time count.

    Returns
    -------
    list of Candidate
        One per kernel.
    """
    seen = np.flatnonzero(case.seen)
    track = case.points[:, case.gap.marker]
    kind = case.gap.kind(case.seen.size)

    def fill(start: int, stop: int, asked: IntArray) -> _Fit:
        first, last = np.searchsorted(seen, [start, stop])
        before = first - BORDERS[first >= BORDERS][::-1]
        after = last + BORDERS[seen.size - last >= BORDERS] - 1
        if kind == "leading":
            before = before[:0]
        if kind == "trailing":
            after = after[:0]
        knots = seen[np.concatenate((before, after))]
        return _fit(knots, track[knots], asked, case.rate, kernels)

    fits = [fill(case.gap.start, case.gap.stop, case.frames[case.samples :])]
    truths = []
    for trial in case.lesson.trials:
        judged = case.lesson.frames[trial.hidden[trial.judged]]
        truths.append(track[judged])
        fits.append(fill(trial.start, trial.stop, judged))
    return [
        Candidate(
            fits[0].values[each],
            fits[0].spread[each],
            tuple(truth - fit.values[each] for truth, fit in zip(truths, fits[1:], strict=True)),
            tuple(fit.spread[each] for fit in fits[1:]),
        )
        for each in range(len(kernels))
    ]


@dataclass(frozen=True, eq=False)
class _Fit:
    """What each kernel makes of the samples beside a stretch.

    Attributes
    ----------
    values : ndarray, shape (kernels, asked, 3)
        Posterior mean.
    spread : ndarray, shape (kernels, asked)
        Posterior standard deviation of a sample.
    """

    values: FloatArray
    spread: FloatArray


def _fit(
    knots: IntArray, values: FloatArray, asked: IntArray, rate: float, kernels: Sequence[Kernel]
) -> _Fit:
    apart = np.abs(knots[:, None] - knots) / rate
    away = np.abs(asked[:, None] - knots) / rate
    mean = values.mean(axis=0)
    among = np.stack([of_time(k, apart) + k.noise * np.eye(knots.size) for k in kernels])
    across = np.stack([of_time(k, away) for k in kernels])
    gain = np.linalg.solve(among, across.transpose(0, 2, 1)).transpose(0, 2, 1)
    noise = np.array([[kernel.noise] for kernel in kernels])
    prior = np.stack([of_time(k, np.zeros(1)) for k in kernels]) + noise
    variance = prior - np.einsum("kan,kan->ka", across, gain)
    return _Fit(mean + gain @ (values - mean), np.sqrt(np.maximum(variance, noise)))
