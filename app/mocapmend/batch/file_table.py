"""The figures of every file of a batch, as a table of a page."""

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import nan
from urllib.parse import quote

from mocapmend.batch.results import Figures, Row
from mocapmend.report.tables import MOST_ROWS, Column, Table, number, percent

STATES = {
    "repaired": "repaired",
    "unchanged": "repaired earlier",
    "nothing": "nothing to repair",
    "failed": "failed",
    "waiting": "not done yet",
}
UNKNOWN = "—"


@dataclass(frozen=True)
class _Figure:
    """A column: what it says of a file, and whether it is there when that is nothing of any."""

    title: str
    text: Callable[[Figures], str]
    always: bool = True


def share(value: float | None) -> str:
    """Write a share in %, or a dash where there is none."""
    return percent(nan if value is None else value)


def _millimetres(value: float | None, decimals: int = 1) -> str:
    return number(nan if value is None else value, decimals)


FIGURES = (
    _Figure("Frames", lambda of: str(of.frames)),
    _Figure("Gaps", lambda of: str(of.gaps)),
    _Figure("Left open", lambda of: str(of.left_open)),
    _Figure("Samples missing before", lambda of: str(of.samples_missing)),
    _Figure("after", lambda of: str(of.samples_left)),
    _Figure("Expected error, median (mm)", lambda of: _millimetres(of.expected_median_mm)),
    _Figure("largest (mm)", lambda of: _millimetres(of.expected_worst_mm)),
    _Figure("Filled without estimate", lambda of: str(of.no_estimate), always=False),
    _Figure("Markers tracked before (%)", lambda of: share(of.tracked_before)),
    _Figure("there but wrong (%)", lambda of: share(of.wrong_before or 0.0), always=False),
    _Figure("tracked after (%)", lambda of: share(of.tracked_after)),
    _Figure("Bad samples put right", lambda of: str(of.samples_fixed), always=False),
    _Figure(
        "Moved by smoothing, rms (mm)",
        lambda of: _millimetres(of.smoothed.rms_mm if of.smoothed else None, 2),
        always=False,
    ),
    _Figure(
        "at most (mm)",
        lambda of: _millimetres(of.smoothed.largest_mm if of.smoothed else None, 2),
        always=False,
    ),
)
NOTHING = frozenset({UNKNOWN, "0", "0.00"})


def file_table(rows: Sequence[Row]) -> Table:
    """List files in the order given; their names lead to their copies."""
    shown = rows[:MOST_ROWS]
    figures = [column for column in FIGURES if column.always or _says_something(column, shown)]
    reports = any(row.report for row in shown)
    return Table(
        (
            Column("File", "name"),
            *[Column("Report", "word")] * reports,
            Column("Result", "word"),
            *(Column(column.title) for column in figures),
            Column("Seconds"),
        ),
        tuple(
            (
                row.file,
                *["report" if row.report else UNKNOWN] * reports,
                STATES[row.state],
                *(column.text(row.figures) if row.figures else UNKNOWN for column in figures),
                number(nan if row.state == "waiting" else row.seconds, 1),
            )
            for row in shown
        ),
        cut(len(rows)),
        tuple(
            (_href(row.output), *[_href(row.report)] * reports, *[""] * (len(figures) + 2))
            for row in shown
        ),
    )


def cut(rows: int) -> str:
    """Say that a table has not all of its rows; "" where it has."""
    if rows <= MOST_ROWS:
        return ""
    return f"Of {rows} rows, the first {MOST_ROWS} are shown. summary.csv has all files."


def _says_something(column: _Figure, rows: Sequence[Row]) -> bool:
    return any(row.figures and column.text(row.figures) not in NOTHING for row in rows)


def _href(path: str | None) -> str:
    # A name may hold a colon, which would make a scheme of what is before it.
    return f"./{quote(os.fsencode(path))}" if path else ""
