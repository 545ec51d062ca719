"""What the user decides about proposed labels, without a window."""

import numpy as np
import pytest

from mocapmend.label_review import Decision, LabelReview
from mocapmend_algorithms import Recording
from mocapmend_algorithms.corrections import Exchange
from mocapmend_algorithms.labelling import Labelled, Labelling, Piece, labelled_recording

A, B, C = 0, 1, 2


@pytest.fixture
def recording() -> Recording:
    """Return four points of 10 frames; the third and fourth are one marker in two pieces."""
    points = np.arange(120, dtype=np.float64).reshape(10, 4, 3)
    points[6:, 2] = np.nan
    points[:6, 3] = np.nan
    return Recording(points, rate=100.0, labels=("A", "*1", "*2", "*3"), unit="mm")


@pytest.fixture
def review() -> LabelReview:
    proposals = (
        Labelled(Piece(0, 0, 10), A, 1.0, "", kept=True),
        Labelled(Piece(1, 0, 10), B, 0.9, ""),
        Labelled(Piece(2, 0, 6), C, 0.7, ""),
        Labelled(Piece(3, 6, 10), C, 0.3, ""),
    )
    return LabelReview(Labelling(("A", "B", "C"), proposals, 1.0), least=0.5)


def row_of(review: LabelReview, point: int) -> int:
    return next(row for row in range(len(review)) if review.proposal(row).piece.point == point)


def test_the_least_sure_comes_first_and_trusted_names_are_not_listed(review: LabelReview) -> None:
    assert [review.proposal(row).piece.point for row in range(len(review))] == [3, 2, 1]
    assert review.counts() == (2, 3)


def test_what_is_sure_enough_is_given(review: LabelReview, recording: Recording) -> None:
    made = review.changes(recording)
    assert made.names == {1: "B", 2: "C"}
    assert not made.exchanges
    review.least = 0.8
    assert review.counts() == (1, 3)
    assert review.changes(recording).names == {1: "B"}


def test_what_is_accepted_is_given_however_sure(review: LabelReview, recording: Recording) -> None:
    review.decide(row_of(review, 3), Decision.ACCEPTED)
    made = review.changes(recording)
    assert made.exchanges == (Exchange(3, 2, 6, 10),)
    whole = labelled_recording(recording, made)
    assert whole.labels == ("A", "B", "C", "*3")
    assert whole.present[:, 2].all()


def test_what_is_rejected_is_left_alone(review: LabelReview, recording: Recording) -> None:
    review.decide(row_of(review, 1), Decision.REJECTED)
    assert review.changes(recording).names == {2: "C"}
    assert review.names_at(0) == {2: "C"}


def test_names_are_those_of_the_frame(review: LabelReview) -> None:
    assert review.names_at(0) == {1: "B", 2: "C"}
    review.decide(row_of(review, 3), Decision.ACCEPTED)
    assert review.names_at(7) == {1: "B", 3: "C"}


def test_free_labels_come_first(review: LabelReview) -> None:
    free, taken = review.choices(row_of(review, 3))
    assert (free, taken) == ([C], [A, B])


def test_a_label_is_taken_away_from_another_piece(
    review: LabelReview, recording: Recording
) -> None:
    review.choose(row_of(review, 2), B)
    assert review.label(row_of(review, 1)) is None
    assert review.label(row_of(review, 2)) == "B"
    assert review.label(row_of(review, 3)) == "C", "it is there at other times"
    assert review.decision(row_of(review, 2)) is Decision.ACCEPTED
    made = labelled_recording(recording, review.changes(recording))
    assert made.labels[2] == "B"
    assert made.labels[1] != "B"


def test_a_trusted_name_can_be_taken_away(review: LabelReview, recording: Recording) -> None:
    review.choose(row_of(review, 1), A)
    made = labelled_recording(recording, review.changes(recording))
    at = made.labels.index("A")
    assert np.array_equal(made.points[:, at], recording.points[:, 1])


def test_a_piece_can_be_no_marker(review: LabelReview, recording: Recording) -> None:
    review.choose(row_of(review, 1), None)
    assert review.label(row_of(review, 1)) is None
    assert review.changes(recording).names == {2: "C"}


def test_points_with_names_of_their_own_take_nothing_in() -> None:
    """What an own point holds besides its label goes into no point that has another name."""
    points = np.arange(90, dtype=np.float64).reshape(10, 3, 3)
    points[4:, 1] = np.nan
    points[4:, 2] = np.nan
    recording = Recording(points, rate=100.0, labels=("*1", "Wand", "*2"), unit="mm")
    proposals = (
        Labelled(Piece(0, 0, 4), A, 0.9, ""),
        Labelled(Piece(0, 4, 10), None, 0.9, ""),
        Labelled(Piece(1, 0, 4), None, 1.0, "", kept=True),
        Labelled(Piece(2, 0, 4), None, 0.9, ""),
    )
    made = LabelReview(Labelling(("A",), proposals, 1.0), least=0.5).changes(recording)
    assert made.exchanges == (Exchange(0, 2, 4, 10),)
