"""Make the pictures of the documentation: python docs/make_screenshots.py (no display needed)."""

import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QEventLoop, QSettings, QTimer
from PySide6.QtWidgets import QWidget

from mocapmend.settings import Settings
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

IMAGES = Path(__file__).parent / "images"
SIZE = (1280, 720)
LIMIT_MS = 300_000


def wait_until(condition: Callable[[], object]) -> None:
    """Let the program work until a condition holds."""
    loop = QEventLoop()
    poll, limit = QTimer(), QTimer()
    poll.timeout.connect(lambda: condition() and loop.quit())
    limit.timeout.connect(lambda: sys.exit("the window did not get ready"))
    poll.start(20)
    limit.start(LIMIT_MS)
    loop.exec()


def open_sample(window: MainWindow, name: str) -> Workspace:
    """Open a bundled recording and wait for its preview and report."""
    window.files.open(next(path for path, _ in sample_recordings() if path.stem == name))
    wait_until(lambda: window.workspace is not None)
    workspace = window.workspace
    assert workspace is not None
    wait_until(lambda: workspace.report.report is not None and window.jobs.running == 0)
    return workspace


def shoot(window: MainWindow, name: str) -> None:
    """Save what the window shows."""
    window.statusBar().clearMessage()
    wait_until(lambda: window.jobs.running == 0)
    window.grab().save(str(IMAGES / f"{name}.png"))


def show(workspace: Workspace, pane: QWidget) -> None:
    """Bring a pane to the front and wait until it is painted."""
    workspace.show_pane(pane)
    wait_until(pane.isVisible)


def worth_a_look(workspace: Workspace) -> Gap:
    """Return a gap of middle length that can be repaired well."""
    mm = workspace.document.original.mm
    known = ((gap, workspace.prospects.best(gap)) for gap in workspace.document.gaps)
    good = (
        gap
        for gap, best in known
        if best is not None and 20 < gap.length < 80 and 2.0 < mm * best.expected_error < 12.0
    )
    return max(good, key=lambda gap: (gap.length, gap.start))


def main() -> None:
    """Walk through the program and take the pictures."""
    app = make_application()
    IMAGES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        store = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        window = MainWindow(Settings(store))
        window.appearance.choose("dark")
        window.resize(*SIZE)
        window.show()
        app.processEvents()
        shoot(window, "welcome")
        workspace = open_sample(window, "sprint_basketball")
        wait_until(lambda: not workspace.survey.running and workspace.survey.portions > 1)
        workspace.view.go_to(worth_a_look(workspace))
        wait_until(lambda: workspace.view.preview is not None and not workspace.previewer.busy)
        shoot(window, "preview")
        workspace.zoom_all()
        shoot(window, "window")
        workspace.show_plan()
        wait_until(lambda: workspace.filling.job is None and workspace.plan.model.rowCount())
        shoot(window, "plan")
        workspace.fill_all()
        wait_until(lambda: workspace.document.undo_stack.count() > 0)
        window.appearance.choose("light")
        before = workspace.report.report
        show(workspace, workspace.report)
        wait_until(lambda: workspace.report.report is not before)
        shoot(window, "report")
        window.appearance.choose("dark")
        show(workspace, workspace.repairs)
        workspace.view.go_to(min(workspace.document.repairs))
        shoot(window, "repairs")
        for each in window.documents:
            each.document.undo_stack.setClean()
        window.close()


if __name__ == "__main__":
    main()
