"""The longest pauses of the window's thread while something goes on in the background."""

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QUndoStack

from mocapmend import engine
from mocapmend.bench.gui.stage import at_rest, opened, settle, show_plots, wait_until, window
from mocapmend.bench.gui.steps import scrub_places
from mocapmend.prospects import Way
from mocapmend.views.main_window import MainWindow
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms.fill.limits import Limits

BEAT_MS = 5
SCRUB_MS = 33


class Heart:
    """Beats in the event loop and knows the longest time between two beats."""

    def __init__(self) -> None:
        self.longest_ms = 0.0
        self._last = time.perf_counter()
        self._timer = QTimer()
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(BEAT_MS)
        self._timer.timeout.connect(self._beat)
        self._timer.start()

    def _beat(self) -> None:
        now = time.perf_counter()
        self.longest_ms = max(self.longest_ms, 1000.0 * (now - self._last))
        self._last = now

    def stop(self) -> float:
        """Beat no more and return the longest pause (ms)."""
        self._beat()
        self._timer.stop()
        return self.longest_ms


@contextmanager
def scrubbing(workspace: Workspace) -> Iterator[None]:
    """Move the playhead all the time, as a user does who does not want to wait."""
    places = iter(scrub_places(workspace.view.frames) * 1000)
    timer = QTimer()
    timer.setInterval(SCRUB_MS)
    timer.timeout.connect(lambda: workspace.view.set_frame(int(next(places))))
    timer.start()
    yield
    timer.stop()


def pauses(path: Path) -> dict[str, float]:
    """Return the longest pauses (ms), by what goes on."""
    found = {}
    with window() as shown, tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        heart = Heart()
        workspace = opened(shown, path)
        found["opening"] = heart.stop()
        show_plots(workspace)
        found["filling"] = _fill_all(shown, workspace, "cubic")
        found["undoing"] = _undo_and_redo(shown, workspace)
        heart = Heart()
        with scrubbing(workspace):
            shown.files.export(Path(folder) / "repaired.c3d")
            wait_until(lambda: at_rest(shown, workspace))
        found["exporting"] = heart.stop()
        heart = Heart()
        with scrubbing(workspace):
            shown.files.write_apart(
                "Report",
                engine.write_report,
                *workspace.report_inputs(),
                Path(folder) / "report.html",
            )
            wait_until(lambda: at_rest(shown, workspace))
        found["reporting"] = heart.stop()
        # A second tab would take room from the plots.
        shown.drop(workspace)
        sprint = opened(shown, sample_recordings()[0][0])
        show_plots(sprint)
        found["auto"] = _fill_all(shown, sprint, "auto")
    return found


def _fill_all(shown: MainWindow, workspace: Workspace, method: str) -> float:
    """Fill what a method can fill within the usual limits, in one step, as the user does."""
    heart = Heart()
    with scrubbing(workspace):
        workspace.filling.fill_all(Way.default(method), Limits())
        wait_until(lambda: workspace.document.revision > 0)
        _rest(shown, workspace)
    return heart.stop()


def _undo_and_redo(shown: MainWindow, workspace: Workspace) -> float:
    stack = workspace.document.undo_stack
    heart = Heart()
    for step, index in ((stack.undo, 0), (stack.redo, 1)):
        QTimer.singleShot(0, step)
        wait_until(partial(_stands_at, stack, index))
        _rest(shown, workspace)
    return heart.stop()


def _stands_at(stack: QUndoStack, index: int) -> bool:
    return stack.index() == index


def _rest(shown: MainWindow, workspace: Workspace) -> None:
    """Wait for the report that follows an edit after a while."""
    last = workspace.report.report
    wait_until(lambda: workspace.report.report is not last)
    settle(workspace, shown)
