"""The tables of a run."""

import itertools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from mocapmend.bench.grid import Cell, Column, Grid, share
from mocapmend.bench.labels.pairs import ACROSS, HALVES, KINDS, SAME
from mocapmend.bench.labels.trials import Trial

TARGETS = {SAME: 0.99, ACROSS: 0.97}
BINS = (0.0, 0.5, 0.8, 0.95, 1.0)
_SUMMARY = (
    Column("half", "half"),
    Column("kind", "model from"),
    Column("named", "names kept"),
    Column("trials", "trials"),
    Column("samples", "samples"),
    Column("right", "samples right", ".2%"),
    Column("worst", "worst trial", ".2%"),
    Column("target", "target"),
    Column("met", "met"),
    Column("none", "without a label", ".2%"),
    Column("ghosts", "ghosts with a label", ".1%"),
    Column("naive", "fixed pose per frame", ".2%"),
    Column("seconds", "CPU s, mean", ".1f"),
    Column("slowest", "slowest", ".1f"),
)
_CONFIDENCE = (
    Column("half", "half"),
    Column("from", "confidence from", ".2f"),
    Column("to", "to", ".2f"),
    Column("pieces", "pieces"),
    Column("stated", "mean confidence", ".3f"),
    Column("right", "pieces right", ".3f"),
    Column("share_of_wrong", "share of the wrong samples", ".1%"),
)
_TRIALS = (
    Column("target", "labelled"),
    Column("source", "model of"),
    Column("kind", "kind"),
    Column("half", "half"),
    Column("seed", "seed"),
    Column("named", "names kept"),
    Column("frames", "frames"),
    Column("points", "points"),
    Column("pieces", "pieces"),
    Column("right", "samples right", ".2%"),
    Column("none", "without a label", ".2%"),
    Column("naive", "fixed pose per frame", ".2%"),
    Column("seconds", "CPU s", ".1f"),
)


class Group(NamedTuple):
    """Trials that are judged together."""

    half: str
    kind: str
    keep: float


def summary(trials: Sequence[Trial]) -> Grid:
    """Judge the labelling by half, kind of model and names that were kept."""
    groups: dict[Group, list[Trial]] = {}
    for trial in trials:
        groups.setdefault(Group(trial.pair.half, trial.pair.kind, trial.keep), []).append(trial)
    ordered = sorted(groups, key=lambda g: (HALVES.index(g.half), KINDS.index(g.kind), g.keep))
    rows = [_summary_row(group, groups[group]) for group in ordered]
    return Grid("summary", "Samples right", _SUMMARY, rows)


def _summary_row(group: Group, trials: Sequence[Trial]) -> dict[str, Cell]:
    samples = sum(trial.samples for trial in trials)
    right = share(sum(trial.right for trial in trials), samples)
    rivals = [trial for trial in trials if trial.naive is not None]
    target = TARGETS.get(group.kind)
    return {
        "half": group.half,
        "kind": group.kind,
        "named": f"{group.keep:.0%}",
        "trials": len(trials),
        "samples": samples,
        "right": right,
        "worst": min(share(trial.right, trial.samples) for trial in trials),
        "target": "" if target is None else f">= {target:.0%}",
        "met": None if target is None else right >= target,
        "none": share(sum(trial.none for trial in trials), samples),
        "ghosts": share(
            sum(trial.ghosts_labelled for trial in trials), sum(trial.ghosts for trial in trials)
        ),
        "naive": share(
            sum(trial.naive or 0 for trial in rivals), sum(trial.samples for trial in rivals)
        ),
        "seconds": float(np.mean([trial.seconds for trial in trials])),
        "slowest": max(trial.seconds for trial in trials),
    }


def confidence(trials: Sequence[Trial]) -> Grid:
    """Hold the stated confidence of pieces with a label against how many are right."""
    rows = []
    for half in HALVES:
        own = [trial for trial in trials if trial.pair.half == half]
        if not own:
            continue
        stated = np.concatenate([trial.confidence for trial in own])
        right = np.concatenate([trial.correct for trial in own])
        lengths = np.concatenate([trial.lengths for trial in own])
        wrong = lengths[~right].sum()
        for low, high in itertools.pairwise(BINS):
            inside = (stated >= low) & ((stated < high) | (high == BINS[-1]))
            row: dict[str, Cell] = {
                "half": half,
                "from": low,
                "to": high,
                "pieces": int(inside.sum()),
                "stated": float(stated[inside].mean()) if inside.any() else None,
                "right": float(right[inside].mean()) if inside.any() else None,
                "share_of_wrong": share(int(lengths[inside & ~right].sum()), int(wrong)),
            }
            rows.append(row)
    return Grid("confidence", "Is a low confidence a wrong label", _CONFIDENCE, rows)


def each(trials: Sequence[Trial]) -> Grid:
    """List the trials."""
    rows: list[dict[str, Cell]] = [
        {
            "target": trial.pair.target,
            "source": trial.pair.source,
            "kind": trial.pair.kind,
            "half": trial.pair.half,
            "seed": trial.seed,
            "named": f"{trial.keep:.0%}",
            "frames": trial.frames,
            "points": trial.points,
            "pieces": trial.pieces,
            "right": share(trial.right, trial.samples),
            "none": share(trial.none, trial.samples),
            "naive": None if trial.naive is None else share(trial.naive, trial.samples),
            "seconds": trial.seconds,
        }
        for trial in trials
    ]
    return Grid("trials", "Trials", _TRIALS, rows)
