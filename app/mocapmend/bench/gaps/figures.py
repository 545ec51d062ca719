"""What is computed from trials: ratios, bands, choices among methods."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend.bench.gaps.cases import Case
from mocapmend.bench.gaps.protocols import Protocol
from mocapmend.bench.gaps.trials import Trial
from mocapmend_algorithms.arrays import FloatArray

LEAST_MM = 1e-6
"""Smaller errors count as this one: a ratio needs something to divide by."""
MISS = 0.1
"""Share of the samples that a 90 % band may miss."""
RESAMPLES = 2000


class Trials:
    """The trials of a run.

    Parameters
    ----------
    trials : sequence of Trial
        Any number of methods, each on the same cases.
    """

    def __init__(self, trials: Sequence[Trial]) -> None:
        self.all = tuple(trials)
        self.methods = tuple(dict.fromkeys(trial.method for trial in trials))
        self.protocols = tuple(sorted({trial.case.protocol for trial in trials}))

    def of(self, method: str, protocol: Protocol | None = None) -> list[Trial]:
        """Return the trials of a method, those of one protocol if one is given."""
        return [
            trial
            for trial in self.all
            if trial.method == method and protocol in (None, trial.case.protocol)
        ]


def ratios(trials: Iterable[Trial], against: Callable[[Case], float | None]) -> FloatArray:
    """Return RMSE ratios over the cases that were filled completely and have a peer's figure."""
    pairs = [(trial.rmse, against(trial.case)) for trial in trials if trial.complete]
    return np.array([_ratio(own, other) for own, other in pairs if other is not None])


def _ratio(own: float, other: float) -> float:
    return max(own, LEAST_MM) / max(other, LEAST_MM)


def geometric_mean(values: FloatArray) -> float | None:
    """Return the geometric mean; None of nothing."""
    return float(np.exp(np.mean(np.log(values)))) if len(values) else None


def percentile(values: FloatArray, percent: float) -> float | None:
    """Return a percentile; None of nothing."""
    return float(np.percentile(values, percent)) if len(values) else None


def mean(values: Sequence[float] | FloatArray) -> float | None:
    """Return the mean; None of nothing."""
    return float(np.mean(values)) if len(values) else None


def best_single(
    trials: Trials, protocol: Protocol | None, method: str
) -> tuple[str, float] | tuple[None, None]:
    """Return the other method that comes out best beside one, and the ratio of RMSE to it.

    Others that leave a case open which the method fills are no rivals: the easy cases alone
    would make them look good.
    """
    own = {trial.case.name: trial for trial in trials.of(method, protocol) if trial.complete}
    found: list[tuple[float, str]] = []
    for other in trials.methods:
        rivals = {t.case.name: t for t in trials.of(other, protocol) if t.complete}
        if other == method or not own or own.keys() - rivals.keys():
            continue
        pairs = [_ratio(own[name].rmse, rivals[name].rmse) for name in own]
        found.append((geometric_mean(np.array(pairs)) or 0.0, other))
    if not found:
        return None, None
    ratio, other = max(found)
    return other, ratio


@dataclass(frozen=True)
class Band:
    """How well the stated 90 % radii fit.

    Attributes
    ----------
    filled : int
        Filled samples.
    stated : int
        Those with a radius.
    inside : int
        Those whose error is within it.
    score : float
        Sum of the interval scores in mm: radius + excess / 0.1 (Gneiting and Raftery 2007,
        section 6.2, for a radius). Less is better.
    constant : float
        The same sum for one radius for all, which holds as many samples.
    """

    filled: int = 0
    stated: int = 0
    inside: int = 0
    score: float = 0.0
    constant: float = 0.0

    @property
    def coverage(self) -> float | None:
        """Share of the samples inside their radius."""
        return self.inside / self.stated if self.stated else None

    @property
    def unstated(self) -> float | None:
        """Share of the filled samples without a radius."""
        return 1.0 - self.stated / self.filled if self.filled else None

    @property
    def to_constant(self) -> float | None:
        """Ratio of the score to that of the constant radius; below 1 the band knows more."""
        return self.score / self.constant if self.constant > 0 else None


def band(trials: Sequence[Trial]) -> Band:
    """Judge the radii of a method in a protocol."""
    errors, radii = _errors_and_radii(trials)
    inside = int((errors <= radii).sum())
    radius = float(np.sort(errors)[inside - 1]) if inside else 0.0
    return Band(
        filled=sum(len(trial.errors) for trial in trials),
        stated=len(errors),
        inside=inside,
        score=interval_score(errors, radii),
        constant=interval_score(errors, np.full(len(errors), radius)),
    )


def pooled(bands: Iterable[Band]) -> Band:
    """Add up the bands of several protocols."""
    each = list(bands)
    return Band(
        sum(one.filled for one in each),
        sum(one.stated for one in each),
        sum(one.inside for one in each),
        sum(one.score for one in each),
        sum(one.constant for one in each),
    )


def interval_score(errors: FloatArray, radii: FloatArray) -> float:
    """Return the sum of the interval scores, in the unit of the errors."""
    return float(np.sum(radii + np.maximum(errors - radii, 0.0) / MISS))


def coverage_interval(trials: Sequence[Trial]) -> tuple[float, float] | None:
    """Return the 95 % interval of the coverage, by bootstrap over recordings; None below two."""
    counts: dict[str, list[tuple[int, int]]] = {}
    for trial in trials:
        errors, radii = _errors_and_radii([trial])
        if len(errors):
            inside = int((errors <= radii).sum())
            counts.setdefault(trial.case.recording, []).append((inside, len(errors)))
    if len(counts) < 2:
        return None
    sums = np.array([np.sum(counts[name], axis=0) for name in sorted(counts)])
    rng = np.random.default_rng(0)
    drawn = sums[rng.integers(0, len(sums), (RESAMPLES, len(sums)))].sum(axis=1)
    low, high = np.percentile(drawn[:, 0] / drawn[:, 1], (2.5, 97.5))
    return float(low), float(high)


def _errors_and_radii(trials: Sequence[Trial]) -> tuple[FloatArray, FloatArray]:
    """Return the samples that have a radius."""
    errors = np.concatenate([np.empty(0), *(trial.errors for trial in trials)])
    radii = np.concatenate([np.empty(0), *(trial.r90 for trial in trials)])
    stated = np.isfinite(radii)
    return errors[stated], radii[stated]
