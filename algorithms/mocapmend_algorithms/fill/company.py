"""Which markers to learn from together, in which frames, and how far they are apart."""

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.recording import Recording

LEAST_FRAMES = 10
LEAST_SHARE = 0.25
MOST_FOR_DISTANCE = 500


def seen_together(
    observed: BoolArray, markers: IntArray, required: int
) -> tuple[IntArray, IntArray]:
    """Choose markers that are often seen at once.

    One marker that is hardly ever seen would leave no frame complete, so those that are missing
    most are left out until a quarter of the frames that show the required one are complete, and
    at least 10.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    markers : ndarray of int
        To choose from.
    required : int
        The marker that stays in whatever happens; it is among `markers`.

    Returns
    -------
    markers : ndarray of int
        Ascending.
    frames : ndarray of int
        Those that show all of them, ascending; too few where even the required marker is seldom
        seen.
    """
    seen = np.flatnonzero(observed[:, required])
    present = observed[np.ix_(seen, markers)]
    # Those seen most come first, and the required one before its equals.
    count = np.count_nonzero(present, axis=0) + (markers == required)
    order = np.argsort(-count, kind="stable")
    together = np.logical_and.accumulate(present[:, order], axis=1)
    enough = np.count_nonzero(together, axis=0) >= max(LEAST_FRAMES, LEAST_SHARE * seen.size)
    kept = max(int(np.count_nonzero(enough)), 1)
    return np.sort(markers[order[:kept]]), seen[together[:, kept - 1]]


def few_frames(complete: int) -> str:
    """Say that too few frames are complete to learn from; empty where enough are."""
    if complete >= LEAST_FRAMES:
        return ""
    return (
        f"only {complete} frames show the marker and those that predict it: this method needs "
        f"{LEAST_FRAMES}"
    )


def few_helpers(helpers: int, least: int, how: str) -> str:
    """Say that too few markers are seen, as `how` has it, to tell one; empty where enough are."""
    if helpers >= least:
        return ""
    return f"of the other markers, {helpers} {how}: this method needs {least}"


def mean_distances(recording: Recording, observed: BoolArray, marker: int) -> FloatArray:
    """Measure how far all markers are from one.

    What a method weights its helpers by is how near they are, not how well they keep their
    distance: so it is the plain mean, as in the paper (GF16, see `pca`), and nothing is said of
    its spread.

    Parameters
    ----------
    recording : Recording
        The recording.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    marker : int
        From which; it is seen at least once.

    Returns
    -------
    ndarray, shape (markers,)
        Mean over about 500 frames in which both are seen, in the recording's unit; infinite where
        there is none.
    """
    frames = evenly(np.flatnonzero(observed[:, marker]), MOST_FOR_DISTANCE)
    points, both = recording.points[frames], observed[frames]
    away = np.linalg.norm(points - points[:, [marker]], axis=2)
    total, count = np.where(both, away, 0.0).sum(axis=0), both.sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.inf)
