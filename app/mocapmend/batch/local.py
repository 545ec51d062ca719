"""The processes of this machine that do a batch.

Each is started by itself and not in a pool of the standard library: when a process of such a pool
dies, nobody can tell which file it was at, and all the others are lost too.
"""

import multiprocessing
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnContext, SpawnProcess

from mocapmend.batch.crew import Watcher
from mocapmend.batch.results import Finished, Problem
from mocapmend.batch.work import Task, do
from mocapmend.repairing import Began
from mocapmend.workers import leave_with_parent
from mocapmend_algorithms import Cancelled, Progress

Do = Callable[[Task, Progress, Began], Finished]
TICK_S = 0.2
"""How often the user is told something, and how soon a wish to stop is noticed."""
MOST = 30 if sys.platform == "win32" else 1024
"""Windows waits for 63 things at once, and each worker is two of them."""
PATIENCE_S = 5.0
"""How long a worker may take to come to the end of what cannot be interrupted."""


class Local:
    """Worker processes.

    Parameters
    ----------
    jobs : int
        How many at most.
    work : callable
        What they do with a task; it must be importable.
    """

    def __init__(self, jobs: int, work: Do = do) -> None:
        self.size = min(jobs, MOST)
        self._do = work
        self._context = multiprocessing.get_context("spawn")

    def work(self, tasks: Sequence[Task], watcher: Watcher) -> None:
        """See `Crew.work`; a worker that dies costs its task alone."""
        waiting = deque(tasks)
        workers: list[_Worker] = []
        try:
            while not watcher.stopping and (waiting or workers):
                while waiting and len(workers) < self.size:
                    workers.append(_Worker(self._context, self._do))
                for worker in workers:
                    if worker.task is None and waiting:
                        watcher.began(waiting[0])
                        worker.give(waiting.popleft())
                wait([item for worker in workers for item in worker.to_wait_for], TICK_S)
                for worker in workers:
                    worker.hear(watcher)
                workers = [worker for worker in workers if worker.needed(bool(waiting))]
                watcher.tick()
        finally:
            _end(workers)


class _Worker:
    """A process, and the task that it is at."""

    def __init__(self, context: SpawnContext, work: Do) -> None:
        self.task: Task | None = None
        self._pipe, theirs = context.Pipe()
        self._process: SpawnProcess = context.Process(
            target=_serve, args=(theirs, work), daemon=True
        )
        with _deaf_to_interrupts():
            self._process.start()
        theirs.close()
        self._dead = False

    @property
    def to_wait_for(self) -> tuple[Connection, int]:
        """What has something to say when the worker has."""
        return self._pipe, self._process.sentinel

    def give(self, task: Task) -> None:
        """Have it do a task."""
        self.task = task
        # Where it has died, `hear` says so.
        with suppress(OSError):
            self._pipe.send(task)

    def hear(self, watcher: Watcher) -> None:
        """Pass on what it has said, or its death."""
        try:
            while self._pipe.poll():
                said = self._pipe.recv()
                assert self.task is not None
                if isinstance(said, Finished):
                    task, self.task = self.task, None
                    watcher.finished(task, said)
                else:
                    watcher.at(self.task, *said)
        except (EOFError, OSError):
            self._process.join()
        if not self._process.is_alive():
            self._dead = True
            if self.task is not None:
                problem = _death(self._process.exitcode, self.task)
                watcher.finished(self.task, Finished(self.task.failed(problem)))
                self.task = None

    def needed(self, more: bool) -> bool:  # noqa: FBT001
        """Say whether it has, or will have, something to do; let it go where it has not."""
        if self._dead or (self.task is None and not more):
            self.leave()
            self.join(PATIENCE_S)
            return False
        return True

    def leave(self) -> None:
        """Ask it to stop: a closed pipe is what it looks for."""
        self._pipe.close()

    def join(self, seconds: float) -> None:
        """Wait for its end, and end it when that takes too long."""
        self._process.join(seconds)
        if self._process.is_alive():
            self._process.kill()
            self._process.join()
        self._process.close()


def _end(workers: Sequence[_Worker]) -> None:
    for worker in workers:
        worker.leave()
    end = time.monotonic() + PATIENCE_S
    for worker in workers:
        worker.join(max(end - time.monotonic(), 0.0))


def _death(code: int | None, task: Task) -> Problem:
    """Say how a worker has died."""
    known = {-number: f"signal {number.name}" for number in signal.Signals}
    how = known.get(code or 0, f"code {code}")
    if how == "signal SIGKILL":
        how += "; the system may have run out of memory"
    return Problem(
        f"The process that repaired this file has died ({how}).",
        str(task.request.file),
        "Repair fewer files at once (--jobs 1), or leave this file out.",
    )


# --- in the process ------------------------------------------------------------------------------


def _serve(pipe: Connection, work: Do) -> None:
    """Do tasks until the pipe is closed."""
    # The parent hears of Ctrl-C too, and decides.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=leave_with_parent, daemon=True).start()
    teller = _Teller(pipe)
    with suppress(EOFError, OSError, Cancelled):
        while True:
            pipe.send(work(pipe.recv(), teller.progress, teller.began))


class _Teller:
    """Tells the parent how far a task is, not more often than somebody looks."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe
        self._step = ""
        self._next = 0.0

    def began(self, step: str) -> None:
        """Name what `progress` is about from now on."""
        self._step = step
        self._next = 0.0

    def progress(self, fraction: float, /) -> None:
        """Tell it; stop where the parent has closed the pipe."""
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + TICK_S
        try:
            # While a task is done, nothing comes but the end.
            if self._pipe.poll():
                raise Cancelled
            self._pipe.send((self._step, fraction))
        except OSError:
            raise Cancelled from None


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """Let a process that is started here not hear of Ctrl-C before it can say so itself."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
