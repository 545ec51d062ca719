"""Bringing a recording to the frames, unit and axes of another one of the same movement. No Qt."""

from collections.abc import Sequence
from typing import Literal

import numpy as np

from mocapmend_algorithms import Progress, Recording, no_progress
from mocapmend_algorithms.alignment import turns
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.refine.aligning import LEAST_SHARED, align_in_time, in_common
from mocapmend_algorithms.refine.preparing import RATE, RefineError, at_rate, bridge_gaps
from mocapmend_algorithms.sparse.training_set import turn_up

LEAST_COMMON = 3
"""Labels in common with which another recording is turned and shifted to fit."""
WELL_SEEN = 0.9
"""Share of the frames in which a marker must be there to have a say in that."""
LONGEST_FIT = 3600
"""Frames at 60 per second that have one: a minute says it all."""
LEAST_SAMPLES = 2
"""Of a marker, for a curve through them."""
SAME_FRAME = 1e-6

Way = Literal["origin", "fitted", "as it is"]


def bring(
    own: Recording, other: Recording, progress: Progress, *, origin: bool = False
) -> tuple[Recording, Way, float]:
    """Bring a recording to the frames, unit and axes of another one.

    Where at least three labels are common, the lag and the rotation that fit best are found as
    `align_in_time` does, and the shift that is left.

    Parameters
    ----------
    own : Recording
        Of the frames that are wanted.
    other : Recording
        Of any rate, unit and axes.
    progress : Progress
        Called often; may cancel.
    origin : bool
        Whether `own` was made from it: then it stays where it is.

    Returns
    -------
    Recording
        With the labels of the other one.
    str
        As `Companion.way`.
    float
        Lag in seconds.
    """
    points = other.points * (other.mm / own.mm) @ turn_up(other.up, own.up).T
    way: Way = "origin" if origin else "as it is"
    lag = 0.0
    fit = None if origin else _fit(own, other.labels, points, other.rate)
    if fit is not None:
        way, (rotation, shift, lag) = "fitted", fit
        points = points @ rotation + shift
    progress(0.5)
    times = np.arange(own.frames) / own.rate - lag
    found = Recording(
        _sampled(points, other.rate, times, part(progress, 0.5, 1.0)),
        other.labels,
        own.rate,
        unit=own.unit,
        up=own.up,
        first_frame=own.first_frame,
    )
    return found, way, lag


def _fit(
    own: Recording, labels: Sequence[str], points: FloatArray, rate: float
) -> tuple[FloatArray, FloatArray, float] | None:
    """Find rotation, shift and lag that bring points onto a recording by their common labels.

    Returns
    -------
    tuple or None
        The rotation, shape (3, 3), for points @ rotation, the shift, shape (3,), and seconds;
        None where too little is common.
    """
    if min(own.frames, len(points)) < LEAST_SAMPLES:
        return None
    mine, theirs = _common(own, labels, points)
    if len(mine) < LEAST_COMMON:
        return None
    steady = own.points[:, mine].copy()
    bridge_gaps(steady)
    steady = at_rate(steady, own.rate, RATE)[:LONGEST_FIT]
    last = (len(points) - 1) / rate
    times = np.arange(min(LONGEST_FIT, int(last * RATE + SAME_FRAME) + 1)) / RATE
    seen = _sampled(points[:, theirs], rate, times, no_progress)
    try:
        found = align_in_time(steady, seen)
    except RefineError:
        return None
    here, there = in_common(found.lag, len(steady), len(seen))
    theirs_then = seen[there]
    measured = _sampled(own.points[:, mine], own.rate, np.arange(len(steady)) / RATE, no_progress)
    ours = measured[here]
    complete = ~np.isnan(ours + theirs_then).any(axis=(1, 2))
    if np.count_nonzero(complete) < LEAST_SHARED:
        # What was bridged has a say where there is nothing better.
        ours, complete = steady[here], ~np.isnan(theirs_then).any(axis=(1, 2))
    one, other = (each[complete].reshape(-1, 3) for each in (ours, theirs_then))
    rotation = turns((other - other.mean(axis=0)).T @ (one - one.mean(axis=0)))
    return rotation, one.mean(axis=0) - other.mean(axis=0) @ rotation, found.seconds


def _common(
    own: Recording, labels: Sequence[str], points: FloatArray
) -> tuple[list[int], list[int]]:
    """Return the places of common labels in both, of those that are well seen if they suffice."""
    places = dict(places_of(labels))
    pairs = [(k, places[name]) for name, k in places_of(own.labels) if name in places]
    shares = (own.present.mean(axis=0), (~np.isnan(points[..., 0])).mean(axis=0))
    least = [min(shares[0][k], shares[1][j]) for k, j in pairs]
    well = [pair for pair, share in zip(pairs, least, strict=True) if share >= WELL_SEEN]
    counts = (own.present.sum(axis=0), (~np.isnan(points[..., 0])).sum(axis=0))
    seen = [pair for pair in pairs if min(counts[0][pair[0]], counts[1][pair[1]]) >= LEAST_SAMPLES]
    chosen = well if len(well) >= LEAST_COMMON else seen
    return [k for k, _ in chosen], [j for _, j in chosen]


def _sampled(points: FloatArray, rate: float, times: FloatArray, progress: Progress) -> FloatArray:
    """Sample points at times (s from their first frame): NaN outside and beside what is missing.

    Between frames on natural cubic splines, one point after the other: each call into scipy keeps
    the window waiting.
    """
    place = times * rate
    near = np.rint(place)
    place = np.where(np.abs(place - near) < SAME_FRAME * max(1.0, rate), near, place)
    inside = (place >= 0) & (place <= len(points) - 1)
    found = np.full((len(times), *points.shape[1:]), np.nan)
    low, high = (end(place[inside]).astype(np.int64) for end in (np.floor, np.ceil))
    if np.array_equal(low, high):
        found[inside] = points[low]
        progress(1.0)
        return found
    from scipy.interpolate import CubicSpline

    missing = np.isnan(points[..., 0])
    for k in range(points.shape[1]):
        progress(k / points.shape[1])
        if np.count_nonzero(~missing[:, k]) < LEAST_SAMPLES:
            continue
        track = points[:, k : k + 1].copy()
        bridge_gaps(track)
        values = CubicSpline(np.arange(len(track)), track[:, 0], bc_type="natural")(place[inside])
        values[missing[low, k] | missing[high, k]] = np.nan
        found[inside, k] = values
    return found


def places_of(labels: Sequence[str]) -> list[tuple[str, int]]:
    """Return names and places of the labels that are there once."""
    names = [bare_name(label) for label in labels]
    return [(name, k) for k, name in enumerate(names) if name and names.count(name) == 1]


def bare_name(label: str) -> str:
    """Return a label as it is compared: without its subject, in capitals."""
    return without_subject(label).upper()
