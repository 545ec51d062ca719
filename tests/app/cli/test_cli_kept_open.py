"""Gaps that the user keeps open, on the command line."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from holes import HOLES

from mocapmend import engine
from mocapmend.cli import main
from mocapmend.files import read_c3d
from mocapmend.files.records import LEFT_OPEN
from mocapmend_algorithms import no_progress

Json = Callable[..., tuple[int, Any]]
WHY = "the marker fell off"


@pytest.fixture
def marked(holed_walk: Path, tmp_path: Path) -> Path:
    """Write the walk with a gap that is never to be filled, and another one left open."""
    source = read_c3d(holed_walk)
    kept = (
        engine.kept_gap(source, HOLES["interior"], never=True, reason=WHY),
        engine.kept_gap(source, HOLES["trailing"], never=False, reason=LEFT_OPEN),
    )
    out = tmp_path / "marked.c3d"
    engine.export(source, engine.Changes((), (), kept), out, False, False, no_progress)
    return out


@pytest.mark.parametrize("more", [[], ["--method", "pca-r2"]], ids=["auto", "another method"])
def test_repair_leaves_what_is_never_to_be_filled(
    run_json: Json, marked: Path, tmp_path: Path, more: list[str]
) -> None:
    out = tmp_path / "out.c3d"
    words = [*more, "--max-error", "inf"]
    code, done = run_json("repair", marked, "-o", out, *words)
    assert code == 0
    assert [gap["reason"] for gap in done["gaps"]] == [None, WHY, None]
    assert done["totals"]["filled"] == 2
    assert done["totals"]["left_open"] == 1
    assert WHY in done["methods_paragraph"]
    again = read_c3d(out)
    assert set(again.kept_open) == {HOLES["interior"]}
    assert set(again.repaired) == {HOLES["leading"], HOLES["trailing"]}
    _, dry = run_json("repair", marked, "--dry-run", *words)
    assert dry["gaps"] == done["gaps"]


def test_repair_says_so_to_people(
    marked: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out.c3d"
    assert main(["repair", str(marked), "-o", str(out), "--method", "linear"]) == 0
    lines = capsys.readouterr().out.splitlines()
    [line] = [line for line in lines if WHY in line]
    assert "121-150" in line
    report = tmp_path / "report.html"
    assert main(["report", str(marked), str(out), "-o", str(report)]) == 0
    assert WHY in report.read_text("utf-8")


def test_info_and_gaps_name_them(
    run_json: Json, marked: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _, info = run_json("info", marked)
    assert [(gap["never"], gap["reason"]) for gap in info["kept_open"]] == [
        (True, WHY),
        (False, LEFT_OPEN),
    ]
    assert info["repairs"] == []
    _, plain = run_json("gaps", marked)
    never, left = {"never": True, "reason": WHY}, {"never": False, "reason": LEFT_OPEN}
    assert [gap["kept_open"] for gap in plain["gaps"]] == [None, never, left]
    _, ranked = run_json("gaps", marked, "--rank")
    assert len(ranked["gaps"]) == 3
    assert ranked["gaps"][-1]["kept_open"] == never
    assert ranked["gaps"][-1]["best_method"] is None
    for command in ("info", "gaps"):
        assert main([command, str(marked)]) == 0
        said = capsys.readouterr().out
        assert "Kept open" in said
        assert WHY in said


def test_convert_keeps_them(run_json: Json, marked: Path, tmp_path: Path) -> None:
    _, done = run_json("convert", marked, "-o", tmp_path / "out.csv")
    assert done["repair_record"]["place"] == "sidecar"
    _, info = run_json("info", tmp_path / "out.csv")
    assert len(info["kept_open"]) == 2
