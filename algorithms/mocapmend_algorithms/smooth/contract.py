"""What every smoothing method takes and returns."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

Run = Gap
"""A stretch of a marker in which samples may change: frames start to stop - 1, from 0."""


@dataclass(frozen=True, eq=False)
class SmoothedRun:
    """The samples of one run after smoothing.

    Attributes
    ----------
    run : Run
        The stretch.
    values : ndarray, shape (length, 3)
        Coordinates in the recording's unit; NaN where a sample is missing, and as they were where
        a piece of the run was left alone.
    before : ndarray, shape (length, 3)
        What they were.
    step : float
        The largest shift of a sample beside one outside the run, which keeps its place: what
        smoothing adds to the step from frame to frame there, in the recording's unit; 0 where the
        run joins no sample.
    chosen : dict
        What the method chose, for a record: numbers, text, and lists of them. Lists have an
        entry per axis; "cutoff_hz" is in Hz, "noise" in the recording's unit.
    """

    run: Run
    values: FloatArray
    before: FloatArray
    step: float = 0.0
    chosen: dict[str, Any] = field(default_factory=dict)

    @cached_property
    def shifts(self) -> FloatArray:
        """How far each sample is moved in the recording's unit, shape (length,); NaN: missing."""
        return np.asarray(np.linalg.norm(self.values - self.before, axis=1), dtype=np.float64)

    @property
    def rms(self) -> float:
        """Root mean square of the shifts of the samples that are there."""
        return float(np.sqrt(np.nanmean(self.shifts**2)))

    @property
    def largest(self) -> float:
        """The largest shift."""
        return float(np.nanmax(self.shifts))


@dataclass(frozen=True)
class Untouched:
    """A stretch of a run that was left as it is, and why, in words a user understands."""

    stretch: Run
    reason: str


@dataclass(frozen=True, eq=False)
class SmoothResult:
    """What a method did with the runs that it was given, in their order.

    Attributes
    ----------
    method : str
        Id of the method.
    params : dict
        Its parameters as `dataclasses.asdict` has them; what it chose for each run is there.
    runs : tuple of SmoothedRun
        One per run of which at least a piece was smoothed.
    untouched : tuple of Untouched
        The pieces that were not, and runs without samples.
    """

    method: str
    params: dict[str, Any]
    runs: tuple[SmoothedRun, ...]
    untouched: tuple[Untouched, ...] = ()

    def applied(self, recording: Recording) -> Recording:
        """Return the recording with the smoothed samples in place of its own."""
        points = recording.points.copy()
        for done in self.runs:
            points[done.run.start : done.run.stop, done.run.marker] = done.values
        return recording.with_points(points)


class SmoothFunction(Protocol):
    """A pure function that smooths runs: same input, same bytes; the input is never changed."""

    def __call__(
        self, recording: Recording, runs: Sequence[Run], params: Any, progress: Progress, /
    ) -> SmoothResult:
        """Smooth the given runs of what is shown, measured or filled, and nothing else.

        Raises
        ------
        ValueError
            With one sentence, if the parameters are impossible for this recording, or the runs are
            outside it or overlap.
        """
