"""What those who do the work of a batch have in common, processes of this machine or a cluster."""

from collections.abc import Sequence
from typing import Protocol

from mocapmend.batch.results import Finished
from mocapmend.batch.work import Task


class Watcher(Protocol):
    """Is told what becomes of the tasks, in the thread that has called `Crew.work`."""

    @property
    def stopping(self) -> bool:
        """Whether no more is to be done."""

    def began(self, task: Task) -> None:
        """Hear that a task goes to a worker."""

    def at(self, task: Task, step: str, fraction: float) -> None:
        """Hear how far a step of a task is, from 0 to 1."""

    def finished(self, task: Task, finished: Finished) -> None:
        """Hear of the end of a task."""

    def tick(self) -> None:
        """Have a moment's time, several times a second."""


class Crew(Protocol):
    """Does tasks, each once."""

    @property
    def size(self) -> int:
        """How many tasks are done at once, about."""

    def work(self, tasks: Sequence[Task], watcher: Watcher) -> None:
        """Do tasks until all are done or the watcher wants to stop; then nothing goes on."""
