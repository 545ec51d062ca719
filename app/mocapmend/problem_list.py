"""The problems of a document in arrays: ten thousand are filtered and put in order at once."""

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.document import Document
from mocapmend.edits import Repair
from mocapmend.prospects import Preview, Prospects
from mocapmend.ranking import Problem, Status
from mocapmend.suspects import KINDS, Suspects, place_of
from mocapmend_algorithms import Gap
from mocapmend_algorithms.problems import BadRun

Places = NDArray[np.intp]
GAP = "gap"
ALL_KINDS = (GAP, *KINDS)
"""What a problem is: a gap, or one of the kinds of bad runs."""
_NUMBER_OF = {kind: number for number, kind in enumerate(ALL_KINDS)}


class ProblemList:
    """All gaps and bad runs of a document that are or were problems; each has a place in the list.

    Parameters
    ----------
    document : Document
        Whose gaps.
    prospects : Prospects
        What is known of the gaps.
    suspects : Suspects
        What is known of bad runs.

    Attributes
    ----------
    gaps : list of Gap
        Where the problems are, gaps first; in no order that means anything.
    marker, other, start, length, status, kind : ndarray of int, shape (problems,)
        Of the problems; `other` is the marker itself where there is no second one, and `kind` is a
        place in `ALL_KINDS`.
    error : ndarray, shape (problems,)
        Expected error of the best repair, or of the one that was made, or the deviation of bad
        samples; NaN where unknown.
    tried : ndarray of bool, shape (problems,)
        Whether any repair was tried.
    """

    def __init__(self, document: Document, prospects: Prospects, suspects: Suspects) -> None:
        self._document = document
        self._prospects = prospects
        self._suspects = suspects
        self.take()

    def take(self) -> None:
        """List the problems anew: edits have changed them, or what has become of them."""
        document, open_gaps = self._document, self._document.fillable
        # A copy: it is asked for until the list is taken anew.
        self._repairs = repairs = dict(document.repairs)
        never = document.never
        self._open = len(open_gaps)
        self.gaps = [*open_gaps, *repairs, *never]
        others = [(gap.marker, gap.start, gap.stop) for gap in self.gaps[self._open :]]
        corners = np.array(others, np.int64).reshape(-1, 3)
        self.marker, self.start, stop = np.concatenate((document.fillable_corners, corners)).T
        self.length = stop - self.start
        kinds, counts = (
            (Status.OPEN, Status.REPAIRED, Status.NEVER),
            (self._open, len(repairs), len(never)),
        )
        self.status = np.repeat(np.array(kinds, np.intp), counts)
        left, aside = document.left_open, document.set_aside
        if left or aside:
            of_open = self.status[: self._open]
            of_open[[gap in left for gap in open_gaps]] = Status.BEYOND
            of_open[[gap in aside for gap in open_gaps]] = Status.LEFT
        self.error = np.full(len(self.gaps), np.nan)
        self.error[self._open : self._open + len(repairs)] = [
            repair.patch.expected_error for repair in repairs.values()
        ]
        self.other = self.marker
        self.kind = np.zeros(len(self.gaps), np.intp)
        self._append_bad()
        self.tried = self.status >= Status.REPAIRED
        self.learn()

    def _append_bad(self) -> None:
        listed = self._suspects.listed()
        self._first_bad = len(self.gaps)
        self._bad = [run for run, _ in listed]
        if not listed:
            return
        table = np.array(
            [
                (
                    run.marker,
                    run.marker if run.other is None else run.other,
                    run.start,
                    run.length,
                    status,
                    _number_of(run.kind),
                )
                for run, status in listed
            ],
            np.int64,
        )
        self.gaps += map(place_of, self._bad)
        for name, values in zip(
            ("marker", "other", "start", "length", "status", "kind"), table.T, strict=True
        ):
            setattr(self, name, np.concatenate((getattr(self, name), values)))
        deviation = [run.deviation for run in self._bad]
        self.error = np.concatenate((self.error, np.array(deviation, np.float64)))

    def learn(self) -> None:
        """Take note of what is known of the open gaps by now."""
        errors = self._prospects.errors
        if not errors:
            return
        known = [errors.get(gap) for gap in self.gaps[: self._open]]
        self.tried[: self._open] = [error is not None for error in known]
        # None becomes NaN.
        self.error[: self._open] = np.array(known, dtype=np.float64)

    def place_of(self, gap: Gap) -> int | None:
        """Return the place of a gap."""
        return self._place(gap, GAP, slice(0, self._first_bad))

    def place_of_bad(self, run: BadRun) -> int | None:
        """Return the place of a bad run."""
        place = self._place(place_of(run), run.kind, slice(self._first_bad, None))
        return None if place is None else self._first_bad + place

    def _place(self, gap: Gap, kind: str, part: slice) -> int | None:
        same = (self.marker[part] == gap.marker) & (self.start[part] == gap.start)
        same &= (self.length[part] == gap.length) & (self.kind[part] == _number_of(kind))
        places = np.flatnonzero(same)
        return int(places[0]) if len(places) else None

    def bad(self, place: int) -> BadRun | None:
        """Return the bad run at a place; None where there is a gap."""
        return self._bad[place - self._first_bad] if place >= self._first_bad else None

    def problem(self, place: int) -> Problem:
        """Return what is at a place."""
        document, gap, status = self._document, self.gaps[place], Status(self.status[place])
        bad = self.bad(place)
        if bad is not None:
            return Problem(gap, status, reason=bad.reason, tried=True, bad=bad)
        if status is Status.NEVER:
            return Problem(gap, status, reason=document.never_reason(gap), tried=True)
        if status is Status.REPAIRED:
            return Problem(gap, status, _made(gap, self._repairs[gap]), tried=True)
        best, reason = self._prospects.best(gap), document.open_reason(gap) or ""
        return Problem(gap, status, best, reason, bool(self.tried[place]))

    def passing(
        self,
        markers: Collection[int],
        status: Collection[Status],
        shortest: float,
        longest: float,
        kinds: Collection[str] = ALL_KINDS,
    ) -> Places:
        """Return the places of some markers' problems: above one length, up to another.

        Parameters
        ----------
        markers, status : collections
            Which pass.
        shortest, longest : float
            In frames.
        kinds : collection of str
            Of `ALL_KINDS`, which pass.
        """
        of_status = np.zeros(len(Status), bool)
        of_status[list(status)] = True
        of_marker = np.zeros(self._document.original.markers, bool)
        of_marker[list(markers)] = True
        of_kind = np.zeros(len(ALL_KINDS), bool)
        of_kind[[_NUMBER_OF[kind] for kind in kinds]] = True
        passes = of_status[self.status] & of_kind[self.kind]
        passes &= of_marker[self.marker] | of_marker[self.other]
        passes &= (shortest < self.length) & (self.length <= longest)
        return np.flatnonzero(passes)

    def ordered(self, places: Places, value: NDArray[Any], *, falling: bool) -> Places:
        """Return places in the order of a value, unknown ones last, and of time where it is equal.

        Parameters
        ----------
        places : ndarray of int
            Some of the list.
        value : ndarray, shape (gaps,)
            What decides.
        falling : bool
            Whether the greatest comes first.
        """
        key = value[places].astype(np.float64)
        # NaN comes last either way.
        return places[
            np.lexsort((self.marker[places], self.start[places], -key if falling else key))
        ]


def _number_of(kind: str) -> int:
    # Files may name kinds of other versions.
    return _NUMBER_OF.get(kind, len(ALL_KINDS) - 1)


def _made(gap: Gap, repair: Repair) -> Preview:
    return Preview(gap, repair.method, repair.params, repair.patch, donors=repair.donors)
