"""Tables of numbers alone: no header says what their columns are."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.cells import read_numbers, to_float
from mocapmend.files.formats.text import Lines

SEPARATORS = (",", ";", "\t", None)
"""None for any number of spaces and tabs; between others than commas, commas may be decimal."""
MOST_COLUMNS = 1000
"""No known kind of table without a header has more."""


@dataclass(frozen=True, eq=False)
class NumberTable:
    """What the first lines of such a table show.

    Attributes
    ----------
    separator : str or None
        Between cells, None for any number of spaces and tabs.
    rows : ndarray, shape (n, columns)
        The first lines that are as long as the first and hold nothing but numbers, NaN where one
        is missing.
    """

    separator: str | None
    rows: NDArray[np.float64]

    @property
    def columns(self) -> int:
        """Numbers in a line."""
        return int(self.rows.shape[1])


def number_table(head: Sequence[str]) -> NumberTable | None:
    """Recognise a table of numbers by its first lines: the first and most others are numbers.

    A separator at the end of the lines does not count.
    """
    lines = [line for line in head if line.strip()]
    for separator in SEPARATORS:
        first = _numbers(lines[0], separator) if lines else None
        if first is None or len(first) < 2:
            continue
        rows = [_numbers(line, separator) for line in lines]
        same = [row for row in rows if row is not None and len(row) == len(first)]
        if 2 * len(same) > len(lines):
            return NumberTable(separator, np.array(same))
    return None


def read_table(lines: Lines, table: NumberTable, warnings: list[str]) -> NDArray[np.float64]:
    """Read all lines of a table of numbers.

    Parameters
    ----------
    lines : Lines
        Of the file, from its first.
    table : NumberTable
        What they look like.
    warnings : list of str
        Gets a sentence about a last line that is cut off.

    Returns
    -------
    ndarray, shape (frames, columns)
        NaN where a number is missing.

    Raises
    ------
    MocapmendError
        If a line is longer or shorter than the first, or has something else than numbers.
    """
    parts = [np.empty((0, table.columns))]
    for every in lines.blocks():
        block = every.without_blank(table.separator or "\t")
        lengths = [_length(line, table.separator) for line in block.lines]
        if lines.cut and lengths and lengths[-1] < table.columns:
            warnings.append("The last line is cut off; it is left out.")
            del block.lines[-1], lengths[-1]
        for number, length in zip(block.numbers, lengths, strict=False):
            if length != table.columns:
                raise lines.error(
                    f"Line {number} has {length} numbers, but the first line has {table.columns}."
                )
        if block.lines:
            columns = range(table.columns)
            parts.append(read_numbers(lines, block, columns, table.separator, quoted=False))
    return np.concatenate(parts)


def _length(line: str, separator: str | None) -> int:
    if separator is None:
        return len(line.split())
    return line.count(separator) + (not line.rstrip(" ").endswith(separator))


def _numbers(line: str, separator: str | None) -> list[float] | None:
    """Return the numbers of a line, None if it has anything else."""
    length = _length(line, separator)
    if length > MOST_COLUMNS:
        return None
    values = []
    for cell in line.split(separator)[:length]:
        value = to_float(cell, separator)
        if value is None:
            return None
        values.append(value)
    return values
