"""The fill plan: what would be done, before it is done; and as a file."""

import json
import math
from collections.abc import Callable
from pathlib import Path

import pytest
from holes import HOLES
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot
from spoilt import HOLE, OTHER, SPIKE, SWAP

from mocapmend.cli import main
from mocapmend.errors import MocapmendError
from mocapmend.plan import Plan, read_plan, write_plan
from mocapmend.prospects import Way
from mocapmend.ranking import Status
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.problems.registry import DETECTORS

Open = Callable[[Path], MainWindow]
CTRL_SHIFT = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def opened(open_in: Open, holed_walk: Path) -> MainWindow:
    """Return the window with the walk."""
    return open_in(holed_walk)


def workspace_of(window: MainWindow) -> Workspace:
    assert window.workspace is not None
    return window.workspace


def texts(workspace: Workspace, column: int) -> list[str]:
    model = workspace.plan.model
    return [model.index(row, column).data() for row in range(model.rowCount())]


def planned(window: MainWindow, qtbot: QtBot) -> Workspace:
    """Show the plan and wait until all of it is known."""
    workspace = workspace_of(window)
    qtbot.keyClick(window, Qt.Key.Key_Return, CTRL_SHIFT)
    qtbot.waitUntil(workspace.plan.isVisible)
    qtbot.waitUntil(
        lambda: (
            workspace.plan.model.rowCount() == 3
            and not any("computed" in text for text in texts(workspace, 4))
        ),
        timeout=30_000,
    )
    return workspace


def test_the_dry_run_says_what_filling_does(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = planned(opened, qtbot)
    document = workspace.document
    assert document.undo_stack.count() == 0
    assert texts(workspace, 4) == ["✔ filled"] * 3
    assert "3 would be filled (samples: 55), 0 would stay open" in workspace.plan.summary.text()
    errors = [float(text.removesuffix(" mm")) for text in texts(workspace, 3)]
    limit = sorted(errors)[1] + 0.05
    workspace.repair.limits._max_error.setValue(limit)
    qtbot.waitUntil(lambda: sum(text == "✔ filled" for text in texts(workspace, 4)) == 2)
    left = next(text for text in texts(workspace, 4) if text != "✔ filled")
    assert left.startswith("○ stays open: the expected error of")
    filled = {
        gap
        for gap, text in zip(
            map(workspace.plan.model.gap, range(3)), texts(workspace, 4), strict=True
        )
        if text == "✔ filled"
    }
    qtbot.keyClick(opened, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert workspace.filling.job is None, "nothing is computed twice"
    qtbot.waitUntil(lambda: set(document.repairs) == filled)
    assert document.undo_stack.count() == 1
    assert list(document.left_open) == [g for g in HOLES.values() if g not in filled]
    qtbot.waitUntil(lambda: workspace.plan.model.rowCount() == 1)
    workspace.queue.model.refresh()
    assert workspace.queue.model.gaps == list(document.left_open), "what is left is next"
    assert workspace.queue.model.problem(0).status is Status.BEYOND
    document.undo_stack.undo()
    assert not document.repairs
    qtbot.waitUntil(lambda: workspace.plan.model.rowCount() == 3)


def test_a_length_that_is_too_long_is_not_computed(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = workspace_of(opened)
    workspace.repair.limits._limit_gap.setChecked(True)
    workspace.repair.limits._max_gap.setValue(12)
    workspace = planned(opened, qtbot)
    long = HOLES["interior"]
    assert workspace.prospects.get(long, workspace.repair.method()) is None or (
        workspace.view.gap == long
    )
    outcome = dict(zip(map(workspace.plan.model.gap, range(3)), texts(workspace, 4), strict=True))
    assert "longer than the limit of 12 frames" in outcome[long]
    assert outcome[HOLES["leading"]] == "✔ filled"


def test_the_list_shows_a_part_and_leads_to_a_gap(opened: MainWindow, qtbot: QtBot) -> None:
    workspace = planned(opened, qtbot)
    pane = workspace.plan
    pane._shown.setCurrentIndex(2)
    assert pane.model.rowCount() == 0
    pane._shown.setCurrentIndex(1)
    assert pane.model.rowCount() == 3
    pane.table.activated.emit(pane.model.index(1, 0))
    assert workspace.view.gap == pane.model.gap(1)


def test_a_plan_is_saved_and_loaded(
    opened: MainWindow, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace = workspace_of(opened)
    repair, path = workspace.repair, tmp_path / "mine.json"
    repair._choose("rigid")
    repair.limits._limit_gap.setChecked(True)
    repair.limits._max_gap.setValue(18)
    repair.limits._max_error.setValue(7.5)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    opened.actions_by_id["save_plan"].trigger()
    assert read_plan(path) == Plan(Way.default("rigid"), 180.0, 7.5)
    repair._choose("cubic")
    repair.limits.set_limits(None, math.inf)
    assert repair.limits.limits() == Limits(None, math.inf)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    opened.actions_by_id["load_plan"].trigger()
    assert repair.method() == Way.default("rigid")
    assert repair.limits.limits() == Limits(18, 7.5)
    path.write_text("{}")
    shown: list[str] = []
    monkeypatch.setattr(QMessageBox, "open", lambda box: shown.append(box.text()))
    opened.actions_by_id["load_plan"].trigger()
    assert shown == ["This is not a plan: it has no 'mocapmend_plan'."]


@pytest.mark.parametrize("method", METHODS)
def test_plans_survive_their_file(method: str, tmp_path: Path) -> None:
    plan = Plan(Way.default(method), 250.0)
    write_plan(plan, tmp_path / "plan.json")
    assert read_plan(tmp_path / "plan.json") == plan


def test_the_length_of_a_plan_fits_every_rate() -> None:
    plan = Plan(Way.default("cubic"), 200.0, 5.0)
    assert plan.limits(100.0) == Limits(20, 5.0)
    assert plan.limits(120.0) == Limits(24, 5.0)
    assert plan.limits(59.94) == Limits(11, 5.0)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    key=st.sampled_from(["mocapmend_plan", "method", "parameters", "max_gap_ms", "max_error_mm"]),
    value=st.sampled_from([-1, "x", [], {}, {"nonsense": 1}, 1e400, True]),
)
def test_a_damaged_plan_is_one_error(key: str, value: object, tmp_path: Path) -> None:
    path = tmp_path / "plan.json"
    write_plan(Plan(Way.default("cubic")), path)
    data = json.loads(path.read_text()) | {key: value}
    path.write_text(json.dumps(data))
    if (key, value) in (("mocapmend_plan", True), ("parameters", {})):
        return
    with pytest.raises(MocapmendError, match="This is not a plan"):
        read_plan(path)


def test_a_plan_keeps_what_it_fixes_first_and_does_it(
    open_in: Open, spoilt_walk: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "plan.json"
    write_plan(Plan(Way.default("cubic"), None, math.inf, ("spikes", "swaps")), path)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "b.json"), ""))
    window = open_in(spoilt_walk)
    workspace = workspace_of(window)
    document = workspace.document
    qtbot.waitUntil(lambda: document.found_skeleton is not None)
    assert not workspace.repair.fix_first.isChecked()
    window.actions_by_id["load_plan"].trigger()
    assert workspace.repair.fix_first.kinds() == ("spikes", "swaps")
    assert "Spikes" in workspace.repair.fix_first.toolTip()
    window.actions_by_id["save_plan"].trigger()
    assert read_plan(tmp_path / "b.json").fix == ("spikes", "swaps")

    window.actions_by_id["fill_all"].trigger()
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2)
    assert document.undo_stack.text(0).startswith("fix ")
    assert set(document.doubts) >= {SPIKE}
    assert {doubt.problem for doubt in document.doubts.values()} == {"spikes"}
    assert {(move.marker, move.origin) for move in document.layers.moves} == {
        (SWAP.marker, OTHER),
        (OTHER, SWAP.marker),
    }
    assert document.gaps == []
    assert {SPIKE, HOLE} <= set(document.repairs)
    workspace.repair.fix_first.setChecked(False)
    window.actions_by_id["save_plan"].trigger()
    assert read_plan(tmp_path / "b.json").fix == ()


def test_the_plan_does_in_the_window_what_it_does_on_the_command_line(
    open_in: Open, spoilt_walk: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    window = open_in(spoilt_walk)
    workspace = workspace_of(window)
    document = workspace.document
    qtbot.waitUntil(lambda: document.found_skeleton is not None)
    workspace.repair.choose_way(Way.default("pchip"))
    workspace.repair.limits.set_limits(None, math.inf)
    workspace.repair.fix_first.setChecked(True)
    workspace.fill_all()
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2)
    window.files.export(tmp_path / "window.c3d")
    qtbot.waitUntil(lambda: not window.isWindowModified() and not window.files.writing)
    out = tmp_path / "command.c3d"
    every = ",".join(DETECTORS)
    words = ["repair", str(spoilt_walk), "-o", str(out), "--method", "pchip", "--fix", every]
    assert main([*words, "--max-error", "inf"]) == 0
    assert out.read_bytes() == (tmp_path / "window.c3d").read_bytes()
