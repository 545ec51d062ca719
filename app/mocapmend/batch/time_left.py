"""How long the rest of a batch takes, by the size of its files and what those done have taken."""

import math
from collections.abc import Callable, Iterable, Sequence

from mocapmend.batch.work import Task

SMALLEST = 100_000
"""Bytes that every file counts at least: starting takes its time too."""


class TimeLeft:
    """An estimate that goes down while files are worked at, and not only when one is done.

    Parameters
    ----------
    tasks : sequence of Task
        What is done.
    clock : callable
        Seconds that go by.
    """

    def __init__(self, tasks: Sequence[Task], clock: Callable[[], float]) -> None:
        self._clock = clock
        self._left = {task.file: _weight(task) for task in tasks}
        self._since: dict[str, float] = {}
        self._weight_known = self._seconds_known = 0.0

    def finished(self, task: Task, seconds: float | None) -> None:
        """Note the end of a task, and how long it took if that says something of others."""
        self._left.pop(task.file, None)
        if seconds is not None:
            self._weight_known += _weight(task)
            self._seconds_known += seconds

    def seconds(self, current: Iterable[str], workers: int) -> float:
        """Return how long the rest is going to take; NaN while nobody knows.

        Parameters
        ----------
        current : iterable of str
            The files that are worked at.
        workers : int
            How many do that at once.
        """
        now = self._clock()
        # Not when it was given away: a cluster gets all files at once.
        spent = {file: now - self._since.setdefault(file, now) for file in current}
        if not self._weight_known:
            return math.nan
        pace = self._seconds_known / self._weight_known
        rest = [
            max(pace * weight - spent.get(file, 0.0), 0.0) for file, weight in self._left.items()
        ]
        # The last files are not shared by the workers.
        return max(math.fsum(rest) / workers, max(rest, default=0.0)) or math.nan


def _weight(task: Task) -> float:
    return float(max(task.size, SMALLEST))
