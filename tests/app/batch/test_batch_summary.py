"""The summary: a table that says what the rows say, and a page that needs nothing else."""

import csv
import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import pytest

from mocapmend.batch.results import Figures, Fixed, Problem, Reason, Row, Smoothed
from mocapmend.batch.summary_files import COLUMNS, PAGE, TABLE, write_summaries
from mocapmend.batch.summary_page import Facts, contents
from mocapmend.report.tables import MOST_ROWS

FIGURES = Figures(
    frames=100, markers=5, rate_hz=100.0, gaps=4, filled=1, left_open=3, samples_missing=40,
    samples_filled=10, reasons=(Reason(2, 20, "it is long"), Reason(1, 10, "it is odd")),
    expected_median_mm=1.0, expected_worst_mm=2.5, worst_place="A, frames 1-10",
    tracked_before=92.0, tracked_after=94.0, fixed=(Fixed("spikes", 2, 5), Fixed("swaps", 1, 40)),
    smoothed=Smoothed(5, 0.25, 3.5), warnings=("Up is a guess.",),
)  # fmt: skip
ROWS = [
    Row(file="<b>&.c3d", state="repaired", figures=FIGURES, output="<b>&.c3d", seconds=1.5),
    Row(
        file='s 1/ö "x", y:z.c3d',
        state="unchanged",
        figures=replace(FIGURES, samples_filled=0, tracked_before=50.0, tracked_after=None),
        output='s 1/ö "x", y:z.c3d',
        report='s 1/ö "x", y:z.c3d.html',
    ),
    Row(file="bad.c3d", state="failed", problem=Problem("Is bad.", "/x", "Mend it.")),
    Row(file="later.c3d", state="waiting"),
    Row(file="odd\udce9.c3d", state="repaired", figures=FIGURES, output="odd\udce9.c3d"),
]


@pytest.fixture
def facts() -> Facts:
    return Facts(
        folder=Path("in"),
        out=Path("out"),
        plan=Path("plan.json"),
        method="linear",
        limits="none",
        fix="spikes, swaps",
        smoothing="butterworth",
        seconds=12.0,
        workers="2 processes",
    )


@pytest.fixture
def page(tmp_path: Path, facts: Facts) -> str:
    write_summaries(ROWS, facts, tmp_path)
    return (tmp_path / PAGE).read_text("utf-8")


def test_the_table_says_what_the_rows_say(tmp_path: Path, facts: Facts) -> None:
    write_summaries(ROWS, facts, tmp_path)
    with (tmp_path / TABLE).open(encoding="utf-8", newline="") as stream:
        lines = list(csv.DictReader(stream))
    assert tuple(lines[0]) == COLUMNS
    assert len(lines) == len(ROWS)
    by_file = {line["file"]: line for line in lines}
    first = by_file["<b>&.c3d"]
    assert (first["frames"], first["left_open"], first["samples_filled"]) == ("100", "3", "10")
    assert float(first["expected_worst_mm"]) == 2.5
    assert first["reasons"] == "2 gaps, such as: it is long; 1 gap: it is odd"
    assert (first["fixed"], first["fixed_samples"]) == ("spikes: 2 runs; swaps: 1 run", "45")
    assert (first["smoothed_markers"], first["smoothing_largest_mm"]) == ("5", "3.5")
    assert by_file[ROWS[1].file]["tracked_after_percent"] == ""
    assert (lines[0]["file"], lines[0]["error"], lines[0]["todo"]) == (
        "bad.c3d", "Is bad.", "Mend it.",
    )  # fmt: skip
    assert lines[1]["state"] == "waiting"
    assert "odd\\udce9.c3d" in by_file


def test_the_page_needs_nothing_else_and_knows_light_and_dark(page: str) -> None:
    assert "prefers-color-scheme: dark" in page
    assert not re.search(r"(src=|url\(|@import|https?://|<script)", page)
    assert "<b>&" not in page
    assert "&lt;b&gt;&amp;.c3d" in page


def test_the_page_leads_to_the_files(page: str) -> None:
    links = {unescape(link) for link in re.findall(r'<a href="(\./[^"]*)"', page)}
    assert links == {
        "./%3Cb%3E%26.c3d",
        "./s%201/%C3%B6%20%22x%22%2C%20y%3Az.c3d",
        "./s%201/%C3%B6%20%22x%22%2C%20y%3Az.c3d.html",
        "./odd%E9.c3d",
    }


def test_the_page_says_first_what_needs_attention(page: str) -> None:
    places = [page.index(name) for name in ("Is bad.", "it is long", "Tracking success of")]
    assert places == sorted(places)
    text = unescape(re.sub(r"<[^>]+>", " ", page))
    assert "5: 2 repaired now, 1 repaired by an earlier run, 1 failed, 1 not done yet" in text
    assert "12.0 s with 2 processes; one by one 1.5 s" in text
    assert "y:z.c3d and 2 other files: Up is a guess." in text
    assert "share of the files (%)" in text


def test_reasons_are_counted_over_all_files(facts: Facts) -> None:
    reasons = (
        (Reason(1, 4, "4 frames is long"),),
        (Reason(2, 9, "5.5 frames is long"), Reason(2, 2, "it is odd")),
    )
    rows = [
        Row(file=str(n), state="repaired", figures=replace(FIGURES, reasons=each))
        for n, each in enumerate(reasons)
    ]
    sections = {section.anchor: section for section in contents(rows, facts).sections}
    _, all_files, _, each_file = sections["open"].parts
    assert all_files.rows == (
        ("3", "13", "2", "such as: 4 frames is long"), ("2", "2", "1", "such as: it is odd"),
    )  # fmt: skip
    assert len(each_file.rows) == 3


def test_what_was_put_right_and_smoothed_is_never_silent(page: str) -> None:
    text = " ".join(unescape(re.sub(r"<[^>]+>", " ", page)).split())
    assert "found by spikes, swaps: 135 put right" in text
    assert "Smoothing butterworth, 3 files" in text
    assert "spikes 3 6 15 swaps 3 3 120" in text
    assert "Moved by smoothing, rms (mm)" in text


def test_columns_that_say_nothing_of_any_file_are_left_out(facts: Facts) -> None:
    plain = replace(FIGURES, fixed=(), smoothed=None, wrong_before=0.0)
    rows = [Row(file="a", state="repaired", figures=plain, output="a"), *ROWS[2:4]]

    def titles(rows: list[Row]) -> set[str]:
        sections = {section.anchor: section for section in contents(rows, facts).sections}
        return {column.title for column in sections["files"].parts[1].columns}

    full = replace(FIGURES, wrong_before=0.5, no_estimate=1)
    named = Row(file="b", state="repaired", figures=full, output="b", report="b.html")
    assert titles([*rows, named]) - titles(rows) == {
        "Report", "Filled without estimate", "there but wrong (%)", "Bad samples put right",
        "Moved by smoothing, rms (mm)", "at most (mm)",
    }  # fmt: skip
    assert {"File", "Result", "Gaps", "Left open", "Seconds"} < titles(rows)


def test_what_was_there_but_wrong_has_its_own_number(facts: Facts) -> None:
    rows = [replace(ROWS[0], figures=replace(FIGURES, wrong_before=1.5))]
    head = dict(contents(rows, facts).head[0].rows)
    assert head["Markers tracked"] == (
        "92.00 % before (1.50 % were there but wrong), 94.00 % after"
    )


def test_the_chart_is_a_distribution(facts: Facts) -> None:
    rows = [
        Row(file=str(n), state="repaired", figures=replace(
            FIGURES, tracked_before=float(value), tracked_after=100.0,
        )) for n, value in enumerate((80, 60, 100))
    ]  # fmt: skip
    sections = {section.anchor: section for section in contents(rows, facts).sections}
    (chart,) = sections["success"].parts[1].charts
    before = next(line for line in chart.lines if line.style == "before")
    heights = [y for _, y in before.pieces[0]]
    assert heights == sorted(heights, reverse=True)
    assert len(heights) == 3
    assert chart.x_ticks[-1].text == "100"
    assert "success" not in {s.anchor for s in contents(rows[:1], facts).sections}


def test_long_tables_are_cut_and_say_so(facts: Facts, tmp_path: Path) -> None:
    rows = [replace(ROWS[0], file=f"{n}.c3d") for n in range(MOST_ROWS + 5)]
    sections = {section.anchor: section for section in contents(rows, facts).sections}
    table = sections["files"].parts[1]
    assert len(table.rows) == len(table.links) == MOST_ROWS
    assert "summary.csv" in table.note
    write_summaries(rows, facts, tmp_path)
    assert len((tmp_path / TABLE).read_text().splitlines()) == MOST_ROWS + 6
