"""Opening files for reading, and the errors that all readers share."""

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import FileIO
from pathlib import Path

from mocapmend.errors import MocapmendError

ANOTHER_FILE = "Choose another file, or export it again from the program that made it."


@dataclass(frozen=True)
class Stamp:
    """Size in bytes and time of change of a file when it was read."""

    size: int
    mtime_ns: int


def cannot_read(where: str, error: OSError) -> MocapmendError:
    """Return the error for a file that the system fails to read."""
    return MocapmendError(f"The file cannot be read: {error.strerror}.", where, "Try a copy of it.")


def changed_on_disk(path: Path) -> MocapmendError:
    """Return the error for a file that is not as it was when it was read."""
    return MocapmendError(
        "The original was changed since it was opened.",
        str(path),
        "Put the former file back under this name to save the repairs, or open it again.",
    )


def too_large(where: str) -> MocapmendError:
    """Return the error for a file that does not fit into memory."""
    return MocapmendError("The recording does not fit into memory.", where, "Close other programs.")


def read_whole(path: Path, most_bytes: int) -> bytes:
    """Return what a small file holds.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    ValueError
        If it is larger than it can be.
    """
    with open_file(path) as (stream, stamp):
        if stamp.size > most_bytes:
            raise ValueError("it is too large")
        return stream.read()


@contextmanager
def open_file(path: Path) -> Iterator[tuple[FileIO, Stamp]]:
    """Open a file for reading.

    Raises
    ------
    MocapmendError
        If it is missing, a folder, or may not or cannot be read.
    """
    try:
        mode = path.stat().st_mode
        # Opening a pipe or a device could wait for ever.
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            raise MocapmendError("This is not an ordinary file.", str(path), ANOTHER_FILE)
        stream = path.open("rb", buffering=0)
    except (FileNotFoundError, NotADirectoryError, ValueError):
        raise MocapmendError(
            "There is no such file.", str(path), "Check the name and the folder."
        ) from None
    except IsADirectoryError:
        raise MocapmendError(
            "This is a folder, not a file.", str(path), "Choose a file in it."
        ) from None
    except PermissionError:
        raise MocapmendError(
            "You may not read this file.", str(path), "Change its permissions or copy it."
        ) from None
    except OSError as error:
        raise cannot_read(str(path), error) from error
    with stream:
        status = os.fstat(stream.fileno())
        yield stream, Stamp(status.st_size, status.st_mtime_ns)
