"""Damaged files: each must open or be refused with a clear message, soon and without much memory.

Every file that opens is filled, exported and checked as well. The command ends with code 1 if a
file breaks this.
"""

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from mocapmend.bench.arguments import at_least
from mocapmend.bench.hunt import Plan, hunt
from mocapmend.bench.seeds import all_seeds
from mocapmend.bench.table import Row, Table
from mocapmend.bench.trial import MOST_EXTRA_MB, SLOW_S, Outcome

MUTANTS = 10_000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--mutants", type=at_least(1), default=MUTANTS, help="damaged files (default: %(default)s)"
    )
    parser.add_argument(
        "--data", type=Path, metavar="DIR", help="damage the recordings in this folder too"
    )
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers")
    parser.add_argument(
        "--keep", type=Path, metavar="DIR", help="keep the files that fail, and how they fail"
    )


def run(arguments: argparse.Namespace) -> Table:
    """Damage files and try them."""
    plan = Plan(all_seeds(arguments.data), arguments.seed)
    tally = Tally()
    for number, outcome in hunt(plan, arguments.mutants):
        tally.add(plan.origin(number).kind, outcome)
        if outcome.fault and arguments.keep is not None:
            keep(plan, number, outcome, arguments.keep)
    title = (
        f"Damaged files, {arguments.mutants} made from {len(plan.seeds)} recordings, "
        f"random seed {arguments.seed}"
    )
    return Table(title, list(rows(tally)), failed=bool(tally.faults))


def keep(plan: Plan, number: int, outcome: Outcome, folder: Path) -> None:
    """Write a file that failed into a folder of its own, with its error."""
    own = folder / f"{number}"
    own.mkdir(parents=True, exist_ok=True)
    plan.write(number, own)
    text = f"{outcome.fault}\nfrom {plan.origin(number).name}\n\n{outcome.detail}\n"
    (own / "error.txt").write_text(text, encoding="utf-8")


@dataclass
class Tally:
    """What became of the files.

    Attributes
    ----------
    outcomes : dict of str to list of Outcome
        By kind of file.
    """

    outcomes: dict[str, list[Outcome]] = field(default_factory=dict)

    def add(self, kind: str, outcome: Outcome) -> None:
        """Count a file."""
        self.outcomes.setdefault(kind, []).append(outcome)

    @property
    def all(self) -> list[Outcome]:
        """Every outcome."""
        return [each for outcomes in self.outcomes.values() for each in outcomes]

    @property
    def faults(self) -> Counter[str]:
        """What went wrong, and how often."""
        return Counter(each.fault for each in self.all if each.fault)


def rows(tally: Tally) -> Iterator[Row]:
    """Make the table."""
    every = tally.all
    count = len(every)
    results = Counter(each.result for each in every)
    yield Row("damaged files", count, "")
    yield Row("opened", results["opened"], "", "damaged files", results["opened"] / count)
    refused = results["refused"]
    yield Row("refused with a clear message", refused, "", "damaged files", refused / count)
    yield _none("failed otherwise", results["failed"])
    yield _none(f"slower than {SLOW_S:g} s", sum(each.seconds > SLOW_S for each in every))
    yield _slowest("slowest", every)
    yield _largest("largest allocation beyond the file", every)
    for kind, outcomes in sorted(tally.outcomes.items()):
        opened = sum(each.result == "opened" for each in outcomes)
        total = len(outcomes)
        yield Row(f"{kind}: opened", opened, "", f"{total} files", opened / total)
        yield _none(f"{kind}: failed, slow or large", sum(bool(each.fault) for each in outcomes))
        yield _slowest(f"{kind}: slowest", outcomes)


def _none(what: str, count: int) -> Row:
    return Row(what, count, "", "none", count, "<= 0")


def _slowest(what: str, outcomes: Sequence[Outcome]) -> Row:
    seconds = max(each.seconds for each in outcomes)
    limit = f"limit {1000 * SLOW_S:g} ms"
    return Row(what, 1000 * seconds, "ms", limit, seconds / SLOW_S, "<= 1")


def _largest(what: str, outcomes: Sequence[Outcome]) -> Row:
    extra = max(0.0, *(each.extra_mb for each in outcomes))
    limit = f"limit {MOST_EXTRA_MB:g} MB"
    return Row(what, extra, "MB", limit, extra / MOST_EXTRA_MB, "<= 1")
