"""All files of a batch together, and which of them need attention first."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from mocapmend.batch.results import Figures, Row

ORDER = ("failed", "waiting", "repaired", "unchanged", "nothing")


@dataclass(frozen=True, kw_only=True)
class Totals:
    """Sums over the files of a batch.

    Attributes
    ----------
    files, repaired, unchanged, nothing, failed, waiting : int
        All files, and those in each state.
    frames : int
        Of the repaired ones, like all that follows.
    gaps, filled, left_open : int
        Gaps that were open, filled, and that stayed open.
    samples_missing, samples_filled : int
        Samples that were missing, and that were filled.
    samples_fixed : int
        Bad samples that were put right.
    files_smoothed : int
        Files in which something was smoothed.
    tracked_before, wrong_before, tracked_after : float or None
        Mean tracking success, and share of the markers that were there but wrong, in %, each file
        weighted by its frames; None without any.
    seconds : float
        What the files took one by one; those of earlier runs count.
    """

    files: int
    repaired: int
    unchanged: int
    nothing: int
    failed: int
    waiting: int
    frames: int
    gaps: int
    filled: int
    left_open: int
    samples_missing: int
    samples_filled: int
    samples_fixed: int
    files_smoothed: int
    tracked_before: float | None
    wrong_before: float | None
    tracked_after: float | None
    seconds: float

    @classmethod
    def of(cls, rows: Sequence[Row]) -> "Totals":
        """Add up the rows of a batch."""
        known = [row.figures for row in rows if row.figures is not None]
        states = Counter(row.state for row in rows)
        return cls(
            files=len(rows),
            repaired=states["repaired"],
            unchanged=states["unchanged"],
            nothing=states["nothing"],
            failed=states["failed"],
            waiting=states["waiting"],
            frames=sum(figures.frames for figures in known),
            gaps=sum(figures.gaps for figures in known),
            filled=sum(figures.filled for figures in known),
            left_open=sum(figures.left_open for figures in known),
            samples_missing=sum(figures.samples_missing for figures in known),
            samples_filled=sum(figures.samples_filled for figures in known),
            samples_fixed=sum(figures.samples_fixed for figures in known),
            files_smoothed=sum(bool(each.smoothed and each.smoothed.markers) for each in known),
            tracked_before=_weighted((each.tracked_before, each.frames) for each in known),
            wrong_before=_weighted((each.wrong_before, each.frames) for each in known),
            tracked_after=_weighted((each.tracked_after, each.frames) for each in known),
            seconds=math.fsum(row.seconds for row in rows),
        )

    @property
    def done(self) -> int:
        """Files that are repaired, now or earlier."""
        return self.repaired + self.unchanged


def by_need(rows: Iterable[Row]) -> list[Row]:
    """Order files so that those which need attention come first.

    These are the ones that failed, then those that are not done, then those with most samples left
    open, then those with the largest expected error.
    """
    return sorted(rows, key=lambda row: (*_need(row), row.file))


def _need(row: Row) -> tuple[int, float, float]:
    figures = row.figures
    if figures is None:
        return ORDER.index(row.state), 0.0, 0.0
    return 2, -float(figures.samples_left), -_worst(figures)


def _worst(figures: Figures) -> float:
    """Return the largest expected error; one that is not known is as bad as any."""
    if figures.no_estimate:
        return math.inf
    return figures.expected_worst_mm or 0.0


def _weighted(values: Iterable[tuple[float | None, int]]) -> float | None:
    known = [(value, weight) for value, weight in values if value is not None]
    weights = sum(weight for _, weight in known)
    return math.fsum(value * weight for value, weight in known) / weights if weights else None
