"""The repair record beside a file that cannot hold it: NAME.mocapmend.json."""

import hashlib
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from mocapmend.files.atomic import write_atomically
from mocapmend.files.opening import cannot_read
from mocapmend.files.provenance import Provenance, decode_sidecar, encode_sidecar

SUFFIX = ".mocapmend.json"
MOST_BYTES = 200_000_000


def sidecar_path(path: Path) -> Path:
    """Return where the record of a file is."""
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


def write(path: Path, provenance: Provenance, digest: str) -> None:
    """Write the record of a file whose SHA-256 is known.

    Raises
    ------
    MocapmendError
        If it cannot be written.
    """
    data = encode_sidecar(provenance, digest)
    write_atomically(sidecar_path(path), lambda stream: _write(stream, data), lambda written: None)


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


def _write(stream: BinaryIO, data: bytes) -> None:
    stream.write(data)
