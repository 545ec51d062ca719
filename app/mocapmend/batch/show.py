"""What a user sees of a batch while it runs, as texts: how far, what goes on, how long still."""

import math
import time
from collections.abc import Callable, Sequence

from mocapmend.batch.results import Finished, Row
from mocapmend.batch.work import Task
from mocapmend.wording import count

SMALLEST = 100_000
"""Bytes that every file counts at least: starting takes its time too."""


class Tracker:
    """How far a batch is.

    Parameters
    ----------
    tasks : sequence of Task
        What is done.
    clock : callable
        Seconds that go by.

    Attributes
    ----------
    done : int
        How many tasks have ended.
    """

    def __init__(self, tasks: Sequence[Task], clock: Callable[[], float] = time.monotonic) -> None:
        self.done = 0
        self._files = len(tasks)
        self._clock = clock
        self._start = clock()
        self._weight = sum(map(_weight, tasks))
        self._weight_done = 0.0
        self._current: dict[str, str] = {}

    def at(self, task: Task, step: str, fraction: float) -> None:
        """Note how far a task is."""
        self._current[task.file] = f"{task.file} ({step.lower()} {100 * fraction:.0f} %)"

    def began(self, task: Task) -> None:
        """Note that a task was given to somebody."""
        self._current[task.file] = task.file

    def finished(self, task: Task) -> None:
        """Note the end of a task."""
        self._current.pop(task.file, None)
        self._weight_done += _weight(task)
        self.done += 1

    @property
    def seconds_left(self) -> float:
        """How long the rest is going to take, by the size of the files; NaN while nobody knows."""
        if not self._weight_done:
            return math.nan
        spent = self._clock() - self._start
        return spent * (self._weight - self._weight_done) / self._weight_done

    def line(self, workers: int) -> str:
        """Say all of it in a line, with as many files as are worked at."""
        left = self.seconds_left
        about = "" if math.isnan(left) else f", about {duration(left)} left"
        names = ", ".join(list(self._current.values())[:workers])
        return f"{self.done} of {count(self._files, 'file')}{about}: {names}"


def duration(seconds: float) -> str:
    """Write how long something takes, as one would say it."""
    if seconds < 60:
        return f"{math.ceil(seconds)} s"
    minutes = math.ceil(seconds / 60)
    return f"{minutes} min" if minutes < 60 else f"{minutes // 60} h {minutes % 60:02} min"


def result_text(row: Row) -> str:
    """Say what has become of a file in a line."""
    if row.state == "nothing":
        return f"{row.file}: nothing to repair"
    if row.problem is not None:
        return f"{row.file}: failed: {row.problem.what} {row.problem.todo}".rstrip()
    if row.figures is None:
        return f"{row.file}: not done yet"
    figures = row.figures
    text = f"{row.file}: {figures.filled} of {count(figures.gaps, 'gap')} filled"
    if figures.expected_worst_mm is not None:
        text += f", largest expected error {figures.expected_worst_mm:.1f} mm"
    return f"{text}, {row.seconds:.1f} s"


def end_text(finished: Finished, done: int, files: int) -> str:
    """Say what has become of a file, and how many are done."""
    return f"{done} of {files}: {result_text(finished.row)}"


def _weight(task: Task) -> float:
    return float(max(task.size, SMALLEST))
