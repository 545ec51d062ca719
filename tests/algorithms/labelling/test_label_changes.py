"""Names and exchanges that make each label one point; pieces; which names mean something."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mocapmend_algorithms import Recording
from mocapmend_algorithms.corrections import exchange, stored_places
from mocapmend_algorithms.labelling import Labelled, Labelling, Piece, changes, labelled_recording
from mocapmend_algorithms.labelling.pieces import cut_pieces
from mocapmend_algorithms.names import is_meaningful, named_points

LABELS = ("A", "B", "C")


def labelling(*proposals, labels=LABELS):
    return Labelling(
        labels,
        tuple(Labelled(Piece(*p[:3]), p[3], p[4] if len(p) > 4 else 1.0, "So.") for p in proposals),
        1.0,
    )


def recording(present, labels=None):
    """Return a recording whose samples all differ, present where told."""
    present = np.array(present, bool)
    points = np.arange(present.size * 3, dtype=float).reshape(*present.shape, 3)
    points[~present] = np.nan
    names = labels or tuple(f"*{k}" for k in range(present.shape[1]))
    return Recording(points, names, 100.0)


@st.composite
def cases(draw):
    """Draw points with pieces of labels and of nothing, no label twice at a frame."""
    frames, points = draw(st.integers(1, 12)), draw(st.integers(1, 6))
    content = np.full((frames, points), -2)
    for frame in range(frames):
        for point in range(points):
            taken = set(content[frame].tolist()) - {-1, -2}
            before = content[frame - 1, point] if frame else -2
            choice = draw(st.sampled_from([-2, -1, 0, 1, 2, before, before]))
            content[frame, point] = choice if choice not in taken else -1
    return content


@given(cases())
def test_each_label_becomes_one_point_and_no_sample_is_lost(content):
    stored = recording(content != -2)
    proposals = []
    for point in range(content.shape[1]):
        for frame in range(content.shape[0]):
            if content[frame, point] != -2:
                label = content[frame, point]
                proposals.append((point, frame, frame + 1, None if label < 0 else int(label)))
    found = labelling(*proposals)
    made = changes(found, stored)
    result = labelled_recording(stored, made)
    origins = stored_places(content.shape)
    exchange(origins, made.exchanges)
    now = np.take_along_axis(content, origins.astype(int), axis=1)
    for label, name in enumerate(LABELS):
        there = (content == label).any(axis=1)
        if there.any() and name in result.labels:
            (home,) = [k for k, given in enumerate(result.labels) if given == name]
            assert np.array_equal(now[:, home] == label, there)
            # What is not the label's own is exchanged away, or missing in the result.
            assert np.array_equal(result.present[:, home], there)
        elif there.any():
            assert set(result.labels) < set(LABELS)
        else:
            assert name not in result.labels
    left = sum(run.length for run in made.left_over)
    assert result.present.sum() == stored.present.sum() - left


def test_a_trusted_point_is_its_label_s_however_little_it_holds():
    stored = recording([[1, 0]] * 2 + [[0, 1]] * 8, ("A", "*0"))
    proposals = (
        Labelled(Piece(0, 0, 2), 0, 1.0, "So.", kept=True),
        Labelled(Piece(1, 2, 10), 0, 0.9, "So."),
    )
    made = changes(Labelling(LABELS, proposals, 1.0), stored)
    assert made.names == {}
    assert made.exchanges == ((1, 0, 2, 10),)
    assert labelled_recording(stored, made).present.sum(axis=0).tolist() == [10, 0]


def test_what_is_not_sure_enough_stays():
    stored = recording([[1, 0], [0, 1]])
    found = labelling((0, 0, 1, 0, 0.9), (1, 1, 2, 0, 0.4))
    assert changes(found, stored, least_confidence=0.5).exchanges == ()
    assert len(changes(found, stored).exchanges) == 1


def test_a_ghost_with_no_room_is_left_over():
    stored = recording([[1, 1], [1, 1]])
    found = labelling((0, 0, 1, 0), (0, 1, 2, None), (1, 0, 2, 1))
    made = changes(found, stored)
    assert made.left_over == ((0, 1, 2),)
    assert labelled_recording(stored, made).present.tolist() == [[True, True], [False, True]]


def test_names_keep_the_subject_and_are_not_given_twice():
    stored = recording(np.ones((4, 3)), ("Ann:A", "Ann:*0", "Ann:B"))
    made = changes(labelling((0, 0, 4, None), (1, 0, 4, 0), (2, 0, 4, 1)), stored)
    assert made.names == {0: "*0", 1: "Ann:A"}
    assert labelled_recording(stored, made).labels == ("*0", "Ann:A", "Ann:B")


@pytest.mark.parametrize(
    ("label", "meant"),
    [("LASI", True), ("C7", True), ("T10", True), ("Matt:RKNE", True), ("Head_Top", True),
     ("u", False), ("", False), (" ", False), ("*12", False), ("Matt:*3", False), ("U7", False),
     ("point 3", False), ("Unlabeled-1024", False), ("Marker_001", False), ("17", False),
     ("Unknown", False), ("New 12", False), ("Uln1", True), ("Newton", True)],
)  # fmt: skip
def test_which_labels_mean_something(label, meant):
    assert is_meaningful(label) is meant


def test_labels_that_two_points_have_name_neither():
    assert named_points(["A", "B", "A", "*0", "x:C"]) == {"B": 1, "C": 4}


def test_points_are_cut_at_gaps_swaps_and_single_wrong_samples():
    t = np.arange(200) / 100.0
    path = np.stack([300 * np.sin(5 * t), 200 * np.cos(4 * t), 900 + 50 * t], axis=1)
    points = path[:, None] + np.array([(0, 0, 0), (0, 400, 0), (150, 0, 30)])
    points[60:70, 0] = np.nan
    points[120:, [1, 2]] = points[120:, [2, 1]]
    points[30, 2] += (0, 0, 185)
    points += np.random.default_rng(0).normal(0, 0.5, points.shape)
    assert cut_pieces(points, 100.0) == [
        (0, 0, 60), (0, 70, 200),
        (1, 0, 120), (1, 120, 200),
        (2, 0, 30), (2, 30, 31), (2, 31, 120), (2, 120, 200),
    ]  # fmt: skip


def test_fast_motion_is_not_cut():
    t = np.arange(300) / 100.0
    path = np.stack([1500 * np.sin(9 * t), 400 * np.cos(14 * t), 100 * t], axis=1)
    assert cut_pieces(path[:, None], 100.0) == [(0, 0, 300)]
    assert cut_pieces(np.full((5, 1, 3), np.nan), 100.0) == []
    assert cut_pieces(np.zeros((1, 1, 3)), 100.0) == [(0, 0, 1)]
