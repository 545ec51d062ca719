"""The tables of `bench paper`."""

import time
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from mocapmend.bench.grid import Cell, Column, Grid
from mocapmend.bench.memory import peak_mb
from mocapmend.bench.paper import rivals as rival_table
from mocapmend.bench.paper.rivals import Rival, project, speed_of_bones
from mocapmend.bench.paper.status import say
from mocapmend.bench.paper.trained import Trained
from mocapmend.bench.paper.trials import (
    LOST_SHARE,
    REGIONS,
    Trial,
    bone_rmse,
    cases,
    read_joints,
    rmse,
    spectrum,
)
from mocapmend_algorithms.sparse.body import find_body

RATES = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
SWEEP = "06_04"
"""Stands for W18's 06_02: a forward dribble too."""
SWEPT = ("TSMC, plain", "TSMC", "SMBS", "ridge, W18's windows", "W18, as printed", "W18, best")
SPECTRUM = "49_18"
"""Stands for W18's 49_02: standing on one leg."""
BEST, SMBS = "W18, best", "SMBS"
ALONE, TAUGHT = "auto", "auto, the trials given"
RATIOS = (
    ("ridge, W18's windows", 0.8),
    ("ridge, best's windows", 0.8),
    ("TSMC, plain", 0.6),
    ("TSMC", 0.6),
    (SMBS, 1.0),
)
"""What the best setting is to be of others' errors."""
AUTO_RATIO = 1.1
"""What `auto` is to be of the error of the best other method."""
VALUES = 12


CASE_COLUMNS = (
    Column("motion", "motion"),
    Column("test", "trial"),
    Column("points", "points"),
    Column("region", "where"),
    Column("method", "method"),
    Column("setting", "setting"),
    Column("projected", "projected"),
    Column("rmse_cm", "RMSE, cm", ".2f"),
    Column("bone_rmse_cm", "bones that touch, cm", ".2g"),
    Column("bone_rmse_all_cm", "all bones, cm", ".2g"),
    Column("seconds", "seconds", ".2f"),
    Column("frames_per_s", "frames/s", ".0f"),
)


def case_rows(trial: Trial, table: Sequence[Rival]) -> Iterator[dict[str, Cell]]:
    """Repair a trial with every method, region by region."""
    for points in REGIONS:
        for case in cases(trial, points, LOST_SHARE, noise=True):
            say(f"{trial.motion} {trial.name}, {points} points, {case.region}")
            for rival in table:
                began = time.perf_counter()
                found = rival.find(case)
                seconds = time.perf_counter() - began
                for projected, places in ((False, found), (True, project(case, found))):
                    yield {
                        "motion": trial.motion,
                        "test": trial.name,
                        "points": points,
                        "region": case.region,
                        "method": rival.name,
                        "setting": rival.chosen,
                        "projected": projected,
                        "rmse_cm": rmse(case, places),
                        "bone_rmse_cm": bone_rmse(case, places),
                        "bone_rmse_all_cm": bone_rmse(case, places, everywhere=True),
                        "seconds": seconds,
                        "frames_per_s": (case.stop - case.start) / seconds,
                    }


def mean(errors: Sequence[float]) -> float:
    """Return the root of the mean square over cases: each counts alike, whatever its length."""
    return float(np.sqrt(np.mean(np.square(errors)))) if errors else float("nan")


def _column(rows: Sequence[Mapping[str, Cell]], key: str) -> list[float]:
    return [float(row[key] or 0) for row in rows]


def summary(rows: Sequence[Mapping[str, Cell]]) -> Grid:
    """Sum the cases up: a line for each method, with and without the bone projection."""
    motions = list(dict.fromkeys(str(row["motion"]) for row in rows))
    kinds = [(motion, points) for motion in motions for points in REGIONS]
    columns = [Column("method", "method"), Column("projected", "projected")]
    columns += [Column(f"{m}_{p}", f"{m} {p}, RMSE cm", ".2f") for m, p in kinds]
    columns += [Column(f"{m}_{p}_bones", f"{m} {p}, bones cm", ".2g") for m, p in kinds]
    columns.append(Column("frames_per_s", "frames/s, learning included", ".0f"))
    table: list[dict[str, Cell]] = []
    for method in dict.fromkeys(str(row["method"]) for row in rows):
        for projected in (False, True):
            own = [r for r in rows if r["method"] == method and r["projected"] is projected]
            line: dict[str, Cell] = {"method": method, "projected": projected}
            for m, p in kinds:
                here = [row for row in own if row["motion"] == m and row["points"] == p]
                line[f"{m}_{p}"] = mean(_column(here, "rmse_cm"))
                line[f"{m}_{p}_bones"] = mean(_column(here, "bone_rmse_cm"))
            line["frames_per_s"] = float(np.median([float(r["frames_per_s"] or 0) for r in own]))
            table.append(line)
    return Grid("summary", "RMSE over the missing points, and bones that touch one", columns, table)


def noise_free(trials: Sequence[Trial], table: Sequence[Rival]) -> Grid:
    """Measure bones where nothing but the gap is wrong."""
    best = next(rival for rival in table if rival.name == BEST)
    plain = rival_table.before_projection()
    lines: list[dict[str, Cell]] = []
    for trial in trials:
        for points in REGIONS:
            before, after, error = [], [], []
            for case in cases(trial, points, LOST_SHARE, noise=False):
                say(f"{trial.motion} {trial.name} without noise, {points} points, {case.region}")
                before.append(bone_rmse(case, plain(case)))
                found = best.find(case)
                after.append(bone_rmse(case, found))
                error.append(rmse(case, found))
            lines.append(
                {
                    "motion": trial.motion,
                    "test": trial.name,
                    "points": points,
                    "rmse_cm": mean(error),
                    "bones_before_cm": mean(before),
                    "bones_after_cm": mean(after),
                }
            )
    columns = (
        Column("motion", "motion"),
        Column("test", "trial"),
        Column("points", "points"),
        Column("rmse_cm", "RMSE, cm", ".2f"),
        Column("bones_before_cm", "bones before projection, cm", ".2g"),
        Column("bones_after_cm", "bones after it, cm", ".2g"),
    )
    return Grid(
        "noise_free", f"{BEST}, without noise: bones that touch a missing point", columns, lines
    )


def sweep(trials: Sequence[Trial], table: Sequence[Rival]) -> Grid:
    """Lose more and more frames (W18, figure 9)."""
    chosen = [rival for rival in table if rival.name in SWEPT]
    swept = [trial for trial in trials if trial.name == SWEEP]
    lines: list[dict[str, Cell]] = []
    for rate in RATES:
        errors: dict[str, list[float]] = {rival.name: [] for rival in chosen}
        for trial in swept:
            say(f"{trial.name}, {100 * rate:.0f} % missing")
            for case in cases(trial, 6, rate, noise=True):
                for rival in chosen:
                    errors[rival.name].append(rmse(case, rival.find(case)))
        if swept:
            line: dict[str, Cell] = {"rate": 100 * rate}
            lines.append(line | {name: mean(values) for name, values in errors.items()})
    columns = [Column("rate", "missing, %", ".0f")]
    columns += [Column(rival.name, f"{rival.name}, cm", ".2f") for rival in chosen]
    return Grid(
        "sweep", f"Figure 9: RMSE by the share of missing frames, {SWEEP}, 6 points", columns, lines
    )


def spectrum_grid(folder: Path) -> Grid:
    """Compare the singular values of coordinates and of F2 (W18, figure 3)."""
    recording = read_joints(folder, SPECTRUM)
    body = find_body(recording, recording.present)
    x, squares = spectrum(recording.points, body, VALUES)
    lines: list[dict[str, Cell]] = [
        {"number": at + 1, "x": a, "f2": b}
        for at, (a, b) in enumerate(zip(x, squares, strict=True))
    ]
    columns = (
        Column("number", "singular value"),
        Column("x", "X", ".4f"),
        Column("f2", "F2", ".4f"),
    )
    return Grid(
        "spectrum", f"Figure 3: singular values as shares of their sum, {SPECTRUM}", columns, lines
    )


def speed(trials: Sequence[Trial]) -> Grid:
    """Time the best setting: what it learns once for a set of markers, and what it then does."""
    lines: list[dict[str, Cell]] = []
    for trial in trials:
        times = [
            (*speed_of_bones(case), case.stop - case.start)
            for points in REGIONS
            for case in cases(trial, points, LOST_SHARE, noise=True)
        ]
        lines.append(
            {
                "motion": trial.motion,
                "test": trial.name,
                "learning_s": float(np.median([learning for learning, _, _ in times])),
                "recovery_s": float(np.median([recovery for _, recovery, _ in times])),
                "frames_per_s": float(np.median([n / recovery for _, recovery, n in times])),
            }
        )
    columns = (
        Column("motion", "motion"),
        Column("test", "trial"),
        Column("learning_s", "learning a set of markers, s", ".2f"),
        Column("recovery_s", "recovery, s", ".2f"),
        Column("frames_per_s", "frames/s of recovery", ".0f"),
    )
    return Grid("speed", f"{BEST}: time, one thread", columns, lines)


def trainings(trials: Sequence[Trial], trained: Trained) -> Grid:
    """Say what the training of each motion took."""
    lines: list[dict[str, Cell]] = []
    for trial in {tuple(map(id, t.teachers)): t for t in trials}.values():
        parts = trained.of(trial)
        rises = [np.diff(values).max() for values in parts.objectives.values()]
        lines.append(
            {
                "motion": trial.motion,
                "frames": parts.frames,
                "atoms": max(d.atoms.shape[1] for d in parts.dictionaries.values()),
                "rounds": max(len(values) - 1 for values in parts.objectives.values()),
                "never_rises": bool(max(rises) <= 0),
                "seconds": parts.seconds,
                "memory_mb": parts.memory_mb,
            }
        )
    columns = (
        Column("motion", "motion"),
        Column("frames", "frames", ","),
        Column("atoms", "atoms per part", ","),
        Column("rounds", "rounds"),
        Column("never_rises", "objective never rises"),
        Column("seconds", "seconds, five parts, one thread", ".0f"),
        Column("memory_mb", "memory, MB", ".0f"),
    )
    return Grid("training", "Training of W18's dictionaries, as printed", columns, lines)


def _error(
    rows: Sequence[Mapping[str, Cell]], motion: str, points: int, method: str, *, projected: bool
) -> float:
    wanted = {"motion": motion, "points": points, "method": method, "projected": projected}
    those = [row for row in rows if all(row[key] == value for key, value in wanted.items())]
    return mean(_column(those, "rmse_cm"))


def targets(rows: Sequence[Mapping[str, Cell]], grids: Sequence[Grid]) -> Grid:
    """Hold the best setting against what it is to reach, motion by motion."""
    lines: list[dict[str, Cell]] = []

    def add(what: str, value: float, most: float) -> None:
        lines.append({"what": what, "value": value, "target": f"<= {most:g}", "met": value <= most})

    for motion in dict.fromkeys(str(row["motion"]) for row in rows):
        for points in REGIONS:
            best = _error(rows, motion, points, BEST, projected=True)
            for rival, most in RATIOS:
                for projected in (False, True):
                    how = ", projected" if projected else ""
                    against = _error(rows, motion, points, rival, projected=projected)
                    add(f"{motion}, {points} points: {BEST} / {rival}{how}", best / against, most)
            errors = {
                method: _error(rows, motion, points, method, projected=False)
                for method in dict.fromkeys(str(row["method"]) for row in rows)
            }
            taught = errors.pop(TAUGHT)
            errors.pop(ALONE)
            name, least = min(errors.items(), key=lambda one: one[1])
            add(f"{motion}, {points} points: {TAUGHT} / {name}", taught / least, AUTO_RATIO)
    by_key = {grid.key: grid.rows for grid in grids}
    bones = [float(row["bones_after_cm"] or 0) for row in by_key["noise_free"]]
    add("bone RMSE without noise, cm", max(bones), 1e-5)
    for row in by_key.get("sweep", ()):
        ratio = float(row[BEST] or 0) / float(row[SMBS] or 1)
        add(f"{BEST} / {SMBS}, {row['rate']:.0f} % missing", ratio, 1.0)
    for row in by_key["training"]:
        add(f"training, {row['motion']}, minutes", float(row["seconds"] or 0) / 60, 30)
    fps = [float(row["frames_per_s"] or 0) for row in by_key["speed"]]
    add("100 / frames/s of recovery", 100 / min(fps), 1.0)
    add("memory, GB", (peak_mb() or float("nan")) / 1000, 2.0)
    columns = (
        Column("what", "what"),
        Column("value", "value", ".3g"),
        Column("target", "target"),
        Column("met", "met"),
    )
    return Grid("targets", "Targets", columns, lines)
