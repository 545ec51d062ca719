"""The program on a stage: driven by a script, and its windows put together to a picture."""

import os
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QEventLoop, QPoint, QRect, QSettings, Qt, QTimer
from PySide6.QtGui import QColor, QPainter, QPixmap
from PySide6.QtWidgets import QApplication, QDialog, QDockWidget, QWidget

from mocapmend.settings import LANGUAGE, TEXT_SIZE, Settings
from mocapmend.views import language
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend.views.samples import sample_recordings
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap

LIMIT_MS = 300_000
SETTLE_MS = 120
"""How long the window paints what has changed, before it is looked at."""
TITLE = 24
"""Height of the bar that stands for the title bar of a dialog."""


def wait_until(condition: Callable[[], object], limit_ms: int = LIMIT_MS) -> None:
    """Let the program work until a condition holds."""
    loop = QEventLoop()
    poll, limit = QTimer(), QTimer()
    poll.timeout.connect(lambda: loop.quit() if condition() else None)
    limit.timeout.connect(lambda: sys.exit("the window did not get ready"))
    poll.start(20)
    limit.start(limit_ms)
    loop.exec()


def settle() -> None:
    """Let the program work for a moment."""
    until = time.monotonic() + SETTLE_MS / 1000
    wait_until(lambda: time.monotonic() > until)


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


class Stage:
    """A window with settings of its own, and the folder that its pictures go to.

    Parameters
    ----------
    folder : Path
        For the pictures, one folder within it per theme.
    home : Path
        For settings and journals.
    chosen : str
        Language of the window.
    size : (int, int)
        Of the window, in its own pixels.
    themes : sequence of str
        Each picture is taken in all of these.
    text : float
        Size of the text as a multiple of what the system has.
    """

    def __init__(
        self,
        folder: Path,
        home: Path,
        chosen: str,
        size: tuple[int, int],
        themes: Sequence[str],
        text: float = 1.0,
    ) -> None:
        self.app = QApplication.instance() or make_application()
        self.folder = folder
        self.home = home
        self.themes = themes
        self.settings = Settings(QSettings(str(home / "settings.ini"), QSettings.Format.IniFormat))
        self.settings.set(LANGUAGE, chosen)
        self.settings.set(TEXT_SIZE, text)
        language.install(self.app, self.settings)
        self.window = MainWindow(self.settings)
        self.window.setGeometry(QRect(QPoint(0, 0), QPoint(size[0] - 1, size[1] - 1)))
        self.window.show()
        self.looks: list[Callable[[str, list[QWidget]], None]] = []
        """Called with the name of each picture and the windows that are in it."""

    @property
    def workspace(self) -> Workspace:
        """The recording that is seen."""
        assert self.window.workspace is not None
        return self.window.workspace

    def do(self, action: str) -> None:
        """Do an action of the table, as its menu does."""
        self.window.actions_by_id[action].trigger()
        settle()

    def choose(self, theme: str) -> None:
        """Choose a theme, as the menu does."""
        self.do(f"theme_{theme}")

    def switch(self, **on: bool) -> None:
        """Switch actions on and off."""
        for name, wanted in on.items():
            self.window.actions_by_id[name].setChecked(wanted)

    def open(self, path: Path) -> Workspace:
        """Open a recording and wait for its preview and report."""
        before = self.window.documents.count()
        self.window.files.open(path)
        wait_until(lambda: self.window.documents.count() > before)
        workspace = self.workspace
        if workspace.document.repairable:
            wait_until(lambda: workspace.report.report is not None)
        self.wait()
        return workspace

    def open_sample(self, name: str) -> Workspace:
        """Open a bundled recording by the name of its file."""
        return self.open(next(path for path, _ in sample_recordings() if path.stem == name))

    def wait(self) -> None:
        """Wait until nothing goes on in the background."""
        wait_until(lambda: self.window.jobs.running == 0)

    def show_pane(self, pane: QWidget) -> None:
        """Bring a pane to the front and wait until it is painted."""
        self.workspace.show_pane(pane)
        wait_until(pane.isVisible)

    def close_all(self) -> None:
        """Close all recordings without a question."""
        for each in list(self.window.documents):
            each.document.undo_stack.setClean()
            self.window.drop(each)
        settle()

    # --- pictures ----------------------------------------------------------------------------

    def shoot(self, name: str, *, wait: bool = True) -> None:
        """Save what is seen, in every theme."""
        for theme in self.themes:
            self.choose(theme)
            if wait:
                self.wait()
                settle()
            self._save(name, theme)

    def dialog(
        self,
        name: str,
        ask: Callable[[], object],
        prepare: Callable[[QWidget], object] | None = None,
    ) -> None:
        """Save what is seen when something opens a dialog or a menu, and close that.

        Parameters
        ----------
        name : str
            Of the picture.
        ask : callable
            Opens it; may return at once, or when it is closed.
        prepare : callable, optional
            Is given the dialog before the picture is taken.
        """
        for theme in self.themes:
            self.choose(theme)
            self.wait()
            done: list[bool] = []
            poll = QTimer()
            poll.timeout.connect(partial(self._look, name, theme, prepare, done))
            poll.start(200)
            ask()
            wait_until(partial(bool, done))
            poll.stop()

    def _look(
        self,
        name: str,
        theme: str,
        prepare: Callable[[QWidget], object] | None,
        done: list[bool],
    ) -> None:
        above = self._above()
        if not above or done:
            return
        done.append(True)
        if prepare is not None:
            prepare(above[-1])
            settle()
        self._save(name, theme)
        for each in reversed(self._above()):
            if isinstance(each, QDialog):
                each.reject()
            else:
                each.close()

    def _above(self) -> list[QWidget]:
        """Return the windows that are seen above the main one."""
        tops = (each for each in QApplication.topLevelWidgets() if each is not self.window)
        shown = [each for each in tops if each.isVisible() and each.width() > 1]
        return sorted(shown, key=lambda each: each.windowType() == Qt.WindowType.Popup)

    def _save(self, name: str, theme: str) -> None:
        windows = [self.window, *self._above()]
        for look in self.looks:
            look(f"{theme}/{name}", windows)
        picture = self.window.grab()
        painter = QPainter(picture)
        for each in windows[1:]:
            self._paint(painter, each)
        painter.end()
        path = self.folder / theme / f"{name}.png"
        path.parent.mkdir(parents=True, exist_ok=True)
        picture.save(str(path))

    def _paint(self, painter: QPainter, each: QWidget) -> None:
        """Paint a window where it is, with a frame and a title like those of a desktop."""
        place = QRect(each.pos() - self.window.pos(), each.size())
        picture: QPixmap = each.grab()
        painter.drawPixmap(place.topLeft(), picture)
        if not isinstance(each, QDialog | QDockWidget):
            return
        bar = QRect(place.left(), place.top() - TITLE, place.width(), TITLE)
        painter.fillRect(bar, QColor("#55606e"))
        painter.setPen(QColor("#ffffff"))
        painter.drawText(bar, Qt.AlignmentFlag.AlignCenter, each.windowTitle())
        painter.setPen(QColor("#55606e"))
        painter.drawRect(place)
