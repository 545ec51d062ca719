"""What an edit writes: runs of samples, how they were repaired, why they stay missing. No Qt."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend.names import with_donors
from mocapmend.state import ABSENT, SampleState
from mocapmend.written import Places, places_of, shares_of
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.smooth.contract import SmoothResult

FILLED = np.uint8(SampleState.FILLED)


class Repair(NamedTuple):
    """How a gap was filled.

    Attributes
    ----------
    method : str
        Method id.
    params : object
        The method's parameter dataclass.
    patch : Patch
        What was put into the gap, with its expected error.
    donors : tuple of str
        Labels of the markers that it was computed from.
    base : int
        Tells from which state of the measured samples; see `Document.base_revision`.
    """

    method: str
    params: Any
    patch: Patch
    donors: tuple[str, ...] = ()
    base: int = 0

    def renamed(self, calls: Mapping[str, str]) -> "Repair":
        """Return it with its donors called as they are now."""
        donors = tuple(calls.get(label, label) for label in self.donors)
        params = with_donors(self.params, calls)
        if donors == self.donors and params is self.params:
            return self
        return self._replace(donors=donors, params=params)


class Smoothed(NamedTuple):
    """How a run was smoothed.

    Attributes
    ----------
    method : str
        Id of the smoothing method.
    params : mapping
        The method's parameters.
    chosen : mapping
        What it chose by itself.
    rms : float
        How far samples were moved, in the recording's unit.
    """

    method: str
    params: Mapping[str, Any]
    chosen: Mapping[str, Any]
    rms: float


@dataclass(frozen=True, eq=False)
class Edit:
    """What a run of one marker shall hold (or held): its samples, and why they may be missing.

    Attributes
    ----------
    gap : Gap
        The run.
    values : ndarray, shape (length, 3)
        Coordinates, NaN where missing.
    states : ndarray of uint8, shape (length,)
        `SampleState` values.
    repair : Repair or None
        Set when the run is the fill of a gap.
    reason : str or None
        Set when the run is a gap that the user keeps open: why. A gap that shall never be filled
        is kept so without one too.
    smoothed : Smoothed or None
        Set when the run is smoothed: what it has of repairs and reasons stays as it is.
    """

    gap: Gap
    values: NDArray[np.float64]
    states: NDArray[np.uint8]
    repair: Repair | None = None
    reason: str | None = None
    smoothed: Smoothed | None = None

    @classmethod
    def fill(
        cls,
        patch: Patch,
        method: str,
        params: object,
        donors: tuple[str, ...] = (),
        base: int = 0,
    ) -> "Edit":
        """Make the edit that puts a method's patch in its gap."""
        states = np.broadcast_to(FILLED, patch.gap.length)
        return cls(patch.gap, patch.values, states, Repair(method, params, patch, donors, base))

    @classmethod
    def fills(cls, result: FillResult, method: str, params: object, base: int = 0) -> list["Edit"]:
        """Make the edits that put all patches of a method's result in their gaps."""
        # A view for each: ten thousand arrays of their own take long.
        filled = np.full(max((p.gap.length for p in result.patches), default=0), FILLED)
        return [
            cls(
                patch.gap,
                patch.values,
                filled[: patch.gap.length],
                Repair(method, params, patch, result.donors(patch.gap), base),
            )
            for patch in result.patches
        ]

    @classmethod
    def smoothings(cls, result: SmoothResult, beneath: Callable[[Gap], "Edit"]) -> list["Edit"]:
        """Make the edits that put smoothed samples in their places.

        Parameters
        ----------
        result : SmoothResult
            What was smoothed.
        beneath : callable
            Returns what a run holds without smoothing; see `beneath.beneath`.
        """
        edits = []
        for done in result.runs:
            now = beneath(done.run)
            states = now.states.copy()
            states[states == SampleState.MEASURED] = SampleState.SMOOTHED
            made = Smoothed(result.method, result.params, done.chosen, done.rms)
            edits.append(cls(done.run, done.values, states, smoothed=made))
        return edits

    @classmethod
    def clear(
        cls, gap: Gap, state: SampleState = SampleState.MISSING, reason: str | None = None
    ) -> "Edit":
        """Make the edit that marks a run as missing, or as never to be filled, for a reason."""
        states = np.full(gap.length, state, np.uint8)
        return cls(gap, np.full((gap.length, 3), np.nan), states, reason=reason)


@dataclass(frozen=True, eq=False)
class Contents:
    """What many runs hold, in arrays: ten thousand edits one by one would be felt.

    Attributes
    ----------
    gaps : tuple of Gap
        The runs.
    places : Places
        Where their samples are, one run after another.
    values : ndarray, shape (samples, 3)
        Coordinates, NaN where missing.
    states : ndarray of uint8, shape (samples,)
        `SampleState` values.
    repairs : tuple of Repair or None
        How each run was filled.
    reasons : tuple of str or None
        Why each run is kept open.
    smoothed : tuple of Smoothed or None
        How each run was smoothed.
    """

    gaps: tuple[Gap, ...]
    places: Places
    values: NDArray[np.float64]
    states: NDArray[np.uint8]
    repairs: tuple[Repair | None, ...]
    reasons: tuple[str | None, ...]
    smoothed: tuple[Smoothed | None, ...]

    @classmethod
    def of(cls, edits: Sequence[Edit]) -> "Contents":
        """Gather what edits write."""
        gaps = tuple(edit.gap for edit in edits)
        return cls(
            gaps,
            places_of(gaps),
            np.concatenate([np.empty((0, 3)), *(edit.values for edit in edits)]),
            np.concatenate([np.empty(0, np.uint8), *(edit.states for edit in edits)]),
            tuple(edit.repair for edit in edits),
            tuple(edit.reason for edit in edits),
            tuple(edit.smoothed for edit in edits),
        )

    @property
    def absent(self) -> NDArray[np.bool_]:
        """Which samples are without coordinates, shape (samples,)."""
        return np.isin(self.states, ABSENT)

    def edits(self) -> Iterator[Edit]:
        """Yield the edits, one for each run."""
        known = zip(self.repairs, self.reasons, self.smoothed, strict=True)
        for gap, own, of_run in zip(self.gaps, shares_of(self.gaps), known, strict=True):
            yield Edit(gap, self.values[own], self.states[own], *of_run)
