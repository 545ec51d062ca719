"""Filling gaps one by one: what is filled, what stays open and why, how far it is."""

from collections.abc import Callable, Sequence
from typing import Any

from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part

FillOne = Callable[[Gap, Progress], tuple[Patch, dict[str, Any]]]
"""Fills a gap and tells its diagnostics; raises `LeftOpenError` where it cannot."""


class LeftOpenError(ValueError):
    """A gap cannot be filled; the message says why, in words a user understands."""


def fill_each(gaps: Sequence[Gap], fill: FillOne, progress: Progress) -> FillResult:
    """Fill gaps one by one.

    Parameters
    ----------
    gaps : sequence of Gap
        The gaps to fill.
    fill : callable
        See `FillOne`; it gets a part of the progress.
    progress : Progress
        Called before each gap and at the end.

    Returns
    -------
    FillResult
    """
    patches: list[Patch] = []
    unfilled: list[Unfilled] = []
    notes: dict[Gap, dict[str, Any]] = {}
    for done, gap in enumerate(gaps):
        progress(done / len(gaps))
        try:
            patch, notes[gap] = fill(gap, part(progress, done / len(gaps), (done + 1) / len(gaps)))
            patches.append(patch)
        except LeftOpenError as error:
            unfilled.append(Unfilled(gap, str(error)))
    progress(1.0)
    return FillResult(tuple(patches), tuple(unfilled), notes)
