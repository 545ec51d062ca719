"""Reading the motion data of Qualisys Track Manager in text files (TSV)."""

import math
from dataclasses import dataclass, field

from mocapmend.files.formats.assemble import Stated, assemble
from mocapmend.files.formats.cells import number, split
from mocapmend.files.formats.columns import Columns, check_count, clean_label, named_columns
from mocapmend.files.formats.frames import MissingRule, read_frames
from mocapmend.files.formats.text import Lines
from mocapmend.files.source import Event, Source, truncation

MOST_HEADER_LINES = 10_000
"""Each event has a line."""
TODO = "Export the 3D data again from Qualisys Track Manager, with the TSV header."


@dataclass
class _Header:
    values: dict[str, list[str]] = field(default_factory=dict)
    events: list[list[str]] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    """Of the columns, where the file names them."""
    lines: int = 0

    def number(self, key: str) -> float:
        return number((self.values.get(key) or [""])[0], "\t")


def is_qualisys(head: list[str]) -> bool:
    """Say whether lines are the head of such a file."""
    return any(
        line.split("\t")[0].strip() in {"NO_OF_FRAMES", "NO_OF_MARKERS", "MARKER_NAMES"}
        for line in head
    )


def parse_qualisys(lines: Lines) -> Source:
    """Read the 3D data that Qualisys Track Manager exports as TSV.

    A sample is missing where it is empty, NaN or exactly (0, 0, 0).

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    warnings: list[str] = []
    header = _read_header(lines)
    _refuse_others(lines, header)
    columns = _columns(lines, header, warnings)
    lines.skip(header.lines)
    rule = MissingRule(zeros=True)
    frames = read_frames(lines, columns, "\t", rule, warnings, quoted=False)
    warnings += rule.sentences()
    stated = Stated(labels=columns.labels, rate=header.number("FREQUENCY"), unit="mm")
    recording = assemble(lines.path, frames, stated, warnings)
    promised = header.number("NO_OF_FRAMES")
    if promised > recording.frames:
        warnings.append(truncation(promised, recording.frames))
    return Source(
        path=lines.path,
        kind="Qualisys TSV",
        recording=recording,
        stamp=lines.stamp,
        events=_events(header, recording.rate, recording.first_frame),
        warnings=tuple(warnings),
        frames_promised=int(promised) if 0 <= promised < 2**31 else 0,
    )


def _read_header(lines: Lines) -> _Header:
    header = _Header()
    head = lines.peek(MOST_HEADER_LINES)
    for line in head:
        cells = split(line, "\t", quoted=False)
        key = cells[0]
        if key == "EVENT":
            header.events.append(cells[1:])
        elif key and key.replace("_", "").isalnum() and key.isupper() and not key.isdigit():
            header.values[key] = cells[1:]
        elif named_columns(cells):
            header.names = cells
            header.lines += 1
            break
        elif any(cells):
            break
        header.lines += 1
    return header


def _refuse_others(lines: Lines, header: _Header) -> None:
    included = " ".join(header.values.get("DATA_INCLUDED", []))
    if "MARKER_NAMES" not in header.values or (included and "3D" not in included.upper()):
        raise lines.error(f"The file holds no 3D markers{_said(included)}.", TODO)


def _said(included: str) -> str:
    return f" but {included:.20} data" if included and "3D" not in included else ""


def _columns(lines: Lines, header: _Header, warnings: list[str]) -> Columns:
    labels = header.values["MARKER_NAMES"]
    while labels and not labels[-1]:
        labels.pop()
    check_count(lines, len(labels))
    stated = header.number("NO_OF_MARKERS")
    if math.isfinite(stated) and stated != len(labels):
        warnings.append(f"There are {stated:g} markers by the header, but it names {len(labels)}.")
    cleaned = tuple(map(clean_label, labels))
    named = named_columns(header.names)
    if named is not None and len(named.first) == len(labels):
        return Columns(cleaned, named.first, named.frame, named.time)
    row = next((line for line in lines.peek(header.lines + 5)[header.lines :] if line.strip()), "")
    width = len(split(row.rstrip("\r "), "\t", quoted=False))
    before = 2 if width >= 3 * len(labels) + 2 else 0
    return Columns(
        cleaned,
        tuple(range(before, before + 3 * len(labels), 3)),
        frame=0 if before else None,
        time=1 if before else None,
    )


def _events(header: _Header, rate: float, first_frame: int) -> tuple[Event, ...]:
    """Return the events: lines of a label, a frame from 1 and a time."""
    events = []
    for cells in header.events:
        label, frame, time = [*cells, "", "", ""][:3]
        at, seconds = number(frame, "\t"), number(time, "\t")
        if not math.isfinite(seconds):
            seconds = (at - 1) / rate
        if not math.isfinite(at):
            at = seconds * rate + 1
        if math.isfinite(at) and math.isfinite(seconds):
            events.append(Event(clean_label(label), "", at - first_frame, seconds))
    return tuple(sorted(events, key=lambda event: event.time))
