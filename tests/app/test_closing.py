"""A closed recording is gone at once: its arrays are large, and nobody collects garbage for it."""

import gc
from collections.abc import Callable
from pathlib import Path
from weakref import ReferenceType, ref

import pytest
from crash_window import edit_of
from pytestqt.qtbot import QtBot

from mocapmend.prospects import Way
from mocapmend.views.main_window import MainWindow
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms.fill.limits import Limits

Open = Callable[[Path], MainWindow]


def leave_alone(workspace: Workspace) -> None:
    """Close it as soon as it is open, while its skeleton is searched."""


def edit(workspace: Workspace) -> None:
    for number, gap in enumerate(workspace.document.gaps[:2], start=1):
        workspace.push([edit_of(gap, number)], f"edit {number}")
    workspace.document.undo_stack.undo()
    workspace.document.undo_stack.setClean()


def look_around(workspace: Workspace) -> None:
    workspace.select_all()
    for pane in workspace.panes():
        workspace.show_pane(pane.widget())
        workspace.grab()
    workspace.show_analog()


def plan(workspace: Workspace) -> None:
    workspace.show_plan()


def fill(workspace: Workspace) -> None:
    workspace.filling.fill_all(Way.default("pca-r2"), Limits())
    assert workspace.filling.job is not None


def correct(workspace: Workspace) -> None:
    workspace.search.start()
    workspace.view.select((3, 4))
    workspace.bad_actions.exchange()
    workspace.bad_actions.exchange()
    workspace.bad_actions.set_aside()
    workspace.bad_actions.fix_then(("spikes",), workspace.fill_all)
    workspace.document.undo_stack.setClean()


def look_ahead_at_smoothing(workspace: Workspace) -> None:
    workspace.select_all()
    workspace.show_pane(workspace.smooth)
    workspace.smooth.refresh()
    assert workspace.smoothing.busy


def smooth(workspace: Workspace) -> None:
    workspace.smooth.markers.setCurrentIndex(1)
    workspace.smooth.apply()
    assert workspace.smoothing.job is not None


def big_parts(workspace: Workspace) -> list[ReferenceType[object]]:
    document = workspace.document
    arrays = (document.source.recording.points, document._samples, document._states)
    return [ref(part) for part in (workspace, document, *arrays, workspace.trajectories)]


@pytest.mark.parametrize(
    "use", [leave_alone, edit, look_around, plan, fill, correct, look_ahead_at_smoothing, smooth]
)
def test_a_closed_recording_leaves_nothing_to_the_garbage_collector(
    use: Callable[[Workspace], None], open_in: Open, gait: Path, qtbot: QtBot
) -> None:
    window = open_in(gait)
    window.jobs._garbage.timer.stop()
    assert not gc.isenabled()
    assert window.workspace is not None
    use(window.workspace)
    parts = big_parts(window.workspace)
    window.files.close()
    assert window.workspace is None
    qtbot.waitUntil(lambda: [part for part in parts if part() is not None] == [], timeout=20_000)
