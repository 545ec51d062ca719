"""How wrong a donor fill is, from what it left over in the trials.

The errors of the trials are taken relative to what a fill says of its own uncertainty (how far the
pose is from known ones, how far the nearest sample), and to how fast the donors move: a trial
during standing says little about a gap during a kick. Their quantile is the band (a conformal one,
as in Vovk, Gammerman and Shafer 2005).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.selftest import count_apart

COVERAGE = 0.9
MANY_TRIALS = 0.97
FEW_TRIALS = 0.5
LENGTH_POWER = 0.1
SPEED_POWER = 0.25
SPEED_FLOOR = 100.0
SPEED_S = 0.1
SPEED_DONORS = 12


@dataclass(frozen=True, eq=False)
class Band:
    """How far the truth may be from a fill.

    Attributes
    ----------
    sigma, r90 : ndarray, shape (length,)
        As in `Patch`, in mm.
    """

    sigma: FloatArray
    r90: FloatArray


def band(
    case: Case,
    errors: Sequence[FloatArray],
    trial_spreads: Sequence[FloatArray],
    spread: FloatArray,
) -> Band:
    """Turn what was left over in trials into a standard deviation and a 90 % radius.

    Parameters
    ----------
    case : Case
        The gap and its trials.
    errors : sequence over trials of ndarray, shape (judged, 3)
        What was left over, in mm.
    trial_spreads : sequence over trials of ndarray, shape (judged,)
        How unsure the fill was there, in its own unit.
    spread : ndarray, shape (length,)
        How unsure it is in the gap.

    Returns
    -------
    Band
        Unknown (NaN) where there was no trial.
    """
    if not errors:
        unknown = np.full(case.gap.length, np.nan)
        return Band(unknown, unknown)
    hardness = _hardness(case)
    relative = np.concatenate(
        [
            np.sqrt(np.einsum("ij,ij->i", error, error))
            / (own * hardness[trial.hidden[trial.judged]])
            for trial, error, own in zip(case.lesson.trials, errors, trial_spreads, strict=True)
        ]
    )
    starts = np.array([trial.start for trial in case.lesson.trials])
    tried = case.lesson.trials[0].stop - case.lesson.trials[0].start
    longer = case.lesson.times_longer(case.gap) ** LENGTH_POWER
    trust = MANY_TRIALS + FEW_TRIALS / count_apart(starts, tried)
    scale = trust * longer * spread * hardness[case.samples :]
    return Band(
        scale * np.sqrt(np.mean(relative**2) / 3), scale * float(np.quantile(relative, COVERAGE))
    )


def _hardness(case: Case) -> FloatArray:
    """Return by what errors are expected to grow with the speed of the donors, per frame."""
    step = max(1, round(SPEED_S * case.rate))
    near = case.donors.best(SPEED_DONORS)
    moved = case.at(near, step) - case.at(near, -step)
    seconds = case.elapsed(step) / case.rate
    speed = np.sqrt(np.einsum("fdi,fdi->fd", moved, moved)) / seconds[:, None]
    seen = np.isfinite(speed)
    mean = np.where(seen, speed, 0.0).sum(axis=1) / np.maximum(seen.sum(axis=1), 1)
    hardness: FloatArray = (mean + SPEED_FLOOR) ** SPEED_POWER
    return hardness
