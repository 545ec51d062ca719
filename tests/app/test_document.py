"""The document is changed by undo commands alone, and undo restores it to the bit."""

import pickle
from weakref import ref

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from mocapmend.commands import EditSamples
from mocapmend.document import Document, Edit
from mocapmend.state import SampleState
from mocapmend.written import places_of
from mocapmend_algorithms import Gap, find_gaps
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.registry import METHODS


def fill(document: Document, gap: Gap, value: float = 1.0) -> EditSamples:
    values = np.full((gap.length, 3), value)
    sigma = np.full(gap.length, 2.0)
    edit = Edit.fill(Patch(gap, values, sigma, 2.5 * sigma), "linear", METHODS["linear"].params())
    return EditSamples(document, [edit], "fill")


def interior(document: Document) -> list[Gap]:
    frames = document.original.frames
    return [gap for gap in document.gaps if gap.kind(frames) == "interior"]


def test_the_gaps_of_a_new_document_are_those_of_the_file(document: Document) -> None:
    assert document.gaps == find_gaps(document.original.present)
    assert len(interior(document)) == 50


def test_a_fill_writes_its_gap_and_nothing_else(document: Document) -> None:
    gap = interior(document)[0]
    before = document.points.copy()
    document.undo_stack.push(fill(document, gap))
    changed = np.zeros(before.shape[:2], bool)
    changed[gap.start : gap.stop, gap.marker] = True
    assert (document.points[changed] == 1.0).all()
    assert document.points[~changed].tobytes() == before[~changed].tobytes()
    assert (document.state[changed] == SampleState.FILLED).all()
    assert gap not in document.gaps
    assert document.repairs[gap].patch.expected_error == pytest.approx(2.0 * np.sqrt(3.0))


def test_a_fill_announces_its_run_and_raises_the_revision(document: Document, qtbot: QtBot) -> None:
    gap = interior(document)[0]
    with qtbot.waitSignal(document.samples_changed) as announced:
        document.undo_stack.push(fill(document, gap))
    assert announced.args == [(gap,)]
    assert document.revision == 1


def test_an_edited_document_waits_for_no_garbage_collector(document: Document) -> None:
    edited = Document(document.source, document.skeleton)
    gap = interior(edited)[0]
    for value in (1.0, 2.0):
        edited.undo_stack.push(fill(edited, gap, value))
    edited.undo_stack.undo()
    gone = ref(edited)
    del edited
    assert gone() is None


def test_the_original_never_changes(document: Document) -> None:
    before = document.original.points.copy()
    for gap in interior(document):
        document.undo_stack.push(fill(document, gap))
    assert document.original.points.tobytes() == before.tobytes()


def test_points_cannot_be_written_from_outside(document: Document) -> None:
    with pytest.raises(ValueError, match="read-only"):
        document.points[0, 0, 0] = 1.0


def test_clearing_a_fill_brings_the_gap_back_and_undo_the_fill(document: Document) -> None:
    gap = interior(document)[0]
    document.undo_stack.push(fill(document, gap, 7.0))
    document.undo_stack.push(EditSamples(document, [Edit.clear(gap)], "clear"))
    assert gap in document.gaps
    assert not document.repairs
    document.undo_stack.undo()
    assert (document.points[gap.start : gap.stop, gap.marker] == 7.0).all()
    assert document.repairs[gap].method == "linear"


@settings(
    max_examples=25,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(
    steps=st.lists(st.one_of(st.integers(0, 49), st.sampled_from(["undo", "redo"])), max_size=30)
)
def test_undoing_everything_restores_every_bit(document: Document, steps: list[int | str]) -> None:
    points, state, gaps = document.points.copy(), document.state.copy(), document.gaps
    candidates = interior(document)
    for step in steps:
        if step == "undo":
            document.undo_stack.undo()
        elif step == "redo":
            document.undo_stack.redo()
        else:
            gap = candidates[int(step)]
            if gap in document.gaps:
                document.undo_stack.push(fill(document, gap, float(step)))
            else:
                document.undo_stack.push(EditSamples(document, [Edit.clear(gap)], "clear"))
        assert document.gaps == find_gaps(~np.isnan(document.points[:, :, 0]))
    document.undo_stack.setIndex(0)
    assert document.points.tobytes() == points.tobytes()
    assert document.state.tobytes() == state.tobytes()
    assert document.gaps == gaps
    assert not document.repairs
    document.undo_stack.clear()


def test_changed_runs_are_what_an_export_has_to_write(document: Document) -> None:
    first, second = interior(document)[:2]
    document.undo_stack.push(fill(document, first, 1.0))
    document.undo_stack.push(fill(document, second, 2.0))
    document.undo_stack.undo()
    runs = document.unsaved().changes().runs
    assert [(run.marker, run.start, len(run.values)) for run in runs] == [
        (first.marker, first.start, first.length)
    ]


def test_a_snapshot_is_a_copy(document: Document) -> None:
    gap = interior(document)[0]
    snapshot = document.snapshot()
    document.undo_stack.push(fill(document, gap))
    assert np.isnan(snapshot.points[gap.start, gap.marker]).all()


def test_one_shared_copy_serves_a_revision(document: Document) -> None:
    shared = document.share()
    assert document.share() is shared
    assert document.share_original() is shared
    document.undo_stack.push(fill(document, interior(document)[0]))
    edited = document.share()
    assert edited is not shared
    assert document.share() is edited
    assert document.share_original() is shared
    document.undo_stack.undo()
    assert document.share().recording().points.tobytes() == shared.recording().points.tobytes()


def test_a_shared_snapshot_has_the_edits_of_its_time(document: Document) -> None:
    first, second = interior(document)[:2]
    document.undo_stack.push(fill(document, first))
    expected = document.points.copy()
    shared = document.share()
    document.undo_stack.push(fill(document, second))
    assert shared.recording().points.tobytes() == expected.tobytes()
    received = pickle.loads(pickle.dumps(shared))
    assert received.points.tobytes() == expected.tobytes()
    original = document.share_original().recording()
    assert original.points.tobytes() == document.original.points.tobytes()


def test_points_that_were_handed_out_do_not_change_before_the_first_edit(
    document: Document,
) -> None:
    gap = interior(document)[0]
    assert np.shares_memory(document.points, document.original.points)
    document.undo_stack.push(fill(document, gap))
    assert not np.shares_memory(document.points, document.original.points)
    assert np.isnan(document.original.points[gap.start, gap.marker]).all()


def test_a_skeleton_that_comes_later_is_announced(document: Document, qtbot: QtBot) -> None:
    later = Document(document.source, None)
    assert later.skeleton.bones == ()
    with qtbot.waitSignal(later.skeleton_changed):
        later.set_skeleton(document.skeleton)
    assert later.skeleton is document.skeleton
    assert later.found_skeleton is document.skeleton


def test_many_runs_are_read_as_one_by_one(document: Document) -> None:
    gaps = interior(document)
    document.undo_stack.push(fill(document, gaps[1]))
    for gap, edit in zip(gaps, document.read_runs(gaps, places_of(gaps)), strict=True):
        alone = document.read(gap)
        assert edit.gap == gap
        assert edit.repair is alone.repair
        assert edit.values.tobytes() == alone.values.tobytes()
        assert edit.states.tobytes() == alone.states.tobytes()
