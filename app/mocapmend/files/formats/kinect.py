"""The 25 joints of a Kinect v2 in text files, as the data sets KERAAL and KIMORE have them.

Each line has the joints in the order of Microsoft's JointType: their x, y and z in metres, y up,
and after them nothing, the state of their tracking, or their orientation as a quaternion.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.body_lengths import unit_by_lengths
from mocapmend.files.formats.csv_header import HEAD_LINES
from mocapmend.files.formats.frames import Frames, MissingRule
from mocapmend.files.formats.headerless import NumberTable, number_table, read_table
from mocapmend.files.formats.joint_layout import joint_layout
from mocapmend.files.formats.kinect_times import frame_times, may_lead
from mocapmend.files.formats.text import Lines
from mocapmend.files.source import Source

LAYOUT = "kinect_v2_25"
JOINTS = 25
PLAIN, WITH_STATE, WITH_ORIENTATION = 3, 4, 7
"""Numbers of a joint."""
NOT_TRACKED, INFERRED, TRACKED = 0, 1, 2
LENGTHS = {
    ("SpineBase", "Head"): (0.4, 1.2),
    ("SpineBase", "SpineShoulder"): (0.25, 0.9),
    ("SpineBase", "HipLeft"): (0.02, 0.25),
    ("SpineBase", "HipRight"): (0.02, 0.25),
    ("HipLeft", "KneeLeft"): (0.15, 0.8),
    ("HipRight", "KneeRight"): (0.15, 0.8),
    ("KneeLeft", "AnkleLeft"): (0.1, 0.8),
    ("KneeRight", "AnkleRight"): (0.1, 0.8),
    ("ShoulderLeft", "ElbowLeft"): (0.08, 0.6),
    ("ShoulderRight", "ElbowRight"): (0.08, 0.6),
    ("ElbowLeft", "WristLeft"): (0.08, 0.6),
    ("ElbowRight", "WristRight"): (0.08, 0.6),
}
"""Of a person, with room for what a Kinect gets wrong (m)."""


@dataclass(frozen=True, eq=False)
class _Kind:
    """How a file has the joints.

    Attributes
    ----------
    table : NumberTable
        Its first lines.
    numbers : int
        Of a joint.
    unit : str
        Of the positions.
    """

    table: NumberTable
    numbers: int
    unit: str

    @property
    def leading(self) -> int:
        """Columns before the joints: 1 where the lines begin with a time or a frame's number."""
        return self.table.columns - JOINTS * self.numbers


def is_kinect(head: list[str]) -> bool:
    """Say whether lines are numbers that show a person, joint by joint as a Kinect has them."""
    return _kind(head) is not None


@np.errstate(all="ignore")
def parse_kinect(lines: Lines) -> Source:
    """Read the joints of such a file.

    Joints that were not tracked are missing; those that the Kinect inferred are kept, for they are
    what it measured, and counted.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    kind = _kind(lines.peek(HEAD_LINES))
    assert kind is not None, "is_kinect has seen these lines"
    layout = joint_layout(LAYOUT)
    warnings: list[str] = []
    table = read_table(lines, kind.table, warnings)
    joints = table[:, kind.leading :].reshape(len(table), JOINTS, kind.numbers)
    points = np.ascontiguousarray(joints[..., :3])
    if kind.numbers == WITH_STATE:
        _apply_states(points, joints[..., 3], warnings)
    if kind.numbers == WITH_ORIENTATION:
        warnings.append("The orientations of the joints are left out.")
    rule = MissingRule(zeros=True)
    rule.apply(points)
    warnings += rule.sentences()
    if kind.unit != "m":
        warnings.append(
            f"The file states no length unit; {kind.unit} is assumed from the size of the skeleton."
        )
    column = table[:, 0] if kind.leading else None
    numbers, rate = frame_times(lines.path, column, len(table), warnings)
    frames = Frames(numbers, np.full(len(points), np.nan), points)
    stated = Stated(labels=layout.labels, rate=rate, unit=kind.unit, up="+y")
    return Source(
        path=lines.path,
        kind="Kinect v2",
        recording=assemble(lines.path, frames, stated, warnings),
        bones=layout.bones,
        stamp=lines.stamp,
        warnings=tuple(warnings),
    )


@np.errstate(all="ignore")
def _kind(head: Sequence[str]) -> _Kind | None:
    table = number_table(head)
    if table is None:
        return None
    numbers, leading = divmod(table.columns, JOINTS)
    if numbers not in (PLAIN, WITH_STATE, WITH_ORIENTATION) or leading > 1:
        return None
    if leading and not may_lead(table.rows[:, 0]):
        return None
    joints = table.rows[:, leading:].reshape(-1, JOINTS, numbers)
    points = joints[..., :3].copy()
    if numbers == WITH_STATE:
        states = joints[..., 3]
        # Files of orientations have as many columns.
        if not np.isin(states, (NOT_TRACKED, INFERRED, TRACKED)).all():
            return None
        points[states == NOT_TRACKED] = np.nan
    unit = unit_by_lengths(points, joint_layout(LAYOUT).labels, LENGTHS)
    return None if unit is None else _Kind(table, numbers, unit)


def _apply_states(
    points: NDArray[np.float64], states: NDArray[np.float64], warnings: list[str]
) -> None:
    """Make what was not tracked missing, in place, and tell of what was not seen."""
    points[states == NOT_TRACKED] = np.nan
    counts = [int(np.count_nonzero(states == state)) for state in (NOT_TRACKED, INFERRED, TRACKED)]
    unknown = states.size - sum(counts)
    if counts[NOT_TRACKED]:
        warnings.append(
            f"Samples that the Kinect did not track are taken as missing: {counts[NOT_TRACKED]}."
        )
    if counts[INFERRED]:
        warnings.append(
            "Samples that the Kinect did not see but inferred are kept as they are: "
            f"{counts[INFERRED]} of {states.size}."
        )
    if unknown:
        warnings.append(
            f"Samples whose state of tracking is unknown are kept as they are: {unknown}."
        )
