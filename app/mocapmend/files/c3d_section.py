"""Header and parameter section of a C3D file that is written, as bytes."""

import struct
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import MAGIC
from mocapmend.files.c3d_numbers import Processor, encode_floats, encode_integers
from mocapmend.files.c3d_parameters import FLOAT, INTEGER, TEXT

MOST_ROWS = 255
"""Entries of a parameter, and bytes of a text: the dimensions are single bytes."""
MOST_BLOCKS = 255
LARGEST_WORD = 65535
LONGEST_RECORD = 32767
"""Many readers take the link from a record to the next one for a signed number."""


def group_record(group_id: int, name: str, processor: Processor, description: str = "") -> bytes:
    """Return the record that names a group.

    Parameters
    ----------
    group_id : int
        Its number, 1 to 127; the records of its parameters repeat it.
    name : str
        Its name, at most 127 characters of ASCII.
    processor : Processor
        The number format of the file.
    description : str
        For people; at most 255 bytes of UTF-8.
    """
    return _record(-group_id, name, b"", processor, description)


def text_record(
    group_id: int, name: str, rows: bytes | Sequence[bytes], processor: Processor
) -> bytes:
    """Return the record of a text, or of a table of texts that are padded with spaces.

    Raises
    ------
    ValueError
        If there are more than 255 rows, or one is longer than 255 bytes.
    """
    if isinstance(rows, bytes):
        return _array(group_id, name, TEXT, (len(rows),), rows, processor)
    width = max(map(len, rows), default=1) or 1
    data = b"".join(row.ljust(width) for row in rows)
    return _array(group_id, name, TEXT, (width, len(rows)), data, processor)


def text_records(
    group_id: int, name: str, rows: Sequence[bytes], processor: Processor
) -> list[bytes]:
    """Return the records of any number of texts: NAME, NAME2, NAME3, ..., at least one."""
    width = max(map(len, rows), default=1) or 1
    step = min(MOST_ROWS, (LONGEST_RECORD - 2 * MOST_ROWS) // width)
    starts = range(0, max(len(rows), 1), step)
    return [
        text_record(group_id, numbered(name, part), rows[start : start + step], processor)
        for part, start in enumerate(starts, 1)
    ]


def integer_record(group_id: int, name: str, values: ArrayLike, processor: Processor) -> bytes:
    """Return the record of 16-bit integers, signed or unsigned.

    Parameters
    ----------
    values : array_like of int
        One number, or an array of which the last axis varies fastest in the file.

    Raises
    ------
    ValueError
        If a number needs more than 16 bits, or an axis has more than 255 entries.
    """
    array = np.asarray(values, np.int64)
    if array.size and not -32768 <= array.min() <= array.max() <= LARGEST_WORD:
        raise ValueError(f"{name}: numbers of more than 16 bits")
    data = encode_integers(array.astype(np.uint16).view(np.int16), processor).tobytes()
    return _array(group_id, name, INTEGER, array.shape[::-1], data, processor)


def float_record(group_id: int, name: str, values: ArrayLike, processor: Processor) -> bytes:
    """Return the record of floats; see `integer_record`."""
    array = np.asarray(values, np.float32)
    data = encode_floats(np.atleast_1d(array), processor).tobytes()
    return _array(group_id, name, FLOAT, array.shape[::-1], data, processor)


def numbered(name: str, part: int) -> str:
    """Return the name of a part of a parameter of more than 255 entries, counted from 1."""
    return name if part == 1 else f"{name}{part}"


def section_bytes(records: Iterable[bytes]) -> int:
    """Return the length of a section with these records, not filled up to a whole block."""
    # The lead, and the empty record that ends the section.
    return 4 + sum(map(len, records)) + 2


def parameter_section(
    records: Callable[[int], Iterable[bytes]], processor: Processor, where: str
) -> bytes:
    """Return a parameter section at block 2, filled up to whole blocks.

    Parameters
    ----------
    records : callable
        Returns the records, given the block where the data begin. That is known only when the
        section is long enough for all of them, so it is called twice; their sizes stay the same.
    processor : Processor
        The number format.
    where : str
        The name of the file for messages.

    Raises
    ------
    MocapmendError
        If they do not fit: the section has 255 blocks at most.
    """
    size = section_bytes(records(0))
    blocks = -(-size // BLOCK)
    if blocks > MOST_BLOCKS:
        raise MocapmendError(
            f"All names and events together need {size} bytes, and a C3D file has room for "
            f"{MOST_BLOCKS * BLOCK}.",
            where,
            "Shorten the labels, or save fewer markers or events.",
        )
    lead = bytes([1, MAGIC, blocks, processor])
    return (lead + b"".join(records(2 + blocks))).ljust(blocks * BLOCK, b"\0")


def float_header(
    *,
    points: int,
    analog: int,
    first: int,
    last: int,
    data_block: int,
    analog_samples: int,
    rate: float,
    processor: Processor,
) -> bytes:
    """Return the first block of a file of floats; see `Header` for the words.

    Frame numbers above 65535 stop there: the parameters have all of their digits.
    """
    block = bytearray(BLOCK)
    order = processor.byte_order
    first, last = min(first, LARGEST_WORD), min(last, LARGEST_WORD)
    struct.pack_into(order + "2B5H", block, 0, 2, MAGIC, points, analog, first, last, 0)
    struct.pack_into(order + "2H", block, 16, data_block, analog_samples)
    block[12:16] = encode_floats(np.array([-1.0], np.float32), processor).tobytes()
    block[20:24] = encode_floats(np.array([rate], np.float32), processor).tobytes()
    return bytes(block)


def _record(
    group: int, name: str, body: bytes, processor: Processor, description: str = ""
) -> bytes:
    text = description.encode()
    head = struct.pack("2b", len(name), group) + name.encode("ascii")
    link = struct.pack(processor.byte_order + "H", 2 + len(body) + 1 + len(text))
    return head + link + body + bytes([len(text)]) + text


def _array(
    group_id: int,
    name: str,
    kind: int,
    dimensions: tuple[int, ...],
    data: bytes,
    processor: Processor,
) -> bytes:
    if max(dimensions, default=0) > MOST_ROWS:
        raise ValueError(f"{name}: dimensions {dimensions}, above {MOST_ROWS}")
    body = struct.pack("bB", kind, len(dimensions)) + bytes(dimensions) + data
    return _record(group_id, name, body, processor)
