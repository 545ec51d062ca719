"""Reading the trajectories in the text (ASCII) files of Vicon Nexus."""

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.cells import number, split
from mocapmend.files.formats.columns import Columns, axis_columns
from mocapmend.files.formats.frames import MissingRule, read_frames
from mocapmend.files.formats.text import Lines
from mocapmend.files.source import Source

SECTIONS = frozenset({"trajectories", "devices", "joints", "model outputs", "segments"})
TODO = "Export it from Nexus with its trajectories."


def is_nexus(head: list[str]) -> bool:
    """Say whether lines are the head of such a file: the name of a section and a rate."""
    first = [line for line in head if line.strip()][:2]
    return len(first) == 2 and _title(first[0]) in SECTIONS and number(_title(first[1])) > 0


def parse_nexus(lines: Lines) -> Source:
    """Read the section Trajectories of a text file of Nexus.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    warnings: list[str] = []
    others = _find_section(lines)
    head = lines.peek(5)
    if len(head) < 5:
        raise lines.error("The file ends in the header of its trajectories.", TODO)
    separator, columns = _columns(lines, head)
    units = split(head[4], separator)
    unit = units[columns.first[0]] if len(units) > columns.first[0] else ""
    lines.skip(5)
    rule = MissingRule(zeros=True)
    frames = read_frames(lines, columns, separator, rule, warnings, to_blank=True)
    warnings += rule.sentences()
    if others:
        warnings.append(f"Other sections of the file are left out: {', '.join(others)}.")
    stated = Stated(labels=columns.labels, rate=number(_title(head[1]), None), unit=unit)
    return Source(
        path=lines.path,
        kind="Nexus CSV",
        recording=assemble(lines.path, frames, stated, warnings),
        stamp=lines.stamp,
        warnings=tuple(warnings),
    )


def _title(line: str) -> str:
    return line.strip(' ,;\t"').lower()


def _find_section(lines: Lines) -> list[str]:
    """Skip to the line "Trajectories"; return the sections before it."""
    others: list[str] = []
    while block := lines.peek(1000):
        for i, line in enumerate(block):
            # Frames begin with digits; most lines are frames.
            if line[:1].isdigit():
                continue
            title = _title(line)
            if title == "trajectories":
                lines.skip(i)
                return others
            if title in SECTIONS:
                others.append(line.strip(' ,;\t"'))
        lines.skip(len(block))
    raise _without_trajectories(lines, others)


def _without_trajectories(lines: Lines, others: list[str]) -> MocapmendError:
    held = f", only {', '.join(others)}" if others else ""
    return lines.error(f"The file holds no trajectories{held}.", TODO)


def _columns(lines: Lines, head: list[str]) -> tuple[str, Columns]:
    """Return the separator and the columns: a row of labels, then one of axes."""
    for separator in ",\t;":
        columns = axis_columns(split(head[3], separator), split(head[2], separator))
        if columns is not None:
            return separator, columns
    raise lines.error("The trajectories have no row of X, Y and Z.", TODO)
