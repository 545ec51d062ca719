"""How long it takes to start the program, beside a bare window."""

import subprocess
import sys
import time

import numpy as np

from mocapmend.bench.table import Row


def start_rows(runs: int) -> list[Row]:
    """Start our window and a bare one in turn, after a round that is not counted."""
    times: dict[str, list[float]] = {"program": [], "bare": []}
    for counted in range(-1, runs):
        for which, seconds in times.items():
            command = [sys.executable, "-m", "mocapmend.bench.gui.first_paint", which]
            started = time.time()
            done = subprocess.run(command, check=True, capture_output=True, text=True)  # noqa: S603
            if counted >= 0:
                seconds.append(float(done.stdout) - started)
    ours, bare = np.array(times["program"]), np.array(times["bare"])
    return [
        Row(
            "bare PySide6 + pyqtgraph window, start to first paint", float(np.median(bare)), "s"
        ),
        Row(
            "mocapmend, start to first paint", float(np.median(ours)), "s",
            "bare window", float(np.median(ours / bare)), "<= 1.6",
        ),
    ]  # fmt: skip
