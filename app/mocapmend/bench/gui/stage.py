"""The window that is measured, and waiting for it."""

import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QEventLoop, QSettings, QTimer
from PySide6.QtWidgets import QApplication

from mocapmend.errors import MocapmendError
from mocapmend.settings import RANKING, SEARCHING, Settings
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend.workers import WORKERS
from mocapmend_algorithms import Progress

T = TypeVar("T")

SIZE = (1600, 950)
PLOTS = 12
SHOWN = (3, 30, 60, 90)
"""Four markers: twelve plots."""
PATIENCE_S = 300.0
LOOK_MS = 5
REST_S = 0.3


def rest(progress: Progress) -> None:
    """Keep a worker from all else for a while."""
    time.sleep(REST_S)
    progress(1.0)


@contextmanager
def window(*, ranking: bool = True) -> Iterator[MainWindow]:
    """Show the program's window, with settings of its own, its workers ready.

    Without ranking nothing goes on but what is asked for: bad samples are not looked for either.
    """
    app = make_application()
    with tempfile.TemporaryDirectory(prefix="mocapmend-bench-") as folder:
        store = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        settings = Settings(store)
        settings.set(RANKING, ranking)
        settings.set(SEARCHING, ranking)
        shown = MainWindow(settings)
        shown.resize(*SIZE)
        shown.show()
        shown.get_ready()
        app.processEvents()
        # As many as there are workers: each has loaded what it needs then.
        for _ in range(WORKERS):
            shown.jobs.compute("Ready", rest)
        wait_until(lambda: shown.jobs.running == 0)
        try:
            yield shown
        finally:
            if shown.workspace is not None:
                shown.workspace.document.undo_stack.setClean()
            shown.close()


def opened(shown: MainWindow, path: Path) -> Workspace:
    """Open a recording as the user does, and return what shows it when all is at rest."""
    before = shown.workspace
    shown.open(path)
    wait_until(lambda: shown.workspace is not before)
    workspace = shown.workspace
    assert workspace is not None
    settle(workspace, shown)
    return workspace


def settle(workspace: Workspace, shown: MainWindow) -> None:
    """Wait until the report is there and nothing goes on but the ranking of the gaps."""
    wait_until(lambda: workspace.report.report is not None and at_rest(shown, workspace))


def at_rest(shown: MainWindow, workspace: Workspace) -> bool:
    """Say whether nothing goes on in the background but the ranking of the gaps."""
    return shown.jobs.running == workspace.survey.running


def show_plots(workspace: Workspace) -> None:
    """Show twelve plots.

    Raises
    ------
    MocapmendError
        If there is no room for them.
    """
    workspace.trajectories.set_separate(on=True)
    markers = workspace.document.original.markers
    workspace.view.select(tuple(marker % markers for marker in SHOWN))
    limit = time.perf_counter() + 10.0
    wait_until(lambda: len(workspace.trajectories.lanes()) >= PLOTS or time.perf_counter() > limit)
    if len(workspace.trajectories.lanes()) < PLOTS:
        raise MocapmendError(
            "The screen is too small for 12 plots.",
            "bench gui",
            "Use QT_QPA_PLATFORM=offscreen.",
        )


def wait_until(done: Callable[[], bool]) -> None:
    """Let the event loop run until something is so.

    Raises
    ------
    MocapmendError
        If it never comes to be so.
    """
    limit = time.perf_counter() + PATIENCE_S
    loop = QEventLoop()
    timer = QTimer()
    timer.setInterval(LOOK_MS)
    seen = False

    def look() -> None:
        # Once is enough: what comes before the loop has ended may change it again.
        nonlocal seen
        seen = seen or done()
        if seen or time.perf_counter() > limit:
            loop.quit()

    timer.timeout.connect(look)
    timer.start()
    loop.exec()
    if not seen:
        raise MocapmendError("The window does not come to rest.", "bench gui", "Retry.")


def steps_per_second(step: Callable[[T], object], values: Sequence[T]) -> float:
    """Return the rate at which steps are made and painted."""
    app = QApplication.instance()
    assert app is not None
    start = time.perf_counter()
    for value in values:
        step(value)
        app.processEvents()
    return len(values) / (time.perf_counter() - start)
