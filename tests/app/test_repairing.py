"""One file repaired by a plan: the steps, what they are told, and what comes of them."""

import pickle
from pathlib import Path

import pytest
from batch_trials import write_trial

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.plan import Plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request, repair, repair_file
from mocapmend_algorithms import Cancelled, no_progress
from mocapmend_algorithms.fill.limits import Limits

LINEAR = Plan(Way.default("linear"), max_gap_ms=200.0)


@pytest.fixture
def trial(tmp_path: Path) -> Path:
    return write_trial(tmp_path / "a.c3d")


def ignore(step: str) -> None:
    """Be told a step."""


def test_steps_are_told_in_order_and_each_has_its_progress(trial: Path, tmp_path: Path) -> None:
    told: list[str] = []
    ends: dict[str, float] = {}

    def progress(fraction: float, /) -> None:
        assert 0 <= fraction <= 1
        assert fraction >= ends.get(told[-1], 0.0)
        ends[told[-1]] = fraction

    request = Request(
        file=trial, plan=LINEAR, out=tmp_path / "out.c3d", report=tmp_path / "report.html"
    )
    done = repair_file(request, progress, told.append)
    assert told == ["Reading", "Looking for bones", "Filling", "Writing", "Report"]
    assert {step: ends[step] for step in told[2:]} == dict.fromkeys(told[2:], 1.0)
    assert done.exported is not None
    assert request.report is not None
    assert request.report.is_file()


def test_a_dry_run_writes_nothing_and_looks_for_no_bones(trial: Path) -> None:
    told: list[str] = []
    done = repair_file(Request(file=trial, plan=LINEAR, out=None), no_progress, told.append)
    assert told == ["Reading", "Filling"]
    assert done.exported is None
    assert [path.name for path in trial.parent.iterdir()] == ["a.c3d"]
    assert done.samples_filled == 5
    assert len(done.repairs) == 1
    assert {entry.gap.length for entry in done.result.unfilled} == {4, 30}


def test_limits_that_are_given_hold_in_place_of_the_plan(trial: Path) -> None:
    request = Request(file=trial, plan=LINEAR, out=None, limits=Limits(max_gap=30))
    assert repair_file(request, no_progress, ignore).samples_filled == 35


def test_what_is_read_is_not_changed(trial: Path, tmp_path: Path) -> None:
    source = read_recording(trial)
    before = source.recording.points.copy()
    done = repair(
        source, Request(file=trial, plan=LINEAR, out=tmp_path / "o.c3d"), no_progress, ignore
    )
    assert source.recording.points.tobytes() == before.tobytes()
    gap = done.repairs[0].gap
    assert done.place(gap) == "M001, frames 11-15"
    assert done.after.present[gap.start : gap.stop, gap.marker].all()


def test_names_that_no_copy_can_have_are_refused_before_anything_is_done(tmp_path: Path) -> None:
    told: list[str] = []
    table = tmp_path / "a.csv"
    table.write_text("frame,time,A_x,A_y,A_z\n1,0,1,2,3\n2,0.01,1,2,3\n")
    request = Request(file=table, plan=LINEAR, out=tmp_path / "out.bvh")
    with pytest.raises(MocapmendError, match="cannot be written"):
        repair_file(request, no_progress, told.append)
    assert told == ["Reading"]


def test_to_cancel_leaves_nothing(trial: Path, tmp_path: Path) -> None:
    step = [""]

    def cancel_writing(fraction: float, /) -> None:
        if step[0] == "Writing":
            raise Cancelled

    def began(title: str) -> None:
        step[0] = title

    request = Request(file=trial, plan=LINEAR, out=tmp_path / "out.c3d")
    with pytest.raises(Cancelled):
        repair_file(request, cancel_writing, began)
    assert [path.name for path in tmp_path.iterdir()] == ["a.c3d"]


def test_a_request_travels(trial: Path) -> None:
    request = Request(file=trial, plan=LINEAR, out=None, markers=("M001",))
    assert pickle.loads(pickle.dumps(request)) == request
