"""Corrections of an open recording: undo, the journal, recipes, and what they mean for fills."""

import json
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from test_layers import FRAMES, MARKERS, SPIKE, SWAP, near, same, write

from mocapmend import engine, recipe, replaying
from mocapmend.beneath import beneath, share_beneath, without_smoothing
from mocapmend.commands import EditSamples
from mocapmend.correcting import step
from mocapmend.document import NO_SKELETON, Document
from mocapmend.doubts import Doubt
from mocapmend.edits import Edit, Smoothed
from mocapmend.files import Source
from mocapmend.files.c3d_reader import read_c3d
from mocapmend.journal.edits import decode, decode_correction, decode_labels, encode
from mocapmend.state import SampleState
from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.corrections import Exchange, corrected
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.smooth.registry import SMOOTHERS

LINEAR = METHODS["linear"].params()


@pytest.fixture
def document(tmp_path: Path) -> Document:
    return opened(write(tmp_path / "in.c3d"))


def opened(source: Source) -> Document:
    return Document(source, NO_SKELETON)


def push(document: Document, edits: list[Edit]) -> None:
    if edits:
        document.undo_stack.push(EditSamples(document, edits, "edit"))


def last(document: Document) -> EditSamples:
    command = document.undo_stack.command(document.undo_stack.index() - 1)
    assert isinstance(command, EditSamples)
    return command


def correct(document: Document, **what: object) -> None:
    edits, correction = step(document, **what)
    document.undo_stack.push(EditSamples(document, edits, "correct", correction))


def fill(document: Document, *gaps: Gap) -> None:
    """Fill gaps, all by default, from what is believed."""
    wanted = list(gaps or document.gaps)
    result = engine.fill_anyway(document.base, wanted, "linear", LINEAR, no_progress)
    push(document, Edit.fills(result, "linear", LINEAR, document.base_revision))


def smooth(document: Document, *runs: Gap, method: str = "butterworth") -> None:
    params = SMOOTHERS[method].params()
    shown = share_beneath(document).recording()
    result = engine.smooth(shown, list(runs), method, params, no_progress)
    push(document, Edit.smoothings(result, partial(beneath, document)))


def held(document: Document) -> tuple[NDArray[np.float64], ...]:
    """Return all that a document holds, as arrays."""
    return (document.points.copy(), document.state.copy(), document.base.points.copy())


def equal(one: tuple[NDArray[np.float64], ...], other: tuple[NDArray[np.float64], ...]) -> bool:
    return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(one, other, strict=True))


def test_bad_samples_are_a_gap(document: Document) -> None:
    correct(document, set_aside={Gap(1, 12, 15): SPIKE})
    assert document.gaps_of(1) == [Gap(1, 12, 15)]
    assert (document.state[12:15, 1] == SampleState.BAD).all()
    assert np.isnan(document.points[12:15, 1]).all()
    assert same(document.stored(Gap(1, 12, 15)), document.original.points[12:15, 1])
    fill(document)
    assert np.isfinite(document.points[12:15, 1]).all()
    document.undo_stack.undo()
    assert (document.state[12:15, 1] == SampleState.BAD).all()


def test_bad_samples_beside_a_gap_make_it_longer(document: Document) -> None:
    assert Gap(0, 5, 11) in document.gaps
    fill(document, Gap(0, 5, 11))
    correct(document, set_aside={Gap(0, 11, 13): SPIKE})
    assert document.gaps_of(0) == [Gap(0, 5, 13)]
    assert Gap(0, 5, 11) not in document.repairs
    document.undo_stack.undo()
    assert Gap(0, 5, 11) in document.repairs


def test_an_exchange_takes_gaps_and_doubts_along(document: Document) -> None:
    correct(document, set_aside={Gap(2, 10, 12): SPIKE})
    correct(document, exchanges=[Exchange(0, 2, 4, 12)])
    assert document.gaps_of(2) == [Gap(2, 5, 11), Gap(2, 30, 33)]
    assert document.gaps_of(0) == [Gap(0, 10, 12)]
    assert document.doubts == {Gap(0, 10, 12): SPIKE}
    expected = corrected(document.original, [Exchange(0, 2, 4, 12)], document.doubts)
    assert same(document.base.points, expected.points)
    assert same(document.points, expected.points)


def test_the_journal_knows_which_detector_found_an_exchange(document: Document) -> None:
    correct(document, exchanges=[SWAP], found_as=("swaps",))
    command = document.undo_stack.command(0)
    assert isinstance(command, EditSamples)
    event, _ = encode(command.text(), command.edits, command.correction)
    event = json.loads(json.dumps(event))
    again = decode_correction(event, document.original)
    assert again == command.correction
    assert again is not None
    assert again.found_as == ("swaps",)
    del event["correction"]["found_as"]
    assert decode_correction(event, document.original) == replace(again, found_as=())


def test_a_protected_gap_that_is_exchanged_is_a_gap_again(document: Document) -> None:
    edit = Edit.clear(Gap(0, 5, 11), SampleState.NEVER, "the hand is hidden")
    document.undo_stack.push(EditSamples(document, [edit], "never"))
    before = held(document)
    correct(document, exchanges=[SWAP])
    assert not document.never
    document.undo_stack.undo()
    assert equal(held(document), before)
    assert document.never_reason(Gap(0, 5, 11)) == "the hand is hidden"


def test_what_is_believed_again_is_as_measured(document: Document) -> None:
    before = held(document)
    correct(document, set_aside={Gap(1, 12, 18): SPIKE})
    correct(document, believe=[Gap(1, 14, 16)])
    assert document.gaps_of(1) == [Gap(1, 12, 14), Gap(1, 16, 18)]
    correct(document, believe=[Gap(1, 0, FRAMES)])
    assert equal(held(document), before)


def test_fills_from_before_are_stale(document: Document) -> None:
    fill(document, Gap(2, 30, 33))
    assert document.stale == []
    correct(document, set_aside={Gap(1, 12, 18): SPIKE})
    assert document.stale == [Gap(2, 30, 33)]
    fill(document, Gap(2, 30, 33))
    assert document.stale == []
    document.undo_stack.undo()
    assert document.stale == [Gap(2, 30, 33)]
    document.undo_stack.undo()
    assert document.stale == []


def test_views_hear_of_the_base_first(document: Document) -> None:
    heard: list[str] = []
    document.base_changed.connect(lambda: heard.append("base"))
    document.samples_changed.connect(lambda runs: heard.append(f"{len(runs)} runs"))
    correct(document, exchanges=[SWAP])
    fill(document)
    assert heard == ["base", "2 runs", f"{len(document.repairs)} runs"]


# --- smoothing ---------------------------------------------------------------------------------


def test_smoothing_is_the_last_layer(document: Document) -> None:
    fill(document, Gap(0, 5, 11))
    before = held(document)
    smooth(document, Gap(0, 2, 38))
    assert (document.state[5:11, 0] == SampleState.FILLED).all()
    assert (document.state[2:5, 0] == SampleState.SMOOTHED).all()
    assert not np.array_equal(document.points[2:38, 0], before[0][2:38, 0])
    assert same(document.points[:, 1:], before[0][:, 1:])
    after = held(document)
    document.undo_stack.push(EditSamples(document, [Edit.clear(Gap(0, 5, 11))], "clear"))
    assert not document.smoothed
    assert same(document.points[20:, 0], before[0][20:, 0])
    document.undo_stack.undo()
    assert equal(held(document), after)
    document.undo_stack.undo()
    assert equal(held(document), before)


def test_smoothing_again_begins_with_what_is_beneath(document: Document) -> None:
    run = Gap(1, 4, 36)
    smooth(document, run, method="gcv")
    once = held(document)
    smooth(document, run)
    smooth(document, run, method="gcv")
    assert equal(held(document), once)
    assert list(document.smoothed) == [run]


def test_stretches_of_a_marker_are_smoothed_one_after_another(document: Document) -> None:
    """Each begins with what is beneath, so that their order makes no difference."""
    smooth(document, Gap(1, 2, 18))
    first = held(document)
    smooth(document, Gap(1, 20, 38), method="gcv")
    assert set(document.smoothed) == {Gap(1, 2, 18), Gap(1, 20, 38)}
    assert same(document.points[:20, 1], first[0][:20, 1])
    both = held(document)
    smooth(document, Gap(1, 10, 24))
    assert list(document.smoothed) == [Gap(1, 10, 24)], "what overlaps is taken off"
    assert [edit.gap for edit in last(document).unsmoothed] == [Gap(1, 2, 18), Gap(1, 20, 38)]
    document.undo_stack.undo()
    assert equal(held(document), both)
    off = [beneath(document, Gap(1, 2, 18))]
    taken = EditSamples(document, off, "take smoothing off B")
    assert not taken.unsmoothed, "the one that is taken off is named once, the other one stays"
    document.undo_stack.push(taken)
    assert list(document.smoothed) == [Gap(1, 20, 38)]


def test_a_file_that_was_smoothed_and_is_smoothed_again_stays_so_without_that(
    tmp_path: Path, document: Document
) -> None:
    smooth(document, Gap(1, 4, 36))
    changes = document.unsaved().changes()
    engine.export(document.source, changes, tmp_path / "out.c3d", False, False, no_progress)
    again = opened(read_c3d(tmp_path / "out.c3d"))
    before = held(again)
    for run in (Gap(1, 4, 36), Gap(1, 10, 40)):
        smooth(again, run)
        off = without_smoothing(again, again.smoothed)
        assert [edit.gap for edit in off] == [run]
        again.undo_stack.push(EditSamples(again, off, "take smoothing off B"))
        assert equal(held(again), before)


def test_a_filled_gap_that_is_smoothed_stays_filled(document: Document) -> None:
    fill(document, Gap(0, 5, 11))
    for _ in range(2):
        smooth(document, Gap(0, 5, 11))
        assert Gap(0, 5, 11) in document.repairs
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert list(document.repairs) == [Gap(0, 5, 11)]
    assert not document.smoothed


def test_a_smoothed_file_stays_so(tmp_path: Path, document: Document) -> None:
    smooth(document, Gap(1, 4, 36))
    unsaved = document.unsaved()
    engine.export(
        document.source, unsaved.changes(), tmp_path / "out.c3d", False, False, no_progress
    )
    again = opened(read_c3d(tmp_path / "out.c3d"))
    assert list(again.smoothed) == [Gap(1, 4, 36)]
    assert (again.state[4:36, 1] == SampleState.SMOOTHED).all()
    assert without_smoothing(again, [Gap(1, 0, FRAMES)]) == []
    unchanged = again.unsaved().changes()
    engine.export(again.source, unchanged, tmp_path / "same.c3d", False, False, no_progress)
    assert (tmp_path / "same.c3d").read_bytes() == (tmp_path / "out.c3d").read_bytes()


# --- any steps ---------------------------------------------------------------------------------


def _spans(draw: st.DrawFn) -> tuple[int, int]:
    start = draw(st.integers(0, FRAMES - 2))
    return start, draw(st.integers(start + 1, FRAMES))


@st.composite
def deeds(draw: st.DrawFn) -> Callable[[Document], None]:
    """Return something that a user does."""
    first, second = draw(st.permutations(range(MARKERS)))[:2]
    span = _spans(draw)
    match draw(
        st.sampled_from(["exchange", "aside", "believe", "fill", "clear", "rename", "smooth"])
    ):
        case "exchange":
            return lambda document: correct(document, exchanges=[Exchange(first, second, *span)])
        case "aside":
            doubt = Doubt("by hand", f"{span}")
            return lambda document: correct(document, set_aside={Gap(first, *span): doubt})
        case "believe":
            return lambda document: correct(document, believe=[Gap(first, *span)])
        case "fill":
            return fill
        case "rename":
            command = {first: f"name {first} {span}"}
            return lambda document: document.undo_stack.push(
                EditSamples(document, [], "rename", labels=command)
            )
        case "clear":
            return lambda document: push(document, [Edit.clear(gap) for gap in document.repairs])
    return lambda document: smooth(document, Gap(first, *span), method="savgol")


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=30)
@given(done=st.lists(deeds(), min_size=1, max_size=7))
def test_whatever_is_done(tmp_path: Path, done: list[Callable[[Document], None]]) -> None:
    """It is undone and redone, comes back from the journal, is exported, and is replayed."""
    document = opened(write(tmp_path / "in.c3d"))
    stack = document.undo_stack
    states = [held(document)]
    for deed in done:
        deed(document)
        if stack.count() == len(states):
            states.append(held(document))
    commands = [stack.command(k) for k in range(stack.count())]
    for state in states[-2::-1]:
        stack.undo()
        assert equal(held(document), state)
    for state in states[1:]:
        stack.redo()
        assert equal(held(document), state)

    again = opened(document.source)
    for command in commands:
        assert isinstance(command, EditSamples)
        event, data = encode(command.text(), command.edits, command.correction, command.labels)
        event = json.loads(json.dumps(event))
        text, edits = decode(event, data, again.original)
        correction = decode_correction(event, again.original)
        assert correction == command.correction
        labels = decode_labels(event, again.original)
        again.undo_stack.push(EditSamples(again, edits, text, correction, labels))
    assert again.labels == document.labels
    assert equal(held(again), held(document))
    assert again.stale == document.stale

    assert document.gaps == [
        gap for gap in find_gaps(np.isfinite(document.points[..., 0])) if gap not in document.never
    ]
    changes = document.unsaved().changes()
    engine.export(document.source, changes, tmp_path / "out.c3d", False, False, no_progress)
    read = read_c3d(tmp_path / "out.c3d")
    assert not read.warnings
    assert read.recording.labels == document.labels
    assert near(read.recording.points, document.points)
    # What was measured where it is smoothed now is in the first file alone.
    kept = document.state != SampleState.SMOOTHED
    assert near(opened(read).base.points[kept], document.base.points[kept])
    assert set(opened(read).gaps) == set(document.gaps)
    if document.stale:
        return
    recipe.write_recipe(
        document.source,
        changes.repairs,
        tmp_path / "recipe.json",
        kept_open=changes.kept_open,
        corrections=changes.corrections,
    )
    made = recipe.read_recipe(tmp_path / "recipe.json")
    replayed = replaying.replay(document.source, made, no_progress)
    engine.export(document.source, replayed, tmp_path / "again.c3d", False, False, no_progress)
    assert (tmp_path / "again.c3d").read_bytes() == (tmp_path / "out.c3d").read_bytes()


def test_smoothed_is_written_down(document: Document) -> None:
    smooth(document, Gap(1, 4, 36))
    (made,) = document.smoothed.values()
    assert isinstance(made, Smoothed)
    assert made.chosen["cutoff_hz"]
    assert made.rms > 0
