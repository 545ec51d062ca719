"""Runs of bad samples in an open recording: found, put right, or no problem after all. No Qt."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from mocapmend.document import Document
from mocapmend.doubts import BY_HAND
from mocapmend.fixing import is_fixable
from mocapmend.ranking import Status
from mocapmend.relabelling import LEFT_OVER
from mocapmend.state import OPEN, SampleState
from mocapmend.unsure_labels import UNSURE, UnsureLabels
from mocapmend_algorithms import Gap
from mocapmend_algorithms.corrections import Exchange, Move
from mocapmend_algorithms.gaps import overlap
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.problems.registry import DETECTORS

LABELS = LEFT_OVER.problem
KINDS = (*DETECTORS, UNSURE, LABELS, BY_HAND)
"""Of bad runs: the ids of the detectors, labels to be looked at, what labelling and the user set
aside."""
BY_NAME = "fragments"
"""The kind that is found by the names of points."""
_Of = tuple[str, int, int | None]
"""Kind and markers."""
MOST_KEPT = 40
"""States of a recording of which it is remembered what was found: for undoing and redoing."""


class Suspect(NamedTuple):
    """A run of bad samples, and what has become of it: found, fixed or dismissed."""

    run: BadRun
    status: Status


class Suspects:
    """What is known of the bad samples of a document.

    What was found belongs to the samples that it was found in. After a correction, all of it that
    the correction has not touched is kept until it is looked for again.

    Parameters
    ----------
    document : Document
        The recording.

    Attributes
    ----------
    labels : UnsureLabels
        The labels that somebody should look at. They are listed beside the bad samples, and are
        none: neither drawn as such nor fixed with others.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self.labels = UnsureLabels(document)
        self._found: dict[int, Sequence[BadRun]] = {}
        """By the revision of the document's base, the latest last."""
        self._left: Sequence[BadRun] = ()
        """What is kept while a search is due."""
        self._dismissed: dict[_Of, list[BadRun]] = {}
        self._seen: dict[tuple[str, Gap], BadRun] = {}
        self._now = document.base_revision
        self._exchanged: tuple[int, list[BadRun]] | None = None

    @property
    def known(self) -> bool:
        """Whether bad samples were looked for since the last correction."""
        return self._document.base_revision in self._found

    @property
    def found(self) -> list[BadRun]:
        """What is still to be decided upon."""
        return [run for run in self._latest() if not self.is_dismissed(run)]

    @property
    def fixable(self) -> list[BadRun]:
        """What of it can be put right without asking what to do."""
        return [run for run in self.found if is_fixable(run)]

    @property
    def dismissed(self) -> list[BadRun]:
        """What the user holds for no problem."""
        return [run for run in self._latest() if self.is_dismissed(run)]

    def take(self, base_revision: int, found: Iterable[BadRun]) -> None:
        """Take note of what was found in a state of the document's base."""
        self._found[base_revision] = tuple(found)
        self._seen |= {(run.kind, place_of(run)): run for run in self._found[base_revision]}
        while len(self._found) > MOST_KEPT:
            del self._found[next(iter(self._found))]

    def keep_up(self, changed: Iterable[Gap]) -> bool:
        """Leave out what a correction has changed; say whether there was one.

        Parameters
        ----------
        changed : iterable of Gap
            Where samples have changed, as the document tells.
        """
        base = self._document.base_revision
        if base == self._now:
            return False
        kept = self._latest()
        self._now = base
        if not self.known:
            touched: dict[int, list[Gap]] = {}
            for run in changed:
                touched.setdefault(run.marker, []).append(run)
            self._left = [run for run in kept if not _meets(run, touched)]
        return True

    def doubt(self) -> None:
        """Keep what was found only until it is looked for again: names have changed.

        Which points are fragments or ghosts depends on names alone; of these nothing is kept.
        """
        self._left = [run for run in self._latest() if run.kind != BY_NAME]
        self._found.clear()

    def dismiss(self, run: BadRun) -> None:
        """Take note that a run is no problem."""
        self._dismissed.setdefault(_of(run), []).append(run)

    def take_up(self, run: BadRun) -> None:
        """Hold a dismissed run for a problem again."""
        alike = self._dismissed.get(_of(run), [])
        self._dismissed[_of(run)] = [other for other in alike if not overlap(run, other)]

    def is_dismissed(self, run: BadRun) -> bool:
        """Say whether a run is what the user holds for no problem."""
        # Ends may differ by what else was corrected between two searches.
        return any(overlap(run, other) for other in self._dismissed.get(_of(run), ()))

    def status(self, run: BadRun) -> Status | None:
        """Return what has become of a run; None where it is a problem no more."""
        if run.kind == UNSURE:
            return self.labels.status(run)
        if run in self._latest():
            return Status.DISMISSED if self.is_dismissed(run) else Status.FOUND
        return Status.FIXED if run in self.fixed() else None

    def is_open(self, run: BadRun) -> bool:
        """Say whether there is something to be decided about a run."""
        status = self.status(run)
        return status is not None and (run.kind == UNSURE or status is not Status.FIXED)

    def listed(self) -> list[Suspect]:
        """Return all of them: found, fixed and dismissed ones, in no order that means anything."""
        latest = self._latest()
        status = (Status.DISMISSED if self.is_dismissed(run) else Status.FOUND for run in latest)
        return [
            *map(Suspect, latest, status),
            *(Suspect(run, Status.FIXED) for run in self.fixed()),
            *(Suspect(run, status) for run, status in self.labels.listed()),
        ]

    def fixed(self) -> list[BadRun]:
        """Return what is set aside or exchanged now, in this session or before."""
        return [*self._set_aside(), *self._moved()]

    def _latest(self) -> Sequence[BadRun]:
        found = self._found.get(self._now)
        return self._left if found is None else found

    def _set_aside(self) -> Iterator[BadRun]:
        for run, doubt in self._document.doubts.items():
            known = self._seen.get((doubt.problem, run))
            yield known or BadRun(
                doubt.problem, *run, score=math.nan, deviation=math.nan, reason=doubt.reason
            )

    def _moved(self) -> list[BadRun]:
        base = self._document.base_revision
        if self._exchanged is None or self._exchanged[0] != base:
            self._exchanged = base, list(self._exchanges(self._document.layers.moves))
        return self._exchanged[1]

    def _exchanges(self, moves: Sequence[Move]) -> Iterator[BadRun]:
        every = set(moves)
        for move in moves:
            back = Move(move.origin, move.start, move.stop, move.marker)
            if back in every and move.origin < move.marker:
                continue
            yield self._seen_exchange(move) or BadRun(
                "swaps", *move.run, score=math.nan, deviation=math.nan, reason="", other=move.origin
            )

    def _seen_exchange(self, move: Move) -> BadRun | None:
        """Return what was found where samples have been exchanged since."""
        pair = {move.marker, move.origin}
        runs = (Gap(marker, move.start, move.stop) for marker in pair)
        known = (self._seen.get((kind, run)) for run in runs for kind in ("swaps", "fragments"))
        return next((run for run in known if run and {run.marker, run.other} == pair), None)


def gap_to_be(document: Document, run: BadRun) -> Gap | None:
    """Return the gap that bad samples are part of once they are set aside, or are already.

    None where they are to be exchanged or labelled, or are filled.
    """
    if run.kind == UNSURE or len(markers_of(run)) > 1:
        return None
    states = document.state[:, run.marker]
    is_open = np.isin(states, OPEN)
    inside = states[run.start : run.stop]
    if not (is_open[run.start : run.stop] | (inside == SampleState.MEASURED)).all():
        return None
    before = np.flatnonzero(~is_open[: run.start])
    after = np.flatnonzero(~is_open[run.stop :])
    start = int(before[-1]) + 1 if len(before) else 0
    stop = run.stop + int(after[0]) if len(after) else len(states)
    return Gap(run.marker, start, stop)


def by_marker(runs: Iterable[BadRun]) -> dict[int, list[BadRun]]:
    """Return the bad runs of each marker; what is exchanged is wrong in both."""
    found: dict[int, list[BadRun]] = {}
    for run in runs:
        for marker in markers_of(run):
            found.setdefault(marker, []).append(run)
    return found


def markers_of(run: BadRun) -> tuple[int, ...]:
    """Return the markers that a bad run is wrong in: both, where they are to be exchanged."""
    if run.other is None or DETECTORS[run.kind].remedy != "exchange":
        return (run.marker,)
    return run.marker, run.other


def exchange_of(run: BadRun) -> Exchange | None:
    """Return what puts a run right; None where it is not to be exchanged."""
    pair = markers_of(run)
    return Exchange(pair[0], pair[1], run.start, run.stop) if len(pair) > 1 else None


def place_of(run: BadRun) -> Gap:
    """Return where a bad run is."""
    return Gap(run.marker, run.start, run.stop)


def _of(run: BadRun) -> _Of:
    return run.kind, run.marker, run.other


def _meets(run: BadRun, touched: dict[int, list[Gap]]) -> bool:
    markers = (run.marker,) if run.other is None else (run.marker, run.other)
    return any(overlap(run, gap) for marker in markers for gap in touched.get(marker, ()))
