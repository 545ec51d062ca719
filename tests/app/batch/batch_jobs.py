"""What worker processes do in tests of their lives; told by the name of the file."""

import os
import signal

from threadpoolctl import threadpool_info

from mocapmend.batch.results import Finished, Problem
from mocapmend.batch.work import Task
from mocapmend.repairing import Began
from mocapmend_algorithms import Progress


def live_or_die(task: Task, progress: Progress, began: Began) -> Finished:
    """Answer with the process, die, or go on until somebody wants it to stop."""
    began("Living")
    word = task.file.partition(" ")[0]
    if word == "kill":
        os.kill(os.getpid(), signal.SIGKILL)
    if word == "exit":
        os._exit(3)
    while word == "forever":
        progress(0.5)
    if word == "unheard":
        signal.pause()
    import numpy as np

    assert np.ones(2) @ np.ones(2) == 2
    threads = {each["num_threads"] for each in threadpool_info() if each["user_api"] == "blas"}
    return Finished(task.failed(Problem(str(os.getpid()), str(sorted(threads)))))
