"""Small recordings for batches, and those who repair them where a test wants no processes."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from c3d_synthetic import Synthetic, encode, walk

from mocapmend.batch.crew import Watcher
from mocapmend.batch.work import Task, do
from mocapmend_algorithms import no_progress


def write_trial(path: Path, seed: int = 0, longest: int = 30, frames: int = 120) -> Path:
    """Write a recording at 100 Hz with gaps of 5, `longest` and (leading) 4 frames."""
    points = walk(frames=frames, seed=seed)
    fourth = np.zeros(points.shape[:2])
    for rows, marker in ((slice(10, 15), 0), (slice(40, 40 + longest), 0), (slice(0, 4), 2)):
        fourth[rows, marker] = -1
        points[rows, marker] = 0
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(encode(Synthetic(points, fourth=fourth)))
    return path


class InTurn:
    """Does the tasks of a batch here, one after the other."""

    size = 1

    def __init__(self, jobs: int = 1) -> None:
        self.jobs = jobs

    def work(self, tasks: Sequence[Task], watcher: Watcher) -> None:
        for task in tasks:
            if watcher.stopping:
                return
            watcher.began(task)
            watcher.finished(task, do(task, no_progress, lambda step: None))
            watcher.tick()
