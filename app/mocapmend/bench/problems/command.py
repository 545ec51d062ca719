"""What `bench problems` takes, and the run."""

import argparse

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.grid import Report
from mocapmend.bench.problems import tables
from mocapmend.bench.problems.corruption import RATE
from mocapmend.bench.problems.experiments import EXPERIMENTS, SWAP_REPEATS
from mocapmend.bench.problems.recordings import CLEAN, HALVES, KNOWN
from mocapmend.bench.problems.trials import Outcome, run_experiment
from mocapmend.bench.problems.untouched import Found, look
from mocapmend.bench.say import say

UNTOUCHED = "untouched"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_data(parser)
    parser.add_argument(
        "--only",
        metavar="E,...",
        type=_names,
        help=f"experiments to run, or {UNTOUCHED} (default: all)",
    )
    parser.add_argument("--half", choices=HALVES, help="recordings to use (default: both halves)")
    parser.add_argument(
        "--repeats", type=at_least(1), default=3, help="how often each recording is corrupted"
    )


def run(arguments: argparse.Namespace) -> Report:
    """Corrupt the recordings, look for the errors, and make the tables."""
    halves = [arguments.half] if arguments.half else list(HALVES)
    outcomes: list[Outcome] = []
    for experiment in EXPERIMENTS:
        if arguments.only and experiment.key not in arguments.only:
            continue
        for half in halves:
            new = run_experiment(experiment, arguments.data, half, arguments.repeats)
            outcomes += new
            say(f"{experiment.key}, {half}: F1 {new[0].score.f1:.3f}")
    found = _untouched(arguments, halves)
    grids = [
        tables.detectors(outcomes),
        tables.untouched(found),
        tables.targets(outcomes, found),
    ]
    members = [f"{half.capitalize()}: {', '.join(HALVES[half])}." for half in halves]
    return Report("Detection of bad samples", grids, [*_notes(arguments.repeats), *members])


def _notes(repeats: int) -> list[str]:
    put_in = (
        f"{100 * RATE:g} % of the samples are made wrong, {repeats} times over "
        f"({SWAP_REPEATS} times as often for swaps, which are long and few)."
    )
    earlier = (
        "What all detectors find in a recording before anything is put in, and three frames beside "
        "it, counts as false for nobody: many of these are real errors. In the strict F1 it counts."
    )
    rivals = "The thresholds of the rivals are the best ones for the very errors that they judge."
    return [put_in, earlier, rivals]


def _untouched(arguments: argparse.Namespace, halves: list[str]) -> list[Found]:
    if arguments.only and UNTOUCHED not in arguments.only:
        return []
    names = [*CLEAN, *KNOWN, *(name for half in halves for name in HALVES[half])]
    return [look(arguments.data, name) for name in dict.fromkeys(names)]


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    known = [*(experiment.key for experiment in EXPERIMENTS), UNTOUCHED]
    if strange := sorted(set(names) - set(known)):
        raise argparse.ArgumentTypeError(
            f"there is no experiment {strange[0]!r}; there are: {', '.join(known)}"
        )
    return names
