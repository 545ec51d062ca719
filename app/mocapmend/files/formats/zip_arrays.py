"""The arrays of an .npz file, checked before anything is allocated; nothing is unpickled."""

import errno
import re
import struct
import zlib
from io import FileIO
from pathlib import Path
from typing import Any, Literal
from zipfile import ZIP_DEFLATED, ZIP_STORED, BadZipFile, LargeZipFile, ZipFile, ZipInfo

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.opening import ANOTHER_FILE, cannot_read

FREE_BYTES = 64 << 20
"""An array of this size is read however small its compressed form is."""
BELIEVABLE_RATIO = 20
"""Recordings shrink to half; those with few present samples, to a tenth."""
LARGEST_DIRECTORY = 1 << 20
"""Bytes of the list of what is in the archive; a recording has about ten arrays."""
LONGEST_HEADER = 4096

END = b"PK\5\6"
END_BYTES = 22
LONGEST_COMMENT = 65535
LOCATOR_64 = b"PK\6\7"
LOCATOR_64_BYTES = 20

MAGIC = b"\x93NUMPY"
HEADER = re.compile(
    rb"\{\s*'descr':\s*'([<>|=]?[a-zA-Z]\d{1,9})',\s*'fortran_order':\s*(True|False),"
    rb"\s*'shape':\s*\(((?:\d{1,18},?\s*)*)\),?\s*\}\s*"
)
KINDS = "fiuUS"

BROKEN = (
    BadZipFile, LargeZipFile, zlib.error, struct.error, EOFError, ValueError, TypeError,
    NotImplementedError, RuntimeError, OverflowError, OSError,
)  # fmt: skip
"""What the standard library raises for damaged archives, and what the system does."""


class ZipArrays:
    """The arrays of an open .npz file, by name.

    Parameters
    ----------
    stream : FileIO
        The file.
    path : Path
        Its name, for messages.

    Raises
    ------
    MocapmendError
        If it is no such archive.
    """

    def __init__(self, stream: FileIO, path: Path) -> None:
        self._path = path
        try:
            _check_directory(stream)
            self._zip = ZipFile(stream)
        except BROKEN as error:
            raise self._broken("This is not an .npz file, or it is damaged.", error) from error
        # A name that leads elsewhere is only a name: nothing is written to the disk.
        self._members = {info.filename: info for info in self._zip.infolist()}

    def __contains__(self, name: str) -> bool:
        return f"{name}.npy" in self._members

    def read(self, name: str) -> NDArray[Any]:
        """Read an array of numbers or text.

        Raises
        ------
        MocapmendError
            If it is not there, damaged, of another type, or larger than the file can justify.
        """
        info = self._members.get(f"{name}.npy")
        if info is None:
            raise self._error(f"The file has no array “{name}”.")
        if info.compress_type not in {ZIP_STORED, ZIP_DEFLATED} or info.flag_bits & 1:
            raise self._error(f"The array “{name}” is encrypted or compressed in an unknown way.")
        if info.file_size > max(FREE_BYTES, BELIEVABLE_RATIO * info.compress_size):
            raise self._error(
                f"The array “{name}” would grow from {info.compress_size} to {info.file_size} "
                "bytes; that is not believable."
            )
        try:
            return self._array(name, info)
        except BROKEN as error:
            raise self._broken(f"The array “{name}” is damaged.", error) from error

    def _array(self, name: str, info: ZipInfo) -> NDArray[Any]:
        with self._zip.open(info) as member:
            magic = member.read(8)
            wide = magic[6:7] != b"\1"
            length = int.from_bytes(member.read(4 if wide else 2), "little")
            if magic[:6] != MAGIC or length > LONGEST_HEADER:
                raise self._error(f"“{name}” is no array.")
            header = HEADER.fullmatch(member.read(length))
            if header is None or not set(header[1].decode()) & set(KINDS):
                raise self._error(f"“{name}” is no array of numbers or text.")
            dtype = np.dtype(header[1].decode())
            shape = tuple(int(size) for size in re.findall(rb"\d+", header[3]))
            count = 1
            for size in shape:
                count *= size
            start = len(magic) + (4 if wide else 2) + length
            if count * dtype.itemsize != info.file_size - start:
                raise self._error(f"The size of “{name}” is not what its header says.")
            raw = member.read()
        order: Literal["F", "C"] = "F" if header[2] == b"True" else "C"
        array: NDArray[Any] = np.ndarray(shape, dtype, buffer=raw, order=order)
        return array

    def _broken(self, what: str, error: Exception) -> MocapmendError:
        # Offsets that are wrong are invalid arguments to the system.
        if isinstance(error, OSError) and error.errno != errno.EINVAL:
            return cannot_read(str(self._path), error)
        return self._error(what)

    def _error(self, what: str) -> MocapmendError:
        return MocapmendError(what, str(self._path), ANOTHER_FILE)


def _check_directory(stream: FileIO) -> None:
    """Refuse a list of contents that would fill the memory; the library reads it as a whole."""
    size = stream.seek(0, 2)
    start = max(size - END_BYTES - LONGEST_COMMENT - LOCATOR_64_BYTES, 0)
    stream.seek(start)
    tail = stream.read(size - start) or b""
    at = tail.rfind(END)
    if at < 0 or len(tail) - at < END_BYTES:
        raise BadZipFile("no end record")
    (directory,) = struct.unpack_from("<I", tail, at + 12)
    if directory > LARGEST_DIRECTORY or tail[:at][-LOCATOR_64_BYTES:].startswith(LOCATOR_64):
        raise BadZipFile("directory too large")
    stream.seek(0)
