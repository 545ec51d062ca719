"""The figures of every file of a batch, as a table of a page."""

import os
from collections.abc import Sequence
from math import nan
from urllib.parse import quote

from mocapmend.batch.results import Row
from mocapmend.report.tables import MOST_ROWS, Column, Table, number, percent

STATES = {
    "repaired": "repaired",
    "unchanged": "repaired by an earlier run",
    "nothing": "nothing to repair",
    "failed": "failed",
    "waiting": "not done yet",
}


def file_table(rows: Sequence[Row]) -> Table:
    """List files in the order given; their names lead to their copies."""
    shown = rows[:MOST_ROWS]
    return Table(
        (
            Column("File", "name"),
            Column("Result", "name"),
            Column("Frames"),
            Column("Markers"),
            Column("Gaps"),
            Column("Filled"),
            Column("Left open"),
            Column("Samples missing before"),
            Column("after"),
            Column("Expected error, median (mm)"),
            Column("largest (mm)"),
            Column("Filled without estimate"),
            Column("Markers tracked before (%)"),
            Column("after (%)"),
            Column("Bad samples put right"),
            Column("Smoothing, rms shift (mm)"),
            Column("largest (mm)"),
            Column("Seconds"),
            Column("Report"),
        ),
        tuple(map(_row, shown)),
        cut(len(rows)),
        tuple(map(_links, shown)),
    )


def cut(rows: int) -> str:
    """Say that a table has not all of its rows; "" where it has."""
    if rows <= MOST_ROWS:
        return ""
    return f"Of {rows} rows, the first {MOST_ROWS} are shown. summary.csv has all files."


def share(value: float | None) -> str:
    """Write a share in %, or a dash where there is none."""
    return percent(nan if value is None else value)


def _millimetres(value: float | None, decimals: int = 1) -> str:
    return number(nan if value is None else value, decimals)


def _row(row: Row) -> tuple[str, ...]:
    figures, report = row.figures, "report" if row.report else "—"
    if figures is None:
        seconds = number(row.seconds if row.state == "failed" else nan, 1)
        return (row.file, STATES[row.state], *["—"] * 15, seconds, report)
    smoothed = figures.smoothed
    return (
        row.file,
        STATES[row.state],
        *map(
            str,
            (
                figures.frames,
                figures.markers,
                figures.gaps,
                figures.filled,
                figures.left_open,
                figures.samples_missing,
                figures.samples_left,
            ),
        ),
        _millimetres(figures.expected_median_mm),
        _millimetres(figures.expected_worst_mm),
        str(figures.no_estimate),
        share(figures.tracked_before),
        share(figures.tracked_after),
        str(figures.samples_fixed),
        _millimetres(smoothed.rms_mm if smoothed else None, 2),
        _millimetres(smoothed.largest_mm if smoothed else None, 2),
        number(row.seconds, 1),
        report,
    )


def _links(row: Row) -> tuple[str, ...]:
    return _href(row.output), *[""] * 17, _href(row.report)


def _href(path: str | None) -> str:
    # A name may hold a colon, which would make a scheme of what is before it.
    return f"./{quote(os.fsencode(path))}" if path else ""
