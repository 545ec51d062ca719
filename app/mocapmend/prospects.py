"""What methods would make of the gaps: computed once and kept. No Qt.

A repair is computed from measured samples alone, so that no fill makes what is kept here stale: a
gap whose ends were moved is another gap. Where samples are exchanged or set aside, all of it is
forgotten.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled


@dataclass(frozen=True, eq=False)
class Preview:
    """A repair that is shown but not applied.

    Attributes
    ----------
    gap : Gap
        The gap that it is for.
    method : str
        Method id.
    params : object
        The method's parameter dataclass.
    patch : Patch or None
        The repair; None when the method leaves the gap open.
    reason : str
        Why the gap stays open; empty when it is filled.
    note : dict
        What the method says of itself, such as its number of self-tests.
    donors : tuple of str
        Labels of the markers that the repair was computed from.
    """

    gap: Gap
    method: str
    params: Any
    patch: Patch | None
    reason: str = ""
    note: Mapping[str, Any] = field(default_factory=dict)
    donors: tuple[str, ...] = ()

    @property
    def expected_error(self) -> float:
        """Expected 3-D RMS error in the recording's unit; NaN where unknown or left open."""
        return math.nan if self.patch is None else self.patch.expected_error

    @property
    def way(self) -> "Way":
        """The method with its parameters."""
        return Way(self.method, self.params)


class Way(NamedTuple):
    """A method with its parameters."""

    method: str
    params: Any

    @classmethod
    def default(cls, method: str) -> "Way":
        """Return a method with the parameters that it has by itself."""
        return cls(method, registry.method(method).params())


class Prospects:
    """Every preview that was computed for a document."""

    def __init__(self) -> None:
        self._known: dict[Way, dict[Gap, Preview]] = {}
        self._best: dict[Gap, Preview] = {}
        self._errors: dict[Gap, float] = {}

    def clear(self) -> None:
        """Forget all: the measured samples that are believed have changed."""
        self._known.clear()
        self._best.clear()
        self._errors.clear()

    @property
    def errors(self) -> Mapping[Gap, float]:
        """Of the gaps that were tried the least expected error; NaN where none is known."""
        return self._errors

    def known(self, way: Way) -> Mapping[Gap, Preview]:
        """Return what a way makes of the gaps that it was tried on."""
        return self._known.get(way, {})

    def get(self, gap: Gap, way: Way) -> Preview | None:
        """Return what a way makes of a gap, if that is known."""
        return self.known(way).get(gap)

    def best(self, gap: Gap) -> Preview | None:
        """Return the known repair of a gap with the least expected error; None without any."""
        return self._best.get(gap)

    def tried(self, gap: Gap) -> bool:
        """Say whether any way was tried on a gap."""
        return gap in self._errors

    def add(self, way: Way, gaps: Iterable[Gap], result: FillResult) -> None:
        """Keep what a way has made of gaps; what is known already stays the same object."""
        known = self._known.setdefault(way, {})
        for preview in previews(way, gaps, result):
            gap, error = preview.gap, preview.expected_error
            if gap in known:
                continue
            known[gap] = preview
            least = self._errors.setdefault(gap, math.nan)
            if not math.isnan(error) and not least <= error:
                self._best[gap] = preview
                self._errors[gap] = error

    def result(self, way: Way, gaps: Iterable[Gap]) -> tuple[FillResult, list[Gap]]:
        """Return what a way makes of gaps, as far as that is known, and the gaps where it is not.

        Returns
        -------
        result : FillResult
            In the order of the gaps.
        unknown : list of Gap
        """
        known: list[Preview] = []
        unknown: list[Gap] = []
        of_way = self.known(way)
        for gap in gaps:
            preview = of_way.get(gap)
            if preview is None:
                unknown.append(gap)
            else:
                known.append(preview)
        patches = tuple(preview.patch for preview in known if preview.patch is not None)
        unfilled = tuple(Unfilled(p.gap, p.reason) for p in known if p.patch is None)
        notes = {preview.gap: dict(preview.note) for preview in known}
        return FillResult(patches, unfilled, notes), unknown


def previews(way: Way, gaps: Iterable[Gap], result: FillResult) -> list[Preview]:
    """Return what a result says about each of the gaps."""
    patches = {patch.gap: patch for patch in result.patches}
    reasons = {entry.gap: entry.reason for entry in result.unfilled}
    return [
        Preview(
            gap,
            way.method,
            way.params,
            patches.get(gap),
            reason=reasons.get(gap, ""),
            note=result.notes.get(gap, {}),
            donors=result.donors(gap),
        )
        for gap in gaps
    ]
