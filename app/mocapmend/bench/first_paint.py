"""Shows a window, prints when it was first painted (seconds of the clock), and ends."""

import sys
import tempfile
import time
from pathlib import Path

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication, QWidget


class FirstPaint(QObject):
    """Waits for the first paint event of a widget."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Print the time once the event has been handled, and end."""
        if event.type() == QEvent.Type.Paint and isinstance(watched, QWidget):
            watched.removeEventFilter(self)
            app = QApplication.instance()
            assert app is not None
            app.processEvents()
            sys.stdout.write(f"{time.time():.6f}\n")
            sys.stdout.flush()
            app.quit()
        return False


def bare() -> None:
    """Show a plot in a window: the least that any program on this stack needs."""
    import pyqtgraph

    app = QApplication([])
    plot = pyqtgraph.PlotWidget()
    plot.plot([0, 1, 2], [0, 1, 0])
    plot.resize(1280, 800)
    waiting = FirstPaint()
    plot.viewport().installEventFilter(waiting)
    plot.show()
    app.exec()


def program() -> None:
    """Show our window as it starts."""
    from PySide6.QtCore import QSettings

    from mocapmend.settings import Settings
    from mocapmend.views.application import make_application
    from mocapmend.views.main_window import MainWindow

    app = make_application()
    with tempfile.TemporaryDirectory() as folder:
        store = QSettings(str(Path(folder) / "settings.ini"), QSettings.Format.IniFormat)
        window = MainWindow(Settings(store))
        waiting = FirstPaint()
        window.installEventFilter(waiting)
        window.show()
        app.exec()
        window.jobs.shut_down()


if __name__ == "__main__":
    bare() if sys.argv[1] == "bare" else program()
