"""Plans and dry runs from the command line, and gaps by rank."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mocapmend.cli import main
from mocapmend.plan import Plan, write_plan
from mocapmend.prospects import Way

Json = Callable[..., tuple[int, Any]]


def test_a_dry_run_says_what_the_repair_then_does(
    run_json: Json, gait: Path, tmp_path: Path
) -> None:
    before = set(tmp_path.iterdir())
    code, dry = run_json("repair", gait, "--dry-run", "--method", "cubic")
    assert code == 0
    assert dry["dry_run"]
    assert dry["output"] is dry["repair_record"] is dry["methods_paragraph"] is None
    assert set(tmp_path.iterdir()) == before
    _, done = run_json("repair", gait, "-o", tmp_path / "out.c3d", "--method", "cubic")
    assert not done["dry_run"]
    assert (dry["gaps"], dry["totals"]) == (done["gaps"], done["totals"])


def test_a_plan_gives_method_parameters_and_limits(
    run_json: Json, gait: Path, tmp_path: Path
) -> None:
    plan = tmp_path / "plan.json"
    write_plan(Plan(Way.default("linear"), 100.0, 15.0), plan)
    _, by_plan = run_json("repair", gait, "-o", tmp_path / "a.c3d", "--plan", plan)
    assert by_plan["method"] == "linear"
    assert by_plan["limits"]["max_gap_frames"] == 10
    limits = ["--max-gap", "10", "--max-error", "15"]
    run_json("repair", gait, "-o", tmp_path / "b.c3d", "--method", "linear", *limits)
    assert (tmp_path / "a.c3d").read_bytes() == (tmp_path / "b.c3d").read_bytes()


@pytest.mark.parametrize(
    "contradiction",
    [
        ["--plan", "p.json", "--method", "cubic"],
        ["--plan", "p.json", "--max-gap", "0"],
        ["--dry-run", "-o", "out.c3d"],
        ["--dry-run", "--in-place"],
        ["--dry-run", "--report", "r.html"],
    ],
)
def test_what_contradicts_itself_is_wrong_usage(
    gait: Path, contradiction: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    output = [] if "--dry-run" in contradiction else ["-o", "never.c3d"]
    with pytest.raises(SystemExit) as stopped:
        main(["repair", str(gait), *output, *contradiction])
    assert stopped.value.code == 2
    assert "--plan says" in (said := capsys.readouterr().err) or "--dry-run writes" in said


def test_a_file_that_is_no_plan_is_refused(run_json: Json, gait: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.json"
    other.write_text("[]")
    code, said = run_json("repair", gait, "-o", tmp_path / "out.c3d", "--plan", other)
    assert code == 1
    assert said["error"]["what"].startswith("This is not a plan")
    assert not (tmp_path / "out.c3d").exists()


def test_ranked_gaps_come_by_harm(run_json: Json, holed_walk: Path) -> None:
    _, plain = run_json("gaps", holed_walk)
    assert all("harm_mm_frames" not in gap for gap in plain["gaps"])
    _, ranked = run_json("gaps", holed_walk, "--rank")
    harms = [gap["harm_mm_frames"] for gap in ranked["gaps"]]
    assert harms == sorted(harms, reverse=True)
    for gap in ranked["gaps"]:
        assert gap["harm_mm_frames"] == pytest.approx(
            gap["expected_error_mm"] * gap["length_frames"]
        )
        assert gap["best_method"]
    places = {(gap["marker"], gap["first_frame"]) for gap in plain["gaps"]}
    assert places == {(gap["marker"], gap["first_frame"]) for gap in ranked["gaps"]}
    assert main(["gaps", str(holed_walk), "--rank"]) == 0
