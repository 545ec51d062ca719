"""Lines of separated cells: their texts and their numbers."""

import csv
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.text import Block, Lines

MISSING_WORDS = frozenset({"", "nan", "na", "n/a", "null", "none", "-", "--", "missing"})
FREE_CELLS = 100_000
"""Cells that lines which end early may lack before it counts."""

Numbers = NDArray[np.float64]


def split(line: str, separator: str | None, *, quoted: bool = True) -> list[str]:
    """Return the cells of a line without the spaces around them."""
    if separator is None or not quoted:
        return [cell.strip() for cell in line.split(separator)]
    try:
        return [cell.strip() for row in csv.reader([line], delimiter=separator) for cell in row]
    except csv.Error:
        return []


def number(cell: str, separator: str | None = ",") -> float:
    """Return the number in a cell, NaN where there is none.

    Where commas do not separate cells they may be decimal.
    """
    cell = cell.strip()
    try:
        # Python would read 1_0 as 10.
        cell = cell.replace("_", "?")
        return float(cell if separator == "," else cell.replace(",", "."))
    except ValueError:
        return math.nan


def read_numbers(
    lines: Lines,
    block: Block,
    columns: Sequence[int],
    separator: str | None,
    *,
    quoted: bool = True,
) -> Numbers:
    """Return the numbers in some columns of a block of lines, none of which may be blank.

    Parameters
    ----------
    lines : Lines
        Of the block, for error messages.
    block : Block
        Lines.
    columns : sequence of int
        Which cells to read, from 0.
    separator : str or None
        Between cells, None for any number of spaces and tabs; where it is no comma, commas may be
        decimal.
    quoted : bool
        Whether cells may be enclosed in quotation marks.

    Returns
    -------
    ndarray, shape (lines of the block, columns), float64
        NaN where a cell is empty, says that a number is missing, or lies beyond the line's end.

    Raises
    ------
    MocapmendError
        If a cell holds something else, or lines lack most of their cells.
    """
    text = "\n".join(["", *block.lines, ""])
    if quoted and '"' in text:
        return _cell_by_cell(lines, block, columns, separator, quoted=True)
    try:
        numbers: Numbers = np.loadtxt(
            _filled(text, separator),
            delimiter=separator,
            usecols=columns,
            comments=None,
            ndmin=2,
        )
    except ValueError:
        return _cell_by_cell(lines, block, columns, separator, quoted=quoted)
    return numbers


def read_rows(
    lines: Lines, block: Block, separator: str | None, *, quoted: bool = True
) -> list[list[str]]:
    """Return the cells of a block of lines.

    Raises
    ------
    MocapmendError
        If a quotation mark is left open.
    """
    if separator is None or not quoted:
        return [line.split(separator) for line in block.lines]
    try:
        rows = list(csv.reader(block.lines, delimiter=separator))
    except csv.Error:
        rows = []
    if len(rows) != len(block.lines):
        first, last = block.numbers[0], block.numbers[-1]
        raise lines.error(f"A quotation mark is not closed between line {first} and line {last}.")
    return rows


def not_a_number(lines: Lines, line_number: int, cell: str) -> MocapmendError:
    """Return the error for a cell in a line."""
    return lines.error(f"Line {line_number} has “{cell.strip():.30}” where a number belongs.")


def to_float(cell: str, separator: str | None) -> float | None:
    """Return the number in a cell, NaN for what says that it is missing, else None."""
    value = number(cell, separator)
    return None if math.isnan(value) and cell.strip().lower() not in MISSING_WORDS else value


def _filled(text: str, separator: str | None) -> list[str]:
    """Return the lines with "nan" in their empty cells, which numpy cannot read."""
    if separator != ",":
        text = text.replace(",", ".")
    if separator is None:
        return text.split("\n")[1:-1]
    nan = f"{separator}nan{separator}"
    double = separator * 2
    if double in text:
        # Once more for the second of two neighbours.
        text = text.replace(double, nan).replace(double, nan)
    text = text.replace(f"\n{separator}", f"\nnan{separator}")
    text = text.replace(f"{separator}\n", f"{separator}nan\n")
    return text.split("\n")[1:-1]


def _cell_by_cell(
    lines: Lines, block: Block, columns: Sequence[int], separator: str | None, *, quoted: bool
) -> Numbers:
    rows = read_rows(lines, block, separator, quoted=quoted)
    if len(rows) * len(columns) > 4 * sum(map(len, rows)) + FREE_CELLS:
        raise lines.error(f"Most lines after line {block.numbers[0]} end before their last column.")
    numbers = np.full((len(rows), len(columns)), np.nan)
    for i, row in enumerate(rows):
        width = len(row)
        cells = [row[column] if column < width else "" for column in columns]
        values = [to_float(cell, separator) for cell in cells]
        if None in values:
            raise not_a_number(lines, block.numbers[i], cells[values.index(None)])
        numbers[i] = values
    return numbers
