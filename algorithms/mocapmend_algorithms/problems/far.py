"""Points far from the body."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun, frames_in_words
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

CHUNK = 2048
LEAST_MARKERS = 4
OWN_SHARE = 0.5
"""Of the distance, what is usual for the marker: a ball or a wand may be far from the body."""


@dataclass(frozen=True)
class FarParams:
    """Parameters of `far`."""

    least_mm: float = option(
        1000.0,
        label="Smallest distance",
        text="Points nearer to the middle of the body are left alone.",
        minimum=0.0,
        unit="mm",
    )
    times_size: float = option(
        3.0,
        label="Times the size of the body",
        text="How far from the middle of the body a point is, against most of its markers.",
        minimum=1.0,
    )


def far(
    recording: Recording, skeleton: Skeleton, params: FarParams, progress: Progress
) -> list[BadRun]:
    """Find points far from the body, further than the marker usually is.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Not used.
    params : FarParams
        The thresholds.
    progress : Progress
        Called often.

    Returns
    -------
    list of BadRun
        Ordered by marker and start; none where fewer than four markers are seen.
    """
    del skeleton
    if recording.markers < LEAST_MARKERS:
        return []
    radius = _radius(recording, progress)
    seen = ~np.isnan(radius)
    ordered = np.sort(radius, axis=1)
    count = seen.sum(axis=1)
    most = np.take_along_axis(ordered, np.maximum(3 * count // 4 - 1, 0)[:, None], axis=1)
    found = []
    for marker in np.flatnonzero(seen.any(axis=0)).tolist():
        own = radius[:, marker]
        with np.errstate(invalid="ignore"):
            wrong = (own > params.least_mm) & (own > params.times_size * most[:, 0])
            wrong &= own * OWN_SHARE > np.median(own[seen[:, marker]])
        wrong &= count >= LEAST_MARKERS
        for start, stop in runs(wrong):
            found.append(_described(recording, marker, start, stop, own, most[:, 0]))
    progress(1.0)
    return found


def _radius(recording: Recording, progress: Progress) -> FloatArray:
    """Return the distance of every sample from the middle of its frame in mm."""
    radius = np.full(recording.present.shape, np.nan)
    for start in range(0, recording.frames, CHUNK):
        progress(start / recording.frames)
        some = recording.points[start : start + CHUNK] * recording.mm
        ordered = np.sort(some, axis=1)
        count = recording.present[start : start + CHUNK].sum(axis=1)
        at = np.maximum(count - 1, 0)[:, None, None] // 2
        middle = np.take_along_axis(ordered, at, axis=1)
        apart = some - middle
        radius[start : start + CHUNK] = np.sqrt(np.einsum("tmk,tmk->tm", apart, apart))
    return radius


def _described(
    recording: Recording, marker: int, start: int, stop: int, own: FloatArray, most: FloatArray
) -> BadRun:
    away, size = float(np.median(own[start:stop])), float(np.median(most[start:stop]))
    usual = float(np.median(own[~np.isnan(own)]))
    times = away / max(size, 1.0)
    frames = frames_in_words(stop - start)
    return BadRun(
        kind="far",
        marker=marker,
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-times / 6.0)),
        deviation=(away - usual) / recording.mm,
        reason=f"For {frames} it is {away:.0f} mm from the middle of the body, where it is "
        f"{usual:.0f} mm otherwise.",
    )
