"""What is recovered from a journal is the document as it was, whenever its program ended."""

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from mocapmend import engine
from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.errors import MocapmendError
from mocapmend.files import Source, Stamp, read_recording
from mocapmend.files.records import NEVER_FILLED
from mocapmend.journal import Recorder, discard, find_abandoned, resume
from mocapmend.journal.file import JournalFile
from mocapmend.journal.history import Subject
from mocapmend.state import SampleState
from mocapmend_algorithms import find_gaps, no_progress
from mocapmend_algorithms.fill.contract import Patch
from mocapmend_algorithms.fill.interpolate import ConstantParams, LinearParams
from mocapmend_algorithms.fill.limits import Limits
from mocapmend_algorithms.skeleton import Skeleton

Steps = list[int | str]
steps_of_a_user = st.lists(
    st.one_of(
        st.integers(0, 5),
        st.sampled_from(["undo", "redo", "all", "export", "leave", "take up", "never"]),
    ),
    max_size=20,
)
fixture_once = settings(
    max_examples=50, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


class Session:
    """A document that is edited and journalled, wired as the workspace does it."""

    def __init__(self, folder: Path, source: Source, journal: Path | None = None) -> None:
        self.folder = folder
        self.document = open_document(source)
        self.gaps = self.document.gaps
        self.errors: list[MocapmendError] = []
        self.recorder = Recorder(folder, source, self.errors.append)
        if journal is not None:
            self.recorder.resume(*resume(journal, self.document))
        stack = self.document.undo_stack
        stack.indexChanged.connect(self.recorder.move)
        stack.cleanChanged.connect(self.recorder.export)

    def push(self, edits: list[Edit], text: str) -> None:
        command = EditSamples(self.document, edits, text)
        self.recorder.push(text, edits)
        self.document.undo_stack.push(command)

    def do(self, step: int | str, number: int = 0) -> None:
        stack = self.document.undo_stack
        if step == "undo":
            stack.undo()
        elif step == "redo":
            stack.redo()
        elif step == "export":
            stack.setClean()
        elif step == "all":
            self.push([self.fill(place, number) for place in range(6)], f"fill all {number}")
        elif step == "leave":
            self.push([Edit.clear(self.gaps[number % 6], reason=f"für {number}")], "leave")
        elif step == "take up":
            self.push([Edit.clear(gap) for gap in self.gaps], "take up")
        elif step == "never":
            reason = f"for {number}" if number % 2 else None
            self.push([Edit.clear(self.gaps[number % 6], SampleState.NEVER, reason)], "never")
        elif self.gaps[int(step)] in self.document.repairs:
            self.push([Edit.clear(self.gaps[int(step)])], f"clear {number}")
        else:
            self.push([self.fill(int(step), number)], f"fill {number}")

    def fill(self, place: int, number: int) -> Edit:
        gap = self.gaps[place]
        values = np.full((gap.length, 3), 0.1 * number + place)
        patch = Patch(gap, values, np.full(gap.length, np.nan), np.full(gap.length, number / 3))
        if number % 2:
            return Edit.fill(patch, "constant", ConstantParams("after"))
        return Edit.fill(patch, "linear", LinearParams())

    def crash(self) -> None:
        """Let go of the journal, as the system does when a program ends."""
        self.recorder.close()

    @property
    def journal(self) -> Path:
        (path,) = self.folder.iterdir()
        return path


def open_document(source: Source) -> Document:
    return Document(source, Skeleton("", (), "none"))


def ends_in(journal: Path) -> list[int]:
    """Return where the records of a journal end, also while it is in use."""
    with journal.open("rb") as stream:
        return [end for _, end in JournalFile(journal, stream).records()]


def state_of(document: Document) -> tuple[Any, ...]:
    """Return all that a user can find out about a document."""
    stack = document.undo_stack
    repairs = {
        gap: (r.method, r.params, r.patch.values.tobytes(), r.patch.r90.tobytes())
        for gap, r in document.repairs.items()
    }
    texts = tuple(stack.text(index) for index in range(stack.count()))
    return (
        document.points.tobytes(),
        document.state.tobytes(),
        document.gaps,
        document.set_aside,
        {gap: document.never_reason(gap) for gap in document.never},
        repairs,
        texts,
        stack.index(),
        stack.cleanIndex(),
    )


def history_of(document: Document) -> list[tuple[Any, ...]]:
    """Return the states at every position of the undo history; the document ends where it was."""
    stack, index = document.undo_stack, document.undo_stack.index()
    states = []
    for position in range(stack.count() + 1):
        stack.setIndex(position)
        states.append(state_of(document))
    stack.setIndex(index)
    return states


@fixture_once
@given(steps=steps_of_a_user)
@example(steps=[0, 1, "export", "undo", 2])
@example(steps=[0, 1, "export", "undo"])
@example(steps=["leave", "never", "leave", "take up", "undo", 0, "undo"])
@example(steps=["leave", "export", "undo"])
def test_a_crash_loses_nothing(source: Source, steps: Steps) -> None:
    with TemporaryDirectory() as folder:
        session = Session(Path(folder), source)
        for number, step in enumerate(steps):
            session.do(step, number)
        session.crash()
        document = session.document
        found = find_abandoned(session.folder, no_progress)
        if document.undo_stack.isClean():
            assert found == []
            assert list(session.folder.iterdir()) == [], "nothing is unsaved: no need of a journal"
            return
        assert [each.edits for each in found] == [document.undo_stack.index()]
        recovered = open_document(source)
        file, history = resume(found[0].journal, recovered)
        file.close()
        assert not history.damaged
        assert state_of(recovered) == state_of(document)
        document.undo_stack.blockSignals(True)
        assert history_of(recovered) == history_of(document)


@fixture_once
@given(first=steps_of_a_user, second=steps_of_a_user)
def test_a_second_crash_after_a_recovery_loses_nothing(
    source: Source, first: Steps, second: Steps
) -> None:
    with TemporaryDirectory() as folder:
        before = Session(Path(folder), source)
        before.do(0)
        for number, step in enumerate(first):
            before.do(step, number)
        before.crash()
        session = Session(before.folder, source, before.journal)
        for number, step in enumerate(second):
            session.do(step, number + 100)
        session.crash()
        recovered = open_document(source)
        file, _ = resume(before.journal, recovered)
        file.close()
        assert state_of(recovered) == state_of(session.document)


def test_a_journal_cut_at_any_byte_gives_the_last_complete_event(
    tmp_path: Path, source: Source
) -> None:
    session = Session(tmp_path / "journal", source)
    states = [state_of(session.document)]
    for number, step in enumerate([0, "export", 0, "undo", "undo", "redo", 1]):
        session.do(step, number)
        # Coming back to what was exported is two records, of which the second changes nothing.
        states += [state_of(session.document)] * (len(ends_in(session.journal)) - len(states))
    session.crash()
    whole, ends = session.journal.read_bytes(), ends_in(session.journal)
    for size in range(ends[0], len(whole) + 1):
        session.journal.write_bytes(whole[:size])
        recovered = open_document(source)
        file, _ = resume(session.journal, recovered)
        file.close()
        assert state_of(recovered) == states[sum(end <= size for end in ends) - 1]
    for size in range(ends[0]):
        session.journal.write_bytes(whole[:size])
        with pytest.raises(MocapmendError):
            resume(session.journal, open_document(source))


def test_without_edits_there_is_no_journal(tmp_path: Path, source: Source) -> None:
    session = Session(tmp_path / "journal", source)
    session.do("export")
    session.do("undo")
    assert not session.folder.exists()
    session.recorder.discard()


def test_a_discarded_journal_is_gone_and_does_not_come_back(tmp_path: Path, source: Source) -> None:
    session = Session(tmp_path / "journal", source)
    session.do(0)
    session.recorder.discard()
    session.do(1)
    assert list(session.folder.iterdir()) == []


def test_a_journal_in_use_is_neither_offered_nor_taken_nor_discarded(
    tmp_path: Path, source: Source
) -> None:
    session = Session(tmp_path / "journal", source)
    session.do(0)
    assert find_abandoned(session.folder, no_progress) == []
    discard(session.journal)
    with pytest.raises(MocapmendError, match="Another window"):
        resume(session.journal, open_document(source))
    session.crash()
    assert len(find_abandoned(session.folder, no_progress)) == 1
    discard(session.journal)
    assert list(session.folder.iterdir()) == []


def test_repairs_that_the_file_had_are_reverted_again(tmp_path: Path, gait: Path) -> None:
    source = read_recording(gait)
    gaps = [gap for gap in find_gaps(source.measured.present) if gap.length < 20][:3]
    way = ("linear", LinearParams())
    result = engine.fill(source.measured, gaps, *way, Limits(99, np.inf), no_progress)
    changes = engine.changes_of(source, result, *way)
    repaired = tmp_path / "repaired.c3d"
    engine.export(source, changes, repaired, False, False, no_progress)
    source = read_recording(repaired)
    session = Session(tmp_path / "journal", source)
    assert session.document.repairs
    session.push([Edit.clear(gap) for gap in list(session.document.repairs)[:2]], "revert")
    session.do(0)
    session.crash()
    recovered = open_document(source)
    file, _ = resume(session.journal, recovered)
    file.close()
    assert state_of(recovered) == state_of(session.document)
    recovered.undo_stack.setIndex(0)
    assert state_of(recovered)[:6] == state_of(open_document(source))[:6]


def test_the_newest_edits_are_offered_first(tmp_path: Path, source: Source) -> None:
    for seconds in (200, 300, 100):
        session = Session(tmp_path / str(seconds), source)
        session.do(0)
        session.crash()
        os.utime(session.journal, (seconds, seconds))
        session.journal.rename(tmp_path / f"{seconds}.journal")
    found = find_abandoned(tmp_path, no_progress)
    assert [each.time for each in found] == [300.0, 200.0, 100.0]


def touched(source: Source) -> Source:
    return replace(source, stamp=Stamp(source.stamp.size, source.stamp.mtime_ns + 1))


def moved(source: Source) -> Source:
    return replace(source, path=source.path.with_name("moved.c3d"))


@pytest.mark.parametrize("alike", [touched, moved])
def test_a_file_that_was_only_touched_or_moved_gets_its_edits_back(
    tmp_path: Path, source: Source, alike: Callable[[Source], Source]
) -> None:
    session = Session(tmp_path / "journal", source)
    session.do("all")
    session.crash()
    (found,) = find_abandoned(session.folder, no_progress)
    assert found.belongs_to(alike(source))
    again = Session(session.folder, alike(source), found.journal)
    assert state_of(again.document) == state_of(session.document)
    again.crash()
    (found,) = find_abandoned(session.folder, no_progress)
    assert found.subject.path == alike(source).path
    assert found.subject.stamp == alike(source).stamp


def test_another_recording_is_none_of_the_journal(tmp_path: Path, source: Source) -> None:
    session = Session(tmp_path / "journal", source)
    session.do("all")
    session.crash()
    (found,) = find_abandoned(session.folder, no_progress)
    assert not found.belongs_to(moved(touched(source)))


def longer(source: Source) -> Source:
    return replace(source, stamp=Stamp(source.stamp.size + 1, source.stamp.mtime_ns))


def other_samples(source: Source) -> Source:
    recording = source.recording.with_points(source.recording.points + 1.0)
    return replace(touched(source), recording=recording)


@pytest.mark.parametrize("change", [longer, other_samples])
def test_a_file_that_was_changed_does_not_get_the_edits(
    tmp_path: Path, source: Source, change: Callable[[Source], Source]
) -> None:
    session = Session(tmp_path / "journal", source)
    session.do("all")
    session.crash()
    before = session.journal.read_bytes()
    document = open_document(change(source))
    with pytest.raises(MocapmendError, match="changed since") as raised:
        resume(session.journal, document)
    assert raised.value.where == str(source.path)
    assert session.journal.read_bytes() == before
    assert document.undo_stack.count() == 0
    assert len(find_abandoned(session.folder, no_progress)) == 1, "nobody holds it any more"


def test_edits_that_do_not_fit_are_refused_as_a_whole(tmp_path: Path, source: Source) -> None:
    session = Session(tmp_path / "journal", source)
    session.do(0)
    session.do(5)
    session.crash()
    before = session.journal.read_bytes()
    smaller = source.recording
    smaller = replace(smaller, points=smaller.points[:, :2].copy(), labels=smaller.labels[:2])
    document = open_document(replace(source, recording=smaller))
    with pytest.raises(MocapmendError, match="damaged, or of another version"):
        resume(session.journal, document)
    assert document.undo_stack.count() == 0
    assert session.journal.read_bytes() == before


def test_edits_of_a_journal_from_before_reasons_were_noted(tmp_path: Path, source: Source) -> None:
    gap = find_gaps(source.recording.present)[1]
    never = {"step": "never fill 1 gaps", "ways": [], "gaps": 1, "samples": 1, "filled": 0}
    data = (
        np.array([gap.marker, gap.start, gap.stop], "<i8"),
        np.array([-1], "<i4"),
        np.array([SampleState.NEVER], "u1"),
        np.full(3, np.nan, "<f8"),
    )
    file = JournalFile.create(tmp_path)
    file.append(Subject.of(source).event())
    file.append(never, b"".join(part.tobytes() for part in data))
    file.close()
    session = Session(tmp_path, source, file.path)
    document = session.document
    assert document.unsaved().never == {gap: NEVER_FILLED}
    assert document.undo_stack.text(0) == "never fill 1 gaps"
    session.do("leave", 3)
    session.crash()
    recovered = open_document(source)
    again, _ = resume(file.path, recovered)
    again.close()
    assert state_of(recovered) == state_of(document)
    recovered.undo_stack.setIndex(0)
    assert (recovered.never, recovered.set_aside) == ([], {})


HEADER = {
    "journal": 1,
    "program": "9",
    "recording": "/a.c3d",
    "size": 1,
    "mtime_ns": 2,
    "checksum": 3,
}


@pytest.mark.parametrize(
    "events",
    [
        [{**HEADER, "journal": 2}],
        [{**HEADER, "size": "1"}],
        [{**HEADER, "recording": 5}],
        [{"journal": 1}],
        [HEADER, {"index": 1}],
        [HEADER, {"index": -1}],
        [HEADER, {"index": True}],
        [HEADER, {"clean": "0"}],
        [HEADER, {"unknown": 0}],
        [HEADER, {"journal": 3}],
    ],
)
def test_a_journal_of_another_version_is_left_alone(
    tmp_path: Path, source: Source, events: list[dict[str, Any]]
) -> None:
    file = JournalFile.create(tmp_path)
    for event in events:
        file.append(event)
    file.close()
    before = file.path.read_bytes()
    assert find_abandoned(tmp_path, no_progress) == []
    with pytest.raises(MocapmendError, match="damaged, or of another version"):
        resume(file.path, open_document(source))
    assert file.path.read_bytes() == before


def test_damage_in_the_middle_keeps_what_is_before_it(tmp_path: Path, source: Source) -> None:
    session = Session(tmp_path / "journal", source)
    session.do(0)
    first, size = state_of(session.document), session.journal.stat().st_size
    session.do(1)
    session.do(2)
    session.crash()
    raw = bytearray(session.journal.read_bytes())
    raw[size + 40] ^= 0x20
    session.journal.write_bytes(raw)
    file, history = resume(session.journal, open_document(source))
    file.close()
    assert history.damaged
    again = Session(session.folder, source, session.journal)
    assert state_of(again.document) == first
    again.do(3)
    again.crash()
    recovered = open_document(source)
    file, history = resume(session.journal, recovered)
    file.close()
    assert not history.damaged
    assert state_of(recovered) == state_of(again.document)


def test_a_killed_first_edit_leaves_nothing_to_offer(tmp_path: Path) -> None:
    for name, content in (("empty", b""), ("half", b'0123abcd {"journal"')):
        (tmp_path / f"{name}.journal").write_bytes(content)
    (tmp_path / "other.txt").write_bytes(b"")
    assert find_abandoned(tmp_path, no_progress) == []
    assert [path.name for path in tmp_path.iterdir()] == ["other.txt"]


def test_a_disk_error_is_told_once_and_does_not_stop_the_edits(
    tmp_path: Path, source: Source
) -> None:
    (tmp_path / "journal").write_text("a file where the folder should be")
    session = Session(tmp_path / "journal", source)
    for step in (0, 1, "undo", "export", 2):
        session.do(step)
    assert session.document.undo_stack.count() == 2
    (error,) = session.errors
    assert "not protected" in error.what


def test_a_large_step_is_on_the_disk_before_the_next_is_noted(
    tmp_path: Path, source: Source, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("mocapmend.journal.recorder.AT_ONCE", 0)
    session = Session(tmp_path / "journal", source)
    session.do(0)
    session.do(1)
    # The recording, the first step, and perhaps the second.
    assert len(ends_in(session.journal)) >= 2
    session.recorder.wait()
    assert session.recorder.poll()
    assert len(ends_in(session.journal)) == 3
    with monkeypatch.context() as full:
        full.setattr("mocapmend.journal.file.LARGEST", 0)
        session.do(2)
        session.recorder.wait()
    assert len(session.errors) == 1
    session.crash()


def test_after_a_full_disk_the_edits_before_can_be_recovered(
    tmp_path: Path, source: Source, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = Session(tmp_path / "journal", source)
    session.do(0)
    protected = state_of(session.document)
    with monkeypatch.context() as full:
        full.setattr("mocapmend.journal.file.LARGEST", 0)
        session.do(1)
    session.do(2)
    assert len(session.errors) == 1
    session.crash()
    recovered = open_document(source)
    file, _ = resume(session.journal, recovered)
    file.close()
    assert state_of(recovered) == protected
