"""One method on one case: what it filled, how wrong that is, and what it took."""

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from mocapmend import engine
from mocapmend.bench.gaps.cases import Case
from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import Recording, find_gaps, no_progress
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.limits import Limits

NO_LIMITS = Limits(max_error_mm=math.inf)
UNLABELLED = "*"


@dataclass(frozen=True, eq=False)
class Trial:
    """A method on a case.

    Attributes
    ----------
    case : Case
        The case.
    method : str
        Id of the method.
    samples : int
        Punched samples of which the truth is known.
    errors : ndarray, shape (filled,)
        3-D distance to the truth in mm, of those that were filled.
    r90 : ndarray, shape (filled,)
        Their stated 90 % radius in mm; NaN where none was stated.
    seconds : float
        CPU time of the fill.
    """

    case: Case
    method: str
    samples: int
    errors: FloatArray
    r90: FloatArray
    seconds: float

    @property
    def left_open(self) -> int:
        """Samples that were not filled."""
        return self.samples - len(self.errors)

    @property
    def complete(self) -> bool:
        """Whether every sample was filled."""
        return self.samples > 0 and self.left_open == 0

    @property
    def rmse(self) -> float:
        """Root mean square of the errors in mm; NaN if nothing was filled."""
        return float(np.sqrt(np.mean(self.errors**2))) if len(self.errors) else math.nan


def load(case: Case, data: Path) -> Recording:
    """Read the recording of a case, without the markers that are not labelled.

    Raises
    ------
    MocapmendError
        If it cannot be read, or is another one than the case is about.
    """
    recording = _read(data / case.file)
    if (recording.frames, recording.markers) != (case.frames, case.markers):
        raise MocapmendError(
            f"The recording has {recording.frames} frames and {recording.markers} markers, but the "
            f"case {case.name} is about {case.frames} and {case.markers}.",
            str(data / case.file),
            "Give the folder of the recordings with --data DIR.",
        )
    return recording


def run_case(case: Case, data: Path, methods: Sequence[str]) -> list[Trial]:
    """Try methods on a case, one after the other."""
    recording = load(case, data)
    return [attempt(case, recording, method) for method in methods]


def attempt(case: Case, recording: Recording, method: str) -> Trial:
    """Punch the gaps of a case, fill them with a method and compare.

    The recording's own gaps are filled as well, as `repair` would; they count in nothing but the
    time.
    """
    points = recording.points.copy()
    punched = np.zeros(recording.present.shape, bool)
    for gap in case.gaps:
        punched[gap.start : gap.stop, gap.marker] = True
    points[punched] = np.nan
    result, seconds = timed_fill(recording.with_points(points), method)
    filled = engine.repaired(recording.with_points(points), result).points
    radius = np.full(punched.shape, np.nan)
    for patch in result.patches:
        radius[patch.gap.start : patch.gap.stop, patch.gap.marker] = patch.r90
    judged = punched & recording.present
    errors = np.linalg.norm(filled[judged] - recording.points[judged], axis=1)
    done = ~np.isnan(errors)
    millimetres = recording.mm
    return Trial(
        case,
        method,
        int(judged.sum()),
        errors[done] * millimetres,
        radius[judged][done] * millimetres,
        seconds,
    )


def timed_fill(recording: Recording, method: str) -> tuple[FillResult, float]:
    """Fill all gaps of a recording as `repair --max-error inf` would; return the CPU time too."""
    gaps = find_gaps(recording.present)
    params = registry.method(method).params()
    start = time.process_time()
    result = engine.fill(recording, gaps, method, params, NO_LIMITS, no_progress)
    return result, time.process_time() - start


def warm_up(methods: Sequence[str]) -> None:
    """Let the methods load what they load late: no case shall pay for that."""
    t = np.linspace(0.0, 6.0, 120)[:, None, None]
    order = np.arange(6)[None, :, None]
    points = 100.0 * np.sin(t + order + np.arange(3)) + 300.0 * order
    points[50:55, 2] = np.nan
    recording = Recording(points, tuple("ABCDEF"), 60.0)
    for method in methods:
        timed_fill(recording, method)


@lru_cache(maxsize=4)
def _read(path: Path) -> Recording:
    recording = read_recording(path).measured
    named = [k for k, label in enumerate(recording.labels) if not label.startswith(UNLABELLED)]
    labels = tuple(recording.labels[k] for k in named)
    return replace(recording, points=recording.points[:, named], labels=labels)
