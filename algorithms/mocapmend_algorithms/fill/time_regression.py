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
from mocapmend_algorithms.fill.stack import LEAST_MM

LEAST_SIZE = 0.3
"""Of the motion beside a gap, relative to the usual: few samples may look stiller than it was."""


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
    stretches = [(case.gap.start, case.gap.stop, case.frames[case.samples :])]
    for trial in case.lesson.trials:
        judged = case.lesson.frames[trial.hidden[trial.judged]]
        stretches.append((trial.start, trial.stop, judged))
    seen = np.flatnonzero(case.seen)
    kind = case.gap.kind(case.seen.size)
    known = [_beside(seen, kind, start, stop) for start, stop, _ in stretches]
    longest = max(
        int(np.ptp(np.concatenate((knots, asked))))
        for knots, (_, _, asked) in zip(known, stretches, strict=True)
    )
    seconds = np.arange(longest + 1) / case.rate
    covariance = np.stack([of_time(kernel, seconds) for kernel in kernels])
    noise = np.array([kernel.noise for kernel in kernels])[:, None]
    fits = [
        _fit(knots, case.track[knots], asked, covariance, noise)
        for knots, (_, _, asked) in zip(known, stretches, strict=True)
    ]
    usual = np.median([fit.size for fit in fits], axis=0)
    # A marker that stands still has no size.
    sizes = [np.maximum(np.hypot(fit.size, LEAST_SIZE * usual), LEAST_MM) for fit in fits]
    spreads = [fit.spread * size[:, None] for fit, size in zip(fits, sizes, strict=True)]
    truths = [case.track[asked] for _, _, asked in stretches[1:]]
    return [
        Candidate(
            fits[0].values[each],
            spreads[0][each],
            tuple(truth - fit.values[each] for truth, fit in zip(truths, fits[1:], strict=True)),
            tuple(spread[each] for spread in spreads[1:]),
        )
        for each in range(len(kernels))
    ]


def _beside(seen: IntArray, kind: str, start: int, stop: int) -> IntArray:
    """Return the frames of the samples beside a stretch, on the sides that a gap has."""
    first, last = np.searchsorted(seen, [start, stop])
    before = first - BORDERS[first >= BORDERS][::-1]
    after = last + BORDERS[seen.size - last >= BORDERS] - 1
    if kind == "leading":
        before = before[:0]
    if kind == "trailing":
        after = after[:0]
    beside: IntArray = seen[np.concatenate((before, after))]
    return beside


@dataclass(frozen=True, eq=False)
class _Fit:
    """What each kernel makes of the samples beside a stretch.

    Attributes
    ----------
    values : ndarray, shape (kernels, asked, 3)
        Posterior mean.
    spread : ndarray, shape (kernels, asked)
        Posterior standard deviation of a sample, for a motion of unit size.
    size : ndarray, shape (kernels,)
        Of the motion beside the stretch, by the samples' likelihood, in mm.
    """

    values: FloatArray
    spread: FloatArray
    size: FloatArray


def _fit(
    knots: IntArray,
    values: FloatArray,
    asked: IntArray,
    covariance: FloatArray,
    noise: FloatArray,
) -> _Fit:
    """Regress; the covariance, shape (kernels, frames), is that of samples so far apart."""
    among = covariance[:, np.abs(knots[:, None] - knots)]
    among += noise[:, :, None] * np.eye(knots.size)
    across = covariance[:, np.abs(asked[:, None] - knots)]
    gain = np.linalg.solve(among, across.transpose(0, 2, 1)).transpose(0, 2, 1)
    mean = values.mean(axis=0)
    around = values - mean
    weights = np.linalg.solve(among, np.broadcast_to(around, (len(noise), *around.shape)))
    size = np.sqrt(np.einsum("ni,kni->k", around, weights) / around.size)
    variance = covariance[:, :1] + noise - np.einsum("kan,kan->ka", across, gain)
    return _Fit(mean + across @ weights, np.sqrt(np.maximum(variance, noise)), size)
