"""Fixtures of the window tests: settings of their own, documents, drained workers."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from mocapmend.document import Document
from mocapmend.engine import load
from mocapmend.jobs import Jobs
from mocapmend.settings import Settings
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import no_progress


@pytest.fixture(autouse=True)
def _no_file_dialog(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where a test would wait for ever for somebody to choose a file."""

    def refuse(*_: object) -> tuple[str, str]:
        raise AssertionError("a file dialog was opened, and the test has no answer for it")

    for name in ("getOpenFileName", "getSaveFileName"):
        monkeypatch.setattr(QFileDialog, name, refuse)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """Return settings that no other test and no user sees."""
    return Settings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))


@pytest.fixture
def jobs(qtbot: QtBot) -> Iterator[Jobs]:
    """Return a job runner that is shut down after the test."""
    runner = Jobs()
    yield runner
    runner.shut_down()


@pytest.fixture
def gait(samples: Path) -> Path:
    """Return the bundled gait recording, which has real gaps."""
    return samples / "gait_plug_in_gait.c3d"


@pytest.fixture
def sprint(samples: Path) -> Path:
    """Return the bundled sprint recording: 26 markers, 780 real gaps, the first frame is 0."""
    return samples / "sprint_basketball.c3d"


@pytest.fixture
def document(gait: Path, qtbot: QtBot) -> Document:
    """Return the gait recording as a document."""
    return Document(*load(gait, no_progress))


@pytest.fixture
def window(
    settings: Settings, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> Iterator[MainWindow]:
    """Return the shown main window; its unsaved edits are discarded at the end."""
    made = MainWindow(settings)
    made.resize(1280, 720)
    made.show()
    qtbot.waitExposed(made)
    yield made
    monkeypatch.setattr(made.files, "after_saving", lambda then: then())
    if made.workspace is not None:
        made.workspace.document.undo_stack.setClean()
    made.close()
    made.deleteLater()


@pytest.fixture
def open_in(qtbot: QtBot, window: MainWindow) -> Callable[[Path], MainWindow]:
    """Return a function that opens a file in the window and waits until it is shown."""

    def open_file(path: Path) -> MainWindow:
        before = window.workspace
        window.files.open(path)
        qtbot.waitUntil(lambda: window.workspace is not None and window.workspace is not before)
        return window

    return open_file
