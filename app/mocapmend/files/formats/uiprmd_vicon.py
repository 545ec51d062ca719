"""The 39 markers of the Vicon system in the data set UI-PRMD."""

import numpy as np

from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.body_lengths import unit_by_lengths
from mocapmend.files.formats.csv_header import HEAD_LINES
from mocapmend.files.formats.frames import Frames, MissingRule
from mocapmend.files.formats.headerless import NumberTable, number_table, read_table
from mocapmend.files.formats.text import Lines
from mocapmend.files.source import Source

MARKERS = (
    "LFHD", "RFHD", "LBHD", "RBHD", "C7", "T10", "CLAV", "STRN", "RBAK",
    "LSHO", "LUPA", "LELB", "LFRM", "LWRA", "LWRB", "LFIN",
    "RSHO", "RUPA", "RELB", "RFRM", "RWRA", "RWRB", "RFIN",
    "LASI", "RASI", "LPSI", "RPSI",
    "LTHI", "LKNE", "LTIB", "LANK", "LHEE", "LTOE",
    "RTHI", "RKNE", "RTIB", "RANK", "RHEE", "RTOE",
)  # fmt: skip
"""Plug-in Gait's names; the order is that of the files, as the geometry of their data shows it."""
RATE = 100.0
LENGTHS = {
    ("LFHD", "RFHD"): (0.05, 0.35),
    ("LSHO", "RSHO"): (0.15, 0.6),
    ("C7", "CLAV"): (0.05, 0.35),
    ("LASI", "RASI"): (0.1, 0.5),
    ("LKNE", "LANK"): (0.2, 0.7),
    ("RKNE", "RANK"): (0.2, 0.7),
    ("LANK", "LHEE"): (0.02, 0.2),
    ("RANK", "RHEE"): (0.02, 0.2),
    ("LELB", "LWRA"): (0.1, 0.5),
    ("RELB", "RWRA"): (0.1, 0.5),
    ("C7", "LASI"): (0.3, 1.0),
}
"""Of a person, with room for small and tall ones (m)."""


def is_uiprmd_vicon(head: list[str]) -> bool:
    """Say whether lines are numbers that show a person by these markers."""
    table = number_table(head)
    return table is not None and _unit(table) is not None


def parse_uiprmd_vicon(lines: Lines) -> Source:
    """Read the markers of such a file.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    table = number_table(lines.peek(HEAD_LINES))
    assert table is not None, "is_uiprmd_vicon has seen these lines"
    warnings: list[str] = []
    points = read_table(lines, table, warnings).reshape(-1, len(MARKERS), 3)
    rule = MissingRule(zeros=True)
    rule.apply(points)
    warnings += [
        *rule.sentences(),
        f"The file states no frame rate; {RATE:g} Hz is assumed.",
        "The file does not name its markers; Plug-in Gait's names are assumed.",
    ]
    nothing = np.full(len(points), np.nan)
    stated = Stated(labels=MARKERS, rate=RATE, unit=_unit(table) or "", up="+z")
    return Source(
        path=lines.path,
        kind="UI-PRMD Vicon",
        recording=assemble(lines.path, Frames(nothing, nothing, points), stated, warnings),
        stamp=lines.stamp,
        warnings=tuple(warnings),
    )


def _unit(table: NumberTable) -> str | None:
    if table.columns != 3 * len(MARKERS):
        return None
    points = table.rows.reshape(-1, len(MARKERS), 3)
    return unit_by_lengths(points, MARKERS, LENGTHS)
