"""Changes to what lies before the data of a C3D file: a group added or removed, another scale.

A group goes to the front of the parameter section and fills whole blocks, so that all that follows
moves as it is; only the numbers that count blocks change.
"""

import struct
from collections.abc import Iterator

import numpy as np

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_numbers import encode_floats
from mocapmend.files.c3d_parameters import FLOAT, INTEGER, read_record
from mocapmend.files.c3d_section import LARGEST_WORD, MOST_BLOCKS

DATA_BLOCK = 16
"""Where the header has the block of the data."""
SCALE = 12
"""Where the header has the scale."""
LABEL_RANGES_KEY = 12345


def can_change(layout: Layout) -> bool:
    """Say whether the parameter section lies before the data, and nothing else counts blocks."""
    return (
        layout.data_start > layout.parameters_start
        and not any(name.endswith(":DATA_START") for name in layout.parameters.duplicates)
        and layout.header.label_ranges_key != LABEL_RANGES_KEY
    )


def insert_group(head: bytes, layout: Layout, records: bytes) -> bytes | None:
    """Put records in front of the others.

    Parameters
    ----------
    head : bytes
        The file up to its data.
    layout : Layout
        Of this file.
    records : bytes
        A whole number of blocks.

    Returns
    -------
    bytes or None
        The new head; None where a count of blocks would become too large, or the file does not
        allow it.
    """
    blocks = len(records) // BLOCK
    at = layout.parameters_start + 4
    if not can_change(layout) or head[at - 2] + blocks > MOST_BLOCKS:
        return None
    changed = with_counts(head, layout, blocks, layout.parameters_start // BLOCK)
    return None if changed is None else changed[:at] + records + changed[at:]


def remove_group(head: bytes, layout: Layout, blocks: int) -> bytes | None:
    """Take records away that `insert_group` has put in, and undo what else it has changed.

    Returns
    -------
    bytes or None
        The head as it was; None where another program has changed it since.
    """
    at = layout.parameters_start + 4
    if not can_change(layout) or head[at - 2] < blocks:
        return None
    changed = with_counts(head, layout, -blocks, layout.parameters_start // BLOCK + blocks)
    return None if changed is None else changed[:at] + changed[at + blocks * BLOCK :]


def leading_blocks(head: bytes, layout: Layout, name: str) -> int:
    """Count the blocks of a group at the front of the section; 0 where it is not there."""
    start = at = layout.parameters_start + 4
    record = read_record(head, at, layout.processor)
    if record is None or record.group >= 0 or record.name != name:
        return 0
    number = -record.group
    while record is not None and abs(record.group) == number:
        at = record.following
        record = read_record(head, at, layout.processor)
    blocks, rest = divmod(at - start, BLOCK)
    return 0 if rest else blocks


def free_group(head: bytes, layout: Layout) -> int | None:
    """Return a group number that no record uses, None if there is none."""
    used = set()
    at = layout.parameters_start + 4
    while (record := read_record(head, at, layout.processor)) is not None:
        used.add(abs(record.group))
        at = record.following
    return next((number for number in range(1, 128) if number not in used), None)


def as_floats(head: bytes, layout: Layout) -> bytes | None:
    """Declare the numbers of a file to be floats: both copies of its scale become negative.

    Returns
    -------
    bytes or None
        None where the file does not allow it.
    """
    if not can_change(layout) or "POINT:SCALE" in layout.parameters.duplicates:
        return None
    changed = bytearray(head)
    scale = encode_floats(np.array([-layout.scale], np.float32), layout.processor).tobytes()
    changed[SCALE : SCALE + 4] = scale
    stated = layout.parameters.get("POINT:SCALE")
    if stated is not None:
        if stated.kind != FLOAT or len(stated.raw) < 4:
            return None
        changed[stated.data : stated.data + 4] = scale
    return bytes(changed)


def with_counts(head: bytes, layout: Layout, blocks: int, above: int) -> bytes | None:
    """Make the section longer, and add as many blocks to each block number above `above` + 1.

    Returns
    -------
    bytes or None
        The head with other numbers; None where one would become too large, or is no integer.
    """
    changed = bytearray(head)
    changed[layout.parameters_start + 2] += blocks
    order = layout.processor.byte_order
    for at in _counts(layout):
        if at is None:
            return None
        (count,) = struct.unpack_from(order + "H", head, at)
        if count - 1 <= above:
            continue
        if count + blocks > LARGEST_WORD:
            return None
        struct.pack_into(order + "H", changed, at, count + blocks)
    return bytes(changed)


def _counts(layout: Layout) -> Iterator[int | None]:
    """Yield where the numbers of blocks are; None for one that is no integer."""
    yield DATA_BLOCK
    for name, item in layout.parameters.items():
        if name.endswith(":DATA_START"):
            yield item.data if item.kind == INTEGER and len(item.raw) >= 2 else None
