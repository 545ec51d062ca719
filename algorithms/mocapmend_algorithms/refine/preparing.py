"""What is done to a recording before a network sees it, all of it undone at the end (Y23, 2.1).

Missing samples are bridged and all is sampled 60 times a second on natural cubic splines, then
taken relative to the root, with z up; windows are turned so that the body faces the same way. The
paper has no headings: its performers faced the camera.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.names import without_subject
from mocapmend_algorithms.recording import Recording, UpAxis
from mocapmend_algorithms.refine.profile import Profile, root_track
from mocapmend_algorithms.sparse import heading
from mocapmend_algorithms.sparse.training_set import turn_up

RATE = 60.0
"""Frames per second of what a network sees."""
SAME_FRAME = 1e-6
MOST_FRAMES = 1_000_000
"""Of what a network sees: four and a half hours."""
LARGEST_BODY = 1e5
"""Millimetres between a joint and the root that can be meant: a hundred metres."""
UP: UpAxis = "+z"


class RefineError(ValueError):
    """A recording cannot be refined; the message says why, in words a user understands."""


@dataclass(frozen=True, eq=False)
class Prepared:
    """A recording as networks take it.

    Attributes
    ----------
    joints : ndarray, shape (frames, inputs, 3)
        In mm relative to the root, z up, at 60 frames per second.
    root : ndarray, shape (frames, 1, 3)
        The root's own track.
    bridged : ndarray of bool, shape (recording's frames, inputs)
        What was missing in the recording, at its own rate.
    recording : Recording
        It.
    """

    joints: FloatArray
    root: FloatArray
    bridged: BoolArray
    recording: Recording

    def undone(self, poses: FloatArray) -> FloatArray:
        """Return refined poses as the recording has its own.

        Parameters
        ----------
        poses : ndarray, shape (frames, outputs, 3)
            In mm relative to the root, z up, at 60 frames per second.

        Returns
        -------
        ndarray, shape (recording's frames, outputs, 3)
            In the recording's place, axes, unit and rate.
        """
        absolute = (poses + self.root) @ turn_up(UP, self.recording.up).T / self.recording.mm
        return at_rate(absolute, RATE, self.recording.rate, self.recording.frames)


def prepare(recording: Recording, profile: Profile) -> Prepared:
    """Bring a recording into the form that networks take.

    Parameters
    ----------
    recording : Recording
        Of any rate, unit and up axis, with the profile's inputs among its labels.
    profile : Profile
        What to look for.

    Raises
    ------
    RefineError
        If a joint is not there, has fewer than two samples or is impossibly far away, or the
        recording is too short or too long.
    """
    places = labels_places(recording.labels, profile.inputs, profile.name)
    if recording.frames < 2:
        raise RefineError("the recording has fewer than two frames")
    if recording.frames / recording.rate * RATE > MOST_FRAMES:
        raise RefineError(
            f"the recording is too long: {recording.frames / recording.rate:.0f} s of at most "
            f"{MOST_FRAMES / RATE:.0f} s"
        )
    points = recording.points[:, places] * recording.mm @ turn_up(recording.up, UP).T
    seen = recording.present[:, places]
    if scarce := [profile.inputs[at] for at in np.flatnonzero(seen.sum(axis=0) < 2)]:
        raise RefineError(f"these joints are never seen: {', '.join(scarce)}")
    bridge_gaps(points)
    sampled = at_rate(points, recording.rate, RATE)
    root = root_track(sampled, profile.input_root)
    joints = sampled - root
    if not np.abs(joints).max() <= LARGEST_BODY:
        worst = int(np.abs(joints).max(axis=(0, 2)).argmax())
        raise RefineError(
            f"{profile.inputs[worst]} is impossibly far from the root: more than "
            f"{LARGEST_BODY / 1000:.0f} m"
        )
    return Prepared(joints, root, ~seen, recording)


def labels_places(labels: Sequence[str], wanted: Sequence[str], name: str) -> list[int]:
    """Find the labels that a profile wants; case and subject prefixes do not matter.

    Parameters
    ----------
    labels : sequence of str
        Of a recording.
    wanted : sequence of str
        What to find.
    name : str
        Of the profile, for the user.

    Raises
    ------
    RefineError
        If some are not there, or one is there twice.
    """
    bare = [without_subject(label).upper() for label in labels]
    lacking = [label for label in wanted if label.upper() not in bare]
    if lacking:
        some = ", ".join(lacking[:5]) + (" ..." if len(lacking) > 5 else "")
        raise RefineError(
            f"the network is for other points ({name}): {len(lacking)} of {len(wanted)} are not "
            f"in this recording ({some})"
        )
    if twice := [label for label in wanted if bare.count(label.upper()) > 1]:
        raise RefineError(f"the recording has more than one {twice[0]}")
    return [bare.index(label.upper()) for label in wanted]


def bridge_gaps(points: FloatArray) -> None:
    """Fill missing samples of each joint on a natural cubic spline; ends hold; in place.

    Parameters
    ----------
    points : ndarray, shape (frames, joints, 3)
        Each joint has two samples at least.
    """
    from scipy.interpolate import CubicSpline

    frames = np.arange(len(points))
    for joint in range(points.shape[1]):
        there = np.flatnonzero(~np.isnan(points[:, joint, 0]))
        if len(there) == len(points):
            continue
        spline = CubicSpline(there, points[there, joint], bc_type="natural")
        absent = np.isnan(points[:, joint, 0])
        points[absent, joint] = spline(np.clip(frames[absent], there[0], there[-1]))


def at_rate(points: FloatArray, own: float, wanted: float, count: int | None = None) -> FloatArray:
    """Sample complete points, shape (frames, ...), at another rate (Hz) on a natural spline.

    Parameters
    ----------
    points : ndarray
        Two frames at least.
    own, wanted : float
        Rates in Hz.
    count : int, optional
        Frames wanted; by default as many as lie within. Those after the last hold it.
    """
    from scipy.interpolate import CubicSpline

    seconds = np.arange(len(points)) / own
    if count is None:
        count = int(seconds[-1] * wanted + SAME_FRAME) + 1
    if own == wanted and count == len(points):
        return points
    spline = CubicSpline(seconds, points, axis=0, bc_type="natural")
    sampled: FloatArray = spline(np.minimum(np.arange(count) / wanted, seconds[-1]))
    return sampled


def headings(windows: FloatArray, profile: Profile) -> FloatArray:
    """Return how far the body is turned about z in each window, from its left-to-right line.

    Parameters
    ----------
    windows : ndarray, shape (windows, frames, inputs, 3)
        z up.
    profile : Profile
        Says what is left and right.

    Returns
    -------
    ndarray, shape (windows,)
        Radians; 0 where left lies along x.
    """
    across = windows[:, :, list(profile.left), :2] - windows[:, :, list(profile.right), :2]
    mean = across.mean(axis=(1, 2))
    angles: FloatArray = np.arctan2(mean[:, 1], mean[:, 0])
    return angles


def turned(windows: FloatArray, angles: FloatArray) -> FloatArray:
    """Turn windows, shape (windows, ..., 3), about z by an angle each, in radians."""
    return heading.turned(windows, angles, UP)
