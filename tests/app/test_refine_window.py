"""Refining in the window: asked, done apart, shown beside its original, exported."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot
from refine_networks import (
    copying,
    write_kinect22,
    write_kinect25,
    write_network,
    write_reference,
)

from mocapmend.action_table import ACTIONS
from mocapmend.commands import EditSamples
from mocapmend.edits import Edit
from mocapmend.files import Source, read_recording
from mocapmend.files.sidecar import sidecar_path
from mocapmend.refine.apart import Order
from mocapmend.refine.card import CAUTION
from mocapmend.refine.fitting import misfit
from mocapmend.refine.profiles import profile_named
from mocapmend.refine.times import seconds_for
from mocapmend.settings import REFINE_CUTOFF, REFINE_FILES, REFINE_NETWORK, REFINE_STRIDE, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.network_box import NetworkBox
from mocapmend.views.quantities import Curve, Quantity
from mocapmend.views.refine_checks import file_problem
from mocapmend.views.refine_dialog import RefineDialog
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.refine.refining import RefineParams

Open = Callable[[Path], MainWindow]


@pytest.fixture
def joints(tmp_path: Path) -> Path:
    return write_kinect22(tmp_path)


@pytest.fixture
def network(tmp_path: Path, settings: Settings) -> Path:
    """Return a network that was used lately."""
    path = write_network(tmp_path / "own.npz")
    settings.set(REFINE_FILES, [str(path)])
    settings.set(REFINE_NETWORK, str(path))
    return path


@pytest.fixture
def opened(network: Path, joints: Path, open_in: Open) -> MainWindow:
    return open_in(joints)


def current(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def dialog_of(window: MainWindow, qtbot: QtBot) -> RefineDialog:
    """Return the dialog that is asked for by its key."""
    qtbot.keyClick(
        window,
        Qt.Key.Key_R,
        Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
    )
    dialog = window.findChild(RefineDialog)
    assert isinstance(dialog, RefineDialog)
    qtbot.waitUntil(dialog.isVisible)
    return dialog


def refined(window: MainWindow, qtbot: QtBot) -> Workspace:
    """Wait for the outcome in its tab, with its original beside it."""
    first = window.documents.count()
    qtbot.waitUntil(lambda: window.documents.count() > first or first > 1)
    qtbot.waitUntil(lambda: current(window).comparing.companion is not None)
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    return current(window)


def make(window: MainWindow, qtbot: QtBot) -> Workspace:
    """Refine the open recording as it is proposed."""
    dialog = dialog_of(window, qtbot)
    qtbot.keyClick(dialog.out.edit, Qt.Key.Key_Return)
    return refined(window, qtbot)


def test_the_whole_job_by_keyboard(opened: MainWindow, qtbot: QtBot, joints: Path) -> None:
    dialog = dialog_of(opened, qtbot)
    assert dialog.network.combo.currentText() == "own.npz"
    assert dialog.out.path() == joints.with_name("kinect_positions_refined.c3d")
    assert dialog.go.isEnabled()
    qtbot.keyClick(dialog.out.edit, Qt.Key.Key_Return)
    workspace = refined(opened, qtbot)
    document, view = workspace.document, workspace.view
    assert document.labels == profile_named("kinect22-pig39").outputs
    assert document.source.provenance is not None
    assert document.source.provenance.refined is not None
    assert document.source.provenance.refined.parameters == {"stride": "60", "cutoff_hz": 6.0}
    assert "39 markers computed in 90 frames" in opened.statusBar().currentMessage()
    beside = view.companion
    assert beside is not None
    assert (beside.way, beside.path) == ("origin", joints)
    marker = document.labels.index("LWRA")
    view.select((marker,))
    partner = beside.partners[marker]
    assert partner is not None
    assert beside.original.labels[partner] == "LeftWrist"
    qtbot.keyClick(opened, Qt.Key.Key_C, Qt.KeyboardModifier.ShiftModifier)
    assert view.companion is None
    qtbot.keyClick(opened, Qt.Key.Key_C, Qt.KeyboardModifier.ShiftModifier)
    assert view.companion is beside
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(opened, Qt.Key.Key_D, both)
    assert view.companion is None
    assert workspace.comparing.companion is None
    assert "No longer compared with kinect_positions.txt" in opened.statusBar().currentMessage()


def test_the_whole_job_by_mouse(
    opened: MainWindow,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    reference, out = write_reference(tmp_path), tmp_path / "chosen.c3d"
    opened.actions_by_id["refine"].trigger()
    dialog = opened.findChild(RefineDialog)
    assert isinstance(dialog, RefineDialog)
    qtbot.waitUntil(dialog.isVisible)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(reference), ""))
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), "C3D (*.c3d)"))
    for field in (dialog.reference, dialog.out):
        qtbot.mouseClick(field.browse, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(dialog.filter, Qt.MouseButton.LeftButton, pos=QPoint(8, 8))
    assert not dialog.cutoff.isEnabled()
    qtbot.mouseClick(dialog.go, Qt.MouseButton.LeftButton)
    workspace = refined(opened, qtbot)
    assert workspace.document.source.path == out
    judged = workspace.facts.given
    assert judged is not None
    assert judged.reference == reference.name
    assert len(judged.rms) == 39
    refining = workspace.facts.refining()
    assert refining is not None
    assert refining.settings == ("60", "")
    assert refining.judged is judged
    copy = tmp_path / "copy.c3d"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(copy), "C3D (*.c3d)"))
    opened.actions_by_id["export"].trigger()
    qtbot.waitUntil(copy.exists)
    qtbot.waitUntil(lambda: not opened.files.writing)
    assert copy.read_bytes() == out.read_bytes()


def fill_one(workspace: Workspace) -> None:
    """Set a run aside by hand and fill it."""
    gap = Gap(3, 20, 25)
    workspace.view.select((gap.marker,))
    workspace.view.set_span((gap.start, gap.stop))
    workspace.bad_actions.set_aside()
    assert gap in workspace.document.gaps
    values = workspace.document.original.points[20:25, 3] + 1.0
    patch = Patch(gap, values, np.ones(5), np.ones(5))
    edit = Edit.fill(patch, "linear", METHODS["linear"].params())
    workspace.do(EditSamples(workspace.document, [edit], "fill"))


@pytest.mark.parametrize("end", ["c3d", "csv"])
def test_the_record_outlives_an_export_after_a_repair(
    opened: MainWindow,
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    end: str,
) -> None:
    workspace = make(opened, qtbot)
    source = workspace.document.source
    assert source.provenance is not None
    fill_one(workspace)
    copy = tmp_path / f"repaired.{end}"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(copy), ""))
    opened.actions_by_id["export"].trigger()
    qtbot.waitUntil(copy.exists)
    qtbot.waitUntil(lambda: not opened.files.writing)
    again = read_recording(copy)
    assert again.provenance is not None
    assert again.provenance.refined == source.provenance.refined
    assert len(again.repairs) == 1
    assert any("none was measured" in text for text in again.warnings)
    assert sidecar_path(copy).exists() == (end == "csv")


def test_a_csv_outcome_opens_with_its_original(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    dialog = dialog_of(opened, qtbot)
    dialog.out.set_path(tmp_path / "table.csv")
    dialog.go.click()
    workspace = refined(opened, qtbot)
    assert workspace.document.source.kind == "CSV"
    assert workspace.facts.refining() is not None
    assert workspace.view.companion is not None
    assert workspace.view.companion.way == "origin"


def test_what_is_there_is_replaced_only_if_the_user_agrees(
    opened: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace = make(opened, qtbot)
    path = workspace.document.source.path
    opened.documents.setCurrentIndex(0)
    dialog = dialog_of(opened, qtbot)
    dialog.filter.setChecked(False)
    asked: list[str] = []

    def answer(button: QMessageBox.StandardButton) -> Callable[..., QMessageBox.StandardButton]:
        return lambda *args: (asked.append(args[2]), button)[1]

    before = path.read_bytes()
    monkeypatch.setattr(QMessageBox, "question", answer(QMessageBox.StandardButton.Cancel))
    dialog.go.click()
    assert asked == [f"There is a file of this name. Replace {path.name}?"]
    assert dialog.isVisible()
    assert path.read_bytes() == before
    monkeypatch.setattr(QMessageBox, "question", answer(QMessageBox.StandardButton.Yes))
    dialog.go.click()
    qtbot.waitUntil(lambda: current(opened).document.source.path == path)
    qtbot.waitUntil(lambda: current(opened).comparing.companion is not None)
    assert opened.documents.count() == 2, "what it replaced is closed"
    assert current(opened) is not workspace
    refining = current(opened).facts.refining()
    assert refining is not None
    assert refining.settings == ("60", "")


@pytest.mark.parametrize("give_up", [False, True])
def test_edits_of_what_is_replaced_are_asked_about_once(
    opened: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, give_up: bool
) -> None:
    workspace = make(opened, qtbot)
    fill_one(workspace)
    path = workspace.document.source.path
    before = path.read_bytes()
    opened.documents.setCurrentIndex(0)
    dialog = dialog_of(opened, qtbot)
    buttons = QMessageBox.StandardButton
    answers = [buttons.Yes, buttons.Discard if give_up else buttons.Cancel]
    monkeypatch.setattr(QMessageBox, "question", lambda *_: answers.pop(0))
    dialog.filter.setChecked(False)
    dialog.go.click()
    assert answers == []
    if give_up:
        qtbot.waitUntil(lambda: opened.documents.count() == 2 and current(opened) is not workspace)
        qtbot.waitUntil(lambda: current(opened).comparing.companion is not None)
        assert path.read_bytes() != before
        assert current(opened).saved
    else:
        assert opened.documents.count() == 2
        assert not workspace.saved
        assert path.read_bytes() == before


def test_settings_are_remembered(opened: MainWindow, qtbot: QtBot, settings: Settings) -> None:
    dialog = dialog_of(opened, qtbot)
    dialog.stride.setCurrentIndex(dialog.stride.findData("1"))
    dialog.cutoff.setValue(8.5)
    dialog.go.click()
    refined(opened, qtbot)
    assert settings.get(REFINE_STRIDE) == "1"
    assert settings.get(REFINE_CUTOFF) == 8.5
    opened.documents.setCurrentIndex(0)
    again = dialog_of(opened, qtbot)
    assert (again.stride.currentData(), again.cutoff.value()) == ("1", 8.5)
    again.reject()


def test_cancelling_leaves_nothing(opened: MainWindow, qtbot: QtBot, tmp_path: Path) -> None:
    dialog = dialog_of(opened, qtbot)
    started: list[object] = []
    opened.jobs.started.connect(started.append)
    opened.jobs.started.connect(lambda job: job.cancel() if "Refining" in job.title else None)
    with qtbot.waitSignal(opened.jobs.ended, check_params_cb=lambda job: "Refin" in job.title):
        dialog.go.click()
    assert any("Refining kinect_positions.txt" in job.title for job in started)  # type: ignore[attr-defined]
    assert opened.documents.count() == 1
    assert not list(tmp_path.glob("*_refined*"))


def test_a_recording_that_changed_meanwhile_is_not_refined(
    opened: MainWindow, qtbot: QtBot, joints: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = dialog_of(opened, qtbot)
    lines = joints.read_text().splitlines(keepends=True)
    joints.write_text("".join(lines[:-1]))
    told: list[Exception] = []
    monkeypatch.setattr(opened, "show_error", told.append)
    with qtbot.waitSignal(opened.jobs.ended, check_params_cb=lambda job: "Refin" in job.title):
        dialog.go.click()
    assert opened.documents.count() == 1
    assert not joints.with_name("kinect_positions_refined.c3d").exists()


# --- the dialog ----------------------------------------------------------------------------------


def test_joints_that_do_not_fit_are_named_at_once(
    network: Path, open_in: Open, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(write_kinect25(tmp_path))
    dialog = dialog_of(window, qtbot)
    assert not dialog.go.isEnabled()
    text = dialog.problem.text()
    assert "20 of 22 are not here" in text or "of 22 are not here" in text
    for name in ("Waist", "LeftCollar", "RightToes"):
        assert name in text
    assert "Kinect v2, 25 joints, to Axis Neuron, 59 joints" in text
    assert "one never stands for the other" in text
    assert "mocapmend train refine" in text
    qtbot.keyClick(dialog.out.edit, Qt.Key.Key_Return)
    assert dialog.isVisible(), "Enter cannot begin it either"
    other = write_network(tmp_path / "v2.npz", "kinect25-neuron59")
    dialog.network.choose(other)
    assert dialog.problem.text() == ""
    assert dialog.go.isEnabled()
    dialog.reject()


def test_misfits_tell_labels_from_samples(joints: Path) -> None:
    profile = profile_named("kinect22-pig39")
    recording = read_recording(joints).recording
    assert not misfit(recording, profile)
    points = recording.points.copy()
    points[1:, 3] = np.nan
    assert misfit(recording.with_points(points), profile).unseen == (profile.inputs[3],)


def test_the_card_is_read_in_the_dialog(opened: MainWindow, qtbot: QtBot) -> None:
    dialog = dialog_of(opened, qtbot)
    text = " ".join(dialog.card.toPlainText().split())
    for part in (
        "copies joints, for tests",
        "For a person whom it has not seen, expect no more than from smoothing and regression",
        CAUTION,
        "performers 8, 9, 10",
        "1234",
        "56.7",
        "0.891",
        "the same training without some people (performers 8, 9, 10; pairs: 7)",
        "2345",
    ):
        assert part in text
    dialog.reject()


def test_a_network_that_is_none_is_told(opened: MainWindow, qtbot: QtBot, tmp_path: Path) -> None:
    dialog = dialog_of(opened, qtbot)
    broken = tmp_path / "broken.npz"
    broken.write_bytes(b"PK")
    dialog.network.choose(broken)
    assert not dialog.go.isEnabled()
    assert "This is not a model of mocapmend, or it is damaged" in dialog.problem.text()
    assert dialog.card.toPlainText() == ""
    dialog.network.combo.setCurrentIndex(-1)
    assert "Choose a network" in dialog.problem.text()
    dialog.reject()


def test_edits_are_said_to_be_left_out(opened: MainWindow, qtbot: QtBot) -> None:
    fill_one(current(opened))
    dialog = dialog_of(opened, qtbot)
    texts = [label.text() for label in dialog.findChildren(type(dialog.problem))]
    assert any("edits are left out" in text for text in texts)
    dialog.reject()


def test_files_are_checked_by_their_names(tmp_path: Path) -> None:
    recording, reference, other, truth = (tmp_path / name for name in ("a.txt", "b", "c", "d.c3d"))
    for path in (recording, reference, other, truth):
        path.write_text("")
    good, none, nothing = tmp_path / "out.c3d", tmp_path / "none.c3d", (None, None, None)
    assert file_problem(recording, nothing, good) == ""
    assert file_problem(recording, (reference, other, truth), good) == ""
    for text, given, out in (
        ("no reference", (none, None, None), good),
        ("a recording and its reference", (None, other, None), good),
        ("a recording and its reference", (None, None, truth), good),
        ("to calibrate with", (None, other, none), good),
        ("cannot calibrate itself", (None, recording, truth), good),
        ("Say where", nothing, None),
        ("must end in one of .c3d, .trc, .csv, .npz", nothing, tmp_path / "out.txt"),
        ("no folder", nothing, tmp_path / "nowhere" / "out.c3d"),
        ("must not replace", (reference, other, truth), truth),
    ):
        assert text in file_problem(recording, given, out)


def test_a_recording_of_the_same_person_calibrates(
    opened: MainWindow, qtbot: QtBot, joints: Path, tmp_path: Path
) -> None:
    reference = write_reference(tmp_path)
    for part in ("positions", "angles"):
        whole = joints.with_name(f"kinect_{part}.txt").read_bytes()
        joints.with_name(f"other_{part}.txt").write_bytes(whole)
    other = joints.with_name("other_positions.txt")
    dialog = dialog_of(opened, qtbot)
    dialog.calibration.set_path(other)
    assert not dialog.go.isEnabled()
    assert "a recording and its reference" in dialog.problem.text()
    dialog.truth.set_path(reference)
    assert dialog.go.isEnabled()
    qtbot.keyClick(dialog.out.edit, Qt.Key.Key_Return)
    workspace = refined(opened, qtbot)
    record = workspace.document.source.provenance.refined
    assert len(record.parameters["calibration_sha256"]) == 2
    facts = workspace.facts.refining()
    assert facts.calibrations == 1


def test_networks_used_lately_come_first(
    qtbot: QtBot, settings: Settings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    paths = [write_network(tmp_path / f"{name}.npz") for name in "abcdefg"]
    for path in paths:
        box = NetworkBox(settings)
        qtbot.addWidget(box)
        monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_, p=path: (str(p), ""))
        box.choosing.click()
        assert box.name() == str(path)
        box.remember()
    assert settings.get(REFINE_FILES) == [str(path) for path in reversed(paths[2:])]
    paths[6].unlink()
    box = NetworkBox(settings)
    qtbot.addWidget(box)
    assert str(paths[6]) not in [box.combo.itemData(k) for k in range(box.combo.count())]


def test_stride_1_takes_longer() -> None:
    model = copying()
    short, long = (seconds_for(60.0, stride, model) for stride in (60, 1))
    assert long / short == pytest.approx(60, rel=0.05)
    assert seconds_for(0.01, 60, model) > 0
    twice = replace(model, mirrored=True)
    assert seconds_for(60.0, 60, twice) == pytest.approx(2 * short)


def test_dialog_asks_and_gives_what_is_chosen(
    qtbot: QtBot, network: Path, joints: Path, settings: Settings, tmp_path: Path
) -> None:
    source: Source = read_recording(joints)
    window = MainWindow(settings)
    qtbot.addWidget(window)
    dialog = RefineDialog(source, tmp_path / "o.npz", settings, window, edited=False)
    with qtbot.waitSignal(dialog.chosen) as told:
        dialog.findChild(QDialogButtonBox).accepted.emit()
    assert told.args == [
        Order(joints, source.stamp, str(network), RefineParams("60", 6.0), tmp_path / "o.npz", None)
    ]


# --- what is seen --------------------------------------------------------------------------------


def colours(workspace: Workspace, where: str) -> int:
    """Count the pixels of a view that have the companion's colour, or nearly."""
    widget = workspace.scene if where == "3D" else workspace.trajectories
    image = widget.grab().toImage()
    theme = workspace.scene._theme
    wanted = QColor(theme.companion).rgb()
    return sum(
        image.pixel(x, y) == wanted for x in range(image.width()) for y in range(image.height())
    )


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_the_companion_is_painted_in_its_own_colour(
    opened: MainWindow, qtbot: QtBot, theme: str
) -> None:
    workspace = make(opened, qtbot)
    opened.actions_by_id[f"theme_{theme}"].trigger()
    workspace.view.select((workspace.document.labels.index("LWRA"),))
    qtbot.waitUntil(lambda: workspace.arranged)
    with_it = {where: colours(workspace, where) for where in ("3D", "plots")}
    opened.actions_by_id["companion"].setChecked(False)
    without = {where: colours(workspace, where) for where in ("3D", "plots")}
    assert min(with_it.values()) > 20
    assert without == {"3D": 0, "plots": 0}


def test_partners_are_read_beside_the_markers(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = make(opened, qtbot)
    labels = workspace.document.labels
    marker, other = labels.index("LWRA"), labels.index("LELB")
    workspace.view.select((marker,))
    qtbot.waitUntil(lambda: workspace.arranged)
    workspace.trajectories.grab()
    readout = workspace.trajectories._readout(40, 0)
    assert [row.name for row in readout.rows] == ["LWRA", "╌ LeftWrist"]
    beside = workspace.view.companion
    assert beside is not None
    wrist = beside.original.labels.index("LeftWrist")
    expected = tuple(f"{value:.1f}" for value in beside.points[40, wrist])
    assert readout.rows[1].values == expected
    painter = workspace.trajectories._painter.companion
    bone = painter.read((Quantity.BONE,), Curve(marker, "", other), 40)
    assert bone is not None
    elbow = beside.original.labels.index("LeftElbow")
    length = np.linalg.norm(beside.points[40, wrist] - beside.points[40, elbow])
    assert bone == ("╌ LeftWrist – LeftElbow", (pytest.approx(length),))
    near = labels.index("LWRB")
    if beside.partners[near] == wrist:
        assert painter.partner(Curve(marker, "", near)) is None


def test_any_recording_can_be_compared_with(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace = make(opened, qtbot)
    reference = write_reference(tmp_path)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(reference), ""))
    qtbot.keyClick(opened, Qt.Key.Key_D, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: workspace.facts.beside is not None)
    assert workspace.facts.beside is not None
    assert workspace.facts.beside.reference == reference.name
    companion = workspace.view.companion
    assert companion is not None
    assert companion.way == "fitted"
    assert companion.partners == tuple(range(39))
    assert "turned and shifted" in opened.statusBar().currentMessage()
    refining = workspace.facts.refining()
    assert refining is not None
    assert refining.judged is workspace.facts.beside
    workspace.comparing.end()
    assert workspace.facts.beside is None


def test_a_reference_that_was_given_keeps_its_figures(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    reference = write_reference(tmp_path)
    dialog = dialog_of(opened, qtbot)
    dialog.reference.set_path(reference)
    dialog.go.click()
    workspace = refined(opened, qtbot)
    given = workspace.facts.given
    workspace.comparing.look(reference)
    qtbot.waitUntil(lambda: workspace.facts.beside is not None)
    refining = workspace.facts.refining()
    assert refining is not None
    assert refining.judged is given
    other = tmp_path / "other_positions.txt"
    other.write_bytes(reference.read_bytes())
    workspace.comparing.look(other)
    qtbot.waitUntil(lambda: workspace.facts.refining() != refining)
    refining = workspace.facts.refining()
    assert refining is not None
    assert refining.judged is workspace.facts.beside


def test_a_file_that_cannot_be_compared_with_leaves_the_one_before(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    workspace = make(opened, qtbot)
    before = workspace.view.companion
    assert before is not None
    with qtbot.waitSignal(workspace.failed):
        workspace.comparing.look(tmp_path / "none.c3d")
    assert workspace.view.companion is before
    for box in opened.findChildren(QMessageBox):
        box.close()


def test_nothing_to_stop_is_told(opened: MainWindow, qtbot: QtBot) -> None:
    current(opened).comparing.end()
    assert "No recording is compared" in opened.statusBar().currentMessage()


def test_a_new_label_finds_another_partner(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = make(opened, qtbot)
    document = workspace.document
    marker = document.labels.index("LWRA")
    workspace.naming.renaming.rename(marker, "HeadTip")
    companion = workspace.view.companion
    assert companion is not None
    assert companion.partners[marker] == companion.original.labels.index("HeadTip")


def test_refining_needs_markers(window: MainWindow) -> None:
    assert not window.actions_by_id["refine"].isEnabled()
    needs = {spec.id: spec.needs for spec in ACTIONS}
    for name in ("refine", "compare_with", "companion", "end_comparing"):
        assert needs[name] == "markers"
