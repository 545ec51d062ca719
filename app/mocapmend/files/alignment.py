"""Two C3D files side by side: with the repair record taken out, and in the same number format."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from io import BytesIO, FileIO

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import c3d_group, c3d_head, c3d_rename
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_reader import analog_unsigned
from mocapmend.files.c3d_samples import (
    BLOCK_BYTES,
    Piece,
    as_float_block,
    read_frames,
    read_part,
    read_pieces,
)


@dataclass(frozen=True, eq=False)
class Side:
    """One of the files.

    Attributes
    ----------
    stream : FileIO
        The file.
    size : int
        In bytes.
    layout : Layout
        As it is.
    head : bytes
        What lies before its frames, without the repair record.
    stored_head : bytes
        The same with it.
    bare : Layout
        As it would be without the repair record.
    record_blocks : int
        Blocks of the repair record.
    added : int
        Bytes by which other labels would make it longer.
    """

    stream: FileIO
    size: int
    layout: Layout
    head: bytes
    stored_head: bytes
    bare: Layout
    record_blocks: int
    added: int = 0


@dataclass(frozen=True, eq=False)
class Alignment:
    """How two files are compared.

    Attributes
    ----------
    layout : Layout
        With which the pieces of both are read.
    before, after : Side or None
        None where the files are compared byte by byte, from their beginning.
    converted : bool
        Whether the integers of the first are floats in the second.
    sizes_fit : bool
        Whether the sizes differ by what the allowed changes make of them.
    """

    layout: Layout
    before: Side | None
    after: Side | None
    converted: bool
    sizes_fit: bool

    @property
    def heads_equal(self) -> bool:
        """Whether the heads are the same as they are stored, as far as they were compared here."""
        if self.before is None or self.after is None:
            return True
        return self.before.stored_head == self.after.stored_head


def read_side(stream: FileIO, size: int, where: str) -> Side:
    """Read a file's head.

    Raises
    ------
    MocapmendError
        If it is not a C3D file.
    """
    layout = read_layout(stream, size, where)
    stream.seek(0)
    head = stream.read(layout.data_start)
    blocks = c3d_head.leading_blocks(head, layout, c3d_group.NAME)
    bare = c3d_head.remove_group(head, layout, blocks) if blocks else None
    if bare is None:
        return Side(stream, size, layout, head, head, layout, 0)
    bare_layout = _layout(bare, size - blocks * BLOCK, layout)
    return Side(stream, size, layout, bare, head, bare_layout, blocks)


def align(
    before: Side, after: Side | None, size: int, labels: Mapping[int, str] | None = None
) -> Alignment:
    """Find out how to compare two files.

    Parameters
    ----------
    before : Side
        The original.
    after : Side or None
        The other one; None where it cannot be read as a C3D file.
    size : int
        Its size in bytes.
    labels : mapping of int to str, optional
        The labels that it has in place of the original's, by stored point.
    """
    if after is not None:
        alike = before.bare, after.bare
        converted = not alike[0].is_float and alike[1].is_float
        if labels:
            before = _with_labels(before, labels)
        if before.record_blocks or after.record_blocks or converted or labels:
            if converted:
                floats = c3d_head.as_floats(before.head, before.bare)
                if floats is None:
                    converted = False
                else:
                    before = replace(before, head=floats)
            return _structured(before, after, converted=converted)
    layout = _limited(before.layout, min(before.size, size))
    return Alignment(layout, None, None, converted=False, sizes_fit=before.size == size)


def _with_labels(side: Side, labels: Mapping[int, str]) -> Side:
    """Return a file as it would be with other labels, if it could have them."""
    head = c3d_rename.renamed(side.head, side.bare, labels)
    if head is None:
        return side
    added = len(head) - len(side.head)
    bare = _layout(head, side.bare.size + added, side.bare)
    return replace(side, head=head, bare=bare, added=added)


def pairs(
    alignment: Alignment, first: FileIO, second: FileIO, names: tuple[str, str]
) -> Iterator[tuple[Piece, Piece]]:
    """Yield pieces of both files that belong together, of equal shape."""
    before, after = alignment.before, alignment.after
    if before is None or after is None:
        yield from zip(
            read_pieces(first, alignment.layout, names[0]),
            read_pieces(second, alignment.layout, names[1]),
            strict=True,
        )
        return
    common = min(len(before.head), len(after.head))
    yield _piece(before.head[:common]), _piece(after.head[:common])
    yield from _frames(alignment, before, after, names)
    rest = [side.size - side.layout.data_stop for side in (before, after)]
    tails = [
        read_part(side.stream, side.layout.data_stop, side.layout.data_stop + min(rest), name)
        for side, name in zip((before, after), names, strict=True)
    ]
    for one, other in zip(*tails, strict=True):
        yield Piece(alignment.layout.data_stop, None, one.raw), other
    if alignment.converted and rest[1] > rest[0]:
        start = after.layout.data_stop + rest[0]
        for piece in read_part(second, start, after.size, names[1]):
            yield Piece(alignment.layout.data_stop, None, np.zeros_like(piece.raw)), piece


def _frames(
    alignment: Alignment, before: Side, after: Side, names: tuple[str, str]
) -> Iterator[tuple[Piece, Piece]]:
    frames = alignment.layout.frames
    step = max(BLOCK_BYTES // max(after.layout.frame_bytes, 1), 1)
    unsigned = analog_unsigned(before.layout)
    for start in range(0, frames, step):
        count = min(step, frames - start)
        one = read_frames(before.stream, before.layout, start, count, names[0])
        if alignment.converted:
            one = as_float_block(one, before.layout, unsigned=unsigned)
        other = read_frames(after.stream, after.layout, start, count, names[1])
        yield Piece(0, start, one), Piece(0, start, other)


def _structured(before: Side, after: Side, *, converted: bool) -> Alignment:
    one, other = before.layout, after.layout
    fits = (one.points, one.channels, one.analog_samples, one.frames) == (
        other.points,
        other.channels,
        other.analog_samples,
        other.frames,
    ) and (converted or one.word == other.word)
    sizes = (
        before.size + before.added - before.record_blocks * BLOCK,
        after.size - after.record_blocks * BLOCK,
    )
    grown = one.frames * one.frame_bytes if converted else 0
    padding = -grown % BLOCK
    sizes_fit = sizes[1] - sizes[0] - grown in {0, padding if converted else 0}
    layout = after.bare
    if not fits:
        # Nothing can be said of the samples: the heads tell what differs.
        layout = replace(layout, frames=0)
    return Alignment(layout, before, after, converted=converted, sizes_fit=sizes_fit and fits)


def _piece(raw: bytes) -> Piece:
    return Piece(0, None, np.frombuffer(raw, np.uint8))


def _layout(head: bytes, size: int, fallback: Layout) -> Layout:
    try:
        return read_layout(BytesIO(head), size, "")
    except MocapmendError:
        return fallback


def _limited(layout: Layout, size: int) -> Layout:
    """Return the layout of the first bytes of a file."""
    start = min(layout.data_start, size)
    frames = (size - start) // layout.frame_bytes if layout.frame_bytes else 0
    return replace(layout, size=size, data_start=start, frames=max(min(layout.frames, frames), 0))
