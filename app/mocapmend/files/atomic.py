"""Writing a file so that it is either there completely or not at all."""

import errno
import os
import secrets
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from mocapmend.errors import MocapmendError


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
    target = Path(os.path.realpath(target))
    temporary = target.with_name(f".mocapmend-{secrets.token_hex(8)}.tmp")
    try:
        if target.exists() and not target.is_file():
            raise MocapmendError(
                "There is a folder or a device of this name.", str(target), "Choose another name."
            )
        _write_through(temporary, target, write)
        verify(temporary)
        temporary.replace(target)
    except OSError as error:
        raise _cannot_write(target, error) from error
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
    _sync_folder(target.parent)


def same_file(first: Path, second: Path) -> bool:
    """Say whether two paths are one file, through links too; neither need exist."""
    try:
        return first.samefile(second)
    except OSError:
        return os.path.realpath(first) == os.path.realpath(second)


def not_as_written(path: Path, what: str) -> MocapmendError:
    """Return the error of a verification that found something else than what was written."""
    return MocapmendError(
        f"The file did not read back as it was written ({what}); it was removed.",
        str(path.parent),
        "Check the disk, or choose another one.",
    )


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


def _sync_folder(folder: Path) -> None:
    """Bring the new name to the disk, where the system knows how to do that."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


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
