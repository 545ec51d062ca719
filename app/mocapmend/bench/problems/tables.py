"""The tables of the benchmark."""

from collections.abc import Sequence

from mocapmend.bench.grid import Column, Grid
from mocapmend.bench.problems.trials import Outcome

_DETECTORS = (
    Column("recordings", "recordings"),
    Column("errors", "errors put in"),
    Column("way", "found by"),
    Column("count", "errors", "d"),
    Column("found", "found", ".3f"),
    Column("precision", "precision", ".3f"),
    Column("recall", "recall", ".3f"),
    Column("f1", "F1", ".3f"),
    Column("target", "target"),
    Column("latency", "latency, median", ".1f"),
    Column("latency95", "95 %", ".1f"),
)


def detectors(outcomes: Sequence[Outcome]) -> Grid:
    """Make the table of precision, recall and latency."""
    rows = []
    for outcome in outcomes:
        score, experiment = outcome.score, outcome.experiment
        own = outcome.way == experiment.detector
        target = f">= {experiment.target_f1:g}" if own and experiment.target_f1 else ""
        rows.append(
            {
                "recordings": outcome.half,
                "errors": f"{experiment.detector}: {experiment.errors}",
                "way": outcome.way,
                "count": score.errors,
                "found": score.found / score.errors if score.errors else float("nan"),
                "precision": score.precision,
                "recall": score.recall,
                "f1": score.f1,
                "target": target,
                "latency": score.latency[0],
                "latency95": score.latency[1],
            }
        )
    return Grid("detectors", "Errors put in, sample by sample", _DETECTORS, rows)
