"""What `bench paper` takes, and the run."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.grid import Cell, Column, Grid, Report
from mocapmend.bench.paper import rivals as rival_table
from mocapmend.bench.paper.rivals import Rival
from mocapmend.bench.paper.status import say
from mocapmend.bench.paper.tables import (
    CASE_COLUMNS,
    case_rows,
    mean,
    noise_free,
    spectrum_grid,
    speed,
    summary,
    sweep,
    targets,
    trainings,
)
from mocapmend.bench.paper.trained import Trained
from mocapmend.bench.paper.trials import (
    FOLDER,
    LOST_SHARE,
    MOTIONS,
    REGIONS,
    Trial,
    cases,
    read_trials,
    rmse,
)
from mocapmend.errors import MocapmendError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_data(parser)
    parser.add_argument(
        "--motion", choices=MOTIONS, help="one kind of motion (default: all of them)"
    )
    parser.add_argument(
        "--test",
        type=Path,
        nargs="+",
        metavar="FILE",
        help="repair these recordings of --motion; all other trials of the motion teach",
    )
    parser.add_argument(
        "--tune",
        action="store_true",
        help="try three settings of each method on the validation trials instead",
    )
    parser.add_argument(
        "--rounds", type=at_least(1), default=10, help="of training (default: %(default)s)"
    )
    parser.add_argument("--atoms", type=at_least(10), help="of each trained dictionary")


def run(arguments: argparse.Namespace) -> Report:
    """Repair the trials with all methods."""
    if arguments.test and not arguments.motion:
        raise MocapmendError(
            "Which motion these recordings are of is not known.",
            str(arguments.test[0]),
            f"Give --motion with one of {', '.join(MOTIONS)}.",
        )
    if not (arguments.data / FOLDER).is_dir():
        raise MocapmendError(
            f"There is no folder {FOLDER} here.", str(arguments.data), "Give its place by --data."
        )
    motions = [arguments.motion] if arguments.motion else list(MOTIONS)
    tests: Sequence[Path | None] = arguments.test or [None]
    trials = [
        trial
        for motion in motions
        for test in tests
        for trial in read_trials(motion, arguments.data, test, validate=arguments.tune)
    ]
    trained = Trained(arguments.rounds, arguments.atoms)
    table = rival_table.rivals(lambda case: trained.of(case.trial).dictionaries)
    if arguments.tune:
        return Report("Settings tried on the validation trials", [_tuned(trials, table)])
    rows = [row for trial in trials for row in case_rows(trial, table)]
    grids = [
        summary(rows),
        Grid("rows", "Case by case", CASE_COLUMNS, rows, for_people=False),
        noise_free(trials, table),
    ]
    if not arguments.test:
        grids.append(sweep(trials, table))
        grids.append(spectrum_grid(arguments.data))
    grids.append(speed(trials))
    grids.append(trainings(trials, trained))
    grids.append(targets(rows, grids))
    return Report(_title(trials), grids, NOTES)


NOTES = (
    "40 % of the frames miss the points, in one run in the middle; errors are 3-D, over these.",
    "Noise of 60 dB on the signed squares, taken back to coordinates once: 0.5 cm in the mean.",
    "The regions are ours: W18's figure 4 cannot be read off.",
    "One trial of punches, divided by time, stands for boxing, whose trials are not to be had.",
    "Each method had three settings to choose from, on the validation trials (--tune).",
)


def _title(trials: Sequence[Trial]) -> str:
    names = ", ".join(f"{trial.motion} {trial.name}" for trial in trials)
    return f"The experiment of W18: {names}"


def _tuned(trials: Sequence[Trial], table: Sequence[Rival]) -> Grid:
    lines: list[dict[str, Cell]] = []
    for rival in (rival for rival in table if len(rival.settings) > 1):
        for setting, find in rival.settings.items():
            line: dict[str, Cell] = {
                "method": rival.name,
                "setting": setting,
                "chosen": setting == rival.chosen,
            }
            for motion in dict.fromkeys(trial.motion for trial in trials):
                for points in REGIONS:
                    say(f"{rival.name}, {setting}: {motion}, {points} points")
                    errors = [
                        rmse(case, find(case))
                        for trial in trials
                        if trial.motion == motion
                        for case in cases(trial, points, LOST_SHARE, noise=True)
                    ]
                    line[f"{motion}_{points}"] = mean(errors)
            lines.append(line)
    kinds = [key for key in lines[0] if key not in ("method", "setting", "chosen")]
    columns = [
        Column("method", "method"),
        Column("setting", "setting"),
        Column("chosen", "chosen"),
        *(Column(key, f"{key.replace('_', ' ')}, RMSE cm", ".2f") for key in kinds),
    ]
    return Grid("settings", "RMSE on the validation trials", columns, lines)
