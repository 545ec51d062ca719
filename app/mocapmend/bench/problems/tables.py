"""The tables of the benchmark."""

from collections.abc import Mapping, Sequence

from mocapmend.bench.grid import Cell, Column, Grid, share
from mocapmend.bench.problems.recordings import CLEAN
from mocapmend.bench.problems.trials import Outcome
from mocapmend.bench.problems.untouched import Found
from mocapmend_algorithms.problems.registry import DETECTORS

MOST_FALSE = 1e-4
"""Share of the samples of the clean recordings."""

_DETECTORS = (
    Column("recordings", "recordings"),
    Column("errors", "errors put in"),
    Column("way", "found by"),
    Column("count", "errors", "d"),
    Column("samples", "bad samples", "d"),
    Column("found", "errors found", ".3f"),
    Column("precision", "precision", ".3f"),
    Column("recall", "recall", ".3f"),
    Column("f1", "F1", ".3f"),
    Column("strict_f1", "F1, strict", ".3f"),
    Column("latency", "latency, median", ".0f"),
    Column("latency95", "95 %", ".0f"),
    Column("exact", "repaired exactly", ".3f"),
    Column("seconds", "CPU s", ".1f"),
)
_TARGETS = (
    Column("what", "what"),
    Column("figure", "figure", ".4g"),
    Column("target", "target"),
    Column("met", "met"),
)


def detectors(outcomes: Sequence[Outcome]) -> Grid:
    """Make the table of precision, recall and latency."""
    rows: list[Mapping[str, Cell]] = []
    for outcome in outcomes:
        score, experiment = outcome.score, outcome.experiment
        rows.append(
            {
                "recordings": outcome.half,
                "errors": f"{experiment.detector}: {experiment.errors}",
                "way": outcome.way,
                "count": score.errors,
                "samples": score.right + score.missed,
                "found": share(score.found, score.errors),
                "precision": score.precision,
                "recall": score.recall,
                "f1": score.f1,
                "strict_f1": score.strict_f1,
                "latency": score.latency[0],
                "latency95": score.latency[1],
                "exact": outcome.exact,
                "seconds": outcome.seconds,
            }
        )
    return Grid("detectors", "Errors put in, sample by sample", _DETECTORS, rows)


def untouched(found: Sequence[Found]) -> Grid:
    """Make the table of what is found in recordings as they are."""
    columns = (
        Column("recording", "recording"),
        Column("clean", "clean"),
        Column("samples", "samples", "d"),
        *(Column(kind, kind, "d") for kind in DETECTORS),
        Column("share", "share, %", ".4f"),
        Column("worst", "worst"),
    )
    rows: list[Mapping[str, Cell]] = [
        {
            "recording": each.recording,
            "clean": each.recording in CLEAN,
            "samples": each.samples,
            **each.flagged,
            "share": 100 * share(each.all_flagged, each.samples),
            "worst": each.worst,
        }
        for each in found
    ]
    return Grid("untouched", "Samples found in the recordings as they are", columns, rows)


def targets(outcomes: Sequence[Outcome], found: Sequence[Found]) -> Grid:
    """Judge the validation recordings, and the clean ones."""
    rows: list[Mapping[str, Cell]] = []
    for outcome in outcomes:
        least = outcome.experiment.least_f1
        if outcome.half != "validation" or outcome.way != outcome.experiment.detector:
            continue
        what = f"{outcome.experiment.detector}: {outcome.experiment.errors}"
        if least is not None:
            f1 = outcome.score.f1
            rows.append(_row(f"F1 of {what}", f1, f">= {least:g}", met=f1 >= least))
        if outcome.experiment.key == "swaps":
            rows.append(
                _row(
                    "swaps found that are repaired exactly",
                    outcome.exact,
                    "1",
                    met=outcome.exact == 1.0,
                )
            )
    clean = [each for each in found if each.recording in CLEAN]
    if clean:
        flagged = sum(each.all_flagged for each in clean)
        found_share = share(flagged, sum(each.samples for each in clean))
        text = f"< {100 * MOST_FALSE:g}"
        what = "samples found in the clean recordings, %"
        rows.append(_row(what, 100 * found_share, text, met=found_share < MOST_FALSE))
    return Grid("targets", "Targets, on the validation recordings", _TARGETS, rows)


def _row(what: str, figure: float, target: str, *, met: bool) -> dict[str, Cell]:
    return {"what": what, "figure": figure, "target": target, "met": met}
