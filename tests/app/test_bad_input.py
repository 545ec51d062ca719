"""Bad input in the window: one clear message, and the open document stays."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtWidgets import QLabel, QMessageBox
from pytestqt.qtbot import QtBot

from mocapmend.errors import MocapmendError
from mocapmend.files import read_c3d
from mocapmend.settings import RECENT_FILES
from mocapmend.views.main_window import MainWindow

Open = Callable[[Path], MainWindow]


def shown_error(window: MainWindow, qtbot: QtBot) -> QMessageBox:
    def boxes() -> list[QMessageBox]:
        return [box for box in window.findChildren(QMessageBox) if box.isVisible()]

    qtbot.waitUntil(lambda: bool(boxes()), timeout=20_000)
    assert len(boxes()) == 1
    return boxes()[0]


@pytest.fixture
def bad(tmp_path: Path, sprint: Path, request: pytest.FixtureRequest) -> Path:
    """Return a file that cannot be opened."""
    path = tmp_path / f"{request.param}.c3d"
    if request.param == "empty":
        path.write_bytes(b"")
    elif request.param == "text":
        path.write_text("time,x,y,z\n" * 200)
    elif request.param == "cut":
        path.write_bytes(sprint.read_bytes()[:700])
    return path


@pytest.mark.parametrize("bad", ["missing", "empty", "text", "cut"], indirect=True)
def test_a_bad_file_leaves_the_open_document_alone(
    open_in: Open, qtbot: QtBot, sprint: Path, bad: Path
) -> None:
    window = open_in(sprint)
    workspace = window.workspace
    window.files.open(bad)
    box = shown_error(window, qtbot)
    assert box.text()
    assert bad.name in box.informativeText()
    assert "Traceback" not in box.text() + box.informativeText()
    box.close()
    assert window.workspace is workspace
    assert str(bad) not in window.settings.get(RECENT_FILES)


def test_a_truncated_file_opens_and_is_saved_only_after_a_yes(
    open_in: Open, qtbot: QtBot, sprint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "truncated.c3d"
    path.write_bytes(sprint.read_bytes()[: sprint.stat().st_size * 2 // 3])
    window = open_in(path)
    workspace = window.workspace
    assert workspace is not None
    assert workspace.document.source.truncated
    assert window.notes.isVisible()
    there = workspace.document.original.frames
    assert f"{there} of 3678 frames are there" in window.statusBar().currentMessage()
    out = tmp_path / "out.c3d"
    asked: list[str] = []

    def answer(question: str, _detail: str) -> bool:
        asked.append(question)
        return len(asked) > 1

    monkeypatch.setattr(window.files, "_confirm", answer)
    window.files.export(out)
    assert len(asked) == 1
    assert not window.files.writing
    window.files.export(out)
    assert len(asked) == 2
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)
    assert out.stat().st_size == path.stat().st_size


def test_a_file_cut_before_its_first_frame_is_shown_as_empty(
    open_in: Open, gait: Path, tmp_path: Path
) -> None:
    path = tmp_path / "no_frames.c3d"
    path.write_bytes(gait.read_bytes()[: read_c3d(gait).layout.data_start])
    window = open_in(path)
    assert window.workspace is not None
    label = window.workspace.centralWidget()
    assert isinstance(label, QLabel)
    assert "nothing to repair" in label.text()
    assert label.text().endswith("It holds 12 events."), "no samples of channels are there"
    assert not window.actions_by_id["next_gap"].isEnabled()


def test_an_export_after_the_source_has_gone_is_a_clear_error(
    open_in: Open, qtbot: QtBot, sprint: Path, tmp_path: Path
) -> None:
    path, taken = tmp_path / "gone.c3d", tmp_path / "taken.c3d"
    path.write_bytes(sprint.read_bytes())
    taken.write_bytes(b"precious")
    window = open_in(path)
    path.unlink()
    window.files.export(taken)
    box = shown_error(window, qtbot)
    assert "gone.c3d" in box.text() + box.informativeText()
    box.close()
    assert taken.read_bytes() == b"precious"


def test_a_file_without_points_says_what_it_holds(
    open_in: Open, qtbot: QtBot, shared: Path
) -> None:
    window = open_in(shared / "c3d" / "btk_1123x01EMG.c3d")
    workspace = window.workspace
    assert workspace is not None
    label = workspace.centralWidget()
    assert isinstance(label, QLabel)
    assert "nothing to repair" in label.text()
    assert "analog" in label.text()
    assert not window.actions_by_id["fill_all"].isEnabled()


def test_a_failed_export_says_why_and_loses_nothing(
    open_in: Open, qtbot: QtBot, sprint: Path, tmp_path: Path
) -> None:
    window = open_in(sprint)
    workspace = window.workspace
    assert workspace is not None
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    workspace.gap_actions.apply()
    window.files.export(tmp_path / "no such folder" / "out.c3d")
    box = shown_error(window, qtbot)
    assert box.informativeText()
    box.close()
    assert window.isWindowModified()
    assert workspace.document.repairs


def test_an_unexpected_error_is_told_without_a_traceback(
    window: MainWindow, qtbot: QtBot, caplog: pytest.LogCaptureFixture
) -> None:
    window.show_error(RuntimeError("boom"))
    box = shown_error(window, qtbot)
    assert "unchanged" in box.text()
    assert "boom" in box.detailedText()
    assert "boom" in caplog.text
    box.close()


def test_an_error_names_what_where_and_what_to_do(window: MainWindow, qtbot: QtBot) -> None:
    window.show_error(MocapmendError("It broke.", "a.c3d", "Mend it."))
    box = shown_error(window, qtbot)
    assert box.text() == "It broke."
    assert box.informativeText() == "a.c3d\nMend it."
    box.close()
