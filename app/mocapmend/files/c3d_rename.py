"""Other labels for the points of a C3D file: the parameter POINT:LABELS, and nothing else.

A label that is no longer than the file's rows is written in place. Otherwise the rows of the
parameter become longer, what follows it moves, and where the section has no room for that it gets
another block.
"""

import struct
from collections.abc import Iterator, Mapping

from mocapmend.files.c3d_head import can_change, with_counts
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_parameters import TEXT, Parameter
from mocapmend.files.c3d_section import LONGEST_RECORD, MOST_BLOCKS, MOST_ROWS, numbered

LABELS = "POINT:LABELS"
END = 2
"""Bytes of the empty record that ends a section."""


def renamed(head: bytes, layout: Layout, labels: Mapping[int, str]) -> bytes | None:
    """Give points other labels.

    Parameters
    ----------
    head : bytes
        The file up to its data.
    layout : Layout
        Of this file.
    labels : mapping of int to str
        The new labels by stored point, from 0.

    Returns
    -------
    bytes or None
        The new head; None where the file does not allow it: it has no row for a point, a label or
        the section would become too long, or its structure is another one.
    """
    parts = list(_parts(layout))
    left, replaced = set(labels), []
    for first, item in parts:
        rows = item.dimensions[1]
        own = {point - first: labels[point] for point in left if first <= point < first + rows}
        left -= {first + row for row in own}
        if own:
            record = _record(head, item, own, layout.processor.byte_order)
            if record is None:
                return None
            replaced.append((item, record))
    if left or not can_change(layout):
        return None
    return _spliced(head, layout, replaced)


def is_label(name: str) -> bool:
    """Say whether a parameter holds labels of points."""
    return name == LABELS or (name.startswith(LABELS) and name.removeprefix(LABELS).isdigit())


def _parts(layout: Layout) -> Iterator[tuple[int, Parameter]]:
    """Yield the parameters that hold the labels, each with the point of its first row."""
    first, part = 0, 1
    while (item := layout.parameters.get(numbered(LABELS, part))) is not None:
        twice = numbered(LABELS, part) in layout.parameters.duplicates
        if twice or item.kind != TEXT or len(item.dimensions) != 2:
            return
        yield first, item
        first, part = first + item.dimensions[1], part + 1


def _record(head: bytes, item: Parameter, labels: Mapping[int, str], order: str) -> bytes | None:
    """Return the record of a parameter with other rows."""
    width, rows = item.dimensions
    texts = {row: label.encode() for row, label in labels.items()}
    stored = [item.raw[width * row : width * (row + 1)] for row in range(rows)]
    wider = max(width, *map(len, texts.values()))
    data = b"".join(texts.get(row, raw).ljust(wider) for row, raw in enumerate(stored))
    added = len(data) - len(item.raw)
    link = item.start + 2 + abs(struct.unpack_from("b", head, item.start)[0])
    (offset,) = struct.unpack_from(order + "H", head, link)
    # An offset of 0 marks the last record.
    offset = offset + added if offset else 0
    if wider > MOST_ROWS or offset > LONGEST_RECORD or len(item.raw) != width * rows:
        return None
    between = bytearray(head[link + 2 : item.data])
    between[2] = wider
    after = head[item.data + len(item.raw) : item.stop]
    return (
        head[item.start : link] + struct.pack(order + "H", offset) + bytes(between) + data + after
    )


def _spliced(head: bytes, layout: Layout, replaced: list[tuple[Parameter, bytes]]) -> bytes | None:
    """Put other records in the places of some, and keep the section in whole blocks."""
    start = layout.parameters_start
    end = start + head[start + 2] * BLOCK
    stop = layout.parameters.stop
    added = sum(len(record) - (item.stop - item.start) for item, record in replaced)
    room = end - stop - END
    blocks = max(0, -(-(added - room) // BLOCK)) if added else 0
    if added and (not stop <= end <= len(head) or any(head[stop:end])):
        return None
    if head[start + 2] + blocks > MOST_BLOCKS:
        return None
    changed = with_counts(head, layout, blocks, start // BLOCK) if blocks else head
    if changed is None:
        return None
    padding = bytes(end + blocks * BLOCK - stop - added) if added else changed[stop:end]
    body, at = b"", 0
    for item, record in sorted(replaced, key=lambda pair: pair[0].start):
        body += changed[at : item.start] + record
        at = item.stop
    return body + changed[at:stop] + padding + changed[end:]
