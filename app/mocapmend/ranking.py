"""The gaps of a recording as a list of problems, the most harmful first. No Qt."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import IntEnum

from mocapmend.engine import fill_anyway
from mocapmend.prospects import Preview, Prospects, Way
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.progress import part

METHODS = ("auto", "local-frame", "pca-r2", "cubic")
"""Tried on every gap, one after another: quick ones of each kind that are often the best."""


class Status(IntEnum):
    """What has become of a gap, or of a run of bad samples."""

    OPEN = 0
    BEYOND = 1
    """Open, since no repair was within the limits."""
    LEFT = 2
    """Left open by the user."""
    REPAIRED = 3
    NEVER = 4
    """Never to be filled."""
    FOUND = 5
    """Bad samples, still there."""
    FIXED = 6
    """Bad samples that were set aside or exchanged."""
    DISMISSED = 7
    """No bad samples, as the user says."""


@dataclass(frozen=True)
class Problem:
    """A gap or a run of bad samples, what has become of it, and what it would cost.

    Attributes
    ----------
    gap : Gap
        Which; where the bad samples are.
    status : Status
        What has become of it.
    best : Preview or None
        The known repair with the least expected error; of a repaired gap the repair.
    reason : str
        Why it is left open.
    tried : bool
        Whether any repair was tried.
    bad : BadRun or None
        What is wrong there; None where it is a gap.
    """

    gap: Gap
    status: Status
    best: Preview | None = None
    reason: str = ""
    tried: bool = False
    bad: BadRun | None = None

    @property
    def error(self) -> float:
        """Expected 3-D RMS error in the recording's unit, or deviation; NaN where unknown."""
        if self.bad is not None:
            return self.bad.deviation
        return math.nan if self.best is None else self.best.expected_error

    @property
    def harm(self) -> float:
        """Expected error times frames; NaN where unknown."""
        return self.error * self.gap.length


def by_harm(problems: Iterable[Problem]) -> list[Problem]:
    """Return problems with the most harmful first, unknown ones last, and by time where equal."""

    def key(problem: Problem) -> tuple[bool, float, int, int]:
        unknown = math.isnan(problem.harm)
        return (
            unknown,
            0.0 if unknown else -problem.harm,
            problem.gap.start,
            problem.gap.marker,
        )

    return sorted(problems, key=key)


def rank(recording: Recording, gaps: Sequence[Gap], progress: Progress) -> list[Problem]:
    """Try the `METHODS` on gaps, and return these with the most harmful first.

    Parameters
    ----------
    recording : Recording
        The measured samples.
    gaps : sequence of Gap
        Open ones.
    progress : Progress
        Called often; may cancel.
    """
    prospects = Prospects()
    for number, name in enumerate(METHODS):
        way = Way.default(name)
        step = part(progress, number / len(METHODS), (number + 1) / len(METHODS))
        prospects.add(way, gaps, fill_anyway(recording, gaps, *way, step))
    found = [Problem(gap, Status.OPEN, prospects.best(gap), tried=True) for gap in gaps]
    return by_harm(found)
