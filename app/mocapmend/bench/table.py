"""A benchmark's result: rows with a figure, what it is held against, and their ratio."""

import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

HEADERS = ("what", "median", "against", "ratio", "target")


@dataclass(frozen=True)
class Row:
    """One figure.

    Attributes
    ----------
    what : str
        What was measured.
    figure : float or None
        Median over the runs; None where there is none.
    unit : str
        Of `figure`.
    against : str
        The peer or limit that it is held against.
    ratio : float or None
        Median of the run-by-run ratios to the peer, or the ratio to the limit.
    target : str
        What the ratio should be, such as "<= 3".
    note : str
        Why there is no figure.
    """

    what: str
    figure: float | None
    unit: str
    against: str = ""
    ratio: float | None = None
    target: str = ""
    note: str = ""


@dataclass
class Table:
    """The rows of a benchmark and the machine that they were measured on.

    Attributes
    ----------
    title : str
        What was measured.
    rows : list of Row
        The figures.
    failed : bool
        Whether the program did something wrong: then the command ends with code 1.
    """

    title: str
    rows: list[Row] = field(default_factory=list)
    failed: bool = False

    def as_json(self) -> dict[str, Any]:
        """Return the table for a JSON document."""
        return {
            "title": self.title,
            "machine": machine(),
            "rows": [asdict(row) for row in self.rows],
        }

    def as_markdown(self) -> str:
        """Return the table as the documentation has it."""
        rows = []
        for row in self.rows:
            ratio = "" if row.ratio is None else f"{row.ratio:.2f}"
            figure = row.note if row.figure is None else _figure(row.figure, row.unit)
            rows.append([row.what, figure, row.against, ratio, row.target])
        lines = [f"{self.title}  ", machine(), "", *markdown(HEADERS, rows)]
        return "\n".join(lines) + "\n"


def markdown(headers: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table."""
    rule = "|" + "---|" * len(headers)
    return [_line(headers), rule, *(_line(row) for row in rows)]


def machine() -> str:
    """Return what the figures depend on, in a line."""
    return (
        f"{os.cpu_count()} cores, {platform.machine()}, {platform.system()}, "
        f"Python {platform.python_version()}, numpy {np.__version__}"
    )


def _figure(value: float, unit: str) -> str:
    """Write a measured figure, or a count, which has no unit, with all its digits."""
    return f"{value:.3g} {unit}" if unit else f"{value:,.0f}"


def _line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cells) + " |"
