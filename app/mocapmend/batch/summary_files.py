"""The summary of a batch as files in its output folder: a page to read and a table to compute."""

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from mocapmend.batch.results import Reason, Row
from mocapmend.batch.summary_page import Facts, contents
from mocapmend.batch.totals import by_need
from mocapmend.files.atomic import write_bytes
from mocapmend.report.page import lay_out
from mocapmend.wording import count

PAGE, TABLE = "summary.html", "summary.csv"
SUMMARIES = (PAGE, TABLE)
COLUMNS = (
    "file", "state", "frames", "markers", "rate_hz", "gaps", "filled", "left_open",
    "samples_missing", "samples_filled", "reasons", "expected_median_mm", "expected_worst_mm",
    "worst_place", "no_estimate", "tracked_before_percent", "wrong_before_percent",
    "tracked_after_percent",
    "fixed", "fixed_samples", "smoothed_markers", "smoothing_rms_mm", "smoothing_largest_mm",
    "seconds", "output", "report", "warnings", "error", "todo",
)  # fmt: skip


def write_summaries(rows: Sequence[Row], facts: Facts, out: Path) -> tuple[Path, Path]:
    """Write page and table of a batch; those of an earlier run are replaced.

    Returns
    -------
    page, table : Path

    Raises
    ------
    MocapmendError
        If they cannot be written.
    """
    page, table = out / PAGE, out / TABLE
    ordered = by_need(rows)
    # Names of files may hold bytes that are no text.
    write_bytes(table, encode_table(ordered).encode("utf-8", "backslashreplace"))
    text = lay_out(contents(ordered, facts))
    write_bytes(page, text.encode("utf-8", "backslashreplace"))
    return page, table


def encode_table(rows: Sequence[Row]) -> str:
    """Return a CSV table with a line per file, in the order given."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows([_cell(value) for value in _values(row)] for row in rows)
    return stream.getvalue()


def reason_text(reason: Reason) -> str:
    """Say why gaps stayed open, and how many."""
    such = ", such as" if reason.gaps > 1 else ""
    return f"{count(reason.gaps, 'gap')}{such}: {reason.example}"


def _values(row: Row) -> tuple[Any, ...]:
    figures, problem = row.figures, row.problem
    measured: tuple[Any, ...] = (None,) * 21
    warnings: tuple[str, ...] = ()
    if figures is not None:
        warnings, smoothed = figures.warnings, figures.smoothed
        measured = (
            figures.frames, figures.markers, figures.rate_hz, figures.gaps, figures.filled,
            figures.left_open, figures.samples_missing, figures.samples_filled,
            "; ".join(map(reason_text, figures.reasons)), figures.expected_median_mm,
            figures.expected_worst_mm, figures.worst_place, figures.no_estimate,
            figures.tracked_before, figures.wrong_before, figures.tracked_after,
            "; ".join(f"{each.kind}: {count(each.runs, 'run')}" for each in figures.fixed),
            figures.samples_fixed, smoothed.markers if smoothed else 0,
            smoothed.rms_mm if smoothed else None, smoothed.largest_mm if smoothed else None,
        )  # fmt: skip
    return (
        row.file, row.state, *measured, row.seconds, row.output, row.report, " ".join(warnings),
        problem.what if problem else None, problem.todo if problem else None,
    )  # fmt: skip


def _cell(value: Any) -> str:
    """Write a value; one that is not known is empty."""
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else str(value)
