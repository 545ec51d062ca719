"""Recordings of all formats, opened, dropped and exported in the window."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from kinect_samples import person, rows
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot
from text_samples import LONG, MOTIVE, NEXUS, TRC, WIDE

from mocapmend.files import read_recording
from mocapmend.files.sidecar import sidecar_path
from mocapmend.settings import RECENT_FILES
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_resources import skeletons

Open = Callable[[Path], MainWindow]
BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Knee
  {
    OFFSET 0 -40 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -45 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.01
0 90 0 0 0 0 0 0 0
1 90 0 0 0 0 0 0 0
2 90 0 0 0 0 0 0 0
"""
KINDS = {
    ".c3d": "C3D (*.c3d)",
    ".trc": "TRC (*.trc)",
    ".csv": "CSV, one line per frame (*.csv)",
    ".long.csv": "CSV, one line per sample (*.long.csv)",
    ".npz": "NumPy (*.npz)",
}


@pytest.fixture
def copy(tmp_path: Path, gait: Path) -> Path:
    """Return a copy of the gait recording in a folder of its own."""
    path = tmp_path / "walk.c3d"
    path.write_bytes(gait.read_bytes())
    return path


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def write(path: Path, text: str) -> Path:
    path.write_text(text, encoding="utf-8", newline="\n")
    return path


def fill_all(window: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(window)
    workspace.fill_all()
    qtbot.waitUntil(lambda: workspace.document.undo_stack.count() == 1, timeout=20_000)


def export(window: MainWindow, qtbot: QtBot) -> None:
    window.actions_by_id["export"].trigger()
    qtbot.waitUntil(lambda: not window.files.writing, timeout=20_000)


def answer(monkeypatch: pytest.MonkeyPatch, kind: str, name: str = "") -> list[tuple[str, ...]]:
    """Choose a kind in the save dialog, and a name if it is not the proposed one."""
    asked: list[tuple[str, ...]] = []

    def choose(_parent: object, _title: str, start: str, kinds: str, first: str) -> tuple[str, str]:
        asked.append((start, kinds, first))
        return str(Path(start).with_name(name)) if name else start, kind

    monkeypatch.setattr(QFileDialog, "getSaveFileName", choose)
    return asked


def mime(*paths: Path) -> QMimeData:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return data


def drag(window: MainWindow, data: QMimeData) -> bool:
    """Drag over the window; say whether it would take what is dragged."""
    keys, buttons = Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
    event = QDragEnterEvent(QPoint(10, 10), Qt.DropAction.CopyAction, data, buttons, keys)
    event.ignore()
    window.dragEnterEvent(event)
    return event.isAccepted()


def drop(window: MainWindow, data: QMimeData) -> None:
    keys, buttons = Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
    window.dropEvent(QDropEvent(QPointF(10, 10), Qt.DropAction.CopyAction, data, buttons, keys))


@pytest.mark.parametrize("end", KINDS)
def test_the_kind_chosen_in_the_dialog_is_written(
    open_in: Open, copy: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, end: str
) -> None:
    window = open_in(copy)
    fill_all(window, qtbot)
    document = workspace_of(window).document
    asked = answer(monkeypatch, KINDS[end])
    export(window, qtbot)
    out = copy.with_name(f"walk_repaired{end}")
    assert asked == [
        (str(copy.with_name("walk_repaired.c3d")), ";;".join(KINDS.values()), KINDS[".c3d"])
    ]
    assert not window.isWindowModified()
    assert out.name in window.statusBar().currentMessage()
    assert out.name in workspace_of(window).report._proof.text()
    filled = sorted(document.repairs)
    points = document.points.copy()

    window = open_in(out)
    document = workspace_of(window).document
    assert sorted(document.repairs) == filled, "the repair record is found again"
    assert all(map(document.is_earlier, filled))
    assert np.allclose(document.points, points, atol=1e-3, equal_nan=True)
    assert sidecar_path(out).exists() == (end != ".c3d")
    gap = filled[0]
    workspace_of(window).view.go_to(gap)
    workspace_of(window).gap_actions.reopen()
    assert gap in document.gaps


@pytest.mark.parametrize("yes", [True, False])
def test_a_file_under_the_changed_name_is_asked_about(
    open_in: Open, copy: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, yes: bool
) -> None:
    window = open_in(copy)
    out = write(copy.with_name("walk_repaired.trc"), "mine")
    questions: list[str] = []
    monkeypatch.setattr(window.files, "_confirm", lambda text, _: questions.append(text) or yes)
    answer(monkeypatch, KINDS[".trc"])
    export(window, qtbot)
    assert questions == ["Replace walk_repaired.trc?"]
    assert (out.read_text() == "mine") is not yes


def test_a_name_that_was_typed_is_kept(
    open_in: Open, copy: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = open_in(copy)
    answer(monkeypatch, KINDS[".c3d"], "typed.trc")
    export(window, qtbot)
    assert read_recording(copy.with_name("typed.trc")).kind == "TRC"


def test_an_ending_that_cannot_be_written_is_told(
    open_in: Open, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = open_in(write(tmp_path / "legs.bvh", BVH))
    answer(monkeypatch, KINDS[".c3d"], "legs.xyz")
    export(window, qtbot)
    (box,) = [box for box in window.findChildren(QMessageBox) if box.isVisible()]
    assert "cannot be written" in box.text()
    box.close()
    assert not (tmp_path / "legs.xyz").exists()


@pytest.mark.parametrize(
    ("name", "text", "proposed"),
    [
        ("legs.bvh", BVH, "legs_repaired.c3d"),
        ("walk.trc", TRC, "walk_repaired.trc"),
        ("walk.csv", WIDE, "walk_repaired.csv"),
        ("walk.long.csv", LONG, "walk_repaired.long.csv"),
        ("motive.csv", MOTIVE, "motive_repaired.csv"),
        ("nexus.csv", NEXUS, "nexus_repaired.csv"),
        ("kinect.txt", rows(person(12)), "kinect_repaired.c3d"),
    ],
)
def test_other_formats_are_dropped_and_exported(
    window: MainWindow,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    text: str,
    proposed: str,
) -> None:
    path = write(tmp_path / name, text)
    expected = read_recording(path)
    assert drag(window, mime(path))
    drop(window, mime(path))
    qtbot.waitUntil(lambda: window.workspace is not None, timeout=20_000)
    workspace = workspace_of(window)
    document = workspace.document
    assert document.source.kind == expected.kind
    assert np.array_equal(document.points, expected.recording.points, equal_nan=True)
    assert window.settings.get(RECENT_FILES)[0] == str(path.resolve())
    assert window.notes.isVisible() == bool(expected.warnings)
    assert not window.actions_by_id["check_copy"].isEnabled()
    kind = next(kind for end, kind in KINDS.items() if proposed.endswith(end))
    if proposed.endswith(".long.csv"):
        kind = KINDS[".long.csv"]
    asked = answer(monkeypatch, kind)
    export(window, qtbot)
    assert asked[0][0] == str(tmp_path / proposed)
    assert asked[0][2] == kind
    back = read_recording(tmp_path / proposed).recording
    # A new C3D file has floats of 32 bits.
    assert np.allclose(back.points, document.points, rtol=1e-6, equal_nan=True)
    assert back.labels == document.original.labels
    assert (back.rate, back.unit) == (document.original.rate, document.original.unit)
    assert "read back" in window.statusBar().currentMessage()
    assert "read back" in workspace.report._proof.text()


def test_a_bvh_file_shows_its_own_bones(open_in: Open, tmp_path: Path) -> None:
    workspace = workspace_of(open_in(write(tmp_path / "legs.bvh", BVH)))
    assert workspace.document.skeleton.bones == workspace.document.source.bones
    assert len(workspace.document.skeleton.bones) == 2
    assert workspace.document.gaps == []
    assert "nothing to fill" in workspace.repair._promise.text()


def test_a_kinect_file_shows_its_joints_with_bones(open_in: Open, tmp_path: Path) -> None:
    points = person()
    points[10:15, 6] = 0
    workspace = workspace_of(open_in(write(tmp_path / "walk.txt", rows(points, " "))))
    document = workspace.document
    template = skeletons.read("kinect_v2_25")
    labels = document.original.labels
    assert {(labels[a], labels[b]) for a, b in document.skeleton.bones} == set(template.bones)
    assert [(labels[gap.marker], gap.start, gap.stop) for gap in document.gaps] == [
        ("WristLeft", 10, 15)
    ]


def test_gaps_of_a_trc_file_are_filled_and_undone(
    open_in: Open, copy: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = open_in(copy)
    answer(monkeypatch, KINDS[".trc"])
    export(window, qtbot)
    window = open_in(copy.with_name("walk_repaired.trc"))
    document = workspace_of(window).document
    gaps = document.gaps
    assert gaps
    fill_all(window, qtbot)
    assert len(document.gaps) < len(gaps)
    asked = answer(monkeypatch, KINDS[".trc"], "again.trc")
    export(window, qtbot)
    assert asked[0][0] == str(copy.with_name("walk_repaired_2.trc"))
    back = read_recording(copy.with_name("again.trc"))
    assert np.array_equal(back.recording.points, document.points, equal_nan=True)
    assert list(back.repaired) == sorted(document.repairs)
    document.undo_stack.undo()
    assert document.gaps == gaps
    assert window.isWindowModified()


def test_several_dropped_files_open_in_tabs(
    window: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    one, other = (write(tmp_path / name, TRC) for name in ("one.trc", "other.trc"))
    assert drag(window, mime(one, other))
    drop(window, mime(one, other, one))
    qtbot.waitUntil(lambda: window.documents.count() == 2, timeout=20_000)
    qtbot.waitUntil(lambda: window.files._loading is None and not window.files._waiting)
    assert [each.document.source.path for each in window.documents] == [one, other]
    assert workspace_of(window).document.source.path == one, "it was dropped once more"
    assert not drag(window, QMimeData())


@pytest.mark.parametrize("name", ["broken.trc", "broken.bvh", "broken.npz", "broken.csv"])
def test_a_broken_file_leaves_the_open_one(
    open_in: Open, qtbot: QtBot, tmp_path: Path, name: str
) -> None:
    window = open_in(write(tmp_path / "walk.trc", TRC))
    workspace = workspace_of(window)
    before = workspace.document.points.tobytes()
    drop(window, mime(write(tmp_path / name, "nothing\nof use")))

    def boxes() -> list[QMessageBox]:
        return [box for box in window.findChildren(QMessageBox) if box.isVisible()]

    qtbot.waitUntil(lambda: len(boxes()) == 1, timeout=20_000)
    (box,) = boxes()
    assert name in box.informativeText()
    box.close()
    assert window.workspace is workspace
    assert workspace.document.points.tobytes() == before
