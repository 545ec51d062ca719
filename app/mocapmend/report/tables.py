"""The tables of a report as texts. Long ones are cut, and say so."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isnan
from typing import ClassVar, Literal

from mocapmend.report.model import About, MarkerRow, RepairRow, Report
from mocapmend.report.put_right import PutRight
from mocapmend_algorithms import Gap

MOST_ROWS = 1000
Align = Literal["name", "number", "text", "word"]


@dataclass(frozen=True)
class Column:
    """A heading, and how its cells are set."""

    title: str
    align: Align = "number"


@dataclass(frozen=True)
class Table:
    """Rows of texts.

    Attributes
    ----------
    columns : tuple of Column
        From left to right.
    rows : tuple of tuple of str
        The cells.
    note : str
        What was left out, and where it is; "" where nothing was.
    links : tuple of tuple of str
        Where a page's cells lead, "" for those that lead nowhere; empty where none does.
    """

    kind: ClassVar = "table"
    columns: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str = ""
    links: tuple[tuple[str, ...], ...] = ()


def bones(report: Report) -> Table:
    """List the bones that repairs touch, those most repaired first."""
    touched = [bone for bone in range(len(report.bones)) if report.bone_repairs[bone]]
    touched.sort(key=lambda bone: -report.bone_repairs[bone])
    shown = touched[:MOST_ROWS]
    return Table(
        (
            Column("Bone", "name"),
            Column("Repaired frames"),
            Column("Spread before (%)"),
            Column("after (%)"),
        ),
        tuple(
            (
                report.bone_names[bone],
                str(report.bone_repairs[bone]),
                number(report.spread_before[bone], 2),
                number(report.spread_after[bone], 2),
            )
            for bone in shown
        ),
        _cut(len(touched), len(shown), "bones with the most repaired frames", ""),
    )


def markers(report: Report, rows: Sequence[MarkerRow]) -> Table:
    """List markers, in their own order; where there are too many, those with most missing."""
    shown = list(rows)
    if len(shown) > MOST_ROWS:
        worst = sorted(range(len(shown)), key=lambda i: -shown[i].missing_before)[:MOST_ROWS]
        shown = [shown[i] for i in sorted(worst)]
    return Table(
        (
            Column("Marker", "name"),
            Column("Missing before (%)"),
            Column("after (%)"),
            Column("Gaps before"),
            Column("after"),
            Column("Longest gap before (frames)"),
            Column("after"),
            Column("Longest gap before (ms)"),
            Column("Samples filled"),
            Column("Samples unfilled"),
            Column("Filled by (% of frames)", "text"),
            Column("Largest expected error (mm)"),
        ),
        tuple(_marker(row, report.rate) for row in shown),
        _cut(
            len(rows),
            len(shown),
            "markers that miss most",
            "“mocapmend info --json” lists all of a file.",
        ),
    )


def _marker(row: MarkerRow, rate: float) -> tuple[str, ...]:
    return (
        row.label,
        percent(row.missing_before),
        percent(row.missing_after),
        str(row.gaps_before),
        str(row.gaps_after),
        str(row.longest_before),
        str(row.longest_after),
        number(1000 * row.longest_before / rate, 0),
        str(row.filled),
        str(row.unfilled),
        filled_by(row),
        number(row.worst_error_mm),
    )


def repairs(report: Report) -> Table:
    """List the filled gaps; where there are too many, those with the largest expected errors."""
    shown = list(report.repairs)
    if len(shown) > MOST_ROWS:
        shown.sort(key=lambda row: -_known_last(row))
        shown = sorted(shown[:MOST_ROWS], key=lambda row: row.gap)
    return Table(
        (
            *_place_columns(),
            Column("Method", "name"),
            Column("Expected error (mm)"),
            Column("90 % radius (mm)"),
        ),
        tuple(
            (
                *_place(report, row.gap),
                row.method + (f" ({', '.join(row.donors)})" if row.donors else ""),
                number(row.expected_error_mm),
                number(row.r90_mm),
            )
            for row in shown
        ),
        _cut(
            len(report.repairs),
            len(shown),
            "repairs with the largest expected errors",
            "“mocapmend info --json” lists all repairs of the repaired file.",
        ),
    )


def _known_last(row: RepairRow) -> float:
    return float("inf") if isnan(row.expected_error_mm) else row.expected_error_mm


def open_gaps(report: Report) -> Table:
    """List the gaps that are left; where there are too many, the longest ones."""
    shown = list(report.open_gaps)
    if len(shown) > MOST_ROWS:
        shown.sort(key=lambda row: -row.gap.length)
        shown = sorted(shown[:MOST_ROWS], key=lambda row: row.gap)
    return Table(
        (*_place_columns(), Column("Why", "text")),
        tuple((*_place(report, row.gap), row.reason) for row in shown),
        _cut(
            len(report.open_gaps),
            len(shown),
            "longest gaps",
            "“mocapmend gaps --json” lists all gaps of a file, “mocapmend repair --json” also "
            "says why each stayed open.",
        ),
    )


def set_aside(done: PutRight) -> Table:
    """List what was set aside, problem by problem."""
    return Table(
        (Column("Problem", "name"), Column("Runs"), Column("Samples")),
        tuple((row.problem, str(row.runs), str(row.samples)) for row in done.aside),
    )


def names(done: PutRight) -> Table:
    """List the markers that were renamed."""
    shown = done.renamed[:MOST_ROWS]
    return Table(
        (Column("Was called", "name"), Column("Is called", "name")),
        shown,
        _cut(len(done.renamed), len(shown), "first", "The repair record has all."),
    )


def smoothing(report: Report, done: PutRight) -> Table:
    """List the smoothed runs; where there are too many, those that were changed most."""
    shown = list(done.smoothed)
    if len(shown) > MOST_ROWS:
        shown.sort(key=lambda row: row.rms_mm if isnan(row.rms_mm) else -row.rms_mm)
        shown = sorted(shown[:MOST_ROWS], key=lambda row: row.run)
    return Table(
        (
            *_place_columns(),
            Column("Method", "name"),
            Column("Cut-off (Hz)"),
            Column("RMS change (mm)"),
        ),
        tuple(
            (
                *_place(report, row.run),
                row.method + (f" ({', '.join(row.chosen)})" if row.chosen else ""),
                row.cutoff_text or "—",
                number(row.rms_mm, 2),
            )
            for row in shown
        ),
        _cut(
            len(done.smoothed),
            len(shown),
            "smoothed runs with the largest changes",
            "The repair record of the repaired file lists all.",
        ),
    )


def history(about: About) -> Table:
    """List the edits in their order; where there are too many, the last ones."""
    numbered = list(enumerate(about.edits, 1))
    shown = numbered[-MOST_ROWS:]
    return Table(
        (
            Column("Step"),
            Column("What", "text"),
            Column("Markers"),
            Column("Runs"),
            Column("Samples filled"),
            Column("Samples set missing"),
        ),
        tuple(
            (str(n), row.text, *map(str, (row.markers, row.runs, row.filled, row.cleared)))
            for n, row in shown
        ),
        _cut(len(numbered), len(shown), "last edits", "The window lists them all."),
    )


def _place_columns() -> tuple[Column, ...]:
    return Column("Marker", "name"), Column("Frames"), Column("Length"), Column("ms")


def _place(report: Report, gap: Gap) -> tuple[str, ...]:
    first, last = gap.start + report.first_frame, gap.stop - 1 + report.first_frame
    return (
        report.labels[gap.marker],
        f"{first} – {last}" if last > first else str(first),
        str(gap.length),
        number(1000 * gap.length / report.rate, 0),
    )


def _cut(there: int, shown: int, which: str, elsewhere: str) -> str:
    return f"Of {there} rows, the {shown} {which} are shown. {elsewhere}".rstrip() * (shown < there)


def filled_by(row: MarkerRow, name: Callable[[str], str] = str) -> str:
    """Say which methods filled how much of a marker, in %; a method's id may have another name."""
    return ", ".join(f"{name(method)} {percent(share)}" for method, share in row.filled_by) or "—"


def number(value: float, decimals: int = 1) -> str:
    """Write a number, or a dash where there is none."""
    return "—" if isnan(value) else f"{value:.{decimals}f}"


def percent(value: float) -> str:
    """Write a share so that little does not look like nothing, nor almost all like all."""
    if isnan(value):
        return "—"
    if 0 < value < 0.01:
        return "<0.01"
    return ">99.99" if 99.99 < value < 100 else f"{value:.2f}"
