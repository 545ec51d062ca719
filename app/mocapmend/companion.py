"""A recording that is looked at beside another one, brought to its frames, unit and axes. No Qt."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from mocapmend.bones import stated_skeleton
from mocapmend.errors import MocapmendError
from mocapmend.files import Provenance, Source, read_recording
from mocapmend.files.sidecar import hash_file
from mocapmend.refine.judging import Judged, judge
from mocapmend_algorithms import Progress, Recording, no_progress
from mocapmend_algorithms.alignment import turns
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.refine.aligning import LEAST_SHARED, align_in_time
from mocapmend_algorithms.refine.preparing import RATE, RefineError, at_rate, bridge_gaps
from mocapmend_algorithms.skeleton import match_template
from mocapmend_algorithms.sparse.training_set import turn_up
from mocapmend_resources import skeletons

LEAST_COMMON = 3
"""Labels in common with which another recording is turned and shifted to fit."""
WELL_SEEN = 0.9
"""Share of the frames in which a marker must be there to have a say in that."""
LONGEST_FIT = 3600
"""Frames at 60 per second that have one: a minute says it all."""
MOST_COMPARED = 500
"""Frames from which it is told what is near."""
SAME_FRAME = 1e-6

Way = Literal["origin", "fitted", "as it is"]


@dataclass(frozen=True, eq=False)
class Companion:
    """Another recording, as it is looked at beside a document.

    Attributes
    ----------
    path : Path
        Its file.
    original : Recording
        In the frames, rate, unit and axes of the document; NaN where it has nothing.
    bones : tuple of (int, int)
        Pairs of its points.
    partners : tuple of int or None
        By marker of the document: the point of the same label, else the nearest on average, None
        where the two are never seen together.
    way : str
        "origin" where the document was made from it, and both are in one place; "fitted" where
        it was turned and shifted so that common labels fit best; else "as it is".
    lag : float
        Seconds by which it was shifted to later frames.
    judged : Judged or None
        How far the refined document is from it, where it can be a reference of that.
    """

    path: Path
    original: Recording
    bones: tuple[tuple[int, int], ...]
    partners: tuple[int | None, ...]
    way: Way
    lag: float = 0.0
    judged: Judged | None = None

    @property
    def points(self) -> FloatArray:
        """Its coordinates, shape (frames of the document, points, 3)."""
        return self.original.points

    def beside(self, own: Recording) -> "Companion":
        """Return it with the partners of a document whose labels have changed."""
        return replace(self, partners=partners_of(own, self.original))


def load(
    own: Recording,
    provenance: Provenance | None,
    path: Path,
    progress: Progress,
) -> Companion:
    """Read a recording and bring it beside a document.

    Parameters
    ----------
    own : Recording
        The document's.
    provenance : Provenance, optional
        Says what the document was made from.
    path : Path
        Of the other recording.
    progress : Progress
        Called often; may cancel.

    Raises
    ------
    MocapmendError
        If it cannot be read, or has nothing to be looked at.
    """
    source = read_recording(path)
    progress(0.2)
    if not source.measured.points.size:
        raise MocapmendError(
            "This recording has no markers to compare with.", str(path), "Choose another one."
        )
    made_from = () if provenance is None else provenance.inputs
    origin = hash_file(source.path) in made_from
    brought, way, lag = bring(own, source.measured, part(progress, 0.2, 0.8), origin=origin)
    refined = None if provenance is None else provenance.refined
    judged = None if refined is None else judge(own, source.measured, refined.profile, path.name)
    progress(0.9)
    companion = Companion(
        path, brought, _bones(source), partners_of(own, brought), way, lag, judged
    )
    progress(1.0)
    return companion


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


def partners_of(own: Recording, other: Recording) -> tuple[int | None, ...]:
    """Find for each marker its partner in a recording of the same frames.

    Returns
    -------
    tuple of int or None
        The point of the same label, whatever its subject and case; else the nearest on average
        over the frames in which both are there; None where there is no such frame.
    """
    places = dict(_places(other.labels))
    named = [places.get(_bare(label)) for label in own.labels]
    step = max(1, own.frames // MOST_COMPARED)
    ours, theirs = own.points[::step], other.points[::step]
    return tuple(
        _nearest(ours[:, marker], theirs) if place is None else place
        for marker, place in enumerate(named)
    )


def _nearest(track: FloatArray, others: FloatArray) -> int | None:
    distance = np.linalg.norm(others - track[:, None], axis=2)
    there = ~np.isnan(distance)
    counts = there.sum(axis=0)
    if not counts.any():
        return None
    means = np.full(len(counts), np.inf)
    np.divide(np.where(there, distance, 0.0).sum(axis=0), counts, out=means, where=counts > 0)
    return int(np.argmin(means))


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
    if min(own.frames, len(points)) < 2:
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
    first, end = max(0, found.lag), min(len(steady), len(seen) + found.lag)
    theirs_then = seen[first - found.lag : end - found.lag]
    measured = _sampled(own.points[:, mine], own.rate, np.arange(len(steady)) / RATE, no_progress)
    ours = measured[first:end]
    complete = ~np.isnan(ours + theirs_then).any(axis=(1, 2))
    if np.count_nonzero(complete) < LEAST_SHARED:
        # What was bridged has a say where there is nothing better.
        ours, complete = steady[first:end], ~np.isnan(theirs_then).any(axis=(1, 2))
    one, other = (each[complete].reshape(-1, 3) for each in (ours, theirs_then))
    rotation = turns((other - other.mean(axis=0)).T @ (one - one.mean(axis=0)))
    return rotation, one.mean(axis=0) - other.mean(axis=0) @ rotation, found.seconds


def _common(
    own: Recording, labels: Sequence[str], points: FloatArray
) -> tuple[list[int], list[int]]:
    """Return the places of common labels in both, of those that are well seen if they suffice."""
    places = dict(_places(labels))
    pairs = [(k, places[name]) for name, k in _places(own.labels) if name in places]
    shares = (own.present.mean(axis=0), (~np.isnan(points[..., 0])).mean(axis=0))
    least = [min(shares[0][k], shares[1][j]) for k, j in pairs]
    well = [pair for pair, share in zip(pairs, least, strict=True) if share >= WELL_SEEN]
    counts = (own.present.sum(axis=0), (~np.isnan(points[..., 0])).sum(axis=0))
    seen = [pair for pair in pairs if min(counts[0][pair[0]], counts[1][pair[1]]) >= 2]
    chosen = well if len(well) >= LEAST_COMMON else seen
    return [k for k, _ in chosen], [j for _, j in chosen]


def _places(labels: Sequence[str]) -> list[tuple[str, int]]:
    """Return names and places of the labels that are there once."""
    names = [_bare(label) for label in labels]
    return [(name, k) for k, name in enumerate(names) if name and names.count(name) == 1]


def _bare(label: str) -> str:
    return without_subject(label).upper()


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
        if np.count_nonzero(~missing[:, k]) < 2:
            continue
        track = points[:, k : k + 1].copy()
        bridge_gaps(track)
        values = CubicSpline(np.arange(len(track)), track[:, 0], bc_type="natural")(place[inside])
        values[missing[low, k] | missing[high, k]] = np.nan
        found[inside, k] = values
    return found


def _bones(source: Source) -> tuple[tuple[int, int], ...]:
    """Return the bones that a file names, or a template for its labels has."""
    stated = stated_skeleton(source)
    if stated is None:
        stated = match_template(source.recording.labels, skeletons.load())
    return () if stated is None else stated.bones
