"""Processes that compute, and the flags that they share with the window; none of them loads Qt."""

import multiprocessing
import os
import threading
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from importlib import import_module
from typing import Any

from mocapmend.shared_memory import start_tracker
from mocapmend_algorithms import Cancelled

SLOTS = 32
WORKERS = 2
"""One for what takes long, one for the preview that the user waits for."""
SLOW_TO_LOAD = ("mocapmend.engine", "scipy.linalg", "scipy.optimize")

_board: "Board | None" = None


class Board:
    """Progress and cancel flags of running jobs, shared with the workers."""

    def __init__(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.progress = context.Array("d", SLOTS, lock=False)
        self.cancel = context.Array("b", SLOTS, lock=False)

    def reporter(self, slot: int) -> Callable[[float], None]:
        """Return the progress function of the job in a slot."""

        def progress(fraction: float) -> None:
            self.progress[slot] = fraction
            if self.cancel[slot]:
                raise Cancelled

        return progress


class Workers:
    """Worker processes, started when they are first needed, and the slots of the jobs.

    Attributes
    ----------
    board : Board
        What jobs and workers tell each other, by slot.
    """

    def __init__(self) -> None:
        start_tracker()
        self.board = Board()
        self._free = list(range(SLOTS))
        self._pool: ProcessPoolExecutor | None = None

    def take_slot(self) -> int | None:
        """Return a slot with its flags cleared; None when all are taken."""
        if not self._free:
            return None
        slot = self._free.pop()
        self.board.progress[slot] = 0.0
        self.board.cancel[slot] = 0
        return slot

    def give_back(self, slot: int) -> None:
        """Let another job have the slot."""
        self._free.append(slot)

    def submit(self, slot: int, function: Callable[..., Any], args: tuple[Any, ...]) -> Future[Any]:
        """Run `function(*args, progress)` in a worker; workers that have died are replaced."""
        try:
            return self._started().submit(_call, slot, function, args)
        except BrokenProcessPool:
            self._pool = None
            return self._started().submit(_call, slot, function, args)

    def warm_up(self) -> None:
        """Start the processes before they are first needed."""
        for _ in range(WORKERS):
            self._started().submit(_get_ready)

    def shut_down(self) -> None:
        """Wait for the processes to end; what they have not begun is dropped."""
        if self._pool is not None:
            self._pool.shutdown(wait=True, cancel_futures=True)

    def _started(self) -> ProcessPoolExecutor:
        if self._pool is None:
            self._pool = ProcessPoolExecutor(
                max_workers=WORKERS,
                mp_context=multiprocessing.get_context("spawn"),
                initializer=_adopt,
                initargs=(self.board,),
            )
        return self._pool


def _adopt(board: Board) -> None:
    """Give a new worker process the flags."""
    global _board  # noqa: PLW0603 - the one thing that a pool's initializer can do
    _board = board
    threading.Thread(target=leave_with_parent, daemon=True).start()


def leave_with_parent() -> None:
    """End with the window, however it ended: else memory stays taken that nobody can free."""
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)


def _get_ready() -> None:
    """Load what takes long to load."""
    for name in SLOW_TO_LOAD:
        import_module(name)


def _call(slot: int, function: Callable[..., Any], args: tuple[Any, ...]) -> Any:
    # Not at the top: the window starts without what repairs need.
    from mocapmend.pieces import in_pieces

    assert _board is not None
    return in_pieces(function(*args, _board.reporter(slot)))
