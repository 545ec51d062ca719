"""What is known of bad samples while a recording is corrected, without a window."""

from pathlib import Path

import numpy as np
import pytest

from mocapmend.commands import EditSamples
from mocapmend.correcting import step, towards
from mocapmend.document import Document
from mocapmend.doubts import BY_HAND, Doubt
from mocapmend.files import Source, Stamp
from mocapmend.fixing import remedies
from mocapmend.layers import Layers
from mocapmend.problem_list import ProblemList
from mocapmend.prospects import Prospects
from mocapmend.ranking import Status
from mocapmend.suspects import Suspects, place_of
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.skeleton import Skeleton

SPIKE = BadRun("spikes", 0, 10, 12, 0.9, 40.0, "It leaps.")
SWAP = BadRun("swaps", 1, 20, 25, 0.8, 100.0, "They swap.", other=2)
FAR = BadRun("far", 3, 30, 31, 0.7, float("nan"), "It is far away.")
HOLE = Gap(3, 5, 9)
ALL = frozenset(Status)


@pytest.fixture
def document() -> Document:
    """Return a recording of four markers with one gap."""
    points = np.arange(40 * 4 * 3, dtype=float).reshape(40, 4, 3)
    points[HOLE.start : HOLE.stop, HOLE.marker] = np.nan
    recording = Recording(points, ("A", "B", "C", "D"), 100.0)
    source = Source(path=Path("a.c3d"), kind="C3D", recording=recording, stamp=Stamp(1, 1))
    return Document(source, Skeleton("", (), "none"))


@pytest.fixture
def suspects(document: Document) -> Suspects:
    made = Suspects(document)
    document.samples_changed.connect(made.keep_up)
    made.take(0, [SPIKE, SWAP, FAR])
    return made


def correct(document: Document, **what: object) -> None:
    made = step(document, **what)  # type: ignore[arg-type]
    document.undo_stack.push(EditSamples(document, made.edits, "correct", made.correction))


def fix(document: Document, run: BadRun) -> None:
    exchanges, aside = remedies([run])
    correct(document, exchanges=exchanges, set_aside=aside)


def test_a_correction_takes_out_what_it_touches_until_it_is_looked_again(
    document: Document, suspects: Suspects
) -> None:
    fix(document, SPIKE)
    assert not suspects.known
    assert suspects.found == [SWAP, FAR]
    assert suspects.fixed() == [SPIKE]
    suspects.take(document.base_revision, [SWAP])
    assert suspects.known
    assert suspects.found == [SWAP]
    fix(document, SWAP)
    assert suspects.found == []
    assert suspects.fixed() == [SPIKE, SWAP]
    document.undo_stack.undo()
    assert suspects.known
    assert suspects.found == [SWAP]
    document.undo_stack.undo()
    assert suspects.found == [SPIKE, SWAP, FAR]


def test_what_touches_the_second_marker_of_a_swap_takes_it_out_too(
    document: Document, suspects: Suspects
) -> None:
    correct(document, set_aside={Gap(2, 21, 22): Doubt(BY_HAND, "")})
    assert suspects.found == [SPIKE, FAR]


def test_corrections_without_a_search_are_listed_as_well(document: Document) -> None:
    suspects = Suspects(document)
    correct(
        document, exchanges=[Exchange(0, 2, 3, 6)], set_aside={Gap(1, 4, 5): Doubt(BY_HAND, "So.")}
    )
    (aside, swap) = suspects.fixed()
    assert (aside.kind, place_of(aside), aside.reason) == (BY_HAND, Gap(1, 4, 5), "So.")
    assert swap.kind == "swaps"
    assert {swap.marker, swap.other} == {0, 2}
    assert (swap.start, swap.stop) == (3, 6)


def test_three_markers_in_a_circle_are_all_listed(document: Document) -> None:
    suspects = Suspects(document)
    correct(document, exchanges=[Exchange(0, 1, 3, 6), Exchange(1, 2, 3, 6)])
    assert {run.marker for run in suspects.fixed()} == {0, 1, 2}


def test_what_is_dismissed_stays_so_though_its_ends_move(
    document: Document, suspects: Suspects
) -> None:
    suspects.dismiss(SPIKE)
    assert suspects.found == [SWAP, FAR]
    assert suspects.dismissed == [SPIKE]
    fix(document, FAR)
    longer = BadRun("spikes", 0, 10, 13, 0.9, 40.0, "It leaps.")
    other = BadRun("frozen", 0, 10, 13, 0.9, 40.0, "It does not move.")
    suspects.take(document.base_revision, [longer, other])
    assert suspects.dismissed == [longer]
    assert suspects.found == [other]
    suspects.take_up(longer)
    assert suspects.found == [longer, other]


def test_the_list_has_them_beside_the_gaps(document: Document, suspects: Suspects) -> None:
    suspects.dismiss(FAR)
    problems = ProblemList(document, Prospects(), suspects)

    def passing(
        status: frozenset[Status] = ALL, markers: tuple[int, ...] = (0, 1, 2, 3), **rest: object
    ) -> set[Gap]:
        found = problems.passing(markers, status, 0.0, 100.0, **rest)  # type: ignore[arg-type]
        return {problems.gaps[place] for place in found}

    assert passing() == {HOLE, place_of(SPIKE), place_of(SWAP), place_of(FAR)}
    assert passing(frozenset({Status.DISMISSED})) == {place_of(FAR)}
    assert passing(kinds=("gap",)) == {HOLE}
    assert passing(kinds=("swaps", "spikes")) == {place_of(SPIKE), place_of(SWAP)}
    assert passing(markers=(2,)) == {place_of(SWAP)}, "by its second marker"
    harm = problems.error * problems.length
    ordered = problems.ordered(np.arange(len(problems.gaps)), harm, falling=True)
    assert [problems.gaps[place] for place in ordered[:2]] == [place_of(SWAP), place_of(SPIKE)]
    place = problems.place_of_bad(SPIKE)
    assert place is not None
    listed = problems.problem(place)
    assert (listed.bad, listed.status, listed.reason) == (SPIKE, Status.FOUND, "It leaps.")
    assert listed.harm == 80.0
    assert problems.place_of(place_of(SPIKE)) is None, "no gap"
    hole = problems.place_of(HOLE)
    assert hole is not None
    assert problems.problem(hole).bad is None


def test_what_is_set_aside_and_the_gap_that_it_makes_are_two_entries(
    document: Document, suspects: Suspects
) -> None:
    fix(document, SPIKE)
    problems = ProblemList(document, Prospects(), suspects)
    gap, bad = problems.place_of(place_of(SPIKE)), problems.place_of_bad(SPIKE)
    assert gap is not None
    assert bad is not None
    assert problems.problem(gap).status is Status.OPEN
    assert problems.problem(bad).status is Status.FIXED


def test_a_step_towards_other_layers_makes_exactly_these(document: Document) -> None:
    wanted = Layers.of(document.source).corrected(
        [Exchange(0, 1, 3, 9), Exchange(1, 2, 5, 7)], {Gap(0, 4, 6): Doubt(BY_HAND, "So.")}
    )
    correct(
        document, exchanges=[Exchange(2, 3, 6, 12)], set_aside={Gap(2, 1, 8): Doubt(BY_HAND, "")}
    )
    before = document.points.tobytes()
    made = towards(document, wanted)
    document.undo_stack.push(EditSamples(document, made.edits, "towards", made.correction))
    assert document.layers.is_same(wanted)
    np.testing.assert_array_equal(document.base.points, wanted.recording.points)
    assert not towards(document, wanted).correction.runs
    document.undo_stack.undo()
    assert document.points.tobytes() == before
