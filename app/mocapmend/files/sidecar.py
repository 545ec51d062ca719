"""The repair record beside a file that cannot hold it: NAME.mocapmend.json."""

import hashlib
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from mocapmend.files.atomic import staged, writer_of
from mocapmend.files.opening import cannot_read
from mocapmend.files.provenance import Provenance, decode_sidecar, encode_sidecar

SUFFIX = ".mocapmend.json"
MOST_BYTES = 50_000_000
NO_HASH = "0" * 64
"""Holds the place of a hash that is not known yet."""


def sidecar_path(path: Path) -> Path:
    """Return where the record of a file is; of a link, beside the file that it leads to."""
    path = Path(os.path.realpath(path)) if path.is_symlink() else path
    return path.with_name(path.name + SUFFIX)


def hash_file(path: Path) -> str:
    """Return the SHA-256 of a file.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    try:
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise cannot_read(str(path), error) from error


@contextmanager
def staged_record(path: Path, provenance: Provenance) -> Iterator[Callable[[Provenance], None]]:
    """Prepare the record of a file that is replaced inside the context.

    The record is on the disk before the file is replaced and gets its name after that: neither a
    full disk nor a file that cannot be replaced takes the record of the former file.

    Parameters
    ----------
    path : Path
        The file.
    provenance : Provenance
        Its record; hashes may still be missing, if they are as long as those to come.

    Yields
    ------
    callable
        Takes the record with its hashes and gives it its name, once the file has its own.

    Raises
    ------
    MocapmendError
        If the record cannot be written.
    """
    data = encode_sidecar(provenance, NO_HASH)
    with staged(sidecar_path(path), writer_of(data)) as stage:

        def finish(final: Provenance) -> None:
            stage.overwrite(encode_sidecar(final, hash_file(path)))
            stage.place()

        yield finish


def remove(path: Path) -> None:
    """Remove the record of a file that has been replaced, if there is one."""
    place = sidecar_path(path)
    # What is not a record of ours is not ours to remove.
    with suppress(OSError, ValueError):
        decode_sidecar(_read(place))
        place.unlink()


def read(path: Path, warnings: list[str]) -> Provenance | None:
    """Read the record beside a file, None if there is none or it belongs to another file.

    Raises
    ------
    MocapmendError
        If the file itself cannot be read.
    """
    place = sidecar_path(path)
    try:
        raw = _read(place)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        warnings.append(f"The repair record {place.name} cannot be read: {error}.")
        return None
    try:
        provenance, digest = decode_sidecar(raw)
    except ValueError as error:
        warnings.append(f"The repair record {place.name} cannot be used: {error}.")
        return None
    if hash_file(path) != digest:
        warnings.append(
            f"The repair record {place.name} belongs to another state of this file; "
            "its repairs are taken for measured samples."
        )
        return None
    return provenance


def _read(place: Path) -> bytes:
    if place.stat().st_size > MOST_BYTES:
        raise ValueError("it is too large")
    return place.read_bytes()
