"""A program that edits in its window until it is killed: SETTINGS RECORDING EDITS_AT_ONCE.

It prints the number of edits after each of them.
"""

import sys
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSettings, QTimer

from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.settings import Settings
from mocapmend.views.application import make_application
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.interpolate import LinearParams


def gaps_to_fill(document: Document) -> list[Gap]:
    return [gap for gap in document.gaps if gap.length < 50]


def edit_of(gap: Gap, number: int) -> Edit:
    values = np.arange(gap.length * 3.0).reshape(-1, 3) + number
    patch = Patch(gap, values, np.full(gap.length, np.nan), np.full(gap.length, 1.0 / number))
    return Edit.fill(patch, "linear", LinearParams())


def main() -> None:
    settings, recording, at_once = sys.argv[1:]
    app = make_application()
    window = MainWindow(Settings(QSettings(settings, QSettings.Format.IniFormat)))
    window.show()
    window.open(Path(recording))
    gaps: list[Gap] = []

    def edit() -> None:
        workspace = window.workspace
        if workspace is None:
            return
        stack = workspace.document.undo_stack
        if not stack.count():
            gaps.extend(gaps_to_fill(workspace.document))
        for _ in range(int(at_once)):
            number = stack.count() + 1
            workspace.push([edit_of(gaps[number - 1], number)], f"edit {number}")
            print(number, flush=True)  # noqa: T201 - the test reads it

    timer = QTimer()
    timer.timeout.connect(edit)
    timer.start()
    app.exec()


if __name__ == "__main__":
    main()
