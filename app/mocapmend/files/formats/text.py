"""Text files of unknown encoding and size, read block by block."""

import codecs
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import FileIO, IncrementalNewlineDecoder
from pathlib import Path

from mocapmend.errors import MocapmendError
from mocapmend.files.opening import ANOTHER_FILE, Stamp, cannot_read, open_file, too_large

BLOCK = 1 << 20
"""Bytes that are read at a time."""
LONGEST_LINE = 4 << 20
"""Characters; 20,000 markers with 20 digits a number need less than 2 million."""


@dataclass
class Block:
    """Some lines of a file.

    Attributes
    ----------
    lines : list of str
        Without their ends.
    numbers : sequence of int
        Of the lines in the file, from 1.
    """

    lines: list[str]
    numbers: Sequence[int]

    def to_blank(self) -> "Block":
        """Return the lines before the first blank one."""
        blank = next((i for i, line in enumerate(self.lines) if not line.strip(" ")), None)
        return Block(self.lines[:blank], self.numbers[:blank])

    def without_blank(self, separator: str = "") -> "Block":
        """Return the lines with anything but spaces and the separator."""
        kept = [i for i, line in enumerate(self.lines) if line.strip(f" {separator}")]
        if len(kept) == len(self.lines):
            return self
        return Block([self.lines[i] for i in kept], [self.numbers[i] for i in kept])


class Lines:
    """The lines of a text file, from the first to the last, without their ends.

    Attributes
    ----------
    path : Path
        Of the file.
    stamp : Stamp
        Of the file when it was opened.
    number : int
        Of the next line, from 1.
    cut : bool
        Whether the last line is reached and has no end.
    """

    def __init__(self, stream: FileIO, path: Path, stamp: Stamp) -> None:
        self.path = path
        self.stamp = stamp
        self.number = 1
        self.cut = False
        self._stream = stream
        encoding = _encoding(stream, path)
        stream.seek(0)
        self._decoder = IncrementalNewlineDecoder(
            codecs.getincrementaldecoder(encoding)("replace"), translate=True
        )
        self._lines: list[str] = []
        self._rest = ""
        self._ended = False

    def peek(self, count: int) -> list[str]:
        """Return the next lines, fewer where the file ends, and leave them there."""
        while len(self._lines) < count and not self._ended:
            self._read_block()
        return self._lines[:count]

    def skip(self, count: int) -> None:
        """Leave out lines that were peeked at."""
        del self._lines[:count]
        self.number += count

    def blocks(self) -> Iterator[Block]:
        """Yield all other lines in blocks."""
        while self.peek(1):
            lines, self._lines = self._lines, []
            first, self.number = self.number, self.number + len(lines)
            yield Block(lines, range(first, self.number))

    def error(self, what: str, todo: str = ANOTHER_FILE) -> MocapmendError:
        """Return the error for what this file holds."""
        return MocapmendError(what, str(self.path), todo)

    def _read_block(self) -> None:
        raw = _read(self._stream, BLOCK, self.path)
        self._ended = not raw
        parts = (self._rest + self._decoder.decode(raw, final=self._ended)).split("\n")
        self._rest = parts.pop()
        if self._ended and self._rest:
            self.cut = True
            parts.append(self._rest)
        if len(self._rest) > LONGEST_LINE or any(len(part) > LONGEST_LINE for part in parts):
            number = self.number + len(self._lines) + len(parts)
            raise self.error(f"Line {number} or one before it is too long for a text file.")
        self._lines += parts


@contextmanager
def open_text(path: Path) -> Iterator[Lines]:
    """Open a text file in UTF-8, UTF-16 or, where it is neither, the Latin letters of Windows.

    Raises
    ------
    MocapmendError
        If it cannot be opened or read, is empty or no text, or does not fit into memory.
    """
    path = Path(path)
    with open_file(path) as (stream, stamp):
        if not stamp.size:
            raise MocapmendError("The file is empty.", str(path), ANOTHER_FILE)
        try:
            yield Lines(stream, path, stamp)
        except MemoryError:
            raise too_large(str(path)) from None


def _read(stream: FileIO, count: int, path: Path) -> bytes:
    try:
        return stream.read(count) or b""
    except OSError as error:
        raise cannot_read(str(path), error) from error


def _encoding(stream: FileIO, path: Path) -> str:
    head = _read(stream, BLOCK, path)
    if head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    if b"\0" in head:
        even, odd = head[::2].count(0), head[1::2].count(0)
        if 2 * max(even, odd) < 0.4 * len(head) or min(even, odd):
            raise MocapmendError("This is not a text file.", str(path), ANOTHER_FILE)
        return "utf-16-be" if even else "utf-16-le"
    decoder = codecs.getincrementaldecoder("utf-8")()
    try:
        while head:
            decoder.decode(head)
            head = _read(stream, BLOCK, path)
        decoder.decode(b"", final=True)
    except UnicodeDecodeError:
        return "cp1252"
    return "utf-8-sig"
