"""Make the pictures of the documentation: python docs/make_screenshots.py (no display needed)."""

import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QEventLoop, QSettings, QTimer
from PySide6.QtWidgets import QDockWidget

from mocapmend.settings import Settings
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace

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
        shoot(window, "window")
        assert workspace.view.gap is not None
        workspace.view.go_to(workspace.view.gap)
        wait_until(lambda: workspace.view.preview is not None)
        shoot(window, "preview")
        workspace.fill_all()
        wait_until(lambda: workspace.document.undo_stack.count() > 0)
        window.appearance.choose("light")
        workspace.zoom_all()
        dock = workspace.findChild(QDockWidget, "report")
        assert dock is not None
        dock.raise_()
        before = workspace.report.report
        wait_until(lambda: workspace.report.report is not before)
        shoot(window, "report")
        window.appearance.choose("dark")
        dock = workspace.findChild(QDockWidget, "repairs")
        assert dock is not None
        dock.raise_()
        workspace.view.go_to(min(workspace.document.repairs))
        shoot(window, "repairs")
        workspace.document.undo_stack.setClean()
        window.close()


if __name__ == "__main__":
    main()
