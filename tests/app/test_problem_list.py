"""The list of problems in arrays: what passes, in which order, and what becomes of a gap."""

from pathlib import Path

import numpy as np
import pytest

from mocapmend.commands import EditSamples
from mocapmend.document import Document
from mocapmend.edits import Edit
from mocapmend.files import Source, Stamp
from mocapmend.problem_list import ProblemList
from mocapmend.prospects import Prospects, Way
from mocapmend.ranking import Status
from mocapmend.state import SampleState
from mocapmend.suspects import Suspects
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.skeleton import Skeleton

SHORT, LONG, LATE, WHOLE = Gap(0, 2, 4), Gap(1, 1, 7), Gap(0, 8, 9), Gap(2, 0, 12)
WAY = Way.default("cubic")
ALL = frozenset(Status)


def patch(gap: Gap, error: float) -> Patch:
    return Patch.stated(gap, np.zeros((gap.length, 3)), error, error)


@pytest.fixture
def document() -> Document:
    """Return a recording with three gaps, and a marker that is never seen."""
    points = np.ones((12, 3, 3))
    for gap in (SHORT, LONG, LATE, WHOLE):
        points[gap.start : gap.stop, gap.marker] = np.nan
    recording = Recording(points, ("A", "B", "C"), 100.0)
    source = Source(path=Path("a.c3d"), kind="C3D", recording=recording, stamp=Stamp(1, 1))
    return Document(source, Skeleton("", (), "none"))


def edit(document: Document, *edits: Edit) -> None:
    document.undo_stack.push(EditSamples(document, edits, "edit"))


def listed(problems: ProblemList, *, falling: bool) -> list[Gap]:
    places = problems.passing({0, 1, 2}, ALL, 0.0, 100.0)
    harm = problems.error * problems.length
    return [problems.gaps[place] for place in problems.ordered(places, harm, falling=falling)]


def test_the_unknown_comes_last_in_the_order_of_time(document: Document) -> None:
    prospects = Prospects()
    problems = ProblemList(document, prospects, Suspects(document))
    assert listed(problems, falling=True) == [LONG, SHORT, LATE]
    assert not problems.tried.any()
    prospects.add(WAY, [SHORT, LATE], FillResult((patch(SHORT, 1.0), patch(LATE, 5.0))))
    problems.learn()
    assert listed(problems, falling=True) == [LATE, SHORT, LONG]
    assert listed(problems, falling=False) == [SHORT, LATE, LONG]
    place = problems.place_of(LATE)
    assert place is not None
    assert problems.problem(place).error == pytest.approx(5.0)


def test_edits_and_decisions_are_seen_when_it_is_taken_anew(document: Document) -> None:
    problems = ProblemList(document, Prospects(), Suspects(document))
    edit(document, Edit.fill(patch(SHORT, 2.0), *WAY), Edit.clear(LATE, SampleState.NEVER))
    document.leave_open({LONG: "by hand"})
    before = problems.place_of(SHORT)
    assert before is not None
    assert problems.problem(before).status is Status.OPEN
    problems.take()
    found = {gap: problems.problem(place).status for place, gap in enumerate(problems.gaps)}
    assert found == {SHORT: Status.REPAIRED, LATE: Status.NEVER, LONG: Status.BEYOND}
    made = problems.problem(problems.gaps.index(SHORT))
    assert (made.error, made.tried) == (pytest.approx(2.0), True)
    edit(document, Edit.clear(SHORT))
    # As it was when the list was taken, until it is taken anew.
    assert problems.problem(problems.gaps.index(SHORT)).best is not None


def test_only_what_is_asked_for_passes(document: Document) -> None:
    problems = ProblemList(document, Prospects(), Suspects(document))

    def passing(markers: set[int], status: frozenset[Status], low: float, high: float) -> set[Gap]:
        return {problems.gaps[place] for place in problems.passing(markers, status, low, high)}

    assert passing({0}, ALL, 0.0, 100.0) == {SHORT, LATE}
    assert passing({0, 1}, ALL, 1.0, 2.0) == {SHORT}
    assert passing({0, 1}, frozenset({Status.LEFT}), 0.0, 100.0) == set()


def test_what_can_be_filled_is_what_is_open_of_markers_that_are_seen(document: Document) -> None:
    def corners() -> list[Gap]:
        return [Gap(*corner) for corner in document.fillable_corners.tolist()]

    assert document.fillable == corners() == [SHORT, LATE, LONG]
    edit(document, Edit.fill(patch(SHORT, 2.0), *WAY), Edit.clear(LONG, SampleState.NEVER))
    assert document.fillable == corners() == [LATE]
    assert document.gaps == [LATE, WHOLE]
    document.undo_stack.undo()
    assert document.fillable == corners() == [SHORT, LATE, LONG]
