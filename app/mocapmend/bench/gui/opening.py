"""How long it takes to open a recording, and to read it alone."""

import time
from pathlib import Path

from mocapmend.bench.gui.stage import wait_until, window
from mocapmend.engine import FOR_MANY
from mocapmend.files import read_recording
from mocapmend.views.first_paint import FirstPaint


def reading(path: Path) -> dict[str, float]:
    """Return the seconds that reading takes in a fresh process."""
    start = time.perf_counter()
    read_recording(path)
    return {"seconds": time.perf_counter() - start}


def sharing(path: Path) -> dict[str, float]:
    """Return the seconds that reading takes as the window does it.

    That is by some threads at once, into memory that workers share.
    """
    start = time.perf_counter()
    read_recording(path, FOR_MANY)
    return {"seconds": time.perf_counter() - start}


def opening(path: Path) -> dict[str, float]:
    """Return the seconds from the order to open until the 3D view is painted."""
    with window() as shown:
        painted: list[float] = []
        shown.stack.currentChanged.connect(
            lambda _: (
                FirstPaint(shown.workspace.scene).painted.connect(
                    lambda: painted.append(time.perf_counter())
                )
                if shown.workspace is not None
                else None
            )
        )
        start = time.perf_counter()
        shown.open(path)
        wait_until(lambda: bool(painted))
        return {"seconds": painted[0] - start}
