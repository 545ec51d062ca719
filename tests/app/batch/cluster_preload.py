"""Makes the workers of a test's cluster die, or work without an end, at files of certain names."""

import os
import signal
import time
from pathlib import Path
from typing import Any

from mocapmend.batch import remote
from mocapmend.batch.results import Finished
from mocapmend.batch.work import Task
from mocapmend.repairing import Began
from mocapmend_algorithms import Cancelled, Progress

_do = remote.do


def _do_or_die(task: Task, progress: Progress, began: Began) -> Finished:
    name, beside = task.request.file.stem, task.request.file.with_suffix(".tried")
    first = not beside.exists()
    if name in {"killer", "kills once"}:
        beside.touch()
        if name == "killer" or first:
            os.kill(os.getpid(), signal.SIGKILL)
    if name == "forever":
        beside.touch()
        _work_until_cancelled(progress, Path(f"{beside}.stopped"))
    return _do(task, progress, began)


def _work_until_cancelled(progress: Progress, stopped: Path) -> None:
    try:
        while True:
            progress(0.5)
            time.sleep(0.01)
    except Cancelled:
        stopped.touch()
        raise


def dask_setup(worker: Any) -> None:
    """Dask calls this in every worker."""
    remote.do = _do_or_die
