"""Reading .csv, .tsv and .txt files: their content says which program wrote them."""

from pathlib import Path

from mocapmend.files.formats.assemble import assemble
from mocapmend.files.formats.columns import Columns
from mocapmend.files.formats.csv_header import HEAD_LINES, read_csv_header
from mocapmend.files.formats.csv_long import read_samples
from mocapmend.files.formats.frames import MissingRule, read_frames
from mocapmend.files.formats.kinect import is_kinect, parse_kinect
from mocapmend.files.formats.motive import is_motive, parse_motive
from mocapmend.files.formats.nexus import is_nexus, parse_nexus
from mocapmend.files.formats.qualisys import is_qualisys, parse_qualisys
from mocapmend.files.formats.text import Lines, open_text
from mocapmend.files.formats.trc import is_trc, parse_trc
from mocapmend.files.formats.uiprmd_kinect import is_uiprmd_kinect, parse_uiprmd_kinect
from mocapmend.files.formats.uiprmd_vicon import is_uiprmd_vicon, parse_uiprmd_vicon
from mocapmend.files.source import Source

KINDS = (
    (is_motive, parse_motive),
    (is_qualisys, parse_qualisys),
    (is_nexus, parse_nexus),
    (is_trc, parse_trc),
    (is_kinect, parse_kinect),
    (is_uiprmd_kinect, parse_uiprmd_kinect),
    (is_uiprmd_vicon, parse_uiprmd_vicon),
)


def read_delimited(path: Path) -> Source:
    """Read a table in a text file: of a program or a data set that is known, or any CSV file.

    Raises
    ------
    MocapmendError
        If it cannot be read; nothing else.
    """
    with open_text(path) as lines:
        head = lines.peek(HEAD_LINES)
        for is_kind, parse in KINDS:
            if is_kind(head):
                return parse(lines)
        return parse_csv(lines)


def parse_csv(lines: Lines) -> Source:
    """Read a table whose header names the columns, with a line per frame or per sample.

    A sample is missing where it is empty, NaN or, unless the file says otherwise, exactly
    (0, 0, 0).

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    warnings: list[str] = []
    header = read_csv_header(lines)
    columns = header.columns
    rule = MissingRule(zeros=header.zeros_missing)
    if isinstance(columns, Columns):
        frames = read_frames(lines, columns, header.separator, rule, warnings)
        labels = columns.labels
    else:
        frames, labels = read_samples(lines, columns, header.separator, rule, warnings)
    warnings += rule.sentences()
    return Source(
        path=lines.path,
        kind="CSV",
        recording=assemble(lines.path, frames, header.stated(labels), warnings),
        stamp=lines.stamp,
        warnings=tuple(warnings),
    )
