"""The repair pane: its list of methods, what it promises, donors, and filling all gaps."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest
from holes import HOLES
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from mocapmend.cli import main
from mocapmend.settings import LIMIT_GAP, MAX_GAP_MS, METHOD, Settings
from mocapmend.views.main_window import MainWindow
from mocapmend.views.method_box import MethodBox
from mocapmend.views.names_edit import NamesEdit
from mocapmend.views.workspace import Workspace
from mocapmend.viewstate import Preview
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.registry import FAMILIES, METHODS

Open = Callable[[Path], MainWindow]


@pytest.fixture
def workspace(open_in: Open, holed_walk: Path) -> Workspace:
    """Return the workspace of the walk."""
    return workspace_of(open_in(holed_walk))


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def preview_of(workspace: Workspace, gap: Gap, qtbot: QtBot) -> Preview:
    workspace.view.go_to(gap)
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    preview = workspace.view.preview
    assert preview is not None
    assert preview.gap == gap
    return preview


def promise(workspace: Workspace) -> str:
    return workspace.repair._promise.text()


def names(labels: Sequence[str]) -> str:
    """Return how the program lists markers, all of which are of one subject."""
    assert all(label.startswith("TakeoMonday:") for label in labels)
    return ", ".join(label.removeprefix("TakeoMonday:") for label in labels)


def type_donors(workspace: Workspace, text: str, qtbot: QtBot) -> None:
    edit = donors_field(workspace).edit
    edit.setFocus()
    qtbot.waitUntil(edit.hasFocus)
    edit.setText(text)
    qtbot.keyClick(edit, Qt.Key.Key_Return)
    assert not edit.hasFocus()


def donors_field(workspace: Workspace) -> NamesEdit:
    field = workspace.repair.findChild(NamesEdit, "donors")
    assert field is not None
    return field


# --- the list of methods -------------------------------------------------------------------------


def test_automatic_comes_first_and_families_stand_together(qtbot: QtBot) -> None:
    box = MethodBox("kalman")
    qtbot.addWidget(box)
    assert box.method is METHODS["kalman"]
    rows = [(box.itemData(row), box.itemText(row)) for row in range(box.count())]
    listed = [method for method, _ in rows if method is not None]
    assert listed[0] == "auto"
    assert sorted(listed) == sorted(METHODS)
    families = [METHODS[method].family for method in listed]
    assert families == sorted(families, key=FAMILIES.index)
    order = list(METHODS)
    for family in FAMILIES:
        members = [m for m in listed if METHODS[m].family == family]
        assert members == sorted(members, key=order.index)
    headings = [text for method, text in rows if method is None]
    assert headings == [f for f in FAMILIES if f in families and f != "Automatic"]


def test_stepping_and_arrow_keys_leave_the_headings_out(qtbot: QtBot) -> None:
    box = MethodBox("auto")
    qtbot.addWidget(box)
    seen = []
    for _ in METHODS:
        seen.append(box.method.id)
        box.step(1)
    assert box.method.id == "auto"
    assert sorted(seen) == sorted(METHODS)
    box.step(-1)
    assert box.method.id == seen[-1]
    box.step(1)
    qtbot.keyClick(box, Qt.Key.Key_Down)
    assert box.method.id == seen[1]
    qtbot.keyClick(box, Qt.Key.Key_Up)
    assert box.method.id == "auto"


@pytest.mark.parametrize(
    ("remembered", "chosen"),
    [(None, "auto"), ("cubic", "cubic"), ("local-frame", "local-frame"), ("of old", "auto")],
)
def test_the_remembered_method_is_chosen(
    open_in: Open, gait: Path, settings: Settings, remembered: str | None, chosen: str
) -> None:
    if remembered is not None:
        settings.set(METHOD, remembered)
    window = open_in(gait)
    assert workspace_of(window).repair.method() == (chosen, METHODS[chosen].params())
    assert settings.chosen(METHOD) == (remembered is not None), "a default is not a choice"
    workspace_of(window).repair.step_method(1)
    assert settings.get(METHOD) == workspace_of(window).repair.method()[0] != chosen


# --- the limits ----------------------------------------------------------------------------------


def test_a_length_that_an_older_version_remembers_is_a_limit(
    open_in: Open, gait: Path, settings: Settings
) -> None:
    settings.set(MAX_GAP_MS, 150.0)
    repair = workspace_of(open_in(gait)).repair
    assert repair.limits.max_gap() == 15
    repair.limits._limit_gap.setChecked(False)
    assert repair.limits.max_gap() is None
    assert settings.chosen(LIMIT_GAP)
    assert settings.get(MAX_GAP_MS) == 150.0


def test_only_the_error_is_limited_at_first(workspace: Workspace, settings: Settings) -> None:
    repair = workspace.repair
    assert (repair.limits.max_gap(), repair.limits.max_error_mm()) == (None, 20.0)
    assert not repair.limits._max_gap.isEnabled()
    repair.limits._limit_gap.setChecked(True)
    assert repair.limits.max_gap() == 20
    assert settings.get(LIMIT_GAP)


# --- what a preview promises ---------------------------------------------------------------------


def test_the_preview_says_where_automatic_draws_a_curve(
    open_in: Open, gait: Path, qtbot: QtBot
) -> None:
    # A fragment that is nobody's marker: no other marker knows where it goes.
    workspace = workspace_of(open_in(gait))
    fragment = workspace.document.original.labels.index("*53")
    gap = next(gap for gap in workspace.document.gaps if gap.marker == fragment and gap.start > 0)
    assert preview_of(workspace, gap, qtbot).note["curve"]
    assert "A cubic spline" in promise(workspace)
    assert "Donors" not in promise(workspace)


@pytest.mark.parametrize("kind", HOLES)
def test_error_band_and_donors_are_known_before_applying(
    workspace: Workspace, qtbot: QtBot, kind: str
) -> None:
    preview = preview_of(workspace, HOLES[kind], qtbot)
    assert preview.method == "auto"
    assert preview.patch is not None
    assert np.isfinite(preview.patch.r90).all()
    shown = promise(workspace)
    assert f"Expected error <b>{preview.patch.expected_error:.1f} mm</b>" in shown
    assert f"90 % within {preview.patch.typical_r90:.1f} mm" in shown
    assert preview.donors
    assert f"Donors: {names(preview.donors)}" in shown
    assert "hidden stretches of this marker" in shown
    assert "⚠" not in shown
    workspace.repair.limits._max_error.setValue(preview.patch.expected_error / 2)
    assert "⚠ Above the limit" in promise(workspace)
    assert len(workspace.document.repairs) == 0


def test_an_applied_repair_knows_its_donors(workspace: Workspace, qtbot: QtBot) -> None:
    gap = HOLES["interior"]
    donors = preview_of(workspace, gap, qtbot).donors
    workspace.gap_actions.apply()
    assert workspace.document.repairs[gap].donors == donors
    assert [record.donors for record in workspace.document.unsaved().records()] == [donors]
    assert f"Donors: {names(donors)}" in promise(workspace)
    model = workspace.repairs.table.model()
    last = model.columnCount() - 1
    assert model.headerData(last, Qt.Orientation.Horizontal).strip() == "Donors"
    assert model.index(0, last).data() == names(donors)


# --- donors by hand ------------------------------------------------------------------------------


def test_the_selected_markers_become_donors(workspace: Workspace, qtbot: QtBot) -> None:
    labels = workspace.document.original.labels
    gap = HOLES["interior"]
    others = preview_of(workspace, gap, qtbot).donors[:3]
    field = donors_field(workspace)
    assert not field.take.isEnabled(), "the marker itself is no donor"
    for label in others:
        workspace.view.toggle(labels.index(label))
    assert workspace.view.gap == gap
    qtbot.mouseClick(field.take, Qt.MouseButton.LeftButton)
    assert workspace.repair.method() == ("auto", METHODS["auto"].params(donors=others))
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    preview = workspace.view.preview
    assert preview is not None
    assert preview.params.donors == others
    assert set(preview.donors) == set(others)


def test_completing_a_donor_applies_nothing(workspace: Workspace, qtbot: QtBot) -> None:
    preview_of(workspace, HOLES["interior"], qtbot)
    edit = donors_field(workspace).edit
    edit.setFocus()
    qtbot.waitUntil(edit.hasFocus)
    qtbot.keyClicks(edit, "lwr")
    popup = edit.completer().popup()
    qtbot.waitUntil(popup.isVisible)
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: workspace.repair.method()[1].donors == ("TakeoMonday:LWRA",))
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    assert workspace.document.undo_stack.count() == 0
    assert workspace.view.gap == HOLES["interior"]


def test_an_unknown_donor_is_the_methods_refusal(workspace: Workspace, qtbot: QtBot) -> None:
    gap = HOLES["interior"]
    preview_of(workspace, gap, qtbot)
    type_donors(workspace, "<b>nobody</b>", qtbot)
    qtbot.waitUntil(lambda: workspace.view.preview is not None)
    preview = workspace.view.preview
    assert preview is not None
    assert preview.patch is None
    assert "there is no marker &lt;b&gt;nobody&lt;/b&gt; to take as a donor" in promise(workspace)
    assert not workspace.repair._apply.isEnabled()
    donors_field(workspace).edit.clear()
    qtbot.waitUntil(
        lambda: workspace.view.preview is not None and workspace.view.preview.patch is not None
    )


def test_donors_are_typed_by_the_names_that_markers_have_elsewhere(
    workspace: Workspace, qtbot: QtBot
) -> None:
    donors = preview_of(workspace, HOLES["interior"], qtbot).donors
    type_donors(workspace, names(donors), qtbot)
    assert workspace.repair.method()[1].donors == donors


# --- all gaps ------------------------------------------------------------------------------------


def test_the_defaults_of_window_and_command_line_write_the_same_bytes(
    open_in: Open, gait: Path, qtbot: QtBot, tmp_path: Path
) -> None:
    window = open_in(gait)
    workspace = workspace_of(window)
    workspace.fill_all()
    qtbot.waitUntil(lambda: workspace.document.undo_stack.count() == 1, timeout=60_000)
    assert {repair.method for repair in workspace.document.repairs.values()} == {"auto"}
    assert any(repair.donors for repair in workspace.document.repairs.values())
    by_window, by_command = tmp_path / "window.c3d", tmp_path / "command.c3d"
    window.files.export(by_window)
    qtbot.waitUntil(lambda: not window.isWindowModified(), timeout=20_000)
    assert main(["repair", str(gait), "-o", str(by_command)]) == 0
    assert by_window.read_bytes() == by_command.read_bytes()


def test_filling_all_automatically_is_cancelled(open_in: Open, sprint: Path, qtbot: QtBot) -> None:
    window = open_in(sprint)
    workspace = workspace_of(window)
    told: list[str] = []
    workspace.message.connect(told.append)
    workspace.fill_all()
    assert not workspace.repair._fill_all.isEnabled()
    job = workspace.filling.job
    assert job is not None
    qtbot.waitUntil(lambda: job.progress > 0, timeout=20_000)
    cancel = window.findChild(QToolButton, "cancel_job")
    qtbot.waitUntil(cancel.isVisible, timeout=20_000)
    qtbot.mouseClick(cancel, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: workspace.filling.job is None, timeout=20_000)
    assert told == ["Cancelled: nothing was filled."]
    assert job.progress < 0.5
    assert workspace.document.undo_stack.count() == 0
    assert workspace.repair._fill_all.isEnabled()
