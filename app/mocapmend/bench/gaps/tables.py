"""The tables of a run."""

import math
import time
from collections.abc import Mapping, Sequence

import numpy as np

from mocapmend.bench.gaps.cases import Case
from mocapmend.bench.gaps.figures import (
    Trials,
    band,
    coverage_interval,
    geometric_mean,
    mean,
    percentile,
    pooled,
    ratios,
)
from mocapmend.bench.gaps.protocols import AUTO, FAST, TARGETS, Protocol, reference
from mocapmend.bench.gaps.trials import Trial
from mocapmend.bench.grid import Cell, Column, Grid
from mocapmend_algorithms.arrays import FloatArray

PERCENTILE = 90

_REFERENCES = (
    Column("protocol", "protocol"),
    Column("cases", "cases"),
    Column("reference", "reference"),
    Column("with_reference", "cases that have it"),
    Column("mean_rmse_mm", "mean RMSE, mm", ".1f"),
    Column("median_rmse_mm", "median, mm", ".1f"),
    Column("best_mean_rmse_mm", "best published: mean RMSE, mm", ".1f"),
    Column("best_median_rmse_mm", "median, mm", ".1f"),
)
_PROTOCOLS = (
    Column("protocol", "protocol"),
    Column("method", "method"),
    Column("cases", "cases"),
    Column("filled_cases", "all filled"),
    Column("left_open", "left open", ".1%"),
    Column("mean_rmse_mm", "mean RMSE, mm", ".1f"),
    Column("median_rmse_mm", "median, mm", ".1f"),
    Column("mean_cpu_s", "CPU s", ".2g"),
    Column("compared", "compared"),
    Column("to_reference", "to reference", ".2f"),
    Column("to_reference_p90", "90th pct", ".2f"),
    Column("target", "target"),
    Column("to_best", "to best published", ".2f"),
    Column("to_best_p90", "90th pct", ".2f"),
    Column("coverage", "inside r90", ".1%"),
    Column("band_score", "score to constant band", ".2f"),
    Column("unstated", "no band", ".1%"),
)
_OVERALL = (
    Column("method", "method"),
    Column("cases", "cases"),
    Column("filled_cases", "all filled"),
    Column("left_open", "left open", ".1%"),
    Column("to_best", "to best published", ".2f"),
    Column("to_best_p90", "90th pct", ".2f"),
    Column("coverage", "inside r90", ".1%"),
    Column("coverage_low", "95 % from", ".1%"),
    Column("coverage_high", "to", ".1%"),
    Column("band_score", "score to constant band", ".2f"),
    Column("unstated", "no band", ".1%"),
    Column("mean_cpu_s", "CPU s", ".2g"),
    Column("to_fast", f"CPU to {FAST}", ".2f"),
    Column("to_fast_median", "median", ".2f"),
)
_CASES = tuple(
    Column(key, key)
    for key in (
        "case", "protocol", "recording", "half", "method", "samples", "left_open", "rmse_mm",
        "mean_mm", "reference_mm", "best_published_mm", "stated", "inside_r90", "median_r90_mm",
        "cpu_s",
    )
)  # fmt: skip


def references(trials: Trials) -> Grid:
    """Say what the methods are held against."""
    rows = []
    for protocol in trials.protocols:
        cases = [trial.case for trial in trials.of(trials.methods[0], protocol)]
        own = _known([case.reference_mm for case in cases])
        best = _known([case.best_published_mm for case in cases])
        row: dict[str, Cell] = {
            "protocol": str(protocol),
            "cases": len(cases),
            "reference": " or ".join(reference(protocol)),
            "with_reference": len(own),
            "mean_rmse_mm": mean(own),
            "median_rmse_mm": percentile(own, 50),
            "best_mean_rmse_mm": mean(best),
            "best_median_rmse_mm": percentile(best, 50),
        }
        rows.append(row)
    return Grid("references", "Published methods", _REFERENCES, rows)


def protocols(trials: Trials) -> Grid:
    """Judge the methods protocol by protocol."""
    rows = [
        _protocol_row(protocol, method, trials.of(method, protocol))
        for protocol in trials.protocols
        for method in trials.methods
    ]
    return Grid("protocols", "Per protocol", _PROTOCOLS, rows)


def _protocol_row(protocol: Protocol, method: str, trials: Sequence[Trial]) -> dict[str, Cell]:
    errors = _known([trial.rmse for trial in trials])
    against = ratios(trials, reference_mm)
    most = TARGETS.get(protocol) if method == AUTO else None
    quality = band(trials)
    return {
        "protocol": str(protocol),
        "method": method,
        **_filled(trials),
        "mean_rmse_mm": mean(errors),
        "median_rmse_mm": percentile(errors, 50),
        "mean_cpu_s": mean([trial.seconds for trial in trials]),
        "compared": len(against),
        "to_reference": geometric_mean(against),
        "to_reference_p90": percentile(against, PERCENTILE),
        "target": "" if most is None else f"<= {most:g}",
        **_to_best(trials),
        "coverage": quality.coverage,
        "band_score": quality.to_constant,
        "unstated": quality.unstated,
    }


def overall(trials: Trials) -> Grid:
    """Judge the methods over all cases."""
    rows = []
    for method in trials.methods:
        own = trials.of(method)
        quality = pooled(band(trials.of(method, protocol)) for protocol in trials.protocols)
        low, high = coverage_interval(own) or (None, None)
        to_fast = time_ratios(trials, method, FAST)
        row: dict[str, Cell] = {
            "method": method,
            **_filled(own),
            **_to_best(own),
            "coverage": quality.coverage,
            "coverage_low": low,
            "coverage_high": high,
            "band_score": quality.to_constant,
            "unstated": quality.unstated,
            "mean_cpu_s": mean([trial.seconds for trial in own]),
            "to_fast": geometric_mean(to_fast),
            "to_fast_median": percentile(to_fast, 50),
        }
        rows.append(row)
    return Grid("overall", "All cases", _OVERALL, rows)


def cases(trials: Trials, halves: Mapping[str, str]) -> Grid:
    """List every trial, for the JSON document."""
    rows = [_case_row(trial, halves[trial.case.recording]) for trial in trials.all]
    return Grid("cases", "Per case", _CASES, rows, for_people=False)


def _case_row(trial: Trial, half: str) -> dict[str, Cell]:
    quality = band([trial])
    return {
        "case": trial.case.name,
        "protocol": str(trial.case.protocol),
        "recording": trial.case.recording,
        "half": half,
        "method": trial.method,
        "samples": trial.samples,
        "left_open": trial.left_open,
        "rmse_mm": trial.rmse,
        "mean_mm": mean(trial.errors),
        "reference_mm": trial.case.reference_mm,
        "best_published_mm": trial.case.best_published_mm,
        "stated": quality.stated,
        "inside_r90": quality.inside,
        "median_r90_mm": percentile(_known(trial.r90), 50),
        "cpu_s": trial.seconds,
    }


def reference_mm(case: Case) -> float | None:
    """Return the RMSE of a case's reference."""
    return case.reference_mm


def best_published_mm(case: Case) -> float | None:
    """Return the RMSE of the best published method on a case."""
    return case.best_published_mm


def time_ratios(trials: Trials, method: str, other: str) -> FloatArray:
    """Return the CPU time of a method over that of another, case by case."""
    least = time.get_clock_info("process_time").resolution
    theirs = {trial.case.name: trial.seconds for trial in trials.of(other)}
    return np.array(
        [
            max(trial.seconds, least) / max(theirs[trial.case.name], least)
            for trial in trials.of(method)
            if trial.case.name in theirs
        ]
    )


def _filled(trials: Sequence[Trial]) -> dict[str, Cell]:
    samples = sum(trial.samples for trial in trials)
    return {
        "cases": len(trials),
        "filled_cases": sum(trial.complete for trial in trials),
        "left_open": sum(trial.left_open for trial in trials) / samples if samples else None,
    }


def _to_best(trials: Sequence[Trial]) -> dict[str, Cell]:
    against = ratios(trials, best_published_mm)
    return {
        "to_best": geometric_mean(against),
        "to_best_p90": percentile(against, PERCENTILE),
    }


def _known(values: Sequence[float | None] | FloatArray) -> FloatArray:
    """Return the numbers among some."""
    known = [value for value in values if value is not None and not math.isnan(value)]
    return np.array(known, np.float64)
