"""The page about a batch: what needs attention first, and the figures of every file."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mocapmend import __version__
from mocapmend.batch.file_table import cut, file_table, share
from mocapmend.batch.results import Fixed, Reason, Row
from mocapmend.batch.totals import Totals
from mocapmend.report import charts
from mocapmend.report.content import Bullets, Content, Figures, Pairs, Part, Section, Text
from mocapmend.report.tables import MOST_ROWS, Column, Table
from mocapmend.wording import count


@dataclass(frozen=True)
class Facts:
    """What the page says of the batch as a whole.

    Attributes
    ----------
    folder, out : Path
        Where the recordings are and where their copies go.
    plan : Path
        The plan's file.
    method, limits, fix, smoothing : str
        What it says, for people; "" where it says nothing.
    seconds : float
        How long this run took.
    workers : str
        Who did the work.
    """

    folder: Path
    out: Path
    plan: Path
    method: str
    limits: str
    fix: str
    smoothing: str
    seconds: float
    workers: str


def contents(rows: Sequence[Row], facts: Facts) -> Content:
    """Lay down what the page says of files in the order given."""
    sections = (
        Section("attention", "What could not be repaired", tuple(_failed(rows))),
        Section("open", "Why gaps stayed open", tuple(_reasons(rows))),
        Section("fixed", "Bad samples put right", tuple(_fixed(rows))),
        Section("success", "Tracking success", tuple(_success(rows))),
        Section("files", "Files", tuple(_files(rows))),
        Section("warnings", "Warnings about the files", tuple(_warnings(rows))),
    )
    return Content(
        f"Batch of {facts.folder.name or facts.folder}",
        f"Summary of a batch, mocapmend {__version__}",
        (Pairs(tuple(_head(rows, facts))),),
        tuple(section for section in sections if section.parts),
    )


def _head(rows: Sequence[Row], facts: Facts) -> Iterator[tuple[str, str]]:
    totals = Totals.of(rows)
    yield "Recordings", str(facts.folder)
    yield "Repaired copies", str(facts.out)
    yield "Plan", facts.plan.name
    if facts.fix:
        yield "Bad samples", f"found by {facts.fix}: {totals.samples_fixed} put right"
    yield "Filling", f"{facts.method}; limits: {facts.limits}"
    if facts.smoothing:
        yield "Smoothing", f"{facts.smoothing}, {totals.files_smoothed} files"
    states = (
        (totals.repaired, "repaired now"),
        (totals.unchanged, "repaired by an earlier run"),
        (totals.nothing, "without markers"),
        (totals.failed, "failed"),
        (totals.waiting, "not done yet: the same command goes on with them"),
    )
    listed = ", ".join(f"{n} {text}" for n, text in states if n)
    yield "Files", f"{totals.files}: {listed}"
    yield "Frames", str(totals.frames)
    yield "Gaps", f"{totals.gaps}: {totals.filled} filled, {totals.left_open} left open"
    yield (
        "Missing samples",
        f"{totals.samples_missing} before, {totals.samples_missing - totals.samples_filled} after",
    )
    before, after = totals.tracked_before, totals.tracked_after
    wrong = f" ({share(totals.wrong_before)} % were there but wrong)" if totals.wrong_before else ""
    yield "Markers tracked", f"{share(before)} % before{wrong}, {share(after)} % after"
    yield "Time", f"{facts.seconds:.1f} s with {facts.workers}; one by one {totals.seconds:.1f} s"


def _failed(rows: Sequence[Row]) -> Iterator[Part]:
    failed = [(row.file, row.problem) for row in rows if row.problem and row.state == "failed"]
    if failed:
        yield Table(
            (Column("File", "name"), Column("Why", "text"), Column("What to do", "text")),
            tuple((file, problem.what, problem.todo) for file, problem in failed[:MOST_ROWS]),
            cut(len(failed)),
        )


def _reasons(rows: Sequence[Row]) -> Iterator[Part]:
    listed = [(row.file, reason) for row in rows if row.figures for reason in row.figures.reasons]
    if not listed:
        return
    yield Text("Reasons that differ in their numbers alone are one.", dim=True)
    kinds: dict[str, list[Reason]] = {}
    for _, reason in listed:
        kinds.setdefault(reason.kind, []).append(reason)
    ordered = sorted(kinds.values(), key=lambda alike: -sum(reason.gaps for reason in alike))
    yield Table(
        (Column("Gaps"), Column("Samples"), Column("Files"), Column("Why", "text")),
        tuple(map(_kind, ordered[:MOST_ROWS])),
    )
    yield Text("File by file:")
    yield Table(
        (Column("File", "name"), Column("Gaps"), Column("Samples"), Column("Why", "text")),
        tuple((file, *_reason(reason)) for file, reason in listed[:MOST_ROWS]),
        cut(len(listed)),
    )


def _kind(alike: Sequence[Reason]) -> tuple[str, ...]:
    gaps, samples = sum(each.gaps for each in alike), sum(each.samples for each in alike)
    all_of_them = Reason(gaps, samples, alike[0].example)
    return str(gaps), str(samples), str(len(alike)), _reason(all_of_them)[-1]


def _reason(reason: Reason) -> tuple[str, str, str]:
    such = "such as: " if reason.gaps > 1 else ""
    return str(reason.gaps), str(reason.samples), such + reason.example


def _fixed(rows: Sequence[Row]) -> Iterator[Part]:
    kinds: dict[str, list[Fixed]] = {}
    for row in rows:
        for fixed in row.figures.fixed if row.figures else ():
            kinds.setdefault(fixed.kind, []).append(fixed)
    if kinds:
        yield Table(
            (Column("Kind", "name"), Column("Files"), Column("Runs"), Column("Samples")),
            tuple(
                (
                    kind,
                    str(len(all_of)),
                    str(sum(each.runs for each in all_of)),
                    str(sum(each.samples for each in all_of)),
                )
                for kind, all_of in sorted(kinds.items())
            ),
        )


def _success(rows: Sequence[Row]) -> Iterator[Part]:
    known = [
        (row.figures.tracked_before, row.figures.tracked_after)
        for row in rows
        if row.figures and row.figures.tracked_before is not None
    ]
    if len(known) < 2:
        return
    before, after = np.sort(np.array(known, dtype=np.float64), axis=0).T
    yield Text(
        "Share of the markers that are there and not known to be wrong, mean over a file's frames. "
        "The files are in the order of their shares: at 20 %, a fifth of them has no more than the "
        "curve shows.",
        dim=True,
    )
    chart = charts.draw(
        "Tracking success of the files",
        "markers (%)",
        (len(known) - 1) / 100,
        before,
        after,
        top=100.0,
        x_label="share of the files (%)",
    )
    yield Figures((chart,))


def _files(rows: Sequence[Row]) -> Iterator[Part]:
    yield Text(
        "Those that need attention come first: what failed, then what misses most samples, then "
        "what has the largest expected errors. A dash: not known.",
        dim=True,
    )
    yield file_table(rows)


def _warnings(rows: Sequence[Row]) -> Iterator[Part]:
    files: dict[str, list[str]] = {}
    for row in rows:
        for warning in row.figures.warnings if row.figures else ():
            files.setdefault(warning, []).append(row.file)
    if files:
        yield Bullets(
            tuple(
                f"{names[0]}{_others(len(names) - 1)}: {text}"
                for text, names in list(files.items())[:MOST_ROWS]
            ),
            warning=True,
        )


def _others(more: int) -> str:
    return f" and {count(more, 'other file')}" if more else ""
