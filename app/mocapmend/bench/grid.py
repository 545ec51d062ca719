"""Results with columns of their own, and several of them in one document."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mocapmend.bench.table import machine, markdown

Cell = str | bool | int | float | None


@dataclass(frozen=True)
class Column:
    """A column.

    Attributes
    ----------
    key : str
        In the JSON document.
    title : str
        For people.
    form : str
        How numbers are written, as ".1f".
    """

    key: str
    title: str
    form: str = ""

    def text(self, value: Cell) -> str:
        """Write a cell for people."""
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, int | float):
            return format(value, self.form) if math.isfinite(value) else ""
        return value or ""


@dataclass(frozen=True)
class Grid:
    """A table.

    Attributes
    ----------
    key : str
        In the JSON document.
    title : str
        For people.
    columns : sequence of Column
        In their order.
    rows : sequence of mapping of str to Cell
        By the keys of the columns.
    for_people : bool
        Whether it is printed; otherwise it is in the JSON document alone.
    """

    key: str
    title: str
    columns: Sequence[Column]
    rows: Sequence[Mapping[str, Cell]]
    for_people: bool = True

    def as_json(self) -> list[dict[str, Cell]]:
        """Return the rows for a JSON document; what is no number is null."""
        return [
            {column.key: _finite(row[column.key]) for column in self.columns} for row in self.rows
        ]

    def as_markdown(self) -> str:
        """Return the table as the documentation has it."""
        cells = [[column.text(row[column.key]) for column in self.columns] for row in self.rows]
        lines = [self.title, "", *markdown([column.title for column in self.columns], cells)]
        return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Report:
    """Several tables on one subject, and the machine that they were measured on.

    Attributes
    ----------
    title : str
        What was measured.
    grids : sequence of Grid
        The tables.
    notes : sequence of str
        What a reader of the figures must know, in sentences.
    failed : bool
        Whether the program did something wrong: then the command ends with code 1.
    """

    title: str
    grids: Sequence[Grid]
    notes: Sequence[str] = ()
    failed: bool = False

    def as_json(self) -> dict[str, Any]:
        """Return everything for a JSON document."""
        tables = {grid.key: grid.as_json() for grid in self.grids}
        return {"title": self.title, "machine": machine(), "notes": list(self.notes), **tables}

    def as_markdown(self) -> str:
        """Return the printed tables as the documentation has them."""
        head = "  \n".join([self.title, machine(), *self.notes]) + "\n"
        return "\n".join([head, *(g.as_markdown() for g in self.grids if g.for_people)])


def _finite(value: Cell) -> Cell:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def share(part: int, whole: int) -> float:
    """Return a part of a whole, for a cell; NaN of nothing."""
    return part / whole if whole else math.nan
