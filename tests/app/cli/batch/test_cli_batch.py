"""`mocapmend batch`: what it writes, what it does again, and what it leaves alone."""

import csv
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from batch_trials import write_trial
from c3d_synthetic import Synthetic, encode

from mocapmend import engine
from mocapmend.batch import running
from mocapmend.batch.ledger import NAME as LEDGER
from mocapmend.cli import main
from mocapmend.plan import Plan, Smoothing, write_plan
from mocapmend.prospects import Way

Json = Callable[..., tuple[int, Any]]
Run = Callable[..., tuple[int, Any]]
NAMES = {"b.c3d", "a 1.C3D", "s1/b.c3d", "s ö/deep/b.c3d"}


def states(done: dict[str, Any]) -> dict[str, str]:
    return {row["file"]: row["state"] for row in done["files"]}


def problem(done: dict[str, Any], file: str) -> dict[str, str]:
    return next(row["problem"] for row in done["files"] if row["file"] == file)


def written(folder: Path) -> dict[str, int]:
    """Return the files of a folder with their inodes: those that are written again have others."""
    return {
        path.relative_to(folder).as_posix(): path.stat().st_ino
        for path in folder.rglob("*")
        if path.is_file() and not path.name.startswith(("summary.", LEDGER))
    }


def spoil(path: Path) -> None:
    """Replace a recording by a smooth one with a spike and a gap."""
    t = np.arange(120)[:, None, None] / 20.0
    points = 1000.0 + 100.0 * np.sin(t + np.arange(15).reshape(1, 5, 3))
    points[60, 1] += 300.0
    fourth = np.zeros((120, 5))
    points[30:35, 2], fourth[30:35, 2] = 0.0, -1.0
    path.write_bytes(encode(Synthetic(points, fourth=fourth)))


# --- what is written -----------------------------------------------------------------------------


def test_every_copy_is_what_repair_writes(
    run: Run, trials: Path, plan: Path, out: Path, tmp_path: Path
) -> None:
    before = {path: path.read_bytes() for path in trials.rglob("*.*")}
    code, done = run()
    assert code == 0
    assert states(done) == dict.fromkeys(NAMES, "repaired")
    assert set(written(out)) == NAMES
    for name in NAMES:
        alone = tmp_path / "alone.c3d"
        assert main(["repair", str(trials / name), "-o", str(alone), "--plan", str(plan)]) == 0
        assert (out / name).read_bytes() == alone.read_bytes()
        alone.unlink()
    assert {path: path.read_bytes() for path in trials.rglob("*.*")} == before


def test_figures_agree_with_repair(run: Run, run_json: Json, trials: Path, plan: Path) -> None:
    _, done = run()
    _, alone = run_json("repair", trials / "b.c3d", "--dry-run", "--plan", plan)
    figures = next(row["figures"] for row in done["files"] if row["file"] == "b.c3d")
    totals = alone["totals"]
    assert figures["gaps"] == totals["gaps"]
    assert figures["filled"] == totals["filled"]
    assert figures["samples_filled"] == totals["samples_filled"]
    assert figures["samples_missing"] == totals["samples_missing_before"]
    errors = [gap["expected_error_mm"] for gap in alone["gaps"] if gap["filled"]]
    known = [error for error in errors if error is not None]
    assert figures["expected_worst_mm"] == max(known, default=None)
    assert figures["no_estimate"] == len(errors) - len(known)
    assert done["totals"]["filled"] == sum(row["figures"]["filled"] for row in done["files"])


def test_a_file_without_markers_is_no_failure(run: Run, trials: Path, out: Path) -> None:
    spec = Synthetic(np.empty((4, 0, 3)), analog=np.ones((4, 2, 3)))
    (trials / "plates.c3d").write_bytes(encode(spec))
    code, done = run()
    assert code == 0
    assert states(done) == {**dict.fromkeys(NAMES, "repaired"), "plates.c3d": "nothing"}
    assert (done["totals"]["nothing"], done["totals"]["failed"]) == (1, 0)
    assert not (out / "plates.c3d").exists()
    assert "What could not be repaired" not in (out / "summary.html").read_text()


def test_table_and_json_say_the_same(run: Run, out: Path) -> None:
    _, done = run("--report")
    with (out / "summary.csv").open(encoding="utf-8", newline="") as stream:
        lines = list(csv.DictReader(stream))
    assert [line["file"] for line in lines] == [row["file"] for row in done["files"]]
    for line, row in zip(lines, done["files"], strict=True):
        assert int(line["left_open"]) == row["figures"]["left_open"]
        assert line["report"] == row["report"] == f"{row['file']}.html"
        assert (out / row["report"]).read_text("utf-8").startswith("<!DOCTYPE html>")
    assert (out / "summary.html").is_file()


def test_a_plan_that_fixes_and_smooths_does_what_repair_does(
    run: Run, run_json: Json, trials: Path, plan: Path, out: Path, tmp_path: Path
) -> None:
    for path in trials.rglob("*.*3*"):
        spoil(path)
    write_plan(
        Plan(Way.default("linear"), fix=("spikes",), smooth=Smoothing.default("butterworth")), plan
    )
    code, done = run()
    assert code == 0
    assert (done["fix"], done["smoothing"]) == (["spikes"], "butterworth")
    alone = tmp_path / "alone.c3d"
    _, repaired = run_json("repair", trials / "b.c3d", "-o", alone, "--plan", plan)
    assert (out / "b.c3d").read_bytes() == alone.read_bytes()
    figures = next(row["figures"] for row in done["files"] if row["file"] == "b.c3d")
    (spikes,) = figures["fixed"]
    assert spikes["runs"] == len(repaired["fixed"]) > 0
    assert figures["smoothed"]["markers"] == len(repaired["smoothed"]) > 0
    largest = max(each["largest_change_mm"] for each in repaired["smoothed"])
    assert figures["smoothed"]["largest_mm"] == pytest.approx(largest)
    assert done["totals"]["samples_fixed"] >= 4
    assert done["totals"]["files_smoothed"] == 4


def test_without_recursive_and_with_a_pattern(
    run_json: Json, trials: Path, plan: Path, out: Path, in_turn: None
) -> None:
    _, done = run_json("batch", trials, "--plan", plan, "-o", out, "--pattern", "A*.c3d")
    assert set(states(done)) == {"a 1.C3D"}


# --- bad files -----------------------------------------------------------------------------------


def test_a_bad_file_stops_nothing_and_is_named(
    run: Run, trials: Path, out: Path, capsys: pytest.CaptureFixture[str], plan: Path
) -> None:
    (trials / "a bad.c3d").write_text("nothing")
    (trials / "empty.c3d").write_bytes(b"")
    whole = (trials / "b.c3d").read_bytes()
    (trials / "cut.c3d").write_bytes(whole[: 2 * len(whole) // 3])
    code, done = run()
    assert code == 1
    assert [row["file"] for row in done["files"][:3]] == ["a bad.c3d", "cut.c3d", "empty.c3d"]
    assert states(done) == dict.fromkeys(NAMES, "repaired") | dict.fromkeys(
        ("a bad.c3d", "cut.c3d", "empty.c3d"), "failed"
    )
    assert "truncated" in problem(done, "cut.c3d")["what"]
    assert done["totals"]["failed"] == 3
    assert set(written(out)) == NAMES
    code = main(["batch", str(trials), "--plan", str(plan), "-o", str(out), "--recursive"])
    assert code == 1
    printed = capsys.readouterr()
    assert "3 files failed:\na bad.c3d: failed: This is not a C3D file." in printed.out
    assert "4 of 7 files (4 by an earlier run, 3 failed)" in printed.out
    assert len(printed.err.splitlines()) == 3
    code, done = run("--accept-truncated")
    assert code == 1
    assert states(done)["cut.c3d"] == "repaired"


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_link_that_leads_nowhere_is_named(run: Run, trials: Path) -> None:
    (trials / "gone.c3d").symlink_to(trials / "nothing.c3d")
    code, done = run()
    assert code == 1
    assert "leads nowhere" in problem(done, "gone.c3d")["what"]


def test_an_unexpected_error_costs_one_file_and_is_in_the_log(
    run: Run, monkeypatch: pytest.MonkeyPatch, log_file: Path
) -> None:
    export = engine.export

    def fail(source: Any, *arguments: Any) -> Any:
        if source.path.name == "a 1.C3D":
            raise ZeroDivisionError("by surprise")
        return export(source, *arguments)

    monkeypatch.setattr(engine, "export", fail)
    code, done = run()
    assert code == 1
    assert done["totals"]["repaired"] == 3
    assert "by surprise" in problem(done, "a 1.C3D")["what"]
    assert "Traceback" in log_file.read_text("utf-8")


# --- going on ------------------------------------------------------------------------------------


def test_what_is_done_is_not_done_again(run: Run, trials: Path, out: Path) -> None:
    _, first = run()
    before = written(out)
    os.utime(trials / "b.c3d", (1, 1))
    os.utime(out / "b.c3d", (1, 1))
    (out / "summary.html").unlink()
    code, second = run()
    assert code == 0
    assert states(second) == dict.fromkeys(NAMES, "unchanged")
    assert written(out) == before
    assert (out / "summary.html").is_file()
    for row in (*first["files"], *second["files"]):
        row.pop("state")
    assert second["files"] == first["files"]


def test_what_has_changed_or_gone_or_come_is_done(run: Run, trials: Path, out: Path) -> None:
    run()
    before = written(out)
    write_trial(trials / "b.c3d", seed=9)
    write_trial(trials / "new.c3d", seed=8)
    (out / "a 1.C3D").unlink()
    (trials / "s1" / "b.c3d").unlink()
    code, done = run()
    assert code == 0
    assert states(done) == {
        "b.c3d": "repaired", "new.c3d": "repaired", "a 1.C3D": "repaired",
        "s ö/deep/b.c3d": "unchanged",
    }  # fmt: skip
    assert written(out)["s ö/deep/b.c3d"] == before["s ö/deep/b.c3d"]
    assert (out / "s1" / "b.c3d").is_file()


def test_another_plan_does_all_again_and_the_same_in_other_words_none(run: Run, plan: Path) -> None:
    run()
    plan.write_text(plan.read_text().replace("\n", "\n  "))
    assert set(states(run()[1]).values()) == {"unchanged"}
    write_plan(Plan(Way.default("linear"), 100.0), plan)
    code, done = run()
    assert code == 0
    assert set(states(done).values()) == {"repaired"}
    assert all(row["figures"]["filled"] == 1 for row in done["files"])


def test_another_version_of_the_program_does_all_again(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    run()
    monkeypatch.setattr(running, "__version__", "0.0.1")
    assert set(states(run()[1]).values()) == {"repaired"}


def test_a_report_that_is_asked_for_later_is_made(run: Run, out: Path) -> None:
    run()
    assert set(states(run("--report")[1]).values()) == {"repaired"}
    assert set(states(run("--report")[1]).values()) == {"unchanged"}
    (out / "b.c3d.html").unlink()
    assert states(run("--report")[1])["b.c3d"] == "repaired"
    assert set(states(run()[1]).values()) == {"unchanged"}


def test_again_does_all_again(run: Run) -> None:
    run()
    assert set(states(run("--again")[1]).values()) == {"repaired"}


def test_failures_are_tried_again(run: Run, trials: Path) -> None:
    bad = trials / "bad.c3d"
    bad.write_text("nothing")
    assert run()[0] == 1
    write_trial(bad, seed=7)
    code, done = run()
    assert code == 0
    assert states(done) == dict.fromkeys(NAMES, "unchanged") | {"bad.c3d": "repaired"}


def test_a_failure_says_that_an_earlier_copy_is_still_there(run: Run, trials: Path) -> None:
    run()
    (trials / "b.c3d").write_text("nothing")
    code, done = run()
    assert code == 1
    assert "earlier run has made is still there" in problem(done, "b.c3d")["todo"]


# --- what is kept --------------------------------------------------------------------------------


def test_files_of_others_are_kept_unless_again(run: Run, out: Path) -> None:
    (out / "s1").mkdir(parents=True)
    (out / "s1" / "b.c3d").write_text("precious")
    code, done = run()
    assert code == 1
    assert "which no batch has written" in problem(done, "s1/b.c3d")["what"]
    assert "--again" in problem(done, "s1/b.c3d")["todo"]
    assert (out / "s1" / "b.c3d").read_text() == "precious"
    assert done["totals"]["repaired"] == 3
    (out / "b.c3d.html").write_text("precious")
    code, done = run("--report")
    assert str(out / "b.c3d.html") == problem(done, "b.c3d")["where"]
    code, done = run("--again")
    assert code == 0
    assert (out / "s1" / "b.c3d").read_bytes() != b"precious"
    assert (out / "b.c3d.html").read_text() == "precious"


def test_a_copy_that_somebody_has_worked_on_is_kept(run: Run, out: Path) -> None:
    run()
    (out / "b.c3d").write_text("more work")
    for more in ((), ("--report",)):
        code, done = run(*more)
        assert code == 1
        assert "changed since the batch wrote it" in problem(done, "b.c3d")["what"]
        assert (out / "b.c3d").read_text() == "more work"
    assert run("--again")[0] == 0


def test_what_somebody_has_made_of_a_file_that_failed_is_kept(
    run: Run, trials: Path, out: Path
) -> None:
    bad = trials / "bad.c3d"
    bad.write_text("nothing")
    assert run()[0] == 1
    (out / "bad.c3d").write_text("work of an evening")
    write_trial(bad)
    code, done = run()
    assert code == 1
    assert "which no batch has written" in problem(done, "bad.c3d")["what"]
    assert (out / "bad.c3d").read_text() == "work of an evening"


def test_a_copy_of_an_attempt_that_failed_is_no_work_of_others(
    run: Run, trials: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    export = engine.export

    def change_meanwhile(source: Any, *arguments: Any) -> Any:
        done = export(source, *arguments)
        if source.path.name == "a 1.C3D":
            write_trial(source.path, seed=11)
        return done

    with monkeypatch.context() as patch:
        patch.setattr(engine, "export", change_meanwhile)
        code, done = run()
    assert code == 1
    assert (out / "a 1.C3D").exists()
    assert "changed" in problem(done, "a 1.C3D")["what"]
    assert "the next run replaces it" in problem(done, "a 1.C3D")["todo"]
    code, done = run()
    assert code == 0
    assert states(done) == dict.fromkeys(NAMES, "unchanged") | {"a 1.C3D": "repaired"}


def test_out_inside_the_folder_is_no_input(
    run_json: Json, trials: Path, plan: Path, in_turn: None
) -> None:
    inside = trials / "repaired"
    arguments = ("batch", trials, "--plan", plan, "-o", inside, "--recursive")
    assert set(states(run_json(*arguments)[1])) == NAMES
    code, done = run_json(*arguments)
    assert code == 0
    assert states(done) == dict.fromkeys(NAMES, "unchanged")


# --- what cannot be ------------------------------------------------------------------------------


def test_what_cannot_be_done_at_all(
    run_json: Json, trials: Path, plan: Path, out: Path, tmp_path: Path, in_turn: None
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    (tmp_path / "file").write_bytes(b"")
    cases = (
        (empty, plan, out, "There is no recording like *.c3d"),
        (tmp_path / "none", plan, out, "There is no such folder"),
        (tmp_path / "file", plan, out, "This is a file"),
        (trials, plan, tmp_path / "file", "There is a file where a folder is needed"),
        (trials, plan, tmp_path / "file" / "out", "There is a file where a folder is needed"),
        (trials, plan, trials, "This is the folder of the recordings themselves"),
        (trials, trials / "b.c3d", out, "This is not a plan"),
        (trials, tmp_path / "none", out, "There is no such file"),
    )
    for folder, chosen, place, text in cases:
        code, done = run_json("batch", folder, "--plan", chosen, "-o", place)
        assert code == 1
        assert done["error"]["what"].startswith(text)
        assert done["error"]["todo"]
    assert not out.exists()


@pytest.mark.skipif(
    getattr(os, "geteuid", lambda: 0)() == 0, reason="the superuser may write everywhere"
)
def test_an_output_folder_that_is_read_only(run: Run, out: Path) -> None:
    out.mkdir()
    out.chmod(0o500)
    try:
        code, done = run()
        assert code == 1
        assert "cannot be written" in done["error"]["what"]
    finally:
        out.chmod(0o700)


@pytest.mark.skipif(
    getattr(os, "geteuid", lambda: 0)() == 0, reason="the superuser may look everywhere"
)
@pytest.mark.parametrize("mode", [0o000, 0o444])
def test_a_folder_that_one_may_not_look_into_is_named(run: Run, trials: Path, mode: int) -> None:
    (trials / "s1").chmod(mode)
    try:
        code, done = run()
        assert code == 1
        failed = [row["file"] for row in done["files"] if row["state"] == "failed"]
        assert failed
        assert {name.split("/")[0] for name in failed} == {"s1"}
        assert done["totals"]["repaired"] == 3
    finally:
        (trials / "s1").chmod(0o755)


def test_what_was_done_is_told_where_the_summary_cannot_be_written(run: Run, out: Path) -> None:
    (out / "summary.html").mkdir(parents=True)
    code, done = run()
    assert code == 1
    assert states(done) == dict.fromkeys(NAMES, "repaired")
    assert done["summary_html"] is None


@pytest.mark.skipif(sys.platform == "win32", reason="names have other limits")
def test_a_name_that_is_too_long_for_its_report_costs_one_file(run: Run, trials: Path) -> None:
    long = "x" * 248 + ".c3d"
    write_trial(trials / long)
    code, done = run("--report")
    assert code == 1
    assert states(done) == dict.fromkeys(NAMES, "repaired") | {long: "failed"}


def test_a_place_in_the_output_folder_that_cannot_be_made(run: Run, out: Path) -> None:
    out.mkdir()
    (out / "s1").write_bytes(b"")
    code, done = run()
    assert code == 1
    assert done["totals"]["repaired"] == 3
    assert "where a folder is needed" in problem(done, "s1/b.c3d")["what"]


@pytest.mark.parametrize(
    "more",
    [[], ["--plan", "p"], ["-o", "x"], ["--plan", "p", "-o", "x", "--jobs", "0"],
     ["--plan", "p", "-o", "x", "--jobs", "two"],
     ["--plan", "p", "-o", "x", "--jobs", "2", "--scheduler", "tcp://h:1"]],
)  # fmt: skip
def test_wrong_usage(more: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["batch", "folder", *more])
    assert stopped.value.code == 2
    assert "usage: mocapmend batch" in capsys.readouterr().err


def test_names_that_are_no_text(run: Run, trials: Path, out: Path) -> None:
    odd = os.fsdecode(b"odd\xe9.c3d")
    try:
        shutil.copy(trials / "b.c3d", trials / odd)
    except OSError:
        pytest.skip("this file system takes no such names")
    assert run()[0] == 0
    assert (out / odd).is_file()
    assert states(run()[1])[odd] == "unchanged"
