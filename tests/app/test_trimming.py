"""The ragged ends of gaps: cut off, given back, repaired, undone, exported."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from holes import HOLES
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from mocapmend import recipe, replaying
from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.engine import export, fill_gap, load
from mocapmend.files import check_files, read_c3d
from mocapmend.state import SampleState
from mocapmend.trimming import hidden, resized, widened
from mocapmend.views.main_window import MainWindow
from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.interpolate import CubicParams

GAP = HOLES["interior"]
WIDE = Gap(GAP.marker, GAP.start - 2, GAP.stop + 2)


def opened(path: Path) -> Document:
    return Document(*load(path, no_progress))


def push(document: Document, edit: Edit) -> None:
    document.undo_stack.push(EditSamples(document, [edit], "edit"))


def test_ends_move_out_and_back_and_undo_restores_every_bit(holed_walk: Path, qtbot: QtBot) -> None:
    document = opened(holed_walk)
    before, states = document.points.tobytes(), document.state.tobytes()
    assert widened(document, GAP, 2) == WIDE
    push(document, resized(document, GAP, WIDE))
    assert WIDE in document.gaps_of(GAP.marker)
    assert hidden(document, WIDE) == (2, 2)
    assert np.isnan(document.points[WIDE.start : WIDE.stop, GAP.marker]).all()
    assert widened(document, WIDE, -1) == Gap(GAP.marker, GAP.start - 1, GAP.stop + 1)
    assert widened(document, WIDE, -9) == GAP, "a missing sample is never uncovered"
    push(document, resized(document, WIDE, GAP))
    assert document.points.tobytes() == before
    document.undo_stack.undo()
    assert WIDE in document.gaps_of(GAP.marker)
    document.undo_stack.undo()
    assert (document.points.tobytes(), document.state.tobytes()) == (before, states)


def test_ends_stop_at_the_ends_of_the_recording_and_before_other_gaps(
    sprint: Path, qtbot: QtBot
) -> None:
    document = opened(sprint)
    measured = document.state == SampleState.MEASURED
    for gap in document.gaps[:200]:
        wide = widened(document, gap, 5)
        assert 0 <= wide.start <= gap.start
        assert gap.stop <= wide.stop <= document.original.frames
        assert measured[wide.start : gap.start, gap.marker].all()
        assert measured[gap.stop : wide.stop, gap.marker].all()
        for edge in (wide.start - 1, wide.stop):
            if 0 <= edge < document.original.frames and wide != gap:
                assert measured[edge, gap.marker] or edge in (gap.start - 1, gap.stop)


def test_a_repair_with_cut_ends_is_exported_checked_and_replayed(
    holed_walk: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    document = opened(holed_walk)
    push(document, resized(document, GAP, WIDE))
    params = CubicParams()
    result = fill_gap(document.original, WIDE, "cubic", params, no_progress)
    push(document, Edit.fill(result.patches[0], "cubic", params))
    out = tmp_path / "out.c3d"
    export(document.source, document.unsaved().changes(), out, False, False, no_progress)
    found = check_files(holed_walk, out)
    assert found.passed
    assert found.changed_samples == WIDE.length
    assert "4 measured samples at the ends of repaired gaps were replaced" in found.allowed[0]
    assert read_c3d(out).repaired == (WIDE,)
    written = tmp_path / "recipe.json"
    recipe.write_recipe(document.source, document.unsaved().records(), written)
    again = tmp_path / "again.c3d"
    made = replaying.replay(document.source, recipe.read_recipe(written), no_progress)
    export(document.source, made, again, False, False, no_progress)
    assert again.read_bytes() == out.read_bytes()


def test_measured_ends_of_a_gap_that_stays_open_stay_in_the_file(
    holed_walk: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    document = opened(holed_walk)
    push(document, resized(document, GAP, WIDE))
    other = HOLES["leading"]
    push(document, resized(document, other, widened(document, other, 1)))
    assert not document.unsaved().changes().runs
    out = tmp_path / "out.c3d"
    export(document.source, document.unsaved().changes(), out, False, False, no_progress)
    assert out.read_bytes() == holed_walk.read_bytes()


def test_keys_move_the_ends_of_the_current_gap(
    open_in: Callable[[Path], MainWindow], holed_walk: Path, qtbot: QtBot
) -> None:
    window = open_in(holed_walk)
    workspace = window.workspace
    assert workspace is not None
    workspace.view.go_to(GAP)
    qtbot.keyClick(window, Qt.Key.Key_W)
    qtbot.keyClick(window, Qt.Key.Key_W)
    assert workspace.view.gap == WIDE
    assert "2 + 2 measured frames" in workspace.repair._title.text()
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    assert workspace.view.preview is not None
    assert workspace.view.preview.gap == WIDE
    qtbot.keyClick(window, Qt.Key.Key_Return)
    assert WIDE in workspace.document.repairs
    qtbot.keyClick(window, Qt.Key.Key_Delete)
    qtbot.keyClick(window, Qt.Key.Key_W, Qt.KeyboardModifier.ShiftModifier)
    qtbot.keyClick(window, Qt.Key.Key_W, Qt.KeyboardModifier.ShiftModifier)
    assert workspace.view.gap == GAP
    told: list[str] = []
    workspace.message.connect(told.append)
    qtbot.keyClick(window, Qt.Key.Key_W, Qt.KeyboardModifier.ShiftModifier)
    assert told == ["The ends of this gap go no further."]


def test_undoing_moved_ends_stays_at_the_gap(
    open_in: Callable[[Path], MainWindow], holed_walk: Path, qtbot: QtBot
) -> None:
    window = open_in(holed_walk)
    workspace = window.workspace
    assert workspace is not None
    workspace.view.go_to(GAP)
    qtbot.keyClick(window, Qt.Key.Key_W)
    assert workspace.view.gap not in (None, GAP)
    workspace.document.undo_stack.undo()
    assert workspace.view.gap == GAP
    qtbot.waitUntil(lambda: workspace.view.preview is not None, timeout=20_000)
    workspace.document.undo_stack.redo()
    assert workspace.view.gap not in (None, GAP)
