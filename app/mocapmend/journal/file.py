"""A file of checked lines that one program holds: what is half written or damaged does not count.

A line is the CRC-32 of a JSON object, and the object.
"""

import errno
import json
import os
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
LONGEST_FIRST_LINE = 64 * 2**10
"""Bytes of the first line, which tells a journal from other files."""
LOCKED_BYTE = 2**30
"""On Windows a lock is on bytes, which others cannot read then: one that is never written."""
ATTEMPTS = 5

Event = dict[str, Any]


class JournalFile:
    """An open journal, locked against other programs until it is closed or the program ends.

    The system keeps the lock, so none outlives its program, however that ended.

    Attributes
    ----------
    path : Path
        Where it is.
    damaged : bool
        Whether `events` met a line that was complete and wrong.
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
            # Another program may have taken the empty file for a remnant before it was locked.
            if made._lock() and path.exists():
                sync_folder(folder)
                return made
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

    def append(self, event: Event) -> None:
        """Write an event and bring it to the disk.

        Raises
        ------
        OSError
            If it cannot be written, or if the file would become too large to be read.
        """
        body = json.dumps(event, separators=(",", ":")).encode("ascii")
        line = b"%08x %s\n" % (zlib.crc32(body), body)
        if self._stream.seek(0, os.SEEK_END) + len(line) > LARGEST:
            raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), str(self.path))
        self._stream.write(line)
        self._stream.flush()
        os.fsync(self._stream.fileno())

    def events(self) -> Iterator[tuple[Event, int]]:
        """Read from the beginning to the first line that is half written or damaged.

        Yields
        ------
        event : dict
            What a line holds.
        end : int
            Bytes up to the end of the line.
        """
        end = self._stream.seek(0)
        limit = LONGEST_FIRST_LINE
        while line := self._stream.readline(limit):
            event = _parse(line)
            if event is None:
                self.damaged = line.endswith(b"\n") or len(line) == limit
                return
            end += len(line)
            limit = LARGEST - end
            yield event, end

    def keep(self, end: int) -> None:
        """Cut off what follows; what is appended then stands behind complete lines.

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


def _parse(line: bytes) -> Event | None:
    checksum, _, body = line.removesuffix(b"\n").partition(b" ")
    if not line.endswith(b"\n") or checksum != b"%08x" % zlib.crc32(body):
        return None
    try:
        event = json.loads(body)
    except (ValueError, RecursionError):
        return None
    return event if isinstance(event, dict) else None
