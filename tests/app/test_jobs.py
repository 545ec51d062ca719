"""Background work ends in exactly one of finished, failed and cancelled."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from threading import Event

import numpy as np
import pytest
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot
from worker_modules import loaded

from mocapmend.errors import MocapmendError
from mocapmend.jobs import APART, Job, Jobs
from mocapmend.shared_recording import SharedRecording
from mocapmend.views.job_indicator import JobIndicator
from mocapmend_algorithms import Progress, Recording


@pytest.fixture
def lent_workers() -> None:
    """Give each test worker processes of its own: how they begin and end is tested here."""


def double(value: int, progress: Progress) -> int:
    progress(0.5)
    return 2 * value


def ask_a_worker(value: int, apart: Callable[..., int], progress: Progress) -> tuple[int, int]:
    return os.getpid(), apart(double, value)


def where(progress: Progress) -> int:
    return os.getpid()


def ask_for(function: Callable[..., object], apart: Callable[..., object], _: Progress) -> object:
    return apart(function)


def refuse(progress: Progress) -> None:
    raise MocapmendError("No.", "here", "Try something else.")


def work_until_cancelled(progress: Progress) -> None:
    for step in range(60_000):
        progress(min(1.0, step / 1000.0))
        time.sleep(0.001)


def die(progress: Progress) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def total(recording: Recording, progress: Progress) -> tuple[float, float, str]:
    return float(np.nansum(recording.points)), recording.rate, recording.labels[0]


def outcomes(job: Job) -> list[str]:
    seen: list[str] = []
    job.finished.connect(lambda _: seen.append("finished"))
    job.failed.connect(lambda _: seen.append("failed"))
    job.cancelled.connect(lambda: seen.append("cancelled"))
    return seen


@pytest.mark.parametrize("kind", ["compute", "read_or_write"])
def test_a_job_delivers_its_result(jobs: Jobs, qtbot: QtBot, kind: str) -> None:
    job = getattr(jobs, kind)("double", double, 21)
    seen = outcomes(job)
    with qtbot.waitSignal(job.ended, timeout=20_000), qtbot.waitSignal(job.finished) as finished:
        pass
    assert finished.args == [42]
    assert seen == ["finished"]
    assert jobs.running == 0


def test_a_thread_has_a_worker_compute_for_it(jobs: Jobs, qtbot: QtBot) -> None:
    with qtbot.waitSignal(jobs.read_or_write("ask", ask_a_worker, 21, APART).finished) as done:
        pass
    assert done.args == [(os.getpid(), 42)]
    with qtbot.waitSignal(jobs.read_or_write("ask", ask_for, where, APART).finished) as done:
        pass
    assert done.args[0] != os.getpid()


def test_what_a_worker_computes_for_a_thread_has_progress_and_errors(
    jobs: Jobs, qtbot: QtBot
) -> None:
    job = jobs.read_or_write("ask", ask_for, work_until_cancelled, APART)
    seen = outcomes(job)
    with qtbot.waitSignal(job.progressed, timeout=20_000):
        pass
    with qtbot.waitSignal(job.ended, timeout=20_000):
        job.cancel()
    assert seen == ["cancelled"]
    with qtbot.waitSignal(jobs.read_or_write("ask", ask_for, refuse, APART).failed) as failed:
        pass
    assert isinstance(failed.args[0], MocapmendError)


@pytest.mark.parametrize("kind", ["compute", "read_or_write"])
def test_an_error_travels_back_whole(jobs: Jobs, qtbot: QtBot, kind: str) -> None:
    job = getattr(jobs, kind)("refuse", refuse)
    seen = outcomes(job)
    with qtbot.waitSignal(job.failed) as failed, qtbot.waitSignal(job.ended):
        pass
    error = failed.args[0]
    assert isinstance(error, MocapmendError)
    assert (error.what, error.where, error.todo) == ("No.", "here", "Try something else.")
    assert seen == ["failed"]


@pytest.mark.parametrize("kind", ["compute", "read_or_write"])
def test_a_running_job_reports_and_can_be_cancelled(jobs: Jobs, qtbot: QtBot, kind: str) -> None:
    job = getattr(jobs, kind)("long", work_until_cancelled)
    seen = outcomes(job)
    with qtbot.waitSignal(job.progressed, check_params_cb=lambda share: share > 0, timeout=20_000):
        pass
    with qtbot.waitSignals([job.cancelled, job.ended]):
        job.cancel()
    assert seen == ["cancelled"]


def test_a_waiting_job_can_be_cancelled(jobs: Jobs, qtbot: QtBot) -> None:
    release = Event()

    def wait(progress: Callable[[float], None]) -> None:
        release.wait(20)

    busy = [jobs.read_or_write("busy", wait) for _ in range(2)]
    waiting = jobs.read_or_write("waiting", double, 1)
    seen = outcomes(waiting)
    with qtbot.waitSignal(waiting.cancelled):
        waiting.cancel()
    with qtbot.waitSignals([job.ended for job in busy]):
        release.set()
    assert seen == ["cancelled"]


def test_an_abandoned_job_ends_in_silence(jobs: Jobs, qtbot: QtBot) -> None:
    job = jobs.compute("long", work_until_cancelled)
    seen = outcomes(job)
    with qtbot.waitSignal(job.progressed, check_params_cb=lambda share: share > 0, timeout=20_000):
        pass
    with qtbot.waitSignal(job.ended):
        job.abandon()
    assert seen == []
    assert jobs.running == 0


def test_a_worker_that_dies_fails_its_job_and_is_replaced(jobs: Jobs, qtbot: QtBot) -> None:
    job = jobs.compute("die", die)
    with qtbot.waitSignal(job.failed, timeout=20_000) as failed:
        pass
    assert isinstance(failed.args[0], MocapmendError)
    again = jobs.compute("double", double, 4)
    with qtbot.waitSignal(again.finished, timeout=20_000) as finished:
        pass
    assert finished.args == [8]


def test_a_recording_reaches_the_worker_through_shared_memory(jobs: Jobs, qtbot: QtBot) -> None:
    points = np.arange(60.0).reshape(5, 4, 3)
    points[2, 1] = np.nan
    recording = Recording(points, ("A", "B", "C", "D"), 120.0)
    job = jobs.compute("total", total, SharedRecording(recording))
    with qtbot.waitSignal(job.finished, timeout=20_000) as finished:
        pass
    assert finished.args[0] == (np.nansum(points), 120.0, "A")


def test_a_worker_loads_no_qt(jobs: Jobs, qtbot: QtBot) -> None:
    names = ("PySide6", "pyqtgraph", "mocapmend.jobs", "mocapmend.workers", "worker_modules")
    job = jobs.compute("loaded", loaded, names)
    with qtbot.waitSignal(job.finished, timeout=20_000) as finished:
        pass
    assert finished.args == [["mocapmend.workers", "worker_modules"]]


def test_more_jobs_than_slots_is_a_clear_error(jobs: Jobs, qtbot: QtBot) -> None:
    release = Event()

    def wait(progress: Callable[[float], None]) -> None:
        release.wait(20)

    started = [jobs.read_or_write("wait", wait) for _ in range(32)]
    with pytest.raises(MocapmendError, match="Too many"):
        jobs.read_or_write("one more", wait)
    with qtbot.waitSignals([job.ended for job in started], timeout=20_000):
        release.set()


def test_cancelling_a_job_that_is_over_harms_no_other(jobs: Jobs, qtbot: QtBot) -> None:
    over = jobs.compute("double", double, 1)
    with qtbot.waitSignal(over.ended, timeout=20_000):
        pass
    after = jobs.compute("double", double, 2)
    assert after.slot == over.slot
    over.abandon()
    with qtbot.waitSignal(after.finished) as finished:
        pass
    assert finished.args == [4]


def test_the_newest_running_job_is_shown(jobs: Jobs, qtbot: QtBot) -> None:
    indicator = JobIndicator(jobs)
    qtbot.addWidget(indicator)
    release = Event()

    def wait(progress: Callable[[float], None]) -> None:
        release.wait(20)

    long = jobs.read_or_write("long", wait)
    with qtbot.waitSignal(jobs.read_or_write("short", double, 1).ended):
        pass
    qtbot.waitUntil(indicator.isVisible)
    assert indicator._title.text() == "long"
    with qtbot.waitSignal(long.ended):
        release.set()
    assert not indicator.isVisible()


def test_a_dialog_that_an_outcome_opens_holds_no_other_job_up(jobs: Jobs, qtbot: QtBot) -> None:
    release = Event()

    def wait(progress: Callable[[float], None]) -> None:
        release.wait(20)

    other = jobs.read_or_write("other", wait)
    seen = outcomes(other)

    def open_dialog() -> None:
        with qtbot.waitSignal(other.ended):
            release.set()
        seen.append("dialog closed")

    job = jobs.read_or_write("double", double, 1)
    job.finished.connect(open_dialog)
    with qtbot.waitSignal(job.ended, timeout=20_000):
        pass
    assert seen == ["finished", "dialog closed"]
    assert jobs.running == 0


DROPPED = """
from PySide6.QtCore import QCoreApplication
from mocapmend.jobs import Jobs

app = QCoreApplication([])
for _ in range(50):
    jobs = Jobs()
    job = jobs.read_or_write("nothing", lambda progress: None)
    while jobs.running:
        app.processEvents()
    jobs.shut_down()
print("whole")
"""


def test_a_runner_may_go_as_soon_as_its_jobs_have_ended() -> None:
    done = subprocess.run([sys.executable, "-c", DROPPED], capture_output=True, text=True)
    assert (done.stdout, done.stderr, done.returncode) == ("whole\n", "", 0)


ORPHAN = """
import os, signal, sys
from PySide6.QtCore import QCoreApplication
from mocapmend.jobs import Jobs

def pid(progress):
    return os.getpid()

if __name__ == "__main__":
    app = QCoreApplication([])
    jobs = Jobs()
    job = jobs.compute("pid", pid)

    def die(worker):
        print(worker, flush=True)
        os.kill(os.getpid(), signal.SIGKILL)

    job.finished.connect(die)
    app.exec()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_the_worker_ends_with_a_killed_window(tmp_path: Path, qtbot: QtBot) -> None:
    script = tmp_path / "orphan.py"
    script.write_text(ORPHAN)
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True)
    status = Path(f"/proc/{int(done.stdout)}/stat")

    def gone() -> bool:
        # Ended, and perhaps not yet collected by its new parent.
        return not status.exists() or status.read_text().rpartition(")")[2].split()[0] == "Z"

    qtbot.waitUntil(gone, timeout=20_000)


class Cycle(QObject):
    """Garbage that only the collector can find; says which thread deleted it."""

    def __init__(self, deleted_by: list[threading.Thread]) -> None:
        super().__init__()
        self._self = self
        self._deleted_by = deleted_by

    def __del__(self) -> None:
        self._deleted_by.append(threading.current_thread())


def leave_garbage(progress: Progress) -> None:
    """Allocate so much that Python would look for garbage many times, in this thread."""
    for step in range(100):
        progress(step / 100)
        _ = [[] for _ in range(1000)]


def test_only_the_thread_of_the_window_deletes_qt_objects(jobs: Jobs, qtbot: QtBot) -> None:
    deleted_by: list[threading.Thread] = []
    Cycle(deleted_by)
    with qtbot.waitSignal(jobs.read_or_write("allocate", leave_garbage).finished):
        pass
    assert deleted_by == []
    # The window's thread allocates too, and finds it.
    kept: list[list[int]] = []

    def found() -> bool:
        kept.extend([] for _ in range(1000))
        return bool(deleted_by)

    qtbot.waitUntil(found, timeout=20_000)
    assert deleted_by == [threading.main_thread()]


def test_after_the_shut_down_garbage_is_collected_as_ever(jobs: Jobs) -> None:
    assert not gc.isenabled()
    jobs.shut_down()
    assert gc.isenabled()
