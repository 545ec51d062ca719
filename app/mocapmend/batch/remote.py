"""What a worker of a cluster does with a task.

Client and workers tell each other by files in a folder that all of them see: how often a task was
tried, which survives a worker's death, and whether the client still wants it.
"""

import hashlib
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from threadpoolctl import threadpool_limits

from mocapmend import __version__
from mocapmend.batch.results import Finished, Problem
from mocapmend.batch.work import Task, do
from mocapmend_algorithms import Cancelled

MOST_ATTEMPTS = 2
"""A worker that dies costs one more attempt."""
LOOK_S = 1.0


def introduce() -> Callable[..., Any]:
    """Return a function that asks a worker for its version, and for a folder that it lacks.

    It is a local one, which travels by value: a worker need not have the program.
    """

    def answer(folders: list[str]) -> tuple[str, str]:
        from pathlib import Path

        try:
            from mocapmend import __version__ as version
        except ImportError:
            version = ""
        missing = [folder for folder in folders if not Path(folder).is_dir()]
        return version, missing[0] if missing else ""

    return answer


def attempt(task: Task, run: Path, version: str) -> Finished:
    """Do a task, unless those who have tried have died of it.

    Parameters
    ----------
    task : Task
        What to do.
    run : Path
        The folder of the client's run.
    version : str
        Of the client's program: a worker may have come after all were asked for theirs.

    Raises
    ------
    Cancelled
        When the client does not want it any more: then the folder has gone.
    """
    if version != __version__:
        problem = Problem(
            f"A worker has mocapmend {__version__}; this is mocapmend {version}.",
            str(task.request.file),
            "Install the same version everywhere, and start the workers again.",
        )
        return Finished(task.failed(problem), untouched=True)
    counter = run / hashlib.sha256(task.file.encode("utf-8", "surrogateescape")).hexdigest()
    if _count(counter) > MOST_ATTEMPTS:
        problem = Problem(
            f"{MOST_ATTEMPTS} workers have died while they repaired this file; they may have run "
            "out of memory.",
            str(task.request.file),
            "Give the workers more memory, or leave this file out.",
        )
        return Finished(task.failed(problem))
    # The last bits of a repair depend on how many threads compute it. For good, since another task
    # may be at work in another thread.
    threadpool_limits(1, user_api="blas")
    looked = time.monotonic()

    def progress(fraction: float, /) -> None:
        nonlocal looked
        if time.monotonic() - looked > LOOK_S:
            looked = time.monotonic()
            if not run.is_dir():
                raise Cancelled

    finished = do(task, progress, lambda step: None)
    # A result can be lost with its worker, who may die of another file: to make it again is no
    # attempt more.
    counter.unlink(missing_ok=True)
    return finished


def _count(counter: Path) -> int:
    """Count an attempt, and return how many have not ended."""
    try:
        with counter.open("ab") as stream:
            stream.write(b".")
            return stream.tell()
    except OSError:
        raise Cancelled from None
