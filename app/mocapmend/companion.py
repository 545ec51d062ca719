"""A recording that is looked at beside another one, brought to its frames, unit and axes. No Qt."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from mocapmend.beside import Way, bare_name, bring, places_of
from mocapmend.bones import stated_skeleton
from mocapmend.errors import MocapmendError
from mocapmend.files import Provenance, Source, read_recording
from mocapmend.files.sidecar import hash_file
from mocapmend.refine.judging import Judged, judge
from mocapmend_algorithms import Progress, Recording
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import part
from mocapmend_algorithms.skeleton import match_template
from mocapmend_resources import skeletons

MOST_COMPARED = 500
"""Frames from which it is told what is near."""


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


def partners_of(own: Recording, other: Recording) -> tuple[int | None, ...]:
    """Find for each marker its partner in a recording of the same frames.

    Returns
    -------
    tuple of int or None
        The point of the same label, whatever its subject and case; else the nearest on average
        over the frames in which both are there; None where there is no such frame.
    """
    places = dict(places_of(other.labels))
    named = [places.get(bare_name(label)) for label in own.labels]
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


def _bones(source: Source) -> tuple[tuple[int, int], ...]:
    """Return the bones that a file names, or a template for its labels has."""
    stated = stated_skeleton(source)
    if stated is None:
        stated = match_template(source.recording.labels, skeletons.load())
    return () if stated is None else stated.bones
