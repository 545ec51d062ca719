"""The most memory that the window and its workers take for a recording."""

import multiprocessing
import os
import threading
from pathlib import Path
from typing import Any

import numpy as np

from mocapmend.bench.gui.stage import (
    opened,
    settle,
    show_plots,
    steps_per_second,
    wait_until,
    window,
)
from mocapmend.bench.gui.steps import scrub_places
from mocapmend.edits import Edit
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill import registry
from mocapmend_algorithms.fill.contract import Patch

EVERY_S = 0.02
NOT_TOLD = "told on Linux only"


class Gauge:
    """Looks again and again at what this process and its workers hold.

    What they share counts once.
    """

    def __init__(self) -> None:
        self._pids = [os.getpid(), *(child.pid for child in multiprocessing.active_children())]
        self._before = self._held()
        self._most = self._before
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._look)
        self._thread.start()

    @property
    def growth_mb(self) -> float:
        """The most that was held so far, beyond what was held at first."""
        return (self._most - self._before) / 1e6

    def stop(self) -> None:
        """Look no more."""
        self._end.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._end.wait(EVERY_S):
            self._most = max(self._most, self._held())

    def _held(self) -> int:
        return sum(_proportional(Path(f"/proc/{pid}/smaps_rollup")) for pid in self._pids)


def memory(path: Path) -> dict[str, Any]:
    """Return the growth (MB) by looking at a recording and by repairing a gap, and its points."""
    if not Path("/proc/self/smaps_rollup").is_file():
        return {"missing": NOT_TOLD}
    with window() as shown:
        gauge = Gauge()
        workspace = opened(shown, path)
        show_plots(workspace)
        view, document = workspace.view, workspace.document
        steps_per_second(lambda frame: view.set_frame(int(frame)), scrub_places(view.frames))
        # Not the worst problem: bad samples that are to be exchanged have no preview.
        workspace.gap_actions.step_here(1)
        wait_until(lambda: view.preview is not None)
        settle(workspace, shown)
        looking = gauge.growth_mb
        last = workspace.report.report
        gap = document.gaps[0]
        workspace.push([Edit.fill(_flat(gap), "cubic", registry.method("cubic").params())], "fill")
        wait_until(lambda: workspace.report.report is not last)
        settle(workspace, shown)
        gauge.stop()
        points = document.original.points.nbytes / 1e6
        return {"looking": looking, "edited": gauge.growth_mb, "points": points}


def _flat(gap: Gap) -> Patch:
    """Return a repair, whatever the method that is chosen makes of the gap."""
    return Patch(gap, np.zeros((gap.length, 3)), np.ones(gap.length), np.ones(gap.length))


def _proportional(path: Path) -> int:
    """Return the bytes of a process, its share of what it has in common with others."""
    line = next(line for line in path.read_text().splitlines() if line.startswith("Pss:"))
    return int(line.split()[1]) * 1024
