"""`mocapmend batch` as a program: its workers, Ctrl-C, a crash in the middle, and going on."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from batch_trials import write_trial

from mocapmend.batch.ledger import NAME as LEDGER
from mocapmend.cli import main

Json = Callable[..., tuple[int, Any]]
posix = pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
SLOW = """
import sys
from mocapmend.batch import local
from mocapmend.batch.work import do
from mocapmend.cli import batch, main
sys.path.insert(0, {tests!r})
import slow_batch
batch.Local = lambda jobs: local.Local(jobs, slow_batch.do_after_the_first)
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
"""


@pytest.fixture
def started(tmp_path: Path, trials: Path, plan: Path, out: Path) -> Any:
    """Start a batch with one worker that does one file and then works without an end."""
    program = tmp_path / "program.py"
    program.write_text(SLOW.format(tests=str(Path(__file__).parent)))
    arguments = ["batch", trials, "--plan", plan, "-o", out, "--recursive", "--jobs", "1"]
    process = subprocess.Popen(
        [sys.executable, program, *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stderr is not None
    first = process.stderr.readline()
    assert first.startswith("1 of 4: "), first + process.stderr.read()
    # Until the second file is begun.
    second = process.stderr.readline()
    assert second == "at work\n"
    return process


def test_processes_do_what_one_would(
    run_json: Json, trials: Path, plan: Path, out: Path, tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    (trials / "bad.c3d").write_text("nothing")
    arguments = ["batch", str(trials), "--plan", str(plan), "-o", str(out), "--recursive"]
    code, done = run_json(*arguments, "--jobs", "2")
    assert code == 1
    assert done["workers"] == "2 processes"
    assert (done["totals"]["repaired"], done["totals"]["failed"]) == (4, 1)
    alone = tmp_path / "alone.c3d"
    assert main(["repair", str(trials / "b.c3d"), "-o", str(alone), "--plan", str(plan)]) == 0
    assert (out / "b.c3d").read_bytes() == alone.read_bytes()


@posix
def test_ctrl_c_stops_and_says_how_to_go_on(
    started: Any, run_json: Json, trials: Path, plan: Path, out: Path, in_turn: None
) -> None:
    os.killpg(started.pid, signal.SIGINT)
    printed, err = started.communicate(timeout=60)
    assert started.returncode == 130
    assert "The same command goes on where this one has stopped." in err
    assert "3 files not done yet" in err
    assert "Traceback" not in err
    assert "1 of 4 files (3 not done yet)" in printed
    assert "not done yet" in (out / "summary.html").read_text("utf-8")
    assert not list(out.rglob("*.tmp"))
    code, done = run_json("batch", trials, "--plan", plan, "-o", out, "--recursive")
    assert code == 0
    assert (done["totals"]["unchanged"], done["totals"]["repaired"]) == (1, 3)


@posix
def test_a_kill_in_the_middle_costs_what_was_at_work(
    started: Any, run_json: Json, trials: Path, plan: Path, out: Path, in_turn: None
) -> None:
    started.kill()
    started.communicate(timeout=60)
    lines = [json.loads(line) for line in (out / LEDGER).read_text().splitlines()]
    (finished,) = [line["done"] for line in lines if "done" in line]
    assert len([line for line in lines if "begun" in line]) == 2
    before = (out / finished).stat()
    # What was written and not noted any more: it may be replaced.
    begun = next(line["begun"] for line in lines[2:] if "begun" in line)
    (out / begun).parent.mkdir(parents=True, exist_ok=True)
    (out / begun).write_text("half")
    code, done = run_json("batch", trials, "--plan", plan, "-o", out, "--recursive")
    assert code == 0
    assert (done["totals"]["unchanged"], done["totals"]["repaired"]) == (1, 3)
    after = (out / finished).stat()
    assert (after.st_ino, after.st_mtime_ns) == (before.st_ino, before.st_mtime_ns)
    assert (out / begun).read_bytes() != b"half"


def test_a_terminal_gets_one_line_that_changes(
    trials: Path, plan: Path, out: Path, in_turn: None,
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    (trials / "bad.c3d").write_text("nothing")
    write_trial(trials / "\x1b[31m.c3d")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    assert main(["batch", str(trials), "--plan", str(plan), "-o", str(out)]) == 1
    printed = capsys.readouterr()
    assert printed.err.count("\n") == 1
    assert "bad.c3d: failed: This is not a C3D file." in printed.err
    assert "\r1 of 4 files" in printed.err
    assert "\x1b" not in printed.err + printed.out
