"""Reading TRC files: markers as OpenSim and Motion Analysis (Cortex, EVa) write them."""

import math
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.cells import number, split
from mocapmend.files.formats.columns import AXIS_AT_END, Columns, check_count, clean_label
from mocapmend.files.formats.frames import MissingRule, read_frames
from mocapmend.files.formats.text import Lines, open_text
from mocapmend.files.source import Source, truncation

HEAD_LINES = 20
"""Lines in which the header must end."""


@dataclass
class _Header:
    values: dict[str, str] = field(default_factory=dict)
    labels: tuple[str, ...] = ()
    lines: int = 0
    """How many lines it has."""

    def value(self, name: str) -> float:
        return number(self.values.get(name, ""), "\t")


def read_trc(path: Path) -> Source:
    """Read a TRC file.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    with open_text(path) as lines:
        return parse_trc(lines)


def is_trc(head: list[str]) -> bool:
    """Say whether lines are the head of such a file."""
    return bool(head) and _first_cell(head[0]) == "pathfiletype"


def parse_trc(lines: Lines) -> Source:
    """Read a TRC file.

    A sample is missing where it is empty, NaN or exactly (0, 0, 0).

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    warnings: list[str] = []
    header = _read_header(lines)
    separator = _separator(_first_row(lines, header))
    columns = _columns(lines, header, separator, warnings)
    lines.skip(header.lines)
    rule = MissingRule(zeros=True)
    frames = read_frames(lines, columns, separator, rule, warnings, quoted=False)
    warnings += rule.sentences()
    stated = Stated(
        labels=columns.labels,
        rate=header.value("datarate"),
        unit=header.values.get("units", ""),
    )
    recording = assemble(lines.path, frames, stated, warnings)
    promised = _promised_frames(header, recording.frames, warnings)
    return Source(
        path=lines.path,
        kind="TRC",
        recording=recording,
        stamp=lines.stamp,
        warnings=tuple(warnings),
        frames_promised=promised,
    )


def _read_header(lines: Lines) -> _Header:
    head = lines.peek(HEAD_LINES)
    at = next((i for i, line in enumerate(head) if _first_cell(line) in {"frame#", "frame"}), None)
    if at is None:
        raise lines.error("This is not a TRC file: it has no line that begins with “Frame#”.")
    header = _Header()
    for names, values in pairwise(head[:at]):
        if _first_cell(names) == "datarate":
            header.values = _values(names, values)
    header.labels = tuple(split(head[at], _separator(head[at]), quoted=False)[2:])
    header.lines = at + 1
    following = head[at + 1] if len(head) > at + 1 else ""
    if _first_cell(following).startswith("x"):
        header.lines += 1
    return header


def _separator(line: str) -> str | None:
    return next((mark for mark in "\t;," if mark in line), None)


def _first_row(lines: Lines, header: _Header) -> str:
    return next((line for line in lines.peek(HEAD_LINES)[header.lines :] if line.strip()), "")


def _first_cell(line: str) -> str:
    return (line.replace(",", " ").replace(";", " ").split() or [""])[0].lower()


def _values(names: str, values: str) -> dict[str, str]:
    """Pair names with values; some writers mix tabs, commas and spaces."""
    keys = names.replace(",", " ").replace(";", " ").lower().split()
    cells = [cell.strip() for cell in values.rstrip().split("\t")]
    if len(cells) < len(keys):
        cells = values.split() if "\t" in values or "," not in values else values.split(",")
    return dict(zip(keys, (cell.strip(" ,;") for cell in cells), strict=False))


def _columns(lines: Lines, header: _Header, separator: str | None, warnings: list[str]) -> Columns:
    """Find the columns of the markers: three for each label, and three for each beyond."""
    labels = _labels(header)
    row = _first_row(lines, header).rstrip((separator or "") + " ")
    cells = split(row, separator, quoted=False)
    beyond = math.ceil((len(cells) - 2) / 3) - len(labels)
    if beyond > 0:
        warnings.append(f"Markers without a label in the file: {beyond}.")
        labels += [""] * beyond
    check_count(lines, len(labels))
    stated = header.value("nummarkers")
    if math.isfinite(stated) and stated != len(labels):
        warnings.append(
            f"There are {stated:g} markers by the header, but {len(labels)} in the file."
        )
    first = tuple(range(2, 2 + 3 * len(labels), 3))
    return Columns(tuple(map(clean_label, labels)), first, frame=0, time=1)


def _labels(header: _Header) -> list[str]:
    """Return the labels of the line of labels, which stand above every third column."""
    cells = list(header.labels)
    while cells and not cells[-1]:
        cells.pop()
    thirds = cells[::3]
    named = [cell for cell in cells if cell]
    if len(named) == sum(map(bool, thirds)):
        return thirds
    triples = list(zip(cells[::3], cells[1::3], cells[2::3], strict=False))
    stems = [[AXIS_AT_END.fullmatch(cell) for cell in triple] for triple in triples]
    if 3 * len(triples) == len(cells) and all(
        found and found[2].lower() == axis
        for triple in stems
        for found, axis in zip(triple, "xyz", strict=True)
    ):
        return [found[1] for triple in stems for found in triple[:1] if found]
    return named


def _promised_frames(header: _Header, frames: int, warnings: list[str]) -> int:
    stated = header.value("numframes")
    if not 0 <= stated < 2**31 or stated == frames:
        return frames
    warnings.append(
        truncation(stated, frames)
        if stated > frames
        else f"There are {stated:g} frames by the header, but {frames} in the file."
    )
    return int(stated)
