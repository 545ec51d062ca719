"""Whether a file is as it was: by its stamp, and where that differs by its bytes."""

import os
from pathlib import Path

from mocapmend.batch.results import Seen
from mocapmend.errors import MocapmendError
from mocapmend.files import Stamp
from mocapmend.files.sidecar import hash_file, sidecar_path


def stamp_of(path: Path) -> Stamp | None:
    """Return size and time of change of a file; None where there is none."""
    try:
        status = path.stat()
    except (OSError, ValueError):
        return None
    return Stamp(status.st_size, status.st_mtime_ns)


def is_there(path: Path) -> bool:
    """Say whether something has this name, as far as one may look and a name can be that long."""
    return os.path.exists(path)  # noqa: PTH110 - swallows errors


def see(path: Path) -> Seen:
    """Note how a file is.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    digest, stamp = hash_file(path), stamp_of(path)
    if stamp is None:
        raise MocapmendError("The file has gone meanwhile.", str(path), "Start the batch again.")
    return Seen(stamp.size, stamp.mtime_ns, digest, _record(path))


def is_still(path: Path, seen: Seen) -> bool:
    """Say whether a file and the repair record beside it are as they were."""
    stamp = stamp_of(path)
    if stamp is None or stamp.size != seen.size:
        return False
    try:
        same = stamp.mtime_ns == seen.mtime_ns or hash_file(path) == seen.sha256
        return same and _record(path) == seen.record_sha256
    except MocapmendError:
        return False


def _record(path: Path) -> str:
    beside = sidecar_path(path)
    return hash_file(beside) if os.path.isfile(beside) else ""  # noqa: PTH113 - swallows errors
