"""Worker processes that outlive a test: to start them takes longer than most tests do."""

from collections.abc import Callable
from concurrent.futures import Future, wait
from typing import Any

from mocapmend.workers import Board, Workers


class LentWorkers:
    """What one `Jobs` sees of workers that others will use after it.

    Shutting it down waits for what it has asked for, as the end of the processes would.

    Parameters
    ----------
    kept : Workers
        The processes.
    """

    def __init__(self, kept: Workers) -> None:
        self._kept = kept
        self._slots: set[int] = set()
        self._asked: list[Future[Any]] = []

    @property
    def board(self) -> Board:
        return self._kept.board

    def take_slot(self) -> int | None:
        slot = self._kept.take_slot()
        if slot is not None:
            self._slots.add(slot)
        return slot

    def give_back(self, slot: int) -> None:
        # A job may be told its end after the shut-down, which has given its slot back.
        if slot in self._slots:
            self._slots.remove(slot)
            self._kept.give_back(slot)

    def submit(self, slot: int, function: Callable[..., Any], args: tuple[Any, ...]) -> Future[Any]:
        future = self._kept.submit(slot, function, args)
        self._asked.append(future)
        return future

    def warm_up(self) -> None:
        self._kept.warm_up()

    def shut_down(self) -> None:
        wait(self._asked)
        for slot in list(self._slots):
            self.give_back(slot)
