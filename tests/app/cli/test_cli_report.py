"""Reports of the command line: `repair --report` in both forms, and `report` of earlier repairs."""

import re
from collections.abc import Callable
from dataclasses import replace
from html import unescape
from pathlib import Path
from typing import Any

import pypdf
import pytest

from mocapmend import engine
from mocapmend.changes import earlier, renames
from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend.layers import Layers
from mocapmend_algorithms import no_progress

Json = Callable[..., tuple[int, Any]]


@pytest.fixture
def gait(samples: Path) -> Path:
    return samples / "gait_plug_in_gait.c3d"


def words(text: str) -> str:
    """Return a text with one space between its words: lines break where there is room."""
    return " ".join(text.split())


def page_text(path: Path) -> str:
    return words(unescape(re.sub(r"<[^>]+>", "", path.read_text("utf-8"))))


def pdf_text(path: Path) -> str:
    return words(" ".join(page.extract_text() for page in pypdf.PdfReader(path).pages))


def test_json_page_and_pdf_say_the_same_paragraph(
    run_json: Json, gait: Path, tmp_path: Path
) -> None:
    said = []
    for name in ("r.html", "r.pdf"):
        path = tmp_path / name
        code, done = run_json(
            "repair", gait, "-o", tmp_path / f"{name}.c3d", "--method", "rigid", "--report", path
        )
        assert code == 0
        assert done["report"] == str(path)
        said.append(done["methods_paragraph"])
        totals = done["totals"]
        assert f"{totals['filled']} gaps ({totals['samples_filled']} samples)" in said[-1]
        assert f"{totals['samples_missing_before']} samples" in said[-1]
        assert f"{totals['left_open']} gaps ({totals['samples_missing_after']} samples)" in said[-1]
        assert "no expected error above 20 mm (default guard)" in said[-1]
        assert "Check of the written file: Check passed" in said[-1]
        assert done["references"][0].startswith("Kabsch")
    assert said[0] == said[1]
    paragraph = words(said[0])
    assert paragraph in page_text(tmp_path / "r.html")
    assert paragraph in pdf_text(tmp_path / "r.pdf")
    history = f"fill {totals['filled']} gaps (rigid)"
    assert history in page_text(tmp_path / "r.html")
    assert history in pdf_text(tmp_path / "r.pdf")


def test_a_report_of_another_ending_stops_before_anything_is_written(
    run_json: Json, gait: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out.c3d"
    code, done = run_json("repair", gait, "-o", out, "--report", tmp_path / "report.txt")
    assert code == 1
    assert ".pdf" in done["error"]["todo"]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", ["html", "pdf"])
def test_a_report_on_an_earlier_repair(
    run_json: Json, gait: Path, tmp_path: Path, ending: str
) -> None:
    out, path = tmp_path / "out.c3d", tmp_path / f"later.{ending}"
    _, done = run_json("repair", gait, "-o", out, "--method", "linear")
    code, made = run_json("report", gait, out, "-o", path)
    assert code == 0
    assert made["repairs"] == done["totals"]["filled"] > 0
    text = page_text(path) if ending == "html" else pdf_text(path)
    filled = done["totals"]["filled"]
    assert f"{filled} by linear interpolation (method “linear”)" in text
    assert f"{filled} of these gaps had been filled before this session" in text
    assert "was examined with" in text
    assert "Check passed" in text
    code, refused = run_json("report", gait, out, "-o", path)
    assert code == 1
    assert "--overwrite" in refused["error"]["todo"]
    assert run_json("report", gait, out, "-o", path, "--overwrite")[0] == 0


def test_reports_that_cannot_be(run_json: Json, gait: Path, samples: Path, tmp_path: Path) -> None:
    page = tmp_path / "later.html"
    code, other = run_json("report", gait, samples / "walk_cmu_02_01.c3d", "-o", page)
    assert code == 1
    assert "cannot be compared" in other["error"]["what"]
    assert run_json("report", gait, gait, "-o", tmp_path / "later.txt")[0] == 1
    assert run_json("report", gait, gait, "-o", tmp_path / "no" / "later.html")[0] == 1
    odd = tmp_path / "odd.html"
    odd.write_bytes(gait.read_bytes())
    code, same = run_json("report", gait, odd, "-o", odd, "--overwrite")
    assert code == 1
    assert "one of the recordings" in same["error"]["what"]
    assert odd.read_bytes() == gait.read_bytes()
    assert not page.exists()


def test_a_report_says_in_words_what_it_did(
    gait: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "r.html"
    assert main(["report", str(gait), str(gait), "-o", str(page)]) == 0
    assert str(page) in capsys.readouterr().out
    assert "No gap was filled." in page_text(page)


def test_a_recording_whose_markers_were_renamed_can_be_compared(
    samples: Path, tmp_path: Path
) -> None:
    walk, out, page = samples / "walk_cmu_02_01.c3d", tmp_path / "o.c3d", tmp_path / "r.html"
    source = read_c3d(walk)
    labels = ["Pelvis & co", *source.recording.labels[1:]]
    made = replace(earlier(Layers.of(source)), renamed=renames(source, labels)).changes()
    engine.export(source, made, out, False, False, no_progress)
    assert main(["report", str(walk), str(out), "-o", str(page)]) == 0
    told = page_text(page)
    assert f"1 marker was renamed: {source.recording.labels[0]} to Pelvis & co." in told
    assert "Pelvis & co" not in page.read_text("utf-8")
    again = tmp_path / "again.html"
    assert main(["report", str(out), str(out), "-o", str(again)]) == 0
