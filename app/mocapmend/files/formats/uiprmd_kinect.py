"""The 22 joints of the Kinect in the data set UI-PRMD: two files for each recording.

Vakanski, Jun, Paul and Baker, "A Data Set of Human Body Movements for Physical Rehabilitation
Exercises", Data 2018, 3, 2. One file has the offset of each joint from its parent (cm), in the
parent's frame; the other one the angles of each joint (degrees).
"""

import numpy as np

from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.csv_header import HEAD_LINES
from mocapmend.files.formats.frames import Frames, MissingRule
from mocapmend.files.formats.headerless import NumberTable, number_table, read_table
from mocapmend.files.formats.joint_files import about_samples
from mocapmend.files.formats.joint_layout import JointLayout, joint_layout
from mocapmend.files.formats.kinect_times import ASSUMED, RATE
from mocapmend.files.formats.kinematics import Joint, Turn, positions
from mocapmend.files.formats.text import Lines, open_text
from mocapmend.files.formats.uiprmd_names import ANGLES, POSITIONS, TODO, partner
from mocapmend.files.source import Source

LAYOUT = "kinect_22"
COLUMNS = 66
MM_PER_CM = 10.0
X, Y, Z = range(3)
ORDER = (Z, X, Y)
"""R = Rz(z) Rx(x) Ry(y): of the six orders the one that agrees with the Vicon system."""
ALONG = {
    "Spine": Y, "Chest": Y, "Neck": Y, "Head": Y, "HeadTip": Y,
    "LeftShoulder": X, "LeftElbow": X, "LeftWrist": X,
    "RightShoulder": X, "RightElbow": X, "RightWrist": X,
    "LeftKnee": Y, "LeftAnkle": Y, "LeftToes": Z,
    "RightKnee": Y, "RightAnkle": Y, "RightToes": Z,
}  # fmt: skip
"""The only axis along which these joints lie from their parents."""
ENDS = ("HeadTip", "LeftToes", "RightToes")
"""Joints that do not turn."""
NOTHING = 0.01
"""cm or degrees."""
SHORTEST = 0.1
"""Bone (cm)."""
NOT_THE_OTHER = (
    "By its name this is the other file of a recording of UI-PRMD's Kinect, but it holds something "
    "else."
)


def is_uiprmd_kinect(head: list[str]) -> bool:
    """Say whether lines are the positions or the angles of such a recording."""
    table = number_table(head)
    return table is not None and _kind(table) is not None


@np.errstate(all="ignore")
def parse_uiprmd_kinect(lines: Lines) -> Source:
    """Read the two files of a recording, whichever of them is opened.

    Raises
    ------
    MocapmendError
        If one of them cannot be read, or the other one is not found.
    """
    warnings: list[str] = []
    table = number_table(lines.peek(HEAD_LINES))
    kind = None if table is None else _kind(table)
    assert table is not None and kind is not None, "is_uiprmd_kinect has seen these lines"
    wanted = ANGLES if kind == POSITIONS else POSITIONS
    with open_text(partner(lines.path, kind, wanted)) as beside:
        other = number_table(beside.peek(HEAD_LINES))
        if other is None or _kind(other) != wanted:
            raise beside.error(NOT_THE_OTHER, TODO)
        numbers = {
            kind: read_table(lines, table, warnings),
            wanted: read_table(beside, other, warnings),
        }
    moved, turned = numbers[POSITIONS], numbers[ANGLES]
    frames = min(len(moved), len(turned))
    if len(moved) != len(turned):
        warnings.append(
            f"There are {len(moved)} frames of positions and {len(turned)} of angles; the first "
            f"{frames} are read."
        )
    layout = joint_layout(LAYOUT)
    points = MM_PER_CM * positions(_joints(layout), np.hstack([moved[:frames], turned[:frames]]))
    about_samples(points, layout.labels, warnings)
    rule = MissingRule(zeros=True)
    rule.apply(points)
    warnings += [*rule.sentences(), ASSUMED]
    nothing = np.full(frames, np.nan)
    stated = Stated(labels=layout.labels, rate=RATE, unit="mm", up="+y")
    return Source(
        path=lines.path,
        kind="UI-PRMD Kinect",
        recording=assemble(lines.path, Frames(nothing, nothing, points), stated, warnings),
        bones=layout.bones,
        stamp=lines.stamp,
        warnings=tuple(warnings),
    )


@np.errstate(all="ignore")
def _kind(table: NumberTable) -> str | None:
    """Tell positions from angles, and both from anything else."""
    if table.columns != COLUMNS:
        return None
    complete = table.rows[np.isfinite(table.rows).all(axis=1)]
    if not len(complete):
        return None
    layout = joint_layout(LAYOUT)
    usual = np.median(np.abs(complete), axis=0).reshape(-1, 3)
    ends = usual[[layout.place(label) for label in ENDS]]
    if not ends.any() and (usual <= 360).all() and usual.any():
        return ANGLES
    joints = usual[[layout.place(label) for label in ALONG]]
    along = np.eye(3, dtype=bool)[list(ALONG.values())]
    if (joints[along] >= SHORTEST).all() and (joints[~along] <= NOTHING).all():
        return POSITIONS
    return None


def _joints(layout: JointLayout) -> list[Joint]:
    """Return the joints, whose positions are the columns before those of their angles."""
    return [
        Joint(
            label=label,
            parent=layout.parents.get(i, -1),
            shifts=tuple((axis, 3 * i + axis) for axis in (X, Y, Z)),
            turns=tuple(Turn(axis, COLUMNS + 3 * i + axis) for axis in ORDER),
        )
        for i, label in enumerate(layout.labels)
    ]
