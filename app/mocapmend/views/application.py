"""Start of the window."""

import logging
import os
import signal
import sys
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QApplication

from mocapmend import __version__
from mocapmend.errors import MocapmendError
from mocapmend.settings import TOUR_SHOWN, Settings
from mocapmend.views import language
from mocapmend.views.first_paint import FirstPaint
from mocapmend.views.main_window import MainWindow

log = logging.getLogger(__name__)


def make_application() -> QApplication:
    """Make the Qt application with the names that its settings are kept under."""
    QCoreApplication.setOrganizationName("mocapmend")
    QCoreApplication.setApplicationName("mocapmend")
    QCoreApplication.setApplicationVersion(__version__)
    return QApplication(sys.argv[:1])


def require_display() -> None:
    """Refuse where Qt would abort the whole program.

    Raises
    ------
    MocapmendError
        If there is no screen to open a window on.
    """
    named = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    if sys.platform == "linux" and not any(os.environ.get(name) for name in named):
        raise MocapmendError(
            "There is no display to open the window on.",
            todo="Log in to a desktop (over SSH: ssh -X), or use the commands (mocapmend --help).",
        )


def wants_tour(settings: Settings, path: Path | None) -> bool:
    """Say whether the user is here for the first time, and not for a certain recording."""
    return path is None and not settings.get(TOUR_SHOWN)


def run(path: Path | None) -> int:
    """Open the window, with a recording if one is named, and return the exit code.

    Raises
    ------
    MocapmendError
        If there is no screen to open a window on.
    """
    require_display()
    app = make_application()
    settings = Settings()
    language.install(app, settings)
    window = MainWindow(settings)

    def show_unexpected(
        kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        log.critical("unexpected error", exc_info=(kind, error, trace))
        if isinstance(error, Exception):
            window.show_error(error)

    # An exception in a slot does not end the event loop: without this nobody would see it.
    sys.excepthook = show_unexpected
    # Python sees Ctrl+C in the terminal only between its own steps, and Qt takes few.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    FirstPaint(window).painted.connect(window.get_ready)
    window.show()
    if path is not None:
        window.open(path)
    if wants_tour(window.settings, path):
        window.start_tour()
    return app.exec()
