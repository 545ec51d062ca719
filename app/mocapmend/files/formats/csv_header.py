"""The header of a CSV file: comments, and the row that names the columns."""

import re
from dataclasses import dataclass, field

from mocapmend.files.formats.assemble import Stated
from mocapmend.files.formats.cells import number, split
from mocapmend.files.formats.columns import (
    FRAME_NAMES,
    TIME_NAMES,
    UNIT_AT_END,
    Columns,
    axis_columns,
    named_columns,
    time_scale,
)
from mocapmend.files.formats.text import Lines
from mocapmend.files.space import AXES, UNITS

HEAD_LINES = 60
"""Lines in which the header must end."""
SEPARATORS = ",;\t"
MARKER_NAMES = frozenset({"marker", "markers", "label", "name", "point", "joint", "trajectory"})
COMMENT = re.compile(r"#\s*(\w+)\s*[=:]\s*(.*)")
TODO = (
    "Name them as in frame, time, LASI_x, LASI_y, LASI_z or, with a line for each sample, "
    "frame, time, marker, x, y, z."
)


@dataclass(frozen=True)
class LongColumns:
    """Where a table of one line per sample holds what.

    Attributes
    ----------
    marker, x, y, z : int
        Columns.
    frame, time : int or None
        Columns; one of them is there.
    time_scale : float
        Seconds per unit of the time.
    unit : str
        Length unit that the names of the columns state, or empty.
    """

    marker: int
    x: int
    y: int
    z: int
    frame: int | None
    time: int | None
    time_scale: float
    unit: str


@dataclass
class CsvHeader:
    """What the head of a CSV file says.

    Attributes
    ----------
    columns : Columns or LongColumns
        What is where.
    separator : str
        Between cells.
    values : dict
        Of the comments, by their names in lower case.
    unit : str
        Length unit, or empty.
    """

    columns: Columns | LongColumns
    separator: str
    values: dict[str, str] = field(default_factory=dict)
    unit: str = ""

    @property
    def zeros_missing(self) -> bool:
        """Whether the file does not say that only empty cells are missing."""
        return self.values.get("missing") != "empty"

    def stated(self, labels: tuple[str, ...]) -> Stated:
        """Return what the file says about its recording."""
        first = number(self.values.get("first_frame", ""))
        return Stated(
            labels=labels,
            rate=number(self.values.get("rate_hz", ""), None),
            unit=self.unit,
            up=AXES.get(self.values.get("up", "").lower()),
            first_frame=int(first) if abs(first) < 2**31 else 1,
        )


def read_csv_header(lines: Lines) -> CsvHeader:
    """Read the header and skip it.

    Raises
    ------
    MocapmendError
        If no row names columns of markers.
    """
    head = lines.peek(HEAD_LINES)
    values = {}
    for i, line in enumerate(head):
        comment = COMMENT.fullmatch(line.strip(' ,;\t"'))
        if comment:
            values[comment[1].lower()] = comment[2].strip()
        if line.lstrip(' "').startswith("#"):
            continue
        found = _columns(line, head[i - 1] if i else "")
        if found is None:
            continue
        columns, separator = found
        lines.skip(i + 1)
        unit = _unit_row(lines, columns, separator) or columns.unit
        return CsvHeader(columns, separator, values, values.get("unit", "") or unit)
    raise lines.error("The file has no row that names columns of markers.", TODO)


def _columns(line: str, above: str) -> tuple[Columns | LongColumns, str] | None:
    """Return the columns that a row names, and its separator."""
    found: list[tuple[int, Columns | LongColumns, str]] = []
    for separator in SEPARATORS:
        cells = split(line, separator)
        if len(cells) < 3:
            continue
        columns = (
            _long_columns(cells)
            or axis_columns(cells, split(above, separator))
            or named_columns(cells)
        )
        if columns is not None:
            found.append((len(cells), columns, separator))
    return max(found, key=lambda item: item[0])[1:] if found else None


def _long_columns(names: list[str]) -> LongColumns | None:
    lower = [UNIT_AT_END.sub("", name.lower()) for name in names]
    marker = next((i for i, name in enumerate(lower) if name in MARKER_NAMES), None)
    frame = next((i for i, name in enumerate(lower) if name in FRAME_NAMES), None)
    time = next((i for i, name in enumerate(lower) if TIME_NAMES.fullmatch(name)), None)
    if marker is None or (frame is None and time is None) or not {"x", "y", "z"} <= {*lower}:
        return None
    x, y, z = (lower.index(axis) for axis in "xyz")
    unit = UNIT_AT_END.search(names[x].lower())
    return LongColumns(
        marker=marker,
        x=x,
        y=y,
        z=z,
        frame=frame,
        time=time,
        time_scale=1.0 if time is None else time_scale(lower[time]),
        unit=unit[1] if unit else "",
    )


def _unit_row(lines: Lines, columns: Columns | LongColumns, separator: str) -> str:
    """Skip a row of units under the header; return the unit, or an empty text."""
    following = lines.peek(1)
    at = columns.first[0] if isinstance(columns, Columns) else columns.x
    cells = split(following[0], separator) if following else []
    if len(cells) <= at or cells[at].strip("()[] ").lower() not in UNITS:
        return ""
    lines.skip(1)
    return cells[at].strip("()[] ")
