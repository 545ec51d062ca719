"""What `bench labels` takes, and the run."""

import argparse

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.grid import Report
from mocapmend.bench.labels import scrambling, tables
from mocapmend.bench.labels.pairs import HALVES, KINDS, OTHER_SET, pairs
from mocapmend.bench.labels.trials import HALF_LABELLED, Trial, attempt
from mocapmend.bench.say import say
from mocapmend.errors import MocapmendError


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_data(parser)
    parser.add_argument(
        "--half", choices=HALVES, help="pairs of one half of the subjects: tune on train alone"
    )
    parser.add_argument("--kind", choices=KINDS, help="pairs of this kind alone")
    parser.add_argument(
        "--recordings", metavar="NAME[,NAME...]", help="label these alone, as 135_02"
    )
    parser.add_argument(
        "--seeds", type=at_least(1), default=1, metavar="N", help="scramblings of each pair"
    )


def run(arguments: argparse.Namespace) -> Report:
    """Label scrambled recordings.

    Raises
    ------
    MocapmendError
        If a recording cannot be read, or no pair is what was asked for.
    """
    chosen = [
        pair
        for pair in pairs(arguments.data)
        if arguments.half in {None, pair.half}
        and arguments.kind in {None, pair.kind}
        and (arguments.recordings is None or pair.target in arguments.recordings.split(","))
    ]
    if not chosen:
        raise MocapmendError("No pair of recordings is what was asked for.", "bench labels")
    trials: list[Trial] = []
    for number, pair in enumerate(chosen, 1):
        for seed in range(1, arguments.seeds + 1):
            for keep in (0.0,) if pair.kind == OTHER_SET else (0.0, HALF_LABELLED):
                naive = seed == 1 and keep == 0.0
                trials.append(attempt(arguments.data, pair, seed, keep, naive=naive))
        say(f"{number} of {len(chosen)}: {_sentence(trials[-1])}")
    return report(trials)


def report(trials: list[Trial]) -> Report:
    """Make the tables of a run."""
    pieces = sum(trial.pieces for trial in trials)
    hidden = (
        f"{pieces} pieces. Each marker is hidden {scrambling.OCCLUSIONS_PER_SECOND:g} times per "
        f"second, for {scrambling.MEDIAN_OCCLUSION:g} s in the middle, "
        f"{scrambling.TOGETHER:.0%} of the times with 1 to {scrambling.NEIGHBOURS} neighbours; "
        f"in {scrambling.HIDDEN_WHOLE:.0%} of the trials one marker is never seen."
    )
    stored = (
        f"{scrambling.SAME_POINT:.0%} of the pieces share a point with pieces of other markers, "
        f"if one is free; {scrambling.GHOSTS_PER_SECOND:g} ghosts per second, and "
        f"{scrambling.STATIC_GHOSTS} that stand still; any heading and place."
    )
    counted = (
        "A sample without a label counts as wrong. Samples of points that kept their names are "
        "not counted. Markers that the model does not know count as ghosts."
    )
    grids = [tables.summary(trials), tables.confidence(trials), tables.each(trials)]
    return Report(f"Labels of {len(trials)} scrambled recordings", grids, [hidden, stored, counted])


def _sentence(trial: Trial) -> str:
    right = trial.right / max(trial.samples, 1)
    return (
        f"{trial.pair.target} by {trial.pair.source} ({trial.pair.kind}): {right:.2%} right, "
        f"{trial.seconds:.1f} s"
    )
