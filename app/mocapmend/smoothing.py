"""Smoothing as a user asks for it: of which markers, where, and what to know before. No Qt."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend import engine
from mocapmend.state import ABSENT
from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.smooth.contract import SmoothedRun, SmoothResult
from mocapmend_algorithms.smooth.registry import AMOUNTS
from mocapmend_algorithms.smooth.residual_curve import ResidualCurve, residual_curve

NOTHING_FOUND = 0.65
"""Share of half the frame rate from which a cut-off that was chosen takes next to nothing away."""


class SmoothWay(NamedTuple):
    """A smoothing method with its parameters."""

    method: str
    params: Any


class Outlook(NamedTuple):
    """What smoothing would do.

    Attributes
    ----------
    result : SmoothResult
        The samples.
    curve : ResidualCurve or None
        Of the marker that is looked at, where its residual chooses the cut-off.
    """

    result: SmoothResult
    curve: ResidualCurve | None


def runs_of(
    states: NDArray[np.uint8], markers: Iterable[int], span: tuple[int, int] | None
) -> list[Gap]:
    """Return what is to be smoothed: a run of each marker that is there in the time.

    Parameters
    ----------
    states : ndarray of uint8, shape (frames, markers)
        `SampleState` values.
    markers : iterable of int
        Which markers.
    span : (int, int), optional
        First frame, and the one after the last; all of them by default.
    """
    start, stop = (0, len(states)) if span is None else span
    return [
        Gap(marker, start, stop)
        for marker in sorted(markers)
        if not np.isin(states[start:stop, marker], ABSENT).all()
    ]


def look_ahead(
    recording: Recording, runs: Sequence[Gap], way: SmoothWay, shown: int | None, progress: Progress
) -> Outlook:
    """Smooth runs to be looked at.

    Parameters
    ----------
    recording : Recording
        What lies beneath the smoothing.
    runs : sequence of Gap
        What is smoothed.
    way : SmoothWay
        How.
    shown : int, optional
        The marker whose residual is looked at.
    progress : Progress
        Called often; may cancel.

    Raises
    ------
    MocapmendError
        If the parameters do not fit the recording.
    """
    result = engine.smooth(recording, runs, *way, progress)
    run = next((run for run in runs if run.marker == shown), None)
    if way.method != "butterworth" or run is None:
        return Outlook(result, None)
    return Outlook(result, residual_curve(recording, run, way.params.order))


def found_nothing(done: SmoothedRun, params: Any, rate: float) -> bool:
    """Say whether a method, left to choose how much to smooth, has found nothing in a run."""
    if any(getattr(params, name, None) is not None for name in AMOUNTS):
        return False
    windows = done.chosen.get("window_frames")
    if windows is not None:
        # A window of so few frames that the next shorter one would change nothing at all.
        return bool(max(windows) < params.order + 4)
    cutoffs = done.chosen.get("cutoff_hz", ())
    return bool(cutoffs) and min(cutoffs) >= NOTHING_FOUND * rate / 2
