"""A method that learns from a training set, in the window: previews, filling all, complaints."""

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot
from taught import install, ship, write_set

from mocapmend.jobs import Job
from mocapmend.settings import METHOD, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.training_box import TrainingBox
from mocapmend.views.workspace import Workspace
from mocapmend.viewstate import Preview
from mocapmend_algorithms import Gap, Recording


@pytest.fixture
def opened(
    open_in: Callable[[Path], MainWindow],
    gait: Path,
    settings: Settings,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> MainWindow:
    """Return the window with the method; it computes where the method is known: in threads."""
    install(monkeypatch)
    ship(tmp_path / "shipped", monkeypatch)
    settings.set(METHOD, "taught")
    window = open_in(gait)
    original = workspace_of(window).document.original
    seen = [m for m in range(original.markers) if original.present[:, m].all()]
    known = Recording(
        original.points[:, seen].copy(), tuple(original.labels[m] for m in seen), original.rate
    )
    write_set(tmp_path / "shipped" / "gait.npz", known)

    def compute(title: str, function: Any, *args: object, quiet: bool = False) -> Job:
        return window.jobs.read_or_write(title, function, *pickle.loads(pickle.dumps(args)))

    monkeypatch.setattr(window.jobs, "compute", compute)
    workspace_of(window).gap_actions.step(1)
    return window


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def type_name(window: MainWindow, name: str, qtbot: QtBot) -> TrainingBox:
    box = workspace_of(window).repair.findChild(TrainingBox, "training")
    box.combo.setFocus()
    qtbot.waitUntil(box.combo.hasFocus)
    box.combo.lineEdit().selectAll()
    qtbot.keyClicks(box.combo, name)
    qtbot.keyClick(box.combo, Qt.Key.Key_Return)
    return box


def preview(window: MainWindow, qtbot: QtBot, training: str) -> Preview:
    view = workspace_of(window).view
    qtbot.waitUntil(
        lambda: view.preview is not None and view.preview.params.training == training,
        timeout=20_000,
    )
    return view.preview


def test_a_name_reaches_previews_repairs_and_records(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    assert not preview(opened, qtbot, "").patch.values.any()
    box = type_name(opened, "gait", qtbot)
    assert workspace.document.undo_stack.index() == 0, "Enter in the field applies nothing"
    assert not box.combo.hasFocus()
    assert preview(opened, qtbot, "gait").patch is not None
    workspace.gap_actions.apply()
    assert workspace.document.unsaved().records()[0].parameters["training"] == "gait"
    gap = next(gap for gap in workspace.document.gaps if gap.length < 20)
    workspace.fill_all()
    qtbot.waitUntil(lambda: gap in workspace.document.repairs, timeout=20_000)
    assert {record.parameters["training"] for record in workspace.document.unsaved().records()} == {
        "gait"
    }


def test_a_preview_says_what_is_wrong_without_a_dialog(opened: MainWindow, qtbot: QtBot) -> None:
    type_name(opened, "nowhere.npz", qtbot)
    shown = preview(opened, qtbot, "nowhere.npz")
    assert shown.patch is None
    assert shown.reason.startswith("nowhere.npz: There is no such training set. Choose a file")
    assert "There is no such training set" in workspace_of(opened).repair._promise.text()


def test_filling_all_says_what_is_wrong_in_a_dialog(
    opened: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    monkeypatch.setattr(QMessageBox, "open", lambda box: told.append(box.text()))
    type_name(opened, "nowhere.npz", qtbot)
    preview(opened, qtbot, "nowhere.npz")
    gaps: list[Gap] = workspace_of(opened).document.gaps
    workspace_of(opened).fill_all()
    qtbot.waitUntil(lambda: bool(told))
    assert told == ["There is no such training set."]
    assert workspace_of(opened).document.gaps == gaps


def test_escape_goes_back_to_the_recording_itself(opened: MainWindow, qtbot: QtBot) -> None:
    box = type_name(opened, "gait", qtbot)
    box.combo.setFocus()
    qtbot.keyClick(box.combo, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: workspace_of(opened).repair.method()[1].training == "")
    assert box.combo.currentText() == ""
    assert not box.combo.hasFocus()
