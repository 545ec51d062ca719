"""One way to smooth one recording: what is left of the noise and what is lost of the motion."""

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from mocapmend.bench.smoothing.cases import Case
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.smooth import registry

DEFAULTS: dict[str, tuple[str, Mapping[str, str]]] = {
    name: (name, {}) for name in registry.SMOOTHERS
}
WAYS = DEFAULTS | {
    "gcv, impacts as all else": ("gcv", {"keep_impacts": "false"}),
    "butterworth, 6 Hz": ("butterworth", {"cutoff_hz": "6"}),
    "butterworth, Winter's rule": ("butterworth", {"rule": "winter"}),
}
"""Method and parameters, by the name of the way; the methods as they come, and what is common."""


@dataclass(frozen=True)
class Errors:
    """Root mean squares over the samples of a recording, 3-D.

    Attributes
    ----------
    position : float
        In mm.
    speed : float
        Of the velocity, by central differences, in mm/s.
    acceleration : float
        Likewise, in m/s^2.
    at_impacts, largest_at_impacts : float
        Of the position at impacts, and the largest there, in mm.
    """

    position: float
    speed: float
    acceleration: float
    at_impacts: float
    largest_at_impacts: float


@dataclass(frozen=True, eq=False)
class Trial:
    """A way on a recording.

    Attributes
    ----------
    case : Case
        The recording.
    way : str
        A key of `WAYS`.
    noise_mm : float
        Standard deviation of the noise that was added to each coordinate.
    before, after : Errors
        Before and after smoothing.
    seconds : float
        CPU time.
    """

    case: Case
    way: str
    noise_mm: float
    before: Errors
    after: Errors
    seconds: float


def trials(
    case: Case, noise_mm: float, ways: Mapping[str, tuple[str, Mapping[str, str]]]
) -> list[Trial]:
    """Try ways on a recording with so much noise."""
    noisy, impacts = case.noisy(noise_mm), case.impacts()
    before = errors(noisy, case.truth, impacts)
    found = []
    for way, (method, pairs) in ways.items():
        start = time.process_time()
        smoothed = smooth_all(noisy, method, pairs)
        seconds = time.process_time() - start
        after = errors(smoothed, case.truth, impacts)
        found.append(Trial(case, way, noise_mm, before, after, seconds))
    return found


def smooth_all(recording: Recording, method: str, pairs: Mapping[str, str]) -> Recording:
    """Smooth every sample of a recording."""
    smoother = registry.smoother(method)
    runs = [Gap(marker, 0, recording.frames) for marker in range(recording.markers)]
    params = registry.parse_params(smoother, pairs)
    return smoother.function(recording, runs, params, no_progress).applied(recording)


def errors(recording: Recording, truth: Recording, impacts: BoolArray) -> Errors:
    """Compare a recording with the truth."""
    away = (recording.points - truth.points) * truth.mm
    velocity = np.gradient(away, axis=0) * truth.rate
    acceleration = np.diff(away, n=2, axis=0) * truth.rate**2 / 1000
    at_impacts = away[impacts]
    return Errors(
        _rms(away),
        _rms(velocity),
        _rms(acceleration),
        _rms(at_impacts),
        float(np.linalg.norm(at_impacts, axis=-1).max()),
    )


def _rms(away: FloatArray) -> float:
    square = np.sum(away**2, axis=-1)
    square = square[~np.isnan(square)]
    return float(np.sqrt(np.mean(square))) if square.size else math.nan
