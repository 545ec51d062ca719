"""Runs of measured samples that nobody shall believe, and why. No Qt."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.gaps import overlap, runs

BY_HAND = "by hand"
"""The problem of what the user has set aside without a detector."""


class Doubt(NamedTuple):
    """Why a run is set aside: the id of the detector, or `BY_HAND`, and a sentence."""

    problem: str
    reason: str


Doubts = Mapping[Gap, Doubt]
"""Runs that do not overlap, with the reasons."""


class Change(NamedTuple):
    """How doubts become others: runs that go, and runs that come. Backwards it is its inverse."""

    gone: Doubts
    come: Doubts

    def applied(self, doubts: Doubts) -> dict[Gap, Doubt]:
        """Return doubts after the change."""
        kept = {run: doubt for run, doubt in doubts.items() if run not in self.gone}
        return kept | dict(self.come)


NO_CHANGE = Change({}, {})


def exchanged(doubts: Doubts, exchange: Exchange) -> Change:
    """Return how doubts change where two markers are exchanged: they go with their samples."""
    others = {exchange.first: exchange.second, exchange.second: exchange.first}
    gone = {
        run: doubt
        for run, doubt in doubts.items()
        if run.marker in others and overlap(run, exchange)
    }
    come = {}
    for run, doubt in gone.items():
        start, stop = max(run.start, exchange.start), min(run.stop, exchange.stop)
        for part in (
            Gap(run.marker, run.start, start),
            Gap(others[run.marker], start, stop),
            Gap(run.marker, stop, run.stop),
        ):
            if part.length > 0:
                come[part] = doubt
    return Change(gone, come)


def doubted(doubts: Doubts, run: Gap, doubt: Doubt, there: NDArray[np.bool_]) -> Change:
    """Return how doubts change where a run is set aside.

    Parameters
    ----------
    doubts : mapping of Gap to Doubt
        So far; what is among them stays as it is.
    run : Gap
        Which.
    doubt : Doubt
        Why.
    there : ndarray of bool, shape (frames of the run,)
        Its measured samples: only these can be set aside.
    """
    free = there.copy()
    for known in overlapping(doubts, run):
        free[max(0, known.start - run.start) : max(0, known.stop - run.start)] = False
    parts = [Gap(run.marker, run.start + a, run.start + b) for a, b in runs(free)]
    return Change({}, dict.fromkeys(parts, doubt))


def believed(doubts: Doubts, run: Gap) -> Change:
    """Return how doubts change where the samples of a run are believed again."""
    gone = {known: doubts[known] for known in overlapping(doubts, run)}
    come = {}
    for known, doubt in gone.items():
        for part in (
            Gap(known.marker, known.start, min(known.stop, run.start)),
            Gap(known.marker, max(known.start, run.stop), known.stop),
        ):
            if part.length > 0:
                come[part] = doubt
    return Change(gone, come)


def overlapping(some: Iterable[Gap], run: Gap) -> Iterator[Gap]:
    """Yield those of some runs that have samples in common with a run."""
    return (one for one in some if one.marker == run.marker and overlap(one, run))
