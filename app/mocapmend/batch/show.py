"""What a user sees of a batch while it runs, as texts: how far, what goes on, how long still."""

import math
import time
from collections.abc import Callable, Sequence
from itertools import islice

from mocapmend.batch.results import Finished, Row
from mocapmend.batch.time_left import TimeLeft
from mocapmend.batch.work import Task
from mocapmend.wording import count

LONGEST_NAME = 32
"""Characters of a file's name in the line that changes: how far it is stands behind it."""


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
        self._left = TimeLeft(tasks, clock)
        self._current: dict[str, str] = {}

    def at(self, task: Task, step: str, fraction: float) -> None:
        """Note how far a task is."""
        self._current[task.file] = f"{_short(task.file)} ({step.lower()} {100 * fraction:.0f} %)"

    def began(self, task: Task) -> None:
        """Note that a task was given to somebody."""
        self._current[task.file] = _short(task.file)

    def finished(self, task: Task, row: Row) -> None:
        """Note the end of a task."""
        self._current.pop(task.file, None)
        self._left.finished(task, row.seconds if row.state == "repaired" else None)
        self.done += 1

    def line(self, workers: int) -> str:
        """Say all of it in a line, with as many files as are worked at."""
        current = dict(islice(self._current.items(), workers))
        left = self._left.seconds(current, workers)
        about = "" if math.isnan(left) else f", about {duration(left)} left"
        return f"{self.done} of {count(self._files, 'file')}{about}: {', '.join(current.values())}"


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


def _short(file: str) -> str:
    """Return a file's name, or the end of it, where names differ."""
    return file if len(file) <= LONGEST_NAME else "…" + file[1 - LONGEST_NAME :]
