"""`bench io`: its rows, its ratios, and peers that are not there."""

import json
from pathlib import Path

import numpy as np
import pytest

from mocapmend.bench import io, io_jobs, main
from mocapmend.bench.io_jobs import JOBS, Step, Work
from mocapmend.bench.synthetic import write_recording
from mocapmend.errors import MocapmendError
from mocapmend.files import read_c3d
from mocapmend_algorithms import find_gaps

STEPS = {"own read": 2, "own save": 2, "ezc3d": 2}


def results(*runs: float) -> io.Results:
    """Return results in which the steps of job k take runs * (k + 1), runs * 10 (k + 1), ..."""
    made = io.Results()
    for order, name in enumerate(JOBS, 1):
        made.steps[name] = [
            [Step(run * order * 10**i, 100.0 * order + i) for i in range(STEPS.get(name, 1))]
            for run in runs
        ]
    return made


@pytest.fixture
def work(tmp_path: Path) -> Work:
    """Return a small recording in which a gap is to be repaired."""
    path = tmp_path / io_jobs.RECORDING
    write_recording(path, frames=120, markers=4, analog=2, gaps=2)
    gap = find_gaps(read_c3d(path).recording.present)[0]
    return Work(str(tmp_path), gap.marker, gap.start, gap.stop)


def assert_repaired(path: Path, work: Work) -> None:
    before = read_c3d(work.path).recording.points.copy()
    after = read_c3d(path).recording.points
    before[work.start : work.stop, work.marker] = io_jobs.VALUE
    np.testing.assert_allclose(after, before, rtol=1e-6)


def test_ratios_are_medians_of_the_ratios_run_by_run() -> None:
    made = results(1.0, 1.0, 1.0)
    made.steps["own read"] = [[Step(s, 1.0), Step(0.0, 1.0)] for s in (1.0, 2.0, 10.0)]
    made.steps["c3d read"] = [[Step(s, 1.0)] for s in (30.0, 10.0, 20.0)]
    row = next(row for row in io.rows(made) if row.what.startswith("c3d: read, points"))
    assert row.figure == 20.0
    assert row.against == "mocapmend"
    assert row.ratio == 5.0
    assert row.target == ">= 10"


def test_the_rows_add_up_the_steps_that_they_name() -> None:
    seconds = {row.what: row.figure for row in io.rows(results(2.0)) if row.unit == "s"}
    order = {name: number for number, name in enumerate(JOBS, 1)}
    assert seconds["read, points"] == 2 * order["own read"]
    assert seconds["read, points, residuals and analog"] == 22 * order["own read"]
    assert seconds["save a repair, verified"] == 20 * order["own save"]
    assert seconds["ezc3d: read, points, residuals and analog"] == 2 * order["ezc3d"]
    assert seconds["ezc3d: read, repair, write, not verified"] == 22 * order["ezc3d"]


def test_memory_is_held_against_the_limit_or_told_to_be_unknown() -> None:
    rows = {row.what: row for row in io.rows(results(1.0)) if row.unit == "MB"}
    own = rows["extra memory, read points, residuals and analog"]
    assert own.figure == 301.0
    assert own.ratio == pytest.approx(301 / 500)
    made = results(1.0)
    made.steps["own read"] = [[Step(1.0, None), Step(1.0, None)]]
    unknown = next(row for row in io.rows(made) if row.what == own.what)
    assert (unknown.figure, unknown.note) == (None, "not told by this system")


@pytest.mark.filterwarnings("ignore:missing parameter")
def test_every_job_runs_and_the_copies_hold_the_repair(work: Work) -> None:
    for name, job in JOBS.items():
        if name.startswith("ezc3d"):
            continue
        steps = io_jobs.measure(job(work))
        assert len(steps) == STEPS.get(name, 1)
        assert all(step.seconds > 0 for step in steps)
    for copy in ("own", "c3d"):
        assert_repaired(Path(work.folder) / f"{copy}.c3d", work)


def test_ezc3d_writes_the_same_repair(work: Work) -> None:
    pytest.importorskip("ezc3d")
    outcome = io._run("ezc3d", work)
    assert [type(step) for step in outcome] == [Step, Step]
    assert_repaired(Path(work.folder) / "ezc3d.c3d", work)


def test_a_peer_that_is_not_installed_gets_a_row(
    work: Work, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(io, "PEERS", ("c3d", "ezc3d", "copy"))
    monkeypatch.setattr(io, "find_spec", lambda name: None)
    monkeypatch.setattr(io, "JOBS", dict.fromkeys(("copy", "ezc3d")))
    failures = io.measure_all(work, 1).failures
    assert failures == {"copy": "not installed", "ezc3d": "not installed"}
    made = results(1.0)
    made.failures["ezc3d"] = "not installed"
    rows = [row for row in io.rows(made) if "ezc3d: " in row.what]
    assert len(rows) == 5
    assert all(row.figure is None and row.ratio is None for row in rows)
    table = io.Table("x", rows).as_markdown()
    assert "| ezc3d: read, points, residuals and analog | not installed | mocapmend |" in table


def test_a_peer_that_crashes_is_told_and_our_own_failure_is_an_error(
    work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    nowhere = Work(work.folder + "/nowhere", 0, 0, 1)
    assert io._run("c3d read", nowhere) == "failed with exit code 1"
    with pytest.raises(MocapmendError, match="ended early: failed with exit code 1"):
        io._run("own read", nowhere)
    monkeypatch.setattr(io, "PATIENCE_S", 0.01)
    assert io._run("c3d read", work) == "not done after 0.01 s"


def test_the_command_prints_every_row(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["io", "--frames", "150", "--runs", "1", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    assert [row["what"] for row in rows] == [row.what for row in io.rows(results(1.0))]
    assert {row["target"] for row in rows} >= {"<= 3", ">= 10", ">= 5", "<= 1"}
