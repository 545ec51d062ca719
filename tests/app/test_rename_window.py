"""Renaming in the window: typed where the name stands, refused where it cannot be, seen at once."""

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path

import pytest
from holes import HOLES
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot
from scrambled import write_scrambled

from mocapmend import engine
from mocapmend.commands import EditSamples
from mocapmend.edits import Edit
from mocapmend.files import read_c3d
from mocapmend.views.main_window import MainWindow
from mocapmend.views.names_edit import NamesEdit
from mocapmend.views.painters.measure import measurement
from mocapmend.views.workspace import Workspace
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.fill.registry import METHODS

Open = Callable[[Path], MainWindow]


@pytest.fixture
def workspace(open_in: Open, holed_walk: Path) -> Workspace:
    window = open_in(holed_walk)
    assert window.workspace is not None
    return window.workspace


def type_name(workspace: Workspace, window: MainWindow, qtbot: QtBot, text: str) -> None:
    """Type another name for the current marker, by the keyboard."""
    window.actions_by_id["rename"].trigger()
    table = workspace.markers.table
    qtbot.waitUntil(lambda: bool(table.findChildren(QLineEdit)))
    (editor,) = table.findChildren(QLineEdit)
    editor.selectAll()
    qtbot.keyClicks(editor, text)
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: not table.findChildren(QLineEdit))


def names_in(table_model: object) -> set[str]:
    model = table_model
    return {str(model.index(row, 0).data()) for row in range(model.rowCount())}  # type: ignore[attr-defined]


def test_a_name_is_typed_where_it_stands(
    workspace: Workspace, window: MainWindow, qtbot: QtBot
) -> None:
    document = workspace.document
    before = document.names[5]
    workspace.view.select((5,))
    type_name(workspace, window, qtbot, "Left hip")
    assert document.names[5] == "Left hip"
    assert document.undo_stack.undoText() == f"rename {before} to Left hip"
    document.undo_stack.undo()
    assert document.names[5] == before
    document.undo_stack.redo()
    assert document.names[5] == "Left hip"


@pytest.mark.parametrize(
    ("text", "said"), [(" ", "needs a name"), ("x" * 256, "256 bytes"), ("a\x07b", "control")]
)
def test_names_that_cannot_be_are_refused_with_a_sentence(
    workspace: Workspace, qtbot: QtBot, text: str, said: str
) -> None:
    before = workspace.document.labels
    with qtbot.waitSignal(workspace.message) as heard:
        workspace.markers.renamed.emit(5, text)
    assert said in heard.args[0]
    assert workspace.document.labels == before
    assert not workspace.document.undo_stack.count()


def test_a_name_that_another_marker_has_is_taken_with_a_warning(
    workspace: Workspace, qtbot: QtBot
) -> None:
    other = workspace.document.names[6]
    with qtbot.waitSignal(workspace.message) as heard:
        workspace.markers.renamed.emit(5, other)
    assert heard.args[0].startswith("⚠")
    assert workspace.document.names[5] == other


def test_the_names_of_two_markers_are_exchanged(
    workspace: Workspace, window: MainWindow, qtbot: QtBot
) -> None:
    document = workspace.document
    before, points = document.labels, document.points.copy()
    workspace.view.select((3,))
    with qtbot.waitSignal(workspace.message):
        window.actions_by_id["exchange_names"].trigger()
    assert not document.undo_stack.count(), "it takes two"
    workspace.view.select((3, 8))
    window.actions_by_id["exchange_names"].trigger()
    assert document.labels[3] == before[8]
    assert document.labels[8] == before[3]
    assert (document.points == points)[document.base.present].all(), "no sample has changed"
    document.undo_stack.undo()
    assert document.labels == before


def test_all_views_have_the_new_name_at_once(workspace: Workspace, qtbot: QtBot) -> None:
    document, view = workspace.document, workspace.view
    gap = HOLES["interior"]
    marker = gap.marker
    view.go_to(gap)
    result = engine.fill_gap(document.base, gap, "linear", METHODS["linear"].params(), no_progress)
    edits = Edit.fills(result, "linear", METHODS["linear"].params())
    assert edits
    document.undo_stack.push(EditSamples(document, edits, "fill"))
    second = next(each for each in document.gaps if each.marker != marker)
    other = second.marker
    for labelled in (workspace.report, workspace.plan):
        workspace.show_pane(labelled)
    workspace.naming.renaming.rename(marker, "Novel")
    workspace.naming.renaming.rename(other, "Fresh")
    view.select((other, marker))
    assert {"Novel", "Fresh"} <= names_in(workspace.markers.table.model())
    assert "Novel" in names_in(workspace.repairs.table.model())
    qtbot.waitUntil(
        lambda: "Fresh" in {workspace.queue.model.index(r, 1).data() for r in rows(workspace)}
    )
    assert any("Novel" in name for name in workspace.timeline._layout.names)
    bones = workspace.plots._bones
    assert bones.itemText(0) == "Fresh – Novel"
    assert "Novel" in measurement(document, view.selection, view.frame)
    view.go_to(second)
    assert workspace.repair._title.text().startswith("Fresh\n")
    workspace.show_pane(workspace.report)
    qtbot.waitUntil(
        lambda: (
            workspace.report.report is not None
            and document.labels[marker] in workspace.report.report.labels
        )
    )


def rows(workspace: Workspace) -> range:
    return range(workspace.queue.model.rowCount())


def test_chosen_donors_go_on_to_be_the_same_markers(workspace: Workspace, qtbot: QtBot) -> None:
    document, repair = workspace.document, workspace.repair
    name = next(
        key
        for key, method in METHODS.items()
        if any(each.name == "donors" for each in fields(method.params))
    )
    repair._choose(name)
    donors = document.labels[10], document.labels[11]
    field = repair.findChild(NamesEdit)
    assert field is not None
    field.set_selection(donors)
    field.take.click()
    assert repair.method().params.donors == donors
    workspace.naming.renaming.rename(10, "Donor")
    assert repair.method().params.donors == (document.labels[10], donors[1])
    field = repair.findChild(NamesEdit)
    assert field is not None
    assert field.edit.text().startswith("Donor")
    document.undo_stack.undo()
    assert repair.method().params.donors == donors


def test_repairs_name_their_donors_as_they_are_called_now(workspace: Workspace) -> None:
    document = workspace.document
    gap = document.gaps[0]
    params = METHODS["pattern"].params()
    result = engine.fill_gap(document.base, gap, "pattern", params, no_progress)
    workspace.do(EditSamples(document, Edit.fills(result, "pattern", params), "fill"))
    (donor, *_) = document.repairs[gap].donors
    at = document.labels.index(donor)
    workspace.naming.renaming.rename(at, "Donor")
    assert document.labels[at] in document.repairs[gap].donors
    assert donor not in document.repairs[gap].donors
    document.undo_stack.undo()
    assert donor in document.repairs[gap].donors
    document.undo_stack.undo()
    assert gap not in document.repairs


def test_repairs_of_the_file_stay_those_of_the_file(
    workspace: Workspace, window: MainWindow, open_in: Open, qtbot: QtBot, tmp_path: Path
) -> None:
    gap, params = workspace.document.gaps[0], METHODS["pattern"].params()
    result = engine.fill_gap(workspace.document.base, gap, "pattern", params, no_progress)
    workspace.do(EditSamples(workspace.document, Edit.fills(result, "pattern", params), "fill"))
    out = tmp_path / "filled.c3d"
    window.files.export(out)
    qtbot.waitUntil(lambda: workspace.saved)
    again = open_in(out).workspace
    assert again is not None
    document = again.document
    (donor, *_) = document.repairs[gap].donors
    at = document.labels.index(donor)
    again.push([Edit.clear(gap)], "clear")
    assert not document.is_earlier(gap)
    document.undo_stack.undo()
    again.naming.renaming.rename(at, "Donor")
    assert document.is_earlier(gap)
    assert document.labels[at] in document.repairs[gap].donors
    document.undo_stack.undo()
    again.push([Edit.clear(gap)], "clear")
    document.undo_stack.undo()
    assert document.is_earlier(gap)


def test_points_without_a_label_are_counted_and_told_about(
    open_in: Open, samples: Path, tmp_path: Path
) -> None:
    path = tmp_path / "scrambled.c3d"
    made = write_scrambled(samples / "walk_cmu_02_01.c3d", path)
    nameless = sum(label.startswith("*") for label in made.recording.labels)
    window = open_in(path)
    assert window.workspace is not None
    markers, document = window.workspace.markers, window.workspace.document
    assert markers.nameless.text() == f"{nameless} points without a label"
    assert f"{nameless} of {len(document.labels)} points have no label." in window.notes.toolTip()
    point = next(k for k, label in enumerate(document.labels) if label.startswith("*"))
    window.workspace.naming.renaming.rename(point, "Heel")
    assert markers.nameless.text() == f"{nameless - 1} points without a label"
    assert f"{nameless - 1} of" in window.notes.toolTip()


def test_bones_are_looked_for_again(workspace: Workspace, qtbot: QtBot) -> None:
    document = workspace.document
    qtbot.waitUntil(lambda: document.found_skeleton is not None)
    before = document.skeleton
    marker = before.bones[0][0]
    with qtbot.waitSignal(document.skeleton_changed):
        workspace.naming.renaming.rename(marker, "Nobody knows")
    assert all(marker not in bone for bone in document.skeleton.bones), "the template lacks it"
    with qtbot.waitSignal(document.skeleton_changed):
        document.undo_stack.undo()
    assert document.skeleton == before


def test_a_renamed_recording_is_exported_and_recovered(
    workspace: Workspace, window: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    workspace.naming.renaming.rename(5, "Novel")
    out = tmp_path / "out.c3d"
    window.files.export(out)
    qtbot.waitUntil(lambda: workspace.saved)
    assert read_c3d(out).recording.labels[5] == workspace.document.labels[5]
