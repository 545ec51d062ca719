"""Fixtures of the window tests: settings of their own, documents, drained workers."""

from collections.abc import Callable, Iterator
from functools import partialmethod
from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode
from holes import HOLES
from lent_workers import LentWorkers
from PySide6.QtCore import QLocale, QSettings, QTranslator
from PySide6.QtWidgets import QApplication, QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot
from repaired_files import write_repaired
from spoilt import HOLE, spoil

from mocapmend import jobs as jobs_module
from mocapmend.document import Document
from mocapmend.engine import load
from mocapmend.files import read_c3d
from mocapmend.jobs import Jobs
from mocapmend.settings import LANGUAGE, RANKING, SEARCHING, Settings
from mocapmend.views import language
from mocapmend.views.main_window import MainWindow
from mocapmend.workers import Workers
from mocapmend_algorithms import no_progress

PATIENCE_MS = 90_000


class PatientBot(QtBot):
    """Waits long: on a machine with much else to do, slow is no failure."""

    waitExposed = partialmethod(QtBot.waitExposed, timeout=PATIENCE_MS)  # noqa: N815
    waitSignal = partialmethod(QtBot.waitSignal, timeout=PATIENCE_MS)  # noqa: N815
    waitSignals = partialmethod(QtBot.waitSignals, timeout=PATIENCE_MS)  # noqa: N815
    waitUntil = partialmethod(QtBot.waitUntil, timeout=PATIENCE_MS)  # noqa: N815


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> QtBot:
    """Return a bot that gives up shortly before the test's own timeout."""
    return PatientBot(request)


@pytest.fixture(autouse=True)
def _no_modal_dialog(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where a test would wait for ever for somebody to answer."""

    def refuse(*args: object) -> None:
        raise AssertionError(f"a dialog was opened, and the test has no answer for it: {args}")

    for name in ("getOpenFileName", "getOpenFileNames", "getSaveFileName"):
        monkeypatch.setattr(QFileDialog, name, refuse)
    for name in ("exec", "about", "critical", "information", "question", "warning"):
        monkeypatch.setattr(QMessageBox, name, refuse)


@pytest.fixture(scope="session")
def kept_workers() -> Iterator[Workers]:
    """Return worker processes that are started once."""
    workers = Workers()
    yield workers
    workers.shut_down()


@pytest.fixture(autouse=True)
def lent_workers(kept_workers: Workers, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the jobs of each test use the same worker processes, one after the other."""
    monkeypatch.setattr(jobs_module, "Workers", lambda: LentWorkers(kept_workers))


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    """Return settings that no other test and no user sees.

    Without ranking, gaps are by time, and without searching they are all problems; the language is
    English whatever the machine's is.
    """
    made = Settings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))
    made.set(RANKING, False)
    made.set(SEARCHING, False)
    made.set(LANGUAGE, "en")
    return made


@pytest.fixture
def chinese(qapp: QApplication, settings: Settings) -> Iterator[None]:
    """Let the program speak Chinese during a test."""
    locale = QLocale()
    settings.set(LANGUAGE, "zh_CN")
    language.install(qapp, settings)
    yield
    for translator in qapp.findChildren(QTranslator):
        qapp.removeTranslator(translator)
        translator.setParent(None)
    QLocale.setDefault(locale)


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


@pytest.fixture(scope="session")
def repaired_gait(samples: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the gait recording with its short gaps repaired; the repair record is in the file."""
    out = tmp_path_factory.mktemp("repaired") / "gait_repaired.c3d"
    return write_repaired(samples / "gait_plug_in_gait.c3d", out, longest=20)


@pytest.fixture(scope="session")
def repaired_sprint(samples: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the sprint recording with its 780 gaps repaired; the repair record is beside it."""
    out = tmp_path_factory.mktemp("repaired") / "sprint_repaired.c3d"
    return write_repaired(samples / "sprint_basketball.c3d", out)


@pytest.fixture(scope="session")
def holed_walk(samples: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write the bundled walk, 343 frames of 41 markers, with the gaps of `HOLES`."""
    recording = read_c3d(samples / "walk_cmu_02_01.c3d").recording
    points, fourth = recording.points.copy(), np.zeros(recording.present.shape)
    for gap in HOLES.values():
        points[gap.start : gap.stop, gap.marker] = 0
        fourth[gap.start : gap.stop, gap.marker] = -1
    path = tmp_path_factory.mktemp("walk") / "holed_walk.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=list(recording.labels))))
    return path


@pytest.fixture(scope="session")
def spoilt_walk(samples: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write the bundled walk with the bad samples and the gap of `spoilt`."""
    recording = read_c3d(samples / "walk_cmu_02_01.c3d").recording
    points, fourth = recording.points.copy(), np.zeros(recording.present.shape)
    spoil(points)
    points[HOLE.start : HOLE.stop, HOLE.marker] = 0
    fourth[HOLE.start : HOLE.stop, HOLE.marker] = -1
    path = tmp_path_factory.mktemp("walk") / "spoilt_walk.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=list(recording.labels))))
    return path


@pytest.fixture
def document(gait: Path, qtbot: QtBot) -> Document:
    """Return the gait recording as a document."""
    return Document(*load(gait, no_progress))


@pytest.fixture
def window(settings: Settings, qtbot: QtBot) -> Iterator[MainWindow]:
    """Return the shown main window; its unsaved edits are discarded at the end."""
    made = MainWindow(settings)
    made.resize(1280, 720)
    made.show()
    qtbot.waitExposed(made)
    yield made
    for workspace in made.documents:
        workspace.document.undo_stack.setClean()
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
