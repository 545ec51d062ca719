"""The figures that `auto` must reach, and whether it does."""

from collections.abc import Iterator
from typing import NamedTuple

from mocapmend.bench.gaps.cases import Case
from mocapmend.bench.gaps.figures import (
    Trials,
    band,
    best_single,
    coverage_interval,
    geometric_mean,
    percentile,
    pooled,
    ratios,
)
from mocapmend.bench.gaps.protocols import (
    AUTO,
    FAST,
    RIGID_BODY,
    TARGETS,
    TITS,
    best,
    reference,
)
from mocapmend.bench.gaps.tables import PERCENTILE, best_published_mm, reference_mm, time_ratios
from mocapmend.bench.grid import Cell, Column, Grid

WORST = 1.5
NO_WORSE_FAMILY, NO_WORSE = "P4", 2.0
BEST_SINGLE = 1.1
COVERAGE, COVERAGE_EACH = (0.92, 0.88), (0.96, 0.82)
"""Most and least."""
BAND_SCORE = 1.0
SPEED = 5.0

_COLUMNS = (
    Column("what", "what"),
    Column("against", "against"),
    Column("cases", "cases"),
    Column("figure", "figure", ".3g"),
    Column("target", "target"),
    Column("met", "met"),
)


class Line(NamedTuple):
    """A figure with bounds; None where there is no figure or no bound."""

    what: str
    against: str
    cases: int
    figure: float | None
    most: float | None
    least: float | None = None

    def row(self) -> dict[str, Cell]:
        """Return the row of the table."""
        bounds = [
            *([f">= {self.least:g}"] if self.least is not None else []),
            *([f"<= {self.most:g}"] if self.most is not None else []),
        ]
        return {
            "what": self.what,
            "against": self.against,
            "cases": self.cases,
            "figure": self.figure,
            "target": ", ".join(bounds),
            "met": self.met,
        }

    @property
    def met(self) -> bool | None:
        """Whether the figure is within its bounds; None without a figure."""
        if self.figure is None:
            return None
        above = self.least is None or self.figure >= self.least
        return above and (self.most is None or self.figure <= self.most)


def targets(trials: Trials) -> Grid:
    """Hold `auto` against its targets; only over cases that it fills completely."""
    lines = [
        *_to_references(trials),
        _to_best(trials),
        _no_worse(trials),
        *_to_best_single(trials),
        *_bands(trials),
        *_speed(trials),
    ]
    return Grid("targets", f"Targets of {AUTO}", _COLUMNS, [line.row() for line in lines])


def _to_references(trials: Trials) -> Iterator[Line]:
    for protocol in trials.protocols:
        found = ratios(trials.of(AUTO, protocol), reference_mm)
        names = " or ".join(reference(protocol)) or "none"
        what = f"{protocol}: geometric mean of the RMSE ratios"
        yield Line(what, names, len(found), geometric_mean(found), TARGETS.get(protocol))


def _to_best(trials: Trials) -> Line:
    found = ratios(trials.of(AUTO), best_published_mm)
    what = f"all: {PERCENTILE}th percentile of the RMSE ratios"
    return Line(what, "best published method", len(found), percentile(found, PERCENTILE), WORST)


def _no_worse(trials: Trials) -> Line:
    def better(case: Case) -> float | None:
        return best(case.peers, (TITS, RIGID_BODY))

    own = [trial for trial in trials.of(AUTO) if trial.case.family == NO_WORSE_FAMILY]
    found = ratios(own, better)
    count = float((found > NO_WORSE).sum()) if len(found) else None
    what = f"{NO_WORSE_FAMILY}: cases with more than {NO_WORSE:g} times the RMSE"
    return Line(what, f"{TITS} or {RIGID_BODY}", len(found), count, 0.0)


def _to_best_single(trials: Trials) -> Iterator[Line]:
    for protocol in trials.protocols:
        own = sum(trial.complete for trial in trials.of(AUTO, protocol))
        other, ratio = best_single(trials, protocol, AUTO)
        what = f"{protocol}: geometric mean of the RMSE ratios"
        yield Line(what, f"best method: {other or 'none'}", own, ratio, BEST_SINGLE)


def _bands(trials: Trials) -> Iterator[Line]:
    own = trials.of(AUTO)
    bands = {protocol: band(trials.of(AUTO, protocol)) for protocol in trials.protocols}
    every = pooled(bands.values())
    interval = coverage_interval(own)
    spread = interval and f"bootstrap over recordings: {interval[0]:.3f} to {interval[1]:.3f}"
    inside, score = "share of samples inside r90", "interval score"
    yield Line(f"all: {inside}", spread or "", len(own), every.coverage, *COVERAGE)
    for protocol, each in bands.items():
        count = len(trials.of(AUTO, protocol))
        yield Line(f"{protocol}: {inside}", "", count, each.coverage, *COVERAGE_EACH)
    yield Line(f"all: {score}", "constant bands", len(own), every.to_constant, BAND_SCORE)


def _speed(trials: Trials) -> Iterator[Line]:
    found = time_ratios(trials, AUTO, FAST)
    for name, figure in (
        ("geometric mean", geometric_mean(found)),
        ("median", percentile(found, 50)),
    ):
        yield Line(f"all: {name} of the ratios of CPU time", FAST, len(found), figure, SPEED)
