"""The parameter section of a C3D file."""

import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import prod

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_numbers import Processor, decode_floats, decode_integers

TEXT, BYTE, INTEGER, FLOAT = -1, 1, 2, 4


def decode_text(raw: bytes) -> str:
    """Decode text that is UTF-8 in new files and Latin-1 in old ones, without its padding."""
    raw = raw.split(b"\0", 1)[0]
    try:
        return raw.decode("utf-8").strip()
    except UnicodeDecodeError:
        return raw.decode("latin-1").strip()


@dataclass(frozen=True)
class Parameter:
    """One parameter as the file stores it.

    Attributes
    ----------
    kind : int
        Size of an element in bytes: 1, 2 (integer), 4 (float), or -1 for text.
    dimensions : tuple of int
        Fastest first, as the file has them; empty for one element.
    raw : bytes
        The data, as many of them as the file has.
    start, stop : int
        Where its record lies in the file, in bytes.
    data : int
        Where its data begin in the file.
    """

    kind: int
    dimensions: tuple[int, ...]
    raw: bytes
    processor: Processor
    start: int
    stop: int
    data: int

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The texts, without padding; empty if the parameter holds numbers."""
        if self.kind != TEXT:
            return ()
        length = self.dimensions[0] if self.dimensions else 1
        if not length:
            return ()
        return tuple(decode_text(self.raw[i : i + length]) for i in range(0, len(self.raw), length))

    def numbers(self, *, unsigned: bool = False) -> NDArray[np.float64]:
        """Return the numbers in file order; empty if the parameter holds text."""
        if self.kind == FLOAT:
            return decode_floats(self._whole(4), self.processor).astype(np.float64)
        if self.kind == INTEGER:
            integers = decode_integers(self._whole(2), self.processor, unsigned=unsigned)
            return integers.astype(np.float64)
        if self.kind == BYTE:
            return np.frombuffer(self.raw, np.uint8).astype(np.float64)
        return np.zeros(0)

    def _whole(self, size: int) -> bytes:
        return self.raw[: len(self.raw) // size * size]


class Parameters(Mapping[str, Parameter]):
    """Parameters by "GROUP:NAME" in upper case, the first one where a name is repeated.

    Attributes
    ----------
    stop : int
        The byte of the file after the last record.
    duplicates : tuple of str
        Names that occur more than once.
    """

    def __init__(
        self, items: Mapping[str, Parameter], stop: int, duplicates: tuple[str, ...] = ()
    ) -> None:
        self._items = dict(items)
        self.stop = stop
        self.duplicates = duplicates

    def __getitem__(self, key: str) -> Parameter:
        return self._items[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._items)

    def __len__(self) -> int:
        return len(self._items)

    def _parts(self, key: str) -> Iterator[Parameter]:
        # More than 255 entries continue in NAME2, NAME3, ...
        name, number = key, 2
        while name in self._items:
            yield self._items[name]
            name, number = f"{key}{number}", number + 1

    def texts(self, key: str) -> tuple[str, ...]:
        """Return the texts of a parameter and its continuations, empty if there is none."""
        return tuple(text for part in self._parts(key) for text in part.texts)

    def text(self, key: str) -> str:
        """Return the first text of a parameter, empty if there is none."""
        return next(iter(self.texts(key)), "")

    def numbers(self, key: str, *, unsigned: bool = False) -> NDArray[np.float64]:
        """Return the numbers of a parameter and its continuations, empty if there is none."""
        parts = [part.numbers(unsigned=unsigned) for part in self._parts(key)]
        return np.concatenate(parts) if parts else np.zeros(0)

    def number(self, key: str, *, unsigned: bool = False) -> float | None:
        """Return the first number of a parameter if there is one and it is finite."""
        values = self.numbers(key, unsigned=unsigned)
        return float(values[0]) if len(values) and np.isfinite(values[0]) else None


@dataclass(frozen=True)
class Record:
    """The head of a record.

    Attributes
    ----------
    name : str
        In upper case.
    group : int
        Number of its group; negative for the group itself.
    body, following : int
        Where its content and the next record begin.
    """

    name: str
    group: int
    body: int
    following: int


def read_record(raw: bytes, at: int, processor: Processor) -> Record | None:
    """Read the head of the record at a place; None after the last one."""
    if at + 5 > len(raw):
        return None
    length, group = struct.unpack_from("bb", raw, at)
    link = at + 2 + abs(length)
    if length == 0 or group == 0 or link + 2 > len(raw):
        return None
    (offset,) = struct.unpack_from(processor.byte_order + "H", raw, link)
    name = decode_text(raw[at + 2 : link]).upper()
    # An offset of 0 marks the last record; offsets 1 and 2 can only be damage.
    following = link + offset if offset > 2 else len(raw)
    return Record(name, group, link + 2, following)


def parse_parameters(raw: bytes, base: int, processor: Processor) -> Parameters:
    """Parse the records of a parameter section.

    The links between records are followed, not the lengths of their parts: some writers leave
    out the length of a description or declare more data than there are.

    Parameters
    ----------
    raw : bytes
        The section after its four leading bytes, and what lies between it and the data.
    base : int
        Where `raw` begins in the file.
    processor : Processor
        The number format.

    Returns
    -------
    parameters : Parameters
        As many as can be read; damage ends the list early and raises nothing.
    """
    groups: dict[int, str] = {}
    found: list[tuple[int, str, Parameter]] = []
    at = stop = 0
    while (record := read_record(raw, at, processor)) is not None:
        stop = min(record.following, len(raw))
        if record.group < 0:
            groups.setdefault(-record.group, record.name)
        elif (item := _parameter(raw, base, at, record, processor)) is not None:
            found.append((record.group, record.name, item))
            stop = item.stop - base
        at = record.following
    items: dict[str, Parameter] = {}
    duplicates = []
    for group, name, item in found:
        key = f"{groups.get(group, f'#{group}')}:{name}"
        if key in items:
            duplicates.append(key)
        else:
            items[key] = item
    return Parameters(items, base + stop, tuple(duplicates))


def _parameter(
    raw: bytes, base: int, at: int, record: Record, processor: Processor
) -> Parameter | None:
    if record.body + 2 > len(raw):
        return None
    kind, count = struct.unpack_from("bB", raw, record.body)
    data = record.body + 2 + count
    if kind not in {TEXT, BYTE, INTEGER, FLOAT} or data > len(raw):
        return None
    dimensions = tuple(raw[record.body + 2 : data])
    stop = min(data + abs(kind) * prod(dimensions), record.following, len(raw))
    last = stop if record.following >= len(raw) else record.following
    return Parameter(
        kind, dimensions, raw[data:stop], processor, base + at, base + last, base + data
    )
