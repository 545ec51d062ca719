"""Reading the frames of a C3D file block by block, and what their numbers mean.

Damaged floats may be anything: callers ignore the floating-point errors of numpy.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from io import FileIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_numbers import decode_floats, decode_integers, encode_floats
from mocapmend.files.opening import cannot_read

BLOCK_BYTES = 1 << 20
"""About how much is in memory at a time: small enough for the cache of a processor."""

Words = NDArray[Any]
"""Points as they are stored: float32 or int16."""


def read_blocks(
    stream: FileIO, layout: Layout, where: str, start: int = 0, stop: int | None = None
) -> Iterator[tuple[int, NDArray[np.uint8]]]:
    """Yield the frames in blocks: all, or those from `start` up to `stop`.

    Yields
    ------
    first : int
        The first frame of the block, from 0.
    block : ndarray of uint8, shape (frames of the block, layout.frame_bytes)
        Valid until the next block is asked for.

    Raises
    ------
    MocapmendError
        If the file ends early: it was changed since its layout was read.
    """
    stop = layout.frames if stop is None else stop
    if start == stop:
        return
    step = max(BLOCK_BYTES // layout.frame_bytes, 1)
    buffer = np.empty((min(step, stop - start), layout.frame_bytes), np.uint8)
    stream.seek(layout.data_start + start * layout.frame_bytes)
    for first in range(start, stop, step):
        block = buffer[: stop - first]
        fill(stream, block, where)
        yield first, block


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of a file.

    Attributes
    ----------
    offset : int
        Its first byte.
    frame : int or None
        The first of its frames, from 0; None for what lies before and after the frames.
    raw : ndarray of uint8, shape (bytes,) or (frames, layout.frame_bytes)
        Its bytes, valid until the next piece is asked for.
    """

    offset: int
    frame: int | None
    raw: NDArray[np.uint8]


def read_pieces(stream: FileIO, layout: Layout, where: str) -> Iterator[Piece]:
    """Yield the whole file: what lies before the frames, the frames, what follows them.

    Raises
    ------
    MocapmendError
        If the file ends early or cannot be read.
    """
    yield from read_part(stream, 0, layout.data_start, where)
    for first, block in read_blocks(stream, layout, where):
        yield Piece(layout.data_start + first * layout.frame_bytes, first, block)
    yield from read_part(stream, layout.data_stop, layout.size, where)


def read_frames(
    stream: FileIO, layout: Layout, first: int, count: int, where: str
) -> NDArray[np.uint8]:
    """Read some frames, shape (count, layout.frame_bytes)."""
    block = np.empty((count, layout.frame_bytes), np.uint8)
    stream.seek(layout.data_start + first * layout.frame_bytes)
    fill(stream, block, where)
    return block


def read_part(stream: FileIO, start: int, stop: int, where: str) -> Iterator[Piece]:
    """Yield the bytes from `start` up to `stop`."""
    stream.seek(start)
    for offset in range(start, stop, BLOCK_BYTES):
        raw = np.empty(min(BLOCK_BYTES, stop - offset), np.uint8)
        fill(stream, raw, where)
        yield Piece(offset, None, raw)


def fill(stream: FileIO, array: NDArray[np.uint8], where: str) -> None:
    """Fill a contiguous array from a file.

    Raises
    ------
    MocapmendError
        If the file ends before, or the system fails to read it.
    """
    view = array.reshape(-1).data
    at = 0
    while at < len(view):
        # A raw file may return less than asked for.
        try:
            count = stream.readinto(view[at:])
        except OSError as error:
            raise cannot_read(where, error) from error
        if not count:
            raise MocapmendError(
                "The file became shorter while it was read.", where, "Open it again."
            )
        at += count


def point_slots(block: NDArray[np.uint8], layout: Layout) -> NDArray[np.uint8]:
    """View the points of a block as bytes, shape (frames, points, layout.slot)."""
    points = block[:, : layout.points * layout.slot]
    return points.reshape(len(block), layout.points, layout.slot)


def point_words(block: NDArray[np.uint8], layout: Layout) -> Words:
    """Decode the points of a block: x, y, z and the fourth word, shape (frames, points, 4)."""
    raw = block[:, : layout.points * layout.slot]
    if layout.is_float:
        words: Words = decode_floats(raw, layout.processor)
    else:
        words = decode_integers(raw, layout.processor)
    return words.reshape(len(block), layout.points, 4)


def coordinates(words: Words, layout: Layout, axis: int) -> NDArray[np.float32]:
    """Return one coordinate in the file's unit; integers are scaled as float32."""
    if layout.is_float:
        return words[..., axis]
    return np.multiply(words[..., axis], np.float32(layout.scale), dtype=np.float32)


def as_float_block(
    block: NDArray[np.uint8], layout: Layout, *, unsigned: bool
) -> NDArray[np.uint8]:
    """Encode a block of integers as floats: coordinates scaled, all else as it is.

    Parameters
    ----------
    block : ndarray of uint8, shape (frames, layout.frame_bytes)
    layout : Layout
        Of the integers.
    unsigned : bool
        Whether analog values are unsigned.

    Returns
    -------
    ndarray of uint8, shape (frames, 2 * layout.frame_bytes)
    """
    width = layout.frame_bytes // 2
    floats = np.empty((len(block), width), np.float32)
    words = point_words(block, layout)
    points = floats[:, : 4 * layout.points].reshape(words.shape)
    for axis in range(3):
        points[..., axis] = coordinates(words, layout, axis)
    points[..., 3] = words[..., 3]
    analog = block[:, layout.points * layout.slot :]
    floats[:, 4 * layout.points :] = decode_integers(analog, layout.processor, unsigned=unsigned)
    return encode_floats(floats, layout.processor).reshape(len(block), 4 * width)


def marked_missing(fourth: Words) -> NDArray[np.bool_]:
    """Whether the fourth word marks each sample as missing: negative as a signed 16-bit number.

    Vicon Workstation and old Qualisys write the float 65535.0, whose 16 bits are those of -1.
    """
    missing: NDArray[np.bool_] = fourth < 0
    if fourth.dtype.kind == "f" and fourth.size and not fourth.max() < 32768:
        missing |= np.fmod(np.trunc(fourth), 65536) >= 32768
    return missing


def unmarked_missing(words: Words, marked: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether each sample that is not marked is missing all the same, shape (frames, points).

    That is where it is exactly (0, 0, 0), as some writers store a missing one, or not finite.
    """
    x, y, z = words[..., 0], words[..., 1], words[..., 2]
    if words.dtype.kind != "f":
        suspect: NDArray[np.bool_] = np.logical_and((x | y | z) == 0, ~marked)
        return suspect
    # One pass over the block in the usual case: the sum is finite, and rarely zero.
    total = x + y + z
    suspect = ~np.isfinite(total)
    suspect |= total == 0
    suspect &= ~marked
    at = np.nonzero(suspect)
    if len(at[0]):
        rows = words[at][:, :3]
        suspect[at] = ~np.isfinite(rows).all(axis=1) | ~rows.any(axis=1)
    return suspect


def residual_steps(fourth: Words) -> NDArray[np.float32]:
    """Return the residual of each sample in steps of the scale: the low byte of word 4.

    Of samples that are marked as missing the result means nothing.
    """
    if fourth.dtype.kind == "f" and fourth.size:
        highest = fourth.max()
        if highest <= 0:
            return np.zeros(fourth.shape, np.float32)
        if not (highest < 2**31 and fourth.min() > -(2**31)):
            fourth = np.nan_to_num(np.fmod(fourth, 65536), nan=0.0)
    return (fourth.astype(np.int32) & 0xFF).astype(np.float32)


def read_analog_samples(
    stream: FileIO,
    layout: Layout,
    where: str,
    convert: Callable[[NDArray[np.float64]], None],
    *,
    unsigned: bool,
    chosen: Sequence[int] | None = None,
) -> NDArray[np.float64]:
    """Read the analog samples, shape (frames * samples, channels).

    Parameters
    ----------
    stream, layout, where
        See `read_blocks`.
    convert : callable
        Brings some samples from what is stored to their units, in place.
    unsigned : bool
        Whether integers have no sign.
    chosen : sequence of int, optional
        The channels to keep; all by default.
    """
    samples = layout.analog_samples
    channels = layout.channels if chosen is None else len(chosen)
    values = np.empty((layout.frames * samples, channels))
    for first, block in read_blocks(stream, layout, where):
        raw = block[:, layout.points * layout.slot :]
        stored = (
            decode_floats(raw, layout.processor)
            if layout.is_float
            else decode_integers(raw, layout.processor, unsigned=unsigned)
        )
        rows = values[first * samples : (first + len(block)) * samples]
        full = rows if chosen is None else np.empty((len(rows), layout.channels))
        full.reshape(len(block), samples * layout.channels)[...] = stored
        # While they are in the cache.
        convert(full)
        if chosen is not None:
            rows[...] = full[:, chosen]
    return values
