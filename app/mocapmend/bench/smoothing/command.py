"""What `bench smoothing` takes, and the run."""

import argparse
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.grid import Cell, Column, Grid, Report
from mocapmend.bench.say import say
from mocapmend.bench.smoothing.cases import BAD_TRUTH, HALVES, Case, read_cases
from mocapmend.bench.smoothing.trials import WAYS, Trial, trials

NOISES_MM = (0.0, 0.5, 1.0, 2.0, 5.0)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_data(parser)
    parser.add_argument(
        "--half", choices=HALVES, help="one half of the subjects: tune on one, report the other"
    )
    parser.add_argument(
        "--frames",
        type=at_least(64),
        default=600,
        help="so many from the middle of each recording (default: %(default)s)",
    )


def run(arguments: argparse.Namespace) -> Report:
    """Try all ways on all recordings with all noises."""
    cases = read_cases(arguments.data, arguments.half, arguments.frames)
    found: list[Trial] = []
    for number, case in enumerate(cases, 1):
        for noise in NOISES_MM:
            found += trials(case, noise, WAYS)
        say(f"{number} of {len(cases)}: {case.name}")
    return report(cases, found)


def report(cases: Sequence[Case], found: Sequence[Trial]) -> Report:
    """Make the tables of a run."""
    members = [
        f"{half}: {', '.join(case.name for case in cases if case.half == half) or 'none'}"
        for half in HALVES
    ]
    left_out = "; ".join(f"{name} {why}" for name, why in BAD_TRUTH.items())
    notes = [
        f"Recordings by half, none of a subject of the other ({'; '.join(members)}).",
        f"Left out: {left_out}.",
        "Ratios are geometric means over recordings; below 1 is better than not smoothing.",
    ]
    grids = [
        _by_noise("position", "RMS error, after / before", found, _ratio("position")),
        _by_noise("speed", "RMS error of velocity, after / before", found, _ratio("speed")),
        _by_noise(
            "acceleration",
            "RMS error of acceleration, after / before",
            found,
            _ratio("acceleration"),
        ),
        _by_noise(
            "impacts", "RMS error at impacts (mm), median over recordings", found, _at_impacts
        ),
        _by_noise("largest", "Largest error at an impact (mm), median", found, _largest),
        _cost(found),
        _everything(found),
    ]
    return Report(f"Smoothing of {len(cases)} recordings with added noise", grids, notes)


Figure = Callable[[Sequence[Trial]], float]


def _ratio(name: str) -> Figure:
    def figure(some: Sequence[Trial]) -> float:
        before = np.array([getattr(trial.before, name) for trial in some])
        after = np.array([getattr(trial.after, name) for trial in some])
        return float(np.exp(np.mean(np.log(after / before)))) if before.all() else float("nan")

    return figure


def _at_impacts(some: Sequence[Trial]) -> float:
    return float(np.median([trial.after.at_impacts for trial in some]))


def _largest(some: Sequence[Trial]) -> float:
    return float(np.median([trial.after.largest_at_impacts for trial in some]))


def _by_noise(key: str, title: str, found: Sequence[Trial], figure: Figure) -> Grid:
    noises = sorted({trial.noise_mm for trial in found})
    if figure not in (_at_impacts, _largest):
        noises = [noise for noise in noises if noise > 0]
    columns = [Column("half", "half"), Column("folder", "recordings"), Column("way", "way")]
    columns += [Column(f"noise_{noise:g}", f"{noise:g} mm", ".3g") for noise in noises]
    rows: list[Mapping[str, Cell]] = []
    for (half, folder, way), some in _groups(found).items():
        cells: dict[str, Cell] = {"half": half, "folder": folder, "way": way}
        for noise in noises:
            cells[f"noise_{noise:g}"] = figure([t for t in some if t.noise_mm == noise])
        rows.append(cells)
    return Grid(key, title, columns, rows)


def _groups(found: Sequence[Trial]) -> dict[tuple[str, str, str], list[Trial]]:
    groups: dict[tuple[str, str, str], list[Trial]] = {}
    for trial in sorted(found, key=lambda t: (HALVES.index(t.case.half), t.case.folder)):
        groups.setdefault((trial.case.half, trial.case.folder, trial.way), []).append(trial)
    return groups


def _cost(found: Sequence[Trial]) -> Grid:
    columns = [Column("way", "way"), Column("ms", "ms CPU per 1,000 samples", ".2f")]
    rows: list[Mapping[str, Cell]] = []
    for way in dict.fromkeys(trial.way for trial in found):
        some = [trial for trial in found if trial.way == way]
        samples = sum(int(trial.case.truth.present.sum()) for trial in some)
        rows.append({"way": way, "ms": 1e6 * sum(trial.seconds for trial in some) / samples})
    return Grid("cost", "Cost", columns, rows)


def _everything(found: Sequence[Trial]) -> Grid:
    names = ("position", "speed", "acceleration", "at_impacts", "largest_at_impacts")
    keys = [f"{name}_{when}" for name in names for when in ("before", "after")]
    columns = [Column(key, key) for key in ("recording", "half", "way", "noise_mm", *keys)]
    rows: list[Mapping[str, Cell]] = [
        {
            "recording": trial.case.name,
            "half": trial.case.half,
            "way": trial.way,
            "noise_mm": trial.noise_mm,
            **{f"{name}_before": getattr(trial.before, name) for name in names},
            **{f"{name}_after": getattr(trial.after, name) for name in names},
        }
        for trial in found
    ]
    return Grid("trials", "All", columns, rows, for_people=False)
