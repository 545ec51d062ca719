"""Places where the trajectories of two markers continue each other better than themselves."""

from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.problems.continuity import AHEAD, cross_errors, own_errors
from mocapmend_algorithms.problems.levels import running_level
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

LEAST_JUMP_MM = 8.0
TIMES_LEVEL = 6.0
BETTER = 0.4
"""At most so much of its own error has the continuation by the other."""
NEAR_MM = 12.0
"""How near a marker appears to where another has vanished, if that is the same one."""
MOST_AT_ONCE = 24
"""Markers at one frame: where more jump, the whole recording does."""


class Crossing(NamedTuple):
    """Before a frame, two markers exchange their trajectories.

    Attributes
    ----------
    first, second : int
        The markers, ascending.
    frame : int
        The first frame after it.
    both : bool
        Whether both were seen before and after it.
    """

    first: int
    second: int
    frame: int
    both: bool


def find_jumps(recording: Recording, progress: Progress) -> tuple[FloatArray, BoolArray]:
    """Find samples that do not continue their own trajectory.

    Parameters
    ----------
    recording : Recording
        What to look at.
    progress : Progress
        Called once per marker.

    Returns
    -------
    errors : ndarray, shape (frames, markers)
        See `own_errors`, in mm.
    jumps : ndarray of bool, shape (frames, markers)
    """
    errors = np.full((recording.markers, recording.frames), np.nan)
    jumps = np.zeros(errors.shape, dtype=np.bool_)
    for marker in range(recording.markers):
        progress(marker / recording.markers)
        own = own_errors(recording.points[:, marker] * recording.mm)
        gate = np.maximum(LEAST_JUMP_MM, TIMES_LEVEL * running_level(own, recording.rate))
        errors[marker] = own
        with np.errstate(invalid="ignore"):
            jumps[marker] = own > gate
    return errors.T, jumps.T


def find_crossings(
    recording: Recording, errors: FloatArray, jumps: BoolArray, progress: Progress
) -> list[Crossing]:
    """Find where two markers exchange their trajectories, one of them may be missing.

    Parameters
    ----------
    recording : Recording
        What to look at.
    errors, jumps : ndarray, shape (frames, markers)
        See `find_jumps`.
    progress : Progress
        Called often.

    Returns
    -------
    list of Crossing
        Ordered by frame.
    """
    present = recording.present
    comes = np.zeros_like(present)
    goes = np.zeros_like(present)
    comes[1:] = present[1:] & ~present[:-1]
    goes[1:] = present[:-1] & ~present[1:]
    odd = jumps | comes | goes
    arrives = (jumps | comes).any(axis=1)
    frames = np.flatnonzero((odd.sum(axis=1) >= 2) & arrives)
    found = []
    for count, frame in enumerate(frames.tolist()):
        if count % 64 == 0:
            progress(count / len(frames))
        markers = np.flatnonzero(odd[frame])
        if len(markers) <= MOST_AT_ONCE:
            found += _at(recording, errors, jumps, frame, markers.tolist())
    return found


def _at(
    recording: Recording,
    errors: FloatArray,
    jumps: BoolArray,
    frame: int,
    markers: list[int],
) -> list[Crossing]:
    low = max(0, frame - AHEAD)
    some = recording.points[low : frame + AHEAD][:, markers] * recording.mm
    cross = cross_errors(some, frame - low)
    own = errors[frame, markers]
    jumped = jumps[frame, markers]
    candidates = []
    for a in range(len(markers)):
        for b in range(a + 1, len(markers)):
            there, back = cross[a, b], cross[b, a]
            if jumped[a] and jumped[b]:
                cost = max(there, back)
                good = cost < BETTER * min(own[a], own[b])
                both = True
            else:
                cost, good = _half(there, back, own[[a, b]], jumped[[a, b]])
                both = False
            if good:
                candidates.append((not both, cost, a, b))
    taken: set[int] = set()
    found = []
    for half, _, a, b in sorted(candidates):
        if not {a, b} & taken:
            taken |= {a, b}
            found.append(Crossing(markers[a], markers[b], frame, not half))
    return found


def _half(there: float, back: float, own: FloatArray, jumped: BoolArray) -> tuple[float, bool]:
    """Judge a pair of which one is missing before or after: only one way can be measured."""
    if np.isfinite(there) == np.isfinite(back):
        return np.inf, False
    cost = min(there, back)
    if jumped.any():
        return cost, bool(cost < BETTER * np.nanmax(own[jumped]))
    return cost, bool(cost < NEAR_MM and np.isnan(own).all())
