"""Joints that carry each other, and where they are in each frame of a motion."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.opening import ANOTHER_FILE

Vector = tuple[float, float, float]
Columns = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
"""The columns of rotation matrices, each of shape (3, frames) or (3, 1)."""

MOST_JOINTS = 10_000
FARTHEST = 1e12
"""Coordinates beyond it are no positions, and their squares could overflow."""
SPARE_BYTES = 64_000_000
POINT_BYTES_PER_FILE_BYTE = 8
BLOCK_SAMPLES = 400_000


@dataclass(frozen=True)
class Turn:
    """A rotation about one axis of the frame that the turns before it have left.

    Attributes
    ----------
    axis : int
        0, 1 or 2 for x, y or z.
    channel : int
        Column of the motion that holds its angle (degrees); -1 where the angle is constant.
    degrees : float
        The constant angle.
    """

    axis: int
    channel: int = -1
    degrees: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Joint:
    """A joint, or the tip of a bone.

    Attributes
    ----------
    label : str
        As the file has it.
    parent : int
        Index of an earlier joint; -1 for a root.
    offset : tuple of float, length 3
        From the parent, in the rest pose.
    shifts : tuple of (int, int)
        Axes (0, 1, 2) along which a column of the motion takes the place of the offset.
    turns : tuple of Turn
        From the parent's frame to its own.
    moves_itself : bool
        Whether its own turns carry its offset, as in Acclaim's bones, or only its parent's do.
    """

    label: str
    parent: int
    offset: Vector = (0.0, 0.0, 0.0)
    shifts: tuple[tuple[int, int], ...] = ()
    turns: tuple[Turn, ...] = ()
    moves_itself: bool = False


def bones_of(joints: Sequence[Joint]) -> tuple[tuple[int, int], ...]:
    """Return the pairs (parent, joint)."""
    return tuple((joint.parent, i) for i, joint in enumerate(joints) if joint.parent >= 0)


def rest_values(joints: Sequence[Joint], channels: int) -> NDArray[np.float64]:
    """Return the motion of one frame that leaves the joints in their rest pose."""
    values = np.zeros((1, channels))
    for joint in joints:
        for axis, channel in joint.shifts:
            values[0, channel] = joint.offset[axis]
    return values


def check_size(frames: int, joints: int, file_bytes: int, where: str) -> None:
    """Refuse more samples than a file of this size can mean.

    Raises
    ------
    MocapmendError
        If the points would be far larger than the file.
    """
    allowed = SPARE_BYTES + POINT_BYTES_PER_FILE_BYTE * file_bytes
    if frames * joints * 24 > allowed:
        raise MocapmendError(
            f"{frames} frames of {joints} joints are too many for a file of this size.",
            where,
            ANOTHER_FILE,
        )


@np.errstate(all="ignore")
def positions(joints: Sequence[Joint], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Compute where the joints are (forward kinematics).

    Parameters
    ----------
    joints : sequence of Joint
        Each after its parent.
    values : ndarray, shape (frames, channels)
        The motion: lengths, and angles in degrees. What is not finite makes the joints that
        depend on it missing.

    Returns
    -------
    ndarray, shape (frames, joints, 3)
        NaN where a joint is missing or farther than 1e12 from the origin.
    """
    points = np.empty((len(values), len(joints), 3))
    block = max(BLOCK_SAMPLES // max(len(joints), 1), 1)
    for start in range(0, len(values), block):
        part = points[start : start + block]
        _place(joints, np.ascontiguousarray(values[start : start + block].T), part)
        part[~(np.abs(part).max(axis=2) < FARTHEST)] = np.nan
    return points


def _place(
    joints: Sequence[Joint], values: NDArray[np.float64], points: NDArray[np.float64]
) -> None:
    """Write the positions of some frames; the values have shape (channels, frames)."""
    still: Columns = tuple(np.eye(3)[:, :, None])
    frames: list[Columns] = []
    places: list[NDArray[np.float64]] = []
    for index, joint in enumerate(joints):
        carrier = own = frames[joint.parent] if joint.parent >= 0 else still
        for turn in joint.turns:
            angle = np.deg2rad(turn.degrees if turn.channel < 0 else values[turn.channel])
            own = _turned(own, turn.axis, np.cos(angle), np.sin(angle))
        if joint.moves_itself:
            carrier = own
        place = places[joint.parent] if joint.parent >= 0 else np.zeros((3, 1))
        moved = dict(joint.shifts)
        for axis in range(3):
            along = values[moved[axis]] if axis in moved else joint.offset[axis]
            place = place + carrier[axis] * along
        frames.append(own)
        places.append(place)
        points[:, index] = place.T


def _turned(columns: Columns, axis: int, cos: np.float64, sin: np.float64) -> Columns:
    """Return R @ R_axis by its columns, which is faster than products of small matrices."""
    second, third = columns[(axis + 1) % 3], columns[(axis + 2) % 3]
    turned = list(columns)
    turned[(axis + 1) % 3] = second * cos + third * sin
    turned[(axis + 2) % 3] = third * cos - second * sin
    return turned[0], turned[1], turned[2]
