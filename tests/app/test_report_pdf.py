"""The report as PDF: its text read back, its figures as vectors, long tables cut, errors."""

import errno
import os
import subprocess
import sys
from dataclasses import replace
from io import BytesIO
from pathlib import Path

import numpy as np
import pypdf
import pytest

from mocapmend import report
from mocapmend.errors import MocapmendError
from mocapmend.report import About, EditRow, RepairRow, pdf, tables
from mocapmend.report.page import render as render_html
from mocapmend.report.pdf_text import BOLD, Style, register_fonts, width, wrap
from mocapmend_algorithms import Gap, Recording, no_progress
from mocapmend_algorithms.skeleton import Skeleton

LABELS = ("左膝", "RKNE", "Größe", "무릎")


def summarised(gaps: int = 1, labels: tuple[str, ...] = LABELS) -> report.Report:
    """Return the figures of four markers, the first with gaps of one frame that are filled."""
    points = np.zeros((2 * gaps + 10, len(labels), 3))
    points[:, :, 0] = 100 * np.arange(len(labels))
    after = points.copy()
    rows = [RepairRow(Gap(0, 2 * k + 1, 2 * k + 2), "cubic", 1.0 + k, 2.0) for k in range(gaps)]
    for row in rows:
        points[row.gap.start, 0] = np.nan
    after[3, 0, 0] = -30
    before, repaired = (Recording(values, labels, 50.0) for values in (points, after))
    skeleton = Skeleton("", ((0, 1), (0, 2), (0, 3)), "distances")
    return report.summarise(before, repaired, skeleton, rows, (), no_progress)


def read(data: bytes) -> tuple[pypdf.PdfReader, str]:
    reader = pypdf.PdfReader(BytesIO(data))
    return reader, "\n".join(page.extract_text() for page in reader.pages)


def test_the_pdf_says_what_the_page_says() -> None:
    edits = (EditRow("fill 左膝 (cubic)", 1, 1, 1),)
    about = About(
        "步行.c3d", ("cubic",), warnings=("It is odd.",), proof=("All is well.",), edits=edits
    )
    reader, text = read(pdf.render(summarised(), about))
    for part in (
        "步行.c3d", "左膝", "RKNE", "Größe", "左膝 – RKNE", "左膝 – 무릎", "It is odd.",
        "All is well.",
        "fill 左膝 (cubic)", "Tracked now", "length (mm)", "Methods paragraph",
        "1 by cubic spline interpolation",
    ):  # fmt: skip
        assert part in text, part
    titles = [str(entry["/Title"]) for entry in reader.outline]
    assert "Gaps left open" in titles
    assert "History of edits" in titles
    assert reader.metadata is not None
    assert reader.metadata.title == "步行.c3d – mocapmend report"
    assert not any("/XObject" in page["/Resources"] for page in reader.pages), "no pictures"


def test_what_was_before_is_dashed_and_drawn_as_lines() -> None:
    reader, _ = read(pdf.render(summarised(), About("walk.c3d")))
    content = b"".join(page.get_contents().get_data() for page in reader.pages)
    assert b"[3.6 3] 0 d" in content
    assert content.count(b" l ") + content.count(b" l\n") > 50


def test_the_same_input_makes_the_same_bytes_without_a_time() -> None:
    one, other = (pdf.render(summarised(), About("walk.c3d")) for _ in range(2))
    assert one == other


def test_a_pdf_needs_no_display_and_no_qt() -> None:
    code = (
        "import sys, test_report_pdf as t;"
        "t.pdf.render(t.summarised(), t.About('a'));"
        "sys.exit(any(m.startswith('PySide6') for m in sys.modules))"
    )
    env = {**os.environ, "PYTHONPATH": os.pathsep.join([*sys.path, str(Path(__file__).parent)])}
    subprocess.run([sys.executable, "-c", code], check=True, env=env, timeout=60)


def test_long_tables_are_cut_and_say_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tables, "MOST_ROWS", 20)
    made = summarised(gaps=50)
    table = tables.repairs(made)
    assert len(table.rows) == 20
    assert {row[4] for row in table.rows} == {"cubic"}
    assert min(float(row[5]) for row in table.rows) == 31.0, "the doubtful ones are shown"
    assert [row[1] for row in table.rows] == [str(2 * k + 2) for k in range(30, 50)]
    sentence = "Of 50 rows, the 20 repairs with the largest expected errors are shown."
    assert table.note.startswith(sentence)
    assert "mocapmend info --json" in table.note
    about = About("walk.c3d")
    assert sentence in render_html(made, about)
    assert sentence in read(pdf.render(made, about))[1].replace("\n", " ")
    open_ones = report.summarise(
        *(Recording(np.full((99, 1, 3), np.nan), ("A",), 50.0) for _ in range(2)),
        Skeleton("", (), "none"), (), (), no_progress,
    )  # fmt: skip
    assert tables.open_gaps(open_ones).note == ""


def test_repairs_of_unknown_error_are_kept_when_a_table_is_cut(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(tables, "MOST_ROWS", 1)
    made = summarised(gaps=3)
    unknown = RepairRow(made.repairs[0].gap, "cubic")
    made = replace(made, repairs=(unknown, *made.repairs[1:]))
    assert tables.repairs(made).rows[0][5] == "—"


def test_a_table_over_many_pages_repeats_its_headings() -> None:
    reader, text = read(pdf.render(summarised(gaps=200), About("walk.c3d")))
    assert len(reader.pages) > 4
    assert text.count("Expected") >= 4
    assert text.count("左膝") >= 200


@pytest.mark.parametrize(
    "text", ["", "a b c " * 30, "x" * 400, "左膝右膝" * 60, "ab 左 cd右ef " * 20]
)
def test_lines_are_no_wider_than_their_room_and_lose_nothing(text: str) -> None:
    register_fonts()
    style = Style(8, font=BOLD)
    lines = wrap(text, style, 120)
    assert all(width(line, style) <= 120 for line in lines)
    assert "".join(lines).replace(" ", "") == text.replace(" ", "")


def test_signs_that_no_font_has_are_replaced() -> None:
    register_fonts()
    assert wrap("a\x00b\U0001f600", Style(8), 500) == ["a□b□"]


@pytest.mark.parametrize("name", ["report", "report.txt", "report.docx"])
def test_other_endings_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(MocapmendError) as error:
        report.write_report(summarised(), About("walk.c3d"), tmp_path / name)
    assert ".pdf" in error.value.todo
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["report.html", "report.pdf", "REPORT.PDF"])
def test_a_full_disk_leaves_nothing(
    tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(MocapmendError, match="not enough space"):
        report.write_report(summarised(), About("walk.c3d"), tmp_path / name)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.undo()
    report.write_report(summarised(), About("walk.c3d"), tmp_path / name)
    head = (tmp_path / name).read_bytes()[:5]
    assert (head == b"%PDF-") == name.lower().endswith(".pdf")


def test_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="folder does not exist"):
        report.write_report(summarised(), About("walk.c3d"), tmp_path / "no" / "report.pdf")
