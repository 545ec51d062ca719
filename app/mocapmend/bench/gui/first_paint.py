"""Shows a window, prints when it was first painted (seconds of the clock), and ends."""

import sys
import tempfile
import time
from pathlib import Path

from PySide6.QtWidgets import QApplication

from mocapmend.views.first_paint import FirstPaint


def stop(app: QApplication) -> None:
    """Print the time and end the program."""
    sys.stdout.write(f"{time.time():.6f}\n")
    sys.stdout.flush()
    app.quit()


def bare() -> None:
    """Show a plot in a window: the least that any program on this stack needs."""
    import pyqtgraph

    app = QApplication([])
    plot = pyqtgraph.PlotWidget()
    plot.plot([0, 1, 2], [0, 1, 0])
    plot.resize(1280, 800)
    FirstPaint(plot.viewport()).painted.connect(lambda: stop(app))
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
        FirstPaint(window).painted.connect(lambda: stop(app))
        window.show()
        app.exec()
        window.jobs.shut_down()


if __name__ == "__main__":
    bare() if sys.argv[1] == "bare" else program()
