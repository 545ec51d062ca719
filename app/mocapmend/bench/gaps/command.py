"""What `bench gaps` takes, and the run."""

import argparse
import math
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path

from mocapmend.bench.arguments import add_data, at_least
from mocapmend.bench.gaps import scaling, tables
from mocapmend.bench.gaps.cases import HALVES, Case, halves, read_cases
from mocapmend.bench.gaps.figures import Trials
from mocapmend.bench.gaps.protocols import AUTO, KNOWN
from mocapmend.bench.gaps.targets import targets
from mocapmend.bench.gaps.trials import Trial, load, run_case, warm_up
from mocapmend.bench.grid import Report
from mocapmend.bench.say import say
from mocapmend.errors import MocapmendError
from mocapmend_algorithms.fill import registry

CASES = Path("peers/cases.json")
THREADS = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    add_data(parser)
    parser.add_argument(
        "--case-file",
        type=Path,
        nargs="+",
        action="extend",
        metavar="F",
        help=f"the cases (default: {CASES.as_posix()} in the folder of the recordings)",
    )
    parser.add_argument(
        "--methods",
        type=_methods,
        default=list(registry.METHODS),
        metavar="ID[,ID...]",
        help=f"some of {', '.join(registry.METHODS)} (default: all)",
    )
    parser.add_argument(
        "--protocols", type=_names, metavar="P[,P...]", help="these alone, as P2 or 'P2 0.5 s'"
    )
    parser.add_argument(
        "--recordings", type=_names, metavar="NAME[,NAME...]", help="cases on these alone"
    )
    parser.add_argument(
        "--half", choices=HALVES, help="one half of the recordings: tune on one, report the other"
    )
    parser.add_argument(
        "--jobs",
        type=at_least(1),
        default=1,
        metavar="N",
        help="processes; several disturb each other's times (default: %(default)s)",
    )
    parser.add_argument(
        "--scaling", action="store_true", help="measure how the cost grows instead; needs no cases"
    )


def run(arguments: argparse.Namespace) -> Report:
    """Try the methods on the cases, or measure how their cost grows."""
    if arguments.scaling:
        walk = scaling.bundled_walk()
        series = scaling.sizes(round(scaling.SECONDS * walk.rate))
        grid = scaling.scaling(walk, series, arguments.methods, say)
        title = f"Cost of repair, {walk.markers} markers, gaps of {scaling.GAP_SECONDS:g} s"
        return Report(title, [grid], [_threads(), "One run; a walk played to and fro."])
    cases = read_cases(arguments.case_file or [arguments.data / CASES])
    half_of = halves(cases)
    chosen = choose(cases, arguments, half_of)
    for case in chosen:
        load(case, arguments.data)
    found: list[Trial] = []
    for number, trials in enumerate(_run_all(chosen, arguments), 1):
        found += trials
        say(f"{number} of {len(chosen)}: {_sentence(trials)}")
    ordered = sorted(found, key=lambda trial: arguments.methods.index(trial.method))
    return report(Trials(ordered), half_of, arguments.half, arguments.jobs)


def choose(
    cases: Sequence[Case], arguments: argparse.Namespace, half_of: dict[str, str]
) -> list[Case]:
    """Return the cases that were asked for.

    Raises
    ------
    MocapmendError
        If there is none of what was asked for.
    """
    chosen = list(cases)
    wanted: tuple[tuple[str, Sequence[str] | None, Callable[[Case], set[str]]], ...] = (
        ("protocol", arguments.protocols, lambda case: {case.family, str(case.protocol)}),
        ("recording", arguments.recordings, lambda case: {case.recording}),
        ("half", arguments.half and [arguments.half], lambda case: {half_of[case.recording]}),
    )
    for what, names, names_of in wanted:
        for name in names or ():
            if not any(name in names_of(case) for case in chosen):
                raise MocapmendError(
                    f"No case is of the {what} {name!r}.", "bench gaps", "Ask for another."
                )
        if names is not None:
            chosen = [case for case in chosen if names_of(case) & set(names)]
    return chosen


def report(trials: Trials, half_of: dict[str, str], half: str | None, jobs: int) -> Report:
    """Make the tables of a run."""
    cases = {trial.case.name: trial.case for trial in trials.all}.values()
    recordings = sorted({case.recording for case in cases})
    title = f"Repair of {len(cases)} gap cases on {len(recordings)} recordings"
    members = [
        f"{name}: {', '.join(each for each in recordings if half_of[each] == name) or 'none'}"
        for name in HALVES
    ]
    part = f"Half {half} alone" if half else "Both halves"
    notes = [
        f"{part} of the recordings ({'; '.join(members)}).",
        f"{jobs} process{'' if jobs == 1 else 'es'}, {_threads()}",
        "Ratios are geometric means over the cases that a method fills completely.",
    ]
    unknown = sorted({peer for case in cases for peer in case.peers} - KNOWN)
    if unknown:
        notes.append(f"Unknown peers, which count as published: {', '.join(unknown)}.")
    judged = [targets(trials)] if AUTO in trials.methods else []
    grids = [
        tables.references(trials),
        tables.protocols(trials),
        tables.overall(trials),
        *judged,
        tables.cases(trials, half_of),
    ]
    return Report(title, grids, notes)


def _run_all(cases: Sequence[Case], arguments: argparse.Namespace) -> Iterator[list[Trial]]:
    """Run the cases; every method is the first in turn."""
    methods: list[str] = arguments.methods
    orders = [
        [*methods[k % len(methods) :], *methods[: k % len(methods)]] for k in range(len(cases))
    ]
    one = partial(_one, arguments.data)
    if arguments.jobs == 1:
        warm_up(methods)
        yield from map(one, cases, orders)
        return
    with ProcessPoolExecutor(
        arguments.jobs, get_context("spawn"), initializer=warm_up, initargs=(methods,)
    ) as pool:
        yield from pool.map(one, cases, orders)


def _one(data: Path, case: Case, methods: Sequence[str]) -> list[Trial]:
    return run_case(case, data, methods)


def _sentence(trials: Sequence[Trial]) -> str:
    return f"{trials[0].case.name}: {', '.join(map(_figure, trials))}"


def _figure(trial: Trial) -> str:
    error = "open" if math.isnan(trial.rmse) else f"{trial.rmse:.1f} mm"
    return f"{trial.method} {error} {trial.seconds:.2g} s"


def _threads() -> str:
    for name in THREADS:
        if name in os.environ:
            return f"BLAS threads: {os.environ[name]} ({name})."
    return f"BLAS threads: not limited (set {THREADS[0]}=1 for steady CPU times)."


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",")]


def _methods(text: str) -> list[str]:
    try:
        return [registry.method(name).id for name in dict.fromkeys(_names(text))]
    except KeyError as error:
        raise argparse.ArgumentTypeError(error.args[0]) from None
