"""Work in the background: pure functions on snapshots, with progress and cancel.

Computation runs in a spawned process, because scipy holds the interpreter for up to seconds;
reading and writing files runs in a thread.
"""

import gc
import sys
from collections.abc import Callable
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import Any

from pyqtgraph.util.garbage_collector import GarbageCollector
from PySide6.QtCore import QObject, QTimer, Signal

from mocapmend.errors import MocapmendError
from mocapmend.shared_recording import SharedRecording
from mocapmend.workers import Board, Workers
from mocapmend_algorithms import Cancelled

SWITCH_S = 0.0005
"""How long a thread may keep the interpreter while the window's thread waits for it.

Every call into Qt gives the interpreter away for a moment; with Python's own 5 ms a picture that
is painted beside a busy thread takes a good part of a second.
"""
POLL_MS = 10
"""How often the window's thread looks at its jobs: no other thread touches a Qt object."""
APART = object()
"""Stands among the arguments of a job in a thread for a function `apart(function, *args)`.

It has a worker process call `function(*args, progress)` and waits for the result: what is long and
all Python would keep the interpreter from the window, call by call.
"""


def _call_in_thread(
    workers: Workers, slot: int, function: Callable[..., Any], args: tuple[Any, ...]
) -> Any:
    """Give a thread what a worker gets: recordings in place of their handles."""

    def apart(inner: Callable[..., Any], *inner_args: object) -> Any:
        return workers.submit(slot, inner, inner_args).result()

    given = (
        arg.recording() if isinstance(arg, SharedRecording) else apart if arg is APART else arg
        for arg in args
    )
    return function(*given, workers.board.reporter(slot))


class Job(QObject):
    """One piece of work.

    It ends with exactly one of finished, failed and cancelled, then ended; when it was abandoned
    with ended alone. Python owns it: what is connected to its signals must not hold it.
    """

    progressed = Signal(float)
    finished = Signal(object)
    failed = Signal(object)
    cancelled = Signal()
    ended = Signal()

    def __init__(
        self,
        title: str,
        board: Board,
        slot: int,
        future: Future[Any],
        held: tuple[Any, ...],
    ) -> None:
        super().__init__()
        self.title = title
        self.slot = slot
        self.quiet = False
        self._board = board
        self._future = future
        self._held = held
        """The arguments: kept alive until the end."""
        self.progress = 0.0
        self.over = False
        self._settled = False
        self._abandoned = False

    def cancel(self) -> None:
        """Ask the job to stop; `cancelled` follows unless it was just finishing."""
        if self.over:
            # Another job may have the slot by now.
            return
        self._board.cancel[self.slot] = 1
        self._future.cancel()

    def abandon(self) -> None:
        """Cancel for one who has gone, or has asked for something else: no outcome is told."""
        self._abandoned = True
        self.cancel()

    def poll(self) -> None:
        """Pass the worker's progress on, or see to it that the end of its work is told."""
        if self._settled:
            return
        progress = self._board.progress[self.slot]
        if progress != self.progress:
            self.progress = progress
            self.progressed.emit(progress)
        if self._future.done():
            self._settled = True
            # Not from within the timer's slot: a dialog that an outcome opens would keep the timer
            # from all other jobs.
            QTimer.singleShot(0, self, self._conclude)

    def _conclude(self) -> None:
        self._held = ()
        self.over = True
        if not self._abandoned:
            self._tell_outcome()
        self.ended.emit()

    def _tell_outcome(self) -> None:
        asked_to_stop = bool(self._board.cancel[self.slot])
        try:
            result = self._future.result()
        except (Cancelled, CancelledError):
            self.cancelled.emit()
        except BrokenProcessPool:
            self.failed.emit(
                MocapmendError("The background worker stopped unexpectedly.", self.title, "Retry.")
            )
        except Exception as error:  # noqa: BLE001 - the end of the thread: whatever it is, show it
            self.failed.emit(error)
        else:
            if asked_to_stop:
                self.cancelled.emit()
            else:
                self.finished.emit(result)


class Jobs(QObject):
    """Starts jobs and knows which are running.

    Until it is shut down, cyclic garbage is collected in the window's thread only. Any thread that
    allocates would do it else, those of the pools too, and would delete the Qt objects in it while
    the window's thread is at work in Qt: a segmentation fault.
    """

    started = Signal(object)
    ended = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._garbage = GarbageCollector()
        self._usual_switch = sys.getswitchinterval()
        sys.setswitchinterval(SWITCH_S)
        self._workers = Workers()
        self._running: dict[int, Job] = {}
        self._threads = ThreadPoolExecutor(max_workers=2, thread_name_prefix="mocapmend")
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self._poll)

    @property
    def running(self) -> int:
        """Number of jobs that have not ended."""
        return len(self._running)

    def compute(
        self, title: str, function: Callable[..., Any], *args: object, quiet: bool = False
    ) -> Job:
        """Run `function(*args, progress)` in a worker process; it must be importable there.

        A quiet job is one that nobody asked for in so many words: it is not shown as running.
        """
        slot = self._take_slot(title)
        future = self._workers.submit(slot, function, args)
        return self._start(title, slot, future, args, quiet=quiet)

    def read_or_write(self, title: str, function: Callable[..., Any], *args: object) -> Job:
        """Run `function(*args, progress)` in a thread: for files, which wait more than compute."""
        slot = self._take_slot(title)
        future = self._threads.submit(_call_in_thread, self._workers, slot, function, args)
        return self._start(title, slot, future, args)

    def warm_up(self) -> None:
        """Start the worker processes before they are first needed."""
        self._workers.warm_up()

    def shut_down(self) -> None:
        """Cancel everything and wait for the workers to end."""
        for job in self._running.values():
            job.cancel()
        self._threads.shutdown(wait=True, cancel_futures=True)
        self._workers.shut_down()
        self._timer.stop()
        self._garbage.timer.stop()
        gc.enable()
        sys.setswitchinterval(self._usual_switch)

    def _take_slot(self, title: str) -> int:
        slot = self._workers.take_slot()
        if slot is None:
            raise MocapmendError(
                "Too many jobs are running at once.", title, "Wait for one to end."
            )
        return slot

    def _start(
        self,
        title: str,
        slot: int,
        future: Future[Any],
        held: tuple[Any, ...],
        *,
        quiet: bool = False,
    ) -> Job:
        job = Job(title, self._workers.board, slot, future, held)
        job.quiet = quiet
        job.ended.connect(self._retire)
        self._running[slot] = job
        self._timer.start()
        self.started.emit(job)
        return job

    def _retire(self) -> None:
        for job in [job for job in self._running.values() if job.over]:
            del self._running[job.slot]
            self._workers.give_back(job.slot)
            self.ended.emit(job)
        if not self._running:
            self._timer.stop()

    def _poll(self) -> None:
        for job in list(self._running.values()):
            job.poll()
