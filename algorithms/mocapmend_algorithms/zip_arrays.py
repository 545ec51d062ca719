"""The arrays of an .npz file, checked before anything is allocated; nothing is unpickled."""

import errno
import re
import struct
import zlib
from collections.abc import Mapping
from io import FileIO
from typing import Any, BinaryIO, Literal
from zipfile import ZIP_DEFLATED, ZIP_STORED, BadZipFile, LargeZipFile, ZipFile, ZipInfo

import numpy as np
from numpy.typing import NDArray

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

UNIX = 3
"""What ZIP files call the system that made them."""

MAGIC = b"\x93NUMPY"
HEADER = re.compile(
    rb"\{\s*'descr':\s*'([<>|=]?[a-zA-Z]\d{1,9})',\s*'fortran_order':\s*(True|False),"
    rb"\s*'shape':\s*\(((?:\d{1,18},?\s*)*)\),?\s*\}\s*"
)
KINDS = "bfiuUS"

BROKEN = (
    BadZipFile, LargeZipFile, zlib.error, struct.error, EOFError, ValueError, TypeError,
    NotImplementedError, RuntimeError, OverflowError, OSError,
)  # fmt: skip
"""What the standard library raises for damaged archives, and what the system does."""


class ArchiveError(Exception):
    """An archive is damaged, or asks for more memory than its size justifies; a sentence."""


class ZipArrays:
    """The arrays of an open .npz file, by name.

    Parameters
    ----------
    stream : FileIO
        The file.

    Raises
    ------
    ArchiveError
        If it is no such archive.
    OSError
        If the system cannot read it.
    """

    def __init__(self, stream: FileIO) -> None:
        try:
            _check_directory(stream)
            self._zip = ZipFile(stream)
        except BROKEN as error:
            raise _broken("This is not an .npz file, or it is damaged.", error) from error
        # A name that leads elsewhere is only a name: nothing is written to the disk.
        self._members = {info.filename: info for info in self._zip.infolist()}

    def __contains__(self, name: str) -> bool:
        return f"{name}.npy" in self._members

    @property
    def names(self) -> tuple[str, ...]:
        """What the arrays are called."""
        return tuple(n.removesuffix(".npy") for n in self._members if n.endswith(".npy"))

    @property
    def bytes(self) -> int:
        """What all arrays need together, as the archive declares it."""
        return sum(info.file_size for info in self._members.values())

    def read(self, name: str) -> NDArray[Any]:
        """Read an array of numbers or text.

        Raises
        ------
        ArchiveError
            If it is not there, damaged, of another type, or larger than the file can justify.
        OSError
            If the system cannot read it.
        """
        info = self._members.get(f"{name}.npy")
        if info is None:
            raise ArchiveError(f"The file has no array “{name}”.")
        if info.compress_type not in {ZIP_STORED, ZIP_DEFLATED} or info.flag_bits & 1:
            raise ArchiveError(f"The array “{name}” is encrypted or compressed in an unknown way.")
        if info.file_size > max(FREE_BYTES, BELIEVABLE_RATIO * info.compress_size):
            raise ArchiveError(
                f"The array “{name}” would grow from {info.compress_size} to {info.file_size} "
                "bytes; that is not believable."
            )
        try:
            return self._array(name, info)
        except BROKEN as error:
            raise _broken(f"The array “{name}” is damaged.", error) from error

    def _array(self, name: str, info: ZipInfo) -> NDArray[Any]:
        with self._zip.open(info) as member:
            magic = member.read(8)
            wide = magic[6:7] != b"\1"
            length = int.from_bytes(member.read(4 if wide else 2), "little")
            if magic[:6] != MAGIC or length > LONGEST_HEADER:
                raise ArchiveError(f"“{name}” is no array.")
            header = HEADER.fullmatch(member.read(length))
            if header is None or not set(header[1].decode()) & set(KINDS):
                raise ArchiveError(f"“{name}” is no array of numbers or text.")
            dtype = np.dtype(header[1].decode())
            shape = tuple(int(size) for size in re.findall(rb"\d+", header[3]))
            count = 1
            for size in shape:
                count *= size
            start = len(magic) + (4 if wide else 2) + length
            if count * dtype.itemsize != info.file_size - start:
                raise ArchiveError(f"The size of “{name}” is not what its header says.")
            # Told how much, it stops there: what follows may grow without end.
            raw = member.read(info.file_size - start)
        order: Literal["F", "C"] = "F" if header[2] == b"True" else "C"
        array: NDArray[Any] = np.ndarray(shape, dtype, buffer=raw, order=order)
        return array


def write_arrays(stream: BinaryIO, arrays: Mapping[str, NDArray[Any]], *, compress: bool) -> None:
    """Write an .npz file: the same arrays give the same bytes.

    As `numpy.savez`, which may pickle what it does not know.

    Parameters
    ----------
    stream : BinaryIO
        Open for writing.
    arrays : mapping of str to ndarray
        Numbers and text.
    compress : bool
        Whether to make it smaller.
    """
    with ZipFile(stream, "w") as archive:
        for name, array in arrays.items():
            # With the time that stands for none, and one system whatever it is.
            info = ZipInfo(f"{name}.npy")
            info.create_system = UNIX
            info.compress_type = ZIP_DEFLATED if compress else ZIP_STORED
            with archive.open(info, "w", force_zip64=True) as member:
                np.lib.format.write_array(member, array, allow_pickle=False)


def _broken(what: str, error: Exception) -> Exception:
    # Offsets that are wrong are invalid arguments to the system.
    if isinstance(error, OSError) and error.errno != errno.EINVAL:
        return error
    return ArchiveError(what)


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
