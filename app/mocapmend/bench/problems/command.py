"""What `bench problems` takes, and the run."""

import argparse
import sys
from pathlib import Path

from mocapmend.bench.arguments import at_least
from mocapmend.bench.grid import Report
from mocapmend.bench.problems import tables
from mocapmend.bench.problems.corruption import RATE
from mocapmend.bench.problems.recordings import HALVES
from mocapmend.bench.problems.trials import EXPERIMENTS, run_experiment

DATA = Path("../shared/data")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--data",
        type=Path,
        default=DATA,
        metavar="DIR",
        help="the folder of the recordings (default: %(default)s)",
    )
    parser.add_argument(
        "--only", metavar="E,...", type=_names, help="experiments to run (default: all)"
    )
    parser.add_argument("--half", choices=HALVES, help="recordings to use (default: both halves)")
    parser.add_argument(
        "--repeats", type=at_least(1), default=5, help="how often each recording is corrupted"
    )


def run(arguments: argparse.Namespace) -> Report:
    """Corrupt the recordings, look for the errors, and make the tables."""
    halves = [arguments.half] if arguments.half else list(HALVES)
    outcomes = []
    for experiment in EXPERIMENTS:
        if arguments.only and experiment.key not in arguments.only:
            continue
        for half in halves:
            outcomes += run_experiment(experiment, arguments.data, half, arguments.repeats)
            sys.stderr.write(f"{experiment.key} {half}: F1 {outcomes[-1].score.f1:.3f}\n")
    notes = [
        f"{100 * RATE:g} % of the samples are made wrong, {arguments.repeats} times over.",
        *(f"{half}: {', '.join(HALVES[half])}." for half in halves),
    ]
    return Report("Detection of bad samples", [tables.detectors(outcomes)], notes)


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    known = [experiment.key for experiment in EXPERIMENTS]
    if strange := sorted(set(names) - set(known)):
        raise argparse.ArgumentTypeError(
            f"there is no experiment {strange[0]!r}; there are: {', '.join(known)}"
        )
    return names
