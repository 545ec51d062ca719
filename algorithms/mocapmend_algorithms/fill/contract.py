"""What every gap-filling method takes and returns."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True, eq=False)
class Patch:
    """The filled samples of one gap.

    Attributes
    ----------
    gap : Gap
        The gap that they fill completely.
    values : ndarray, shape (length, 3)
        Coordinates in the recording's unit, finite.
    sigma : ndarray, shape (length,)
        Expected standard deviation per axis in the recording's unit; NaN where unknown.
    r90 : ndarray, shape (length,)
        Radius around the value that should hold the true position with probability 0.9, in the
        recording's unit; NaN where unknown.
    """

    gap: Gap
    values: NDArray[np.float64]
    sigma: NDArray[np.float64]
    r90: NDArray[np.float64]

    @cached_property
    def expected_error(self) -> float:
        """Expected 3-D RMS error over the gap in the recording's unit; NaN where unknown."""
        return float(np.sqrt(3.0 * np.mean(self.sigma**2)))

    @cached_property
    def typical_r90(self) -> float:
        """Median of `r90` where it is known; NaN where it is not."""
        known = np.sort(self.r90[~np.isnan(self.r90)])
        if not known.size:
            return float("nan")
        # What numpy's median gives, in a fifth of the time: there may be ten thousand patches.
        return float((known[(known.size - 1) // 2] + known[known.size // 2]) / 2.0)

    @classmethod
    def stated(
        cls, gap: Gap, values: NDArray[np.float64], expected_error: float, typical_r90: float
    ) -> "Patch":
        """Make a patch of which only the error over the whole gap is known."""
        sigma = np.full(gap.length, expected_error / np.sqrt(3.0))
        return cls(gap, values, sigma, np.full(gap.length, typical_r90))


@dataclass(frozen=True)
class Unfilled:
    """A gap that was left open, and why, in words a user understands."""

    gap: Gap
    reason: str


@dataclass(frozen=True, eq=False)
class FillResult:
    """What a method did with the gaps that it was given, in their order.

    Attributes
    ----------
    patches : tuple of Patch
        One per filled gap.
    unfilled : tuple of Unfilled
        One per gap left open.
    notes : dict
        Diagnostics of the method per gap (donors, estimated parameters, number of self-tests, ...).
    """

    patches: tuple[Patch, ...]
    unfilled: tuple[Unfilled, ...] = ()
    notes: dict[Gap, dict[str, Any]] = field(default_factory=dict)

    def donors(self, gap: Gap) -> tuple[str, ...]:
        """Return the labels of the markers that a gap was filled from, in the order of use."""
        return tuple(self.notes.get(gap, {}).get("donors", ()))


class FillFunction(Protocol):
    """A pure function that fills gaps: same input, same bytes; the input is never changed."""

    def __call__(
        self, recording: Recording, gaps: Sequence[Gap], params: Any, progress: Progress, /
    ) -> FillResult:
        """Fill the given gaps of a recording and nothing else."""
