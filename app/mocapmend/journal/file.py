"""A file of checked records that one program holds: what is half written or damaged does not count.

A record is a line with a CRC-32 and two lengths, a JSON object, bytes that belong to it, and a line
end. The checksum is of the object and the bytes.
"""

import errno
import json
import os
import re
import secrets
import sys
import zlib
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO

from mocapmend.files.atomic import sync_folder

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

SUFFIX = ".journal"
LARGEST = 512 * 2**20
"""Bytes that are written or read at most: some ten million filled samples."""
LONGEST_HEAD = 40
"""Bytes of the line that begins a record."""
HEAD = re.compile(rb"([0-9a-f]{8}) (\d{1,9}) (\d{1,9})\n")
LOCKED_BYTE = 2**30
"""On Windows a lock is on bytes, which others cannot read then: one that is never written."""
ATTEMPTS = 5

Event = dict[str, Any]
Record = tuple[Event, bytes]


class JournalFile:
    """An open journal, locked against other programs until it is closed or the program ends.

    The system keeps the lock, so none outlives its program, however that ended.

    Attributes
    ----------
    path : Path
        Where it is.
    damaged : bool
        Whether `records` met one that was complete and wrong.
    """

    def __init__(self, path: Path, stream: BinaryIO) -> None:
        self.path = path
        self.damaged = False
        self._stream = stream

    @classmethod
    def create(cls, folder: Path) -> "JournalFile":
        """Make an empty journal of a new name.

        Raises
        ------
        OSError
            If that is not possible.
        """
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        for _ in range(ATTEMPTS):
            path = folder / (secrets.token_hex(8) + SUFFIX)
            # What is read and written to the end of the file needs one stream for both.
            made = cls(path, path.open("x+b"))
            try:
                # Another program may have taken the empty file for a remnant before it was locked.
                if made._lock() and path.exists():
                    sync_folder(folder)
                    return made
            except OSError:
                made.discard()
                raise
            made.close()
        raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN), str(folder))

    @classmethod
    def claim(cls, path: Path) -> "JournalFile | None":
        """Open a journal that no program holds; None where one does, or where it is gone.

        Raises
        ------
        OSError
            If it cannot be opened or locked.
        """
        try:
            claimed = cls(path, path.open("r+b"))
        except FileNotFoundError:
            return None
        try:
            free = claimed._lock()
        except OSError:
            claimed.close()
            raise
        if free:
            return claimed
        claimed.close()
        return None

    def append(self, event: Event, data: bytes = b"") -> None:
        """Write a record and bring it to the disk.

        Parameters
        ----------
        event : dict
            What JSON can hold.
        data : bytes
            What it cannot.

        Raises
        ------
        OSError
            If it cannot be written, or if the file would become too large to be read.
        """
        body = json.dumps(event, separators=(",", ":")).encode("ascii")
        head = b"%08x %d %d\n" % (_checksum(body, data), len(body), len(data))
        record = b"".join((head, body, data, b"\n"))
        if self._stream.seek(0, os.SEEK_END) + len(record) > LARGEST:
            raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), str(self.path))
        self._stream.write(record)
        self._stream.flush()
        os.fsync(self._stream.fileno())

    def records(self) -> Iterator[tuple[Record, int]]:
        """Read from the beginning to the first record that is half written or damaged.

        Yields
        ------
        record : tuple of dict and bytes
            What was appended.
        end : int
            Bytes up to the end of the record.

        Raises
        ------
        OSError
            If it cannot be read.
        """
        size = min(LARGEST, self._stream.seek(0, os.SEEK_END))
        end = self._stream.seek(0)
        while head := self._stream.readline(LONGEST_HEAD):
            match = HEAD.fullmatch(head)
            if match is None:
                self.damaged = head.endswith(b"\n") or len(head) == LONGEST_HEAD
                return
            lengths = int(match[2]), int(match[3])
            end += len(head) + sum(lengths) + 1
            if end > size:
                return
            body, data, last = (self._stream.read(length) for length in (*lengths, 1))
            event = _parse(body)
            if event is None or last != b"\n" or int(match[1], 16) != _checksum(body, data):
                self.damaged = True
                return
            yield (event, data), end

    def keep(self, end: int) -> None:
        """Cut off what follows; what is appended then stands behind complete records.

        Raises
        ------
        OSError
            If it cannot be written.
        """
        self._stream.truncate(end)

    def discard(self) -> None:
        """Delete the journal."""
        # One who opened it before it went must not find edits in it.
        with suppress(OSError):
            self._stream.truncate(0)
        # While the lock is held, but Windows deletes no open file.
        with suppress(OSError):
            self.path.unlink()
        self.close()
        with suppress(OSError):
            self.path.unlink()

    def close(self) -> None:
        """Let go of the journal; it stays where it is."""
        with suppress(OSError):
            self._stream.close()

    def _lock(self) -> bool:
        """Take the lock, and say whether it was free."""
        descriptor = self._stream.fileno()
        try:
            if sys.platform == "win32":
                os.lseek(descriptor, LOCKED_BYTE, os.SEEK_SET)
                msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
                os.lseek(descriptor, 0, os.SEEK_SET)
            else:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError):
            return False
        return True


def _checksum(body: bytes, data: bytes) -> int:
    return zlib.crc32(data, zlib.crc32(body))


def _parse(body: bytes) -> Event | None:
    try:
        event = json.loads(body)
    except (ValueError, RecursionError):
        return None
    return event if isinstance(event, dict) else None
