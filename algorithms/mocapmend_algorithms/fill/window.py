"""Common ground of the methods that look at one marker and a few samples on both sides of a gap.

Such a method is a function of a *window*: the nearest observed samples before and after the gap.
Its cost is linear in the gaps, and edits far away change nothing. How far it goes wrong is
measured by self-tests: see `selftest`.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.selftest import (
    Calibration,
    TrialFinder,
    Trials,
    calibrate,
    turn,
)
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

LEAST_REACH = 4
"""Samples per side that every window holds: the self-tests see the velocity from them."""

Edges = Literal["leave", "hold"]
"""What happens to gaps at the beginning and the end of a recording."""


def edges_option() -> Any:
    """Make the parameter `edges`, of type `Edges`, of a method that has no model for an edge."""
    return option(
        "leave",
        label="Start and end",
        text="What to do with a gap at the start or the end of the recording: leave it open, or "
        "hold the nearest sample over all of it.",
    )


class Solve(Protocol):
    """Fills a window for many columns at once."""

    def __call__(self, knots: IntArray, values: FloatArray, length: int, /) -> FloatArray:
        """Return the values at the missing frames.

        Parameters
        ----------
        knots : ndarray of int, shape (knots,)
            Frames of the observed samples, ascending, counted from the first missing frame.
        values : ndarray, shape (knots, columns)
            What was observed there.
        length : int
            Number of missing frames.

        Returns
        -------
        ndarray, shape (length, columns)
        """


@dataclass(frozen=True)
class Candidate:
    """One setting of a method; where there are several, the self-tests choose.

    Attributes
    ----------
    solve : Solve
        The fill.
    shape : callable, optional
        The method's own standard deviation along the gap, up to a factor:
        (knots, length) -> (length,). Without it the self-tests measure that too.
    notes : dict
        The setting, for the diagnostics.
    """

    solve: Solve
    shape: Callable[[IntArray, int], FloatArray] | None = None
    notes: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class WindowMethod:
    """What the windows of a method look like.

    Attributes
    ----------
    candidates : callable
        The settings to choose from, given a marker's observed trajectory, shape (frames, 3), NaN
        where missing; the first is taken where nothing can be tested.
    name : str
        What to call the fill in a reason, as "a cubic curve".
    reach : int
        How many observed samples it looks at on each side.
    least, least_before : int
        How many samples it needs in all and before the gap.
    edge : Candidate, optional
        What fills a gap at the beginning or the end of the recording, from the samples of one
        side; without it such gaps stay open.
    """

    candidates: Callable[[FloatArray], Sequence[Candidate]]
    name: str
    reach: int = LEAST_REACH
    least: int = 2
    least_before: int = 1
    edge: Candidate | None = None

    @classmethod
    def single(
        cls, solve: Solve, name: str, edges: Edges, *, reach: int = LEAST_REACH, least: int = 2
    ) -> "WindowMethod":
        """Make a method that has nothing to choose."""
        candidates = (Candidate(solve),)
        return cls(
            lambda points: candidates, name, reach=reach, least=least, edge=edge_candidate(edges)
        )


def edge_candidate(edges: Edges) -> Candidate | None:
    """Return what fills a gap at the beginning or the end of a recording, as the user chose."""
    return Candidate(_hold) if edges == "hold" else None


def _hold(knots: IntArray, values: FloatArray, length: int) -> FloatArray:
    """Hold the nearest sample of the only side that has any."""
    nearest = -1 if knots[0] < 0 else 0
    return np.repeat(values[[nearest]], length, axis=0)


def fill_windows(
    recording: Recording, gaps: Sequence[Gap], method: WindowMethod, progress: Progress
) -> FillResult:
    """Fill gaps one by one from their windows.

    Parameters
    ----------
    recording : Recording
        Not changed. Samples inside the given gaps are never looked at.
    gaps : sequence of Gap
        The gaps to fill; those without observed samples on both sides stay open, unless the
        method has something for the edges.
    method : WindowMethod
        The window and the function to apply.
    progress : Progress
        Called before each gap and at the end.

    Returns
    -------
    FillResult
        With `self_tests`, `tested_on` and the chosen setting per gap in the notes.
    """
    return fill_each(gaps, Windows(recording, gaps, method).fill, progress)


@dataclass(frozen=True, eq=False)
class _Choice:
    """The setting for a pattern and what the self-tests say about it."""

    candidate: Candidate
    calibration: Calibration | None
    notes: dict[str, Any]


class Windows:
    """Windows of one recording, and what was learned from its self-tests.

    Parameters
    ----------
    recording, gaps, method
        As in `fill_windows`.
    """

    def __init__(self, recording: Recording, gaps: Sequence[Gap], method: WindowMethod) -> None:
        self._recording = recording
        self._method = method
        self._observed = seen_outside(recording.present, gaps)
        self._finder = TrialFinder(self._observed)
        self._frames: dict[int, IntArray] = {}
        self._candidates: dict[int, Sequence[Candidate]] = {}
        self._choices: dict[tuple[int, int, bytes], _Choice] = {}

    def _knots(self, gap: Gap) -> IntArray:
        """Return the nearest observed frames on both sides, counted from the gap's start."""
        if gap.marker not in self._frames:
            self._frames[gap.marker] = np.flatnonzero(self._observed[:, gap.marker])
        frames = self._frames[gap.marker]
        middle = int(np.searchsorted(frames, gap.start))
        reach = self._method.reach
        return frames[max(middle - reach, 0) : middle + reach] - gap.start

    def _obstacle(self, gap: Gap, knots: IntArray) -> str:
        """Say why a gap cannot be filled; empty where it can."""
        before = int(np.count_nonzero(knots < 0))
        if not knots.size:
            return "the marker is never seen in this recording"
        if _one_sided(knots):
            if self._method.edge is not None:
                return ""
            seen = int(knots[-1] if before else knots[0]) + gap.start + self._recording.first_frame
            side = "after" if before else "before"
            return f"the marker is never seen {side} frame {seen}: this method needs both sides"
        name = self._method.name
        if knots.size < self._method.least:
            return (
                f"{name} needs {self._method.least} samples, and the marker has only {knots.size}"
            )
        if before < self._method.least_before:
            return (
                f"{name} needs {self._method.least_before} samples before the gap, "
                f"and the marker has only {before}"
            )
        return ""

    def fill(self, gap: Gap, _: Progress) -> tuple[Patch, dict[str, Any]]:
        """Fill a gap and say how sure that is.

        Raises
        ------
        LeftOpenError
            If the method cannot fill it.
        """
        knots = self._knots(gap)
        if reason := self._obstacle(gap, knots):
            raise LeftOpenError(reason)
        key = (gap.marker, gap.length, knots.tobytes())
        if key not in self._choices:
            self._choices[key] = self._choose(gap, knots)
        choice = self._choices[key]
        observed = self._recording.points[gap.start + knots, gap.marker]
        values = choice.candidate.solve(knots, observed, gap.length)
        if choice.calibration is None:
            unknown = np.full(gap.length, np.nan)
            return Patch(gap, values, unknown, unknown), dict(choice.notes)
        scale = choice.calibration.scale(turn(knots, observed[:, None], gap.length)[0])
        sigma, r90 = scale * choice.calibration.sigma, scale * choice.calibration.r90
        return Patch(gap, values, sigma, r90), dict(choice.notes)

    def _choose(self, gap: Gap, knots: IntArray) -> _Choice:
        candidates = self._candidates_for(gap.marker, knots)
        trials = self._finder.find(gap.marker, knots, gap.length)
        if trials is None:
            notes = {"self_tests": 0, "tested_on": "nothing", **candidates[0].notes}
            return _Choice(candidates[0], None, notes)
        tested = [(self._test(c, trials, knots, gap.length), c) for c in candidates]
        calibration, best = min(tested, key=lambda pair: pair[0].error)
        notes = {
            "self_tests": trials.frames.size,
            "tested_on": "this marker" if trials.own else "all markers",
            **best.notes,
        }
        return _Choice(best, calibration, notes)

    def _candidates_for(self, marker: int, knots: IntArray) -> Sequence[Candidate]:
        if self._method.edge is not None and _one_sided(knots):
            return (self._method.edge,)
        if marker not in self._candidates:
            observed = self._observed[:, marker, None]
            points = np.where(observed, self._recording.points[:, marker], np.nan)
            self._candidates[marker] = self._method.candidates(points)
        return self._candidates[marker]

    def _test(
        self, candidate: Candidate, trials: Trials, knots: IntArray, length: int
    ) -> Calibration:
        points = self._recording.points
        observed = points[trials.frames + knots[:, None], trials.markers]
        columns = observed.reshape(knots.size, -1)
        filled = candidate.solve(knots, columns, length).reshape(length, -1, 3)
        truth = points[trials.frames + np.arange(length)[:, None], trials.markers]
        errors = np.linalg.norm(filled - truth, axis=2).T
        shape = candidate.shape(knots, length) if candidate.shape else None
        return calibrate(errors, turn(knots, observed, length), trials.disjoint, shape)


def _one_sided(knots: IntArray) -> bool:
    return bool(knots[-1] < 0 or knots[0] >= 0)
