"""The worker processes of a batch: each task once, deaths cost one task, stopping stops all."""

import multiprocessing
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from batch_jobs import live_or_die

from mocapmend.batch import local
from mocapmend.batch.local import Local
from mocapmend.batch.results import Finished, Row
from mocapmend.batch.work import Task
from mocapmend.plan import Plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request

posix = pytest.mark.skipif(sys.platform == "win32", reason="signals differ")


class Notes:
    """Notes what it is told; wants to stop when it has heard of as many steps as it is to."""

    def __init__(self, steps: int | None = None) -> None:
        self.steps = steps
        self.given: list[str] = []
        self.ended: dict[str, Row] = {}

    @property
    def stopping(self) -> bool:
        return self.steps == 0

    def began(self, task: Task) -> None:
        self.given.append(task.file)

    def at(self, task: Task, step: str, fraction: float) -> None:
        assert (step, fraction) == ("Living", 0.5)
        if self.steps:
            self.steps -= 1

    def finished(self, task: Task, finished: Finished) -> None:
        assert task.file == finished.row.file
        assert task.file not in self.ended
        self.ended[task.file] = finished.row

    def tick(self) -> None:
        pass


def tasks(*names: str) -> list[Task]:
    request = Request(file=Path("x"), plan=Plan(Way.default("linear")), out=Path("y"))
    return [
        Task(file=name, request=request, output="", report="", size=1, key="") for name in names
    ]


@pytest.fixture(autouse=True)
def _no_process_is_left() -> Iterator[None]:
    before = set(multiprocessing.active_children())
    yield
    assert set(multiprocessing.active_children()) <= before


def what(row: Row) -> str:
    assert row.problem is not None
    return row.problem.what


def test_every_task_is_done_once_by_processes_with_one_thread() -> None:
    notes = Notes()
    names = [f"task {n}" for n in range(7)]
    Local(2, live_or_die).work(tasks(*names), notes)
    assert notes.given == names
    assert set(notes.ended) == set(names)
    assert len({what(row) for row in notes.ended.values()}) <= 2
    for row in notes.ended.values():
        assert row.problem is not None
        assert row.problem.where in ("[1]", "[]")


@posix
def test_a_process_that_dies_costs_its_task_alone() -> None:
    notes = Notes()
    Local(2, live_or_die).work(tasks("kill 1", "a", "exit 2", "b", "kill 3", "c"), notes)
    assert len(notes.ended) == 6
    assert "signal SIGKILL; the system may have run out of memory" in what(notes.ended["kill 1"])
    assert "signal SIGKILL" in what(notes.ended["kill 3"])
    assert "code 3" in what(notes.ended["exit 2"])
    assert all(what(notes.ended[name]).isdigit() for name in "abc")


def test_stopping_stops_those_at_work() -> None:
    notes = Notes(steps=2)
    Local(2, live_or_die).work(tasks("forever 1", "forever 2", "never"), notes)
    assert notes.ended == {}
    assert notes.given == ["forever 1", "forever 2"]


@posix
def test_who_does_not_listen_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local, "PATIENCE_S", 0.0)
    notes = Notes(steps=1)
    Local(2, live_or_die).work(tasks("unheard", "forever"), notes)
    assert notes.ended == {}


def test_ctrl_c_is_as_it_was_after_a_process_was_started() -> None:
    before = signal.getsignal(signal.SIGINT)
    Local(1, live_or_die).work(tasks("a"), Notes())
    assert signal.getsignal(signal.SIGINT) is before
