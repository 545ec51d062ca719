"""Writing a file so that it is either there completely or not at all."""

import errno
import os
import secrets
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from mocapmend.errors import MocapmendError

TEMPORARY = ".mocapmend-{}.tmp"
REMNANT_AGE_S = 24 * 3600.0


def write_atomically(
    target: Path, write: Callable[[BinaryIO], None], verify: Callable[[Path], None]
) -> None:
    """Write a file beside its place, verify it, and only then move it there.

    Parameters
    ----------
    target : Path
        Where the file shall be; what was there before is replaced at the end.
    write : callable
        Writes the content into the open temporary file.
    verify : callable
        Reads the temporary file and raises if it is not as it should be.

    Raises
    ------
    MocapmendError
        If it cannot be written. Then, and after whatever `write` and `verify` raise, nothing is
        left behind and a file that was there is untouched.
    """
    with staged(target, write) as stage:
        verify(stage.temporary)
        stage.place()


def write_bytes(target: Path, data: bytes) -> None:
    """Write a file whose content is at hand; see `write_atomically`.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    write_atomically(target, writer_of(data), lambda written: None)


def writer_of(data: bytes) -> Callable[[BinaryIO], None]:
    """Return what writes given bytes into an open file."""

    def write(stream: BinaryIO) -> None:
        stream.write(data)

    return write


@dataclass(frozen=True)
class Stage:
    """A file that is written but does not have its name yet.

    Attributes
    ----------
    temporary : Path
        Where it is.
    target : Path
        Where it shall be.
    """

    temporary: Path
    target: Path

    def overwrite(self, data: bytes) -> None:
        """Replace its bytes by as many others, which the disk has room for."""
        with self.temporary.open("r+b") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())

    def place(self) -> None:
        """Move it to its place; what was there before is replaced."""
        self.temporary.replace(self.target)
        sync_folder(self.target.parent)


@contextmanager
def staged(target: Path, write: Callable[[BinaryIO], None]) -> Iterator[Stage]:
    """Write a file beside its place, and remove it at the end if it was not moved there.

    Parameters
    ----------
    target : Path
        Where the file shall be; through a link, where that leads to.
    write : callable
        Writes the content into the open temporary file.

    Raises
    ------
    MocapmendError
        If it cannot be written, read or moved.
    """
    target = Path(os.path.realpath(target))
    temporary = target.with_name(TEMPORARY.format(secrets.token_hex(8)))
    _remove_remnants(target.parent)
    try:
        if target.exists() and not target.is_file():
            raise MocapmendError(
                "There is a folder or a device of this name.", str(target), "Choose another name."
            )
        _write_through(temporary, target, write)
        yield Stage(temporary, target)
    except OSError as error:
        raise _cannot_write(target, error) from error
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def same_file(first: Path, second: Path) -> bool:
    """Say whether two paths are one file, through links too; neither need exist."""
    try:
        return first.samefile(second)
    except OSError:
        return os.path.realpath(first) == os.path.realpath(second)


def sync_folder(folder: Path) -> None:
    """Bring the new names in a folder to the disk, where the system knows how to do that."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def not_as_written(path: Path, what: str) -> MocapmendError:
    """Return the error of a verification that found something else than what was written."""
    return MocapmendError(
        f"The file did not read back as it was written ({what}); it was removed.",
        str(path.parent),
        "Check the disk, or choose another one.",
    )


def _remove_remnants(folder: Path) -> None:
    """Delete what killed saves have left in a folder; no save that goes on is a day old."""
    with suppress(OSError):
        for path in folder.glob(TEMPORARY.format("[0-9a-f]" * 16)):
            with suppress(OSError):
                if time.time() - path.lstat().st_mtime > REMNANT_AGE_S:
                    path.unlink()


def _write_through(temporary: Path, target: Path, write: Callable[[BinaryIO], None]) -> None:
    """Create the temporary file, fill it and bring it to the disk."""
    # "x" creates it with the permissions that the user's umask gives, unlike the tempfile module.
    with temporary.open("xb") as stream:
        if target.exists():
            with suppress(OSError):
                temporary.chmod(target.stat().st_mode & 0o777)
        write(stream)
        stream.flush()
        os.fsync(stream.fileno())


def _cannot_write(target: Path, error: OSError) -> MocapmendError:
    if error.errno == errno.ENOENT:
        return MocapmendError(
            "The folder does not exist.", str(target.parent), "Create it or choose another."
        )
    if error.errno in {errno.EACCES, errno.EPERM, errno.EROFS}:
        return MocapmendError(
            "You may not write into this folder.", str(target.parent), "Choose another one."
        )
    if error.errno in {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}:
        return MocapmendError(
            "There is not enough space for the file.",
            str(target),
            "Free some space or choose another folder.",
        )
    return MocapmendError(
        f"The file cannot be written: {error.strerror}.", str(target), "Choose another place."
    )
