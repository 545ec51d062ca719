"""The bones of sparse recovery: W18's joints, and trees over other markers."""

import numpy as np
import pytest
from joint_samples import NAMES, hidden, walker
from synthetic import bending_body, record

from mocapmend_algorithms import Recording
from mocapmend_algorithms.sparse.body import find_body

W18_PARENTS = [0, 1, 2, 3, 4, 5, 1, 7, 8, 9, 10, 1, 12, 13, 14, 15, 16]
W18_PARENTS += [14, 18, 19, 20, 21, 22, 21, 14, 25, 26, 27, 28, 29, 28]
"""Of the joints 1 to 31 in the paper's numbering; 0: none."""
W18_NAMES = ["root", "lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes"]
W18_NAMES += ["rhipjoint", "rfemur", "rtibia", "rfoot", "rtoes"]
W18_NAMES += ["lowerback", "upperback", "thorax", "lowerneck", "upperneck", "head"]
W18_NAMES += ["lclavicle", "lhumerus", "lradius", "lwrist", "lhand", "lfingers", "lthumb"]
W18_NAMES += ["rclavicle", "rhumerus", "rradius", "rwrist", "rhand", "rfingers", "rthumb"]


def body_of(recording):
    return find_body(recording, recording.present)


def test_the_joints_hang_together_as_the_paper_numbers_them():
    recording = walker(60)
    body = body_of(recording)
    for child, parent in zip(range(1, 32), W18_PARENTS, strict=True):
        at = NAMES.index(W18_NAMES[child - 1])
        expected = -1 if parent == 0 else NAMES.index(W18_NAMES[parent - 1])
        assert body.parents[at] == expected
    assert body.exact
    assert [len(part) for part in body.parts] == [7, 7, 7, 5, 5]
    assert sorted(np.concatenate(body.parts)) == list(range(31))


def test_each_triple_is_the_part_the_trunk_and_one_more():
    body = body_of(walker(60))
    for part, triple in enumerate(body.triples):
        assert part in triple
        assert 0 in triple
        assert len(set(triple)) == 3


def test_labels_may_have_a_subject_and_any_case():
    recording = walker(60)
    labels = tuple(f"Ann:{label.title()}" for label in recording.labels)
    named = Recording(recording.points, labels, recording.rate, recording.unit, recording.up)
    np.testing.assert_array_equal(body_of(named).parents, body_of(recording).parents)


def test_lengths_are_measured_in_mm_where_both_ends_are_seen():
    recording = walker(60)
    body = body_of(hidden(recording, [5, 6], 10, 40))
    ends = recording.points[0][body.bones]
    expected = 10 * np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    np.testing.assert_allclose(body.lengths, expected, rtol=1e-9)
    np.testing.assert_allclose(body.edge_lengths, expected, rtol=1e-9)


def test_a_skeleton_is_found_without_names():
    recording = walker(200)
    labels = tuple(f"p{marker}" for marker in range(31))
    body = body_of(Recording(recording.points, labels, 100.0, "cm", "+y"))
    assert body.exact
    named = {frozenset(edge) for edge in body_of(recording).edges.tolist()}
    found = {frozenset(edge) for edge in body.edges.tolist()}
    assert len(named - found) <= 2
    assert len(found) == 30


def test_markers_on_skin_are_one_tree_with_parts_and_no_exact_bones():
    recording = record(bending_body(200, 12))
    body = body_of(recording)
    assert not body.exact
    assert len(body.edges) == 11
    assert (body.depths >= 0).all()
    assert set(np.concatenate(body.parts).tolist()) == set(range(12))
    for part, triple in enumerate(body.triples):
        assert triple[0] == part


def test_markers_never_seen_together_are_trees_of_their_own():
    points = bending_body(200, 8)
    points[:100, :4] = np.nan
    points[100:, 4:] = np.nan
    body = body_of(record(points))
    assert np.count_nonzero(body.parents < 0) == 2


@pytest.mark.parametrize("markers", [1, 1200])
def test_one_marker_or_a_crowd_has_no_bones(markers):
    body = body_of(record(np.random.default_rng(0).normal(size=(12, markers, 3))))
    assert (body.parents == -1).all()
    assert not body.bones.size
    np.testing.assert_array_equal(body.helpers_of(0), np.arange(markers))
