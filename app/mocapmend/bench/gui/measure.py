"""Starts a process for a measurement and takes its figures."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from mocapmend.errors import MocapmendError

CHILD = "mocapmend.bench.gui.child"


def measure(name: str, path: Path, *sizes: float, python: str = sys.executable) -> dict[str, Any]:
    """Measure something in a new process and return its figures.

    Parameters
    ----------
    name : str
        A key of `child.MODULES`.
    path : Path
        The recording.
    *sizes : float
        What the measurement takes besides.
    python : str
        The interpreter.

    Raises
    ------
    MocapmendError
        If the process fails.
    """
    command = [python, "-m", CHILD, name, str(path), *map(str, sizes)]
    done = subprocess.run(command, check=False, capture_output=True, text=True)  # noqa: S603
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise MocapmendError(f"The measurement of {name} failed: {last}.", "bench gui", "Retry.")
    # Libraries print as they like; the figures come last.
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found
