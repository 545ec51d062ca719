"""Reading the CSV files of OptiTrack Motive."""

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.cells import number, split
from mocapmend.files.formats.columns import Columns, check_count, clean_label
from mocapmend.files.formats.frames import MissingRule, read_frames
from mocapmend.files.formats.text import Lines
from mocapmend.files.source import Source, truncation

HEAD_LINES = 20
"""Lines in which the header must end."""
EXPECTED = ("rigid body marker", "bone marker")
"""Markers where Motive expects them; it writes them even where no camera saw them."""
NAMED = 5
"""Bodies that a warning names."""
TODO = "Export it from Motive with its markers and with the header."


def is_motive(head: list[str]) -> bool:
    """Say whether lines are the head of such a file."""
    return bool(head) and head[0].lstrip('"').startswith("Format Version")


def parse_motive(lines: Lines) -> Source:
    """Read the markers of a CSV file of Motive; the poses of bodies and bones are left out.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    warnings: list[str] = []
    values, rows = _read_header(lines)
    columns, expected, bodies = _columns(lines, rows)
    if not columns.first:
        raise _no_markers(lines, bodies)
    if expected:
        warnings.append(
            "Markers that are not measured, but where Motive expects them on a body or bone: "
            f"{expected} of {len(columns.first)}."
        )
    if bodies:
        warnings.append(f"The poses of bodies and bones are left out: {_some(bodies)}.")
    rule = MissingRule(zeros=True)
    frames = read_frames(lines, columns, ",", rule, warnings)
    warnings += rule.sentences()
    rate = values.get("export frame rate") or values.get("capture frame rate", "")
    stated = Stated(
        labels=columns.labels,
        rate=number(rate),
        unit=values.get("length units", ""),
        up="+y",
        first_frame=0,
    )
    recording = assemble(lines.path, frames, stated, warnings)
    promised = number(values.get("total exported frames", ""))
    if promised > recording.frames:
        warnings.append(truncation(promised, recording.frames))
    return Source(
        path=lines.path,
        kind="Motive CSV",
        recording=recording,
        stamp=lines.stamp,
        model_outputs=bodies,
        warnings=tuple(warnings),
        frames_promised=int(promised) if 0 <= promised < 2**31 else 0,
    )


def _read_header(lines: Lines) -> tuple[dict[str, str], list[list[str]]]:
    """Return the values of the first line, and the rows that say what the columns are."""
    head = [split(line, ",") for line in lines.peek(HEAD_LINES)]
    at = next(
        (
            i
            for i, cells in enumerate(head)
            if len(cells) > 2
            and cells[0].lower() == "frame"
            and cells[1].lower().startswith("time")
        ),
        None,
    )
    rows = [cells for cells in head[1 : (at or 0) + 1] if any(cells)]
    if at is None or len(rows) < 4:
        raise lines.error("The file has no rows that name its columns.", TODO)
    values = {key.lower(): value for key, value in zip(head[0][::2], head[0][1::2], strict=False)}
    lines.skip(at + 1)
    return values, rows


def _columns(lines: Lines, rows: list[list[str]]) -> tuple[Columns, int, tuple[str, ...]]:
    """Find the markers; also return how many are only expected, and what else has a pose."""
    types, names, kinds, axes = rows[0], rows[1], rows[-2], rows[-1]
    width = max(map(len, rows))
    check_count(lines, width // 3)
    types, names, kinds, axes = (
        row + [""] * (width - len(row)) for row in (types, names, kinds, axes)
    )
    labels, first = [], []
    bodies: dict[str, None] = {}
    expected = 0
    for i in range(2, width - 2):
        if kinds[i].lower() != "position" or [axis.lower() for axis in axes[i : i + 3]] != [
            "x",
            "y",
            "z",
        ]:
            continue
        kind = types[i].lower()
        if kind.endswith("marker"):
            labels.append(clean_label(names[i]))
            first.append(i)
            expected += kind in EXPECTED
        else:
            bodies[clean_label(names[i])] = None
    return Columns(tuple(labels), tuple(first), frame=0, time=1), expected, tuple(bodies)


def _no_markers(lines: Lines, bodies: tuple[str, ...]) -> MocapmendError:
    held = f", only the poses of {_some(bodies)}" if bodies else ""
    return lines.error(f"The file holds no markers{held}.", TODO)


def _some(names: tuple[str, ...]) -> str:
    more = len(names) - NAMED
    return ", ".join(names[:NAMED]) + (f" and {more} more" if more > 0 else "")
