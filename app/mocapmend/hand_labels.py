"""Labels given by hand: which stretch of a point is meant, and what makes it a label's. No Qt."""

from typing import NamedTuple

import numpy as np

from mocapmend.document import Document
from mocapmend.errors import MocapmendError
from mocapmend.renaming import without_label
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.labelling.pieces import cut_pieces


class Given(NamedTuple):
    """What makes a stretch a label's: an exchange with the point of the label, or a new name.

    Attributes
    ----------
    point : int
        The point that has the label then.
    exchange : Exchange or None
        What is exchanged with it; None where the point itself gets the label.
    """

    point: int
    exchange: Exchange | None


def stretch(
    document: Document, point: int, frame: int, span: tuple[int, int] | None
) -> tuple[int, int]:
    """Return the frames of a point that are meant: start to stop - 1.

    Parameters
    ----------
    document : Document
        The recording.
    point : int
        Which point.
    frame : int
        The playhead: without selected frames the stretch is from there to where the trajectory
        ends or jumps.
    span : tuple of int or None
        The selected frames.

    Raises
    ------
    MocapmendError
        If the point is not seen there.
    """
    base = document.base
    if span is not None:
        if not base.present[span[0] : span[1], point].any():
            raise MocapmendError("The marker is not seen in the selected frames.")
        return span
    path = base.points[:, [point]] * base.mm
    for piece in cut_pieces(path, base.rate):
        if piece.start <= frame < piece.stop:
            return frame, piece.stop
    raise MocapmendError("The marker is not seen in this frame: go to one in which it is.")


def given(document: Document, point: int, frames: tuple[int, int], label: str) -> Given:
    """Return what makes a stretch of a point a label's.

    Parameters
    ----------
    document : Document
        The recording.
    point : int
        Holds the stretch.
    frames : tuple of int
        Its start and stop.
    label : str
        As the file would have it.

    Raises
    ------
    MocapmendError
        If the label is the point's own, or has no point and cannot get this one.
    """
    labels = document.labels
    if labels[point] == label:
        raise MocapmendError("The marker has this label already.")
    if label in labels:
        home = labels.index(label)
        return Given(home, Exchange(point, home, *frames))
    if point in without_label(labels):
        return Given(point, None)
    raise MocapmendError(
        "No point has this label, and this one has another.",
        todo="Rename the marker, or choose a label that a point has.",
    )


def free_and_taken(
    document: Document, point: int, frames: tuple[int, int]
) -> tuple[list[int], list[int]]:
    """Return the other points that have labels: those not seen in some frames, and the rest."""
    there = document.base.present[frames[0] : frames[1]]
    seen = [bool(there[:, other].any()) for other in range(there.shape[1])]
    nameless = set(without_label(document.labels))
    free: list[int] = []
    taken: list[int] = []
    for other, is_seen in enumerate(seen):
        if other != point and other not in nameless:
            (taken if is_seen else free).append(other)
    return free, taken


def next_without_label(document: Document, after: int | None, frame: int) -> tuple[int, int] | None:
    """Return a point without a label that is to be labelled next, and a frame in which it is seen.

    Those that are seen in a frame come first, from a point on; then those that come up later, and
    last those from before.
    """
    present = document.base.present
    points = [point for point in without_label(document.labels) if present[:, point].any()]
    if not points:
        return None
    here = [point for point in points if present[frame, point]]
    if here:
        later = [point for point in here if after is None or point > after]
        return (later or here)[0], frame
    seen = present[:, points].any(axis=1)
    frames = np.flatnonzero(seen)
    ahead = frames[frames > frame]
    where = int(ahead[0]) if len(ahead) else int(frames[0])
    return next(point for point in points if present[where, point]), where
