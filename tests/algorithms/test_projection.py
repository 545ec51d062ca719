"""Bone projection: lengths are met, and nothing else moves."""

import numpy as np
import pytest
from joint_samples import walker

from mocapmend_algorithms.skeleton.projection import BoneConstraints, project_bones
from mocapmend_algorithms.sparse.body import find_body


def lengths(points, bones):
    return np.linalg.norm(points[:, bones[:, 0]] - points[:, bones[:, 1]], axis=2)


@pytest.fixture
def skeleton():
    recording = walker(50)
    return recording.points, find_body(recording, recording.present)


def constraints(body, movable):
    touching = np.isin(body.bones, movable).any(axis=1)
    return BoneConstraints(body.bones[touching], body.lengths[touching] / 10)


@pytest.mark.parametrize("movable", [[9, 10, 11], [1, 2, 3], [30], [8, 9, 10, 11, 12, 13], [3]])
def test_bones_get_their_lengths_between_points_that_stay(skeleton, movable):
    points, body = skeleton
    rough = points.copy()
    rough[:, movable] += np.random.default_rng(0).normal(0, 2, (50, len(movable), 3))
    bones = constraints(body, movable)
    rough[:, movable] = project_bones(rough, np.array(movable), bones)
    assert np.abs(lengths(rough, bones.bones) - bones.lengths).max() < 1e-9
    others = np.setdiff1d(np.arange(31), movable)
    np.testing.assert_array_equal(rough[:, others], points[:, others])


def test_points_move_no_further_than_they_must():
    points = np.array([[[0.0, 0, 0], [3.0, 4.0, 0]]])
    bones = BoneConstraints(np.array([[0, 1]]), np.array([10.0]))
    moved = project_bones(points, np.array([1]), bones)
    np.testing.assert_allclose(moved, [[[6, 8, 0]]], atol=1e-9)


def test_what_is_less_sure_moves_further():
    points = np.array([[[0.0, 0, 0], [4.0, 0, 0]]])
    bones = BoneConstraints(np.array([[0, 1]]), np.array([8.0]))
    covariance = np.diag([1.0, 3.0])
    moved = project_bones(points, np.array([0, 1]), bones, covariance)
    np.testing.assert_allclose(moved[0, :, 0], [-1, 7], atol=1e-9)


def test_what_errs_together_moves_together():
    points = np.array([[[0.0, 0, 0], [4.0, 0, 0], [4.0, 3.0, 0]]])
    bones = BoneConstraints(np.array([[0, 1]]), np.array([5.0]))
    covariance = np.array([[1.0, 0.5], [0.5, 2.0]])
    moved = project_bones(points, np.array([1, 2]), bones, covariance)
    np.testing.assert_allclose(moved, [[[5, 0, 0], [4.5, 3, 0]]], atol=1e-9)


def test_an_end_out_of_reach_is_met_as_nearly_as_can_be():
    points = np.array([[[0.0, 0, 0], [3.0, 1.0, 0], [10.0, 0, 0]]])
    bones = BoneConstraints(np.array([[0, 1], [1, 2]]), np.array([4.0, 4.0]))
    moved = project_bones(points, np.array([1]), bones)
    np.testing.assert_allclose(moved, [[[5, 0, 0]]], atol=1e-3)


def test_contradicting_lengths_are_least_squares():
    corners = np.array([[0.0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 10]])
    points = np.concatenate([corners, [[2.0, 3.0, 4.0]]])[None]
    bones = np.array([[0, 4], [1, 4], [2, 4], [3, 4]])
    wanted = lengths(points, bones)[0] + [0.1, -0.1, 0.1, 0.1]
    moved = points.copy()
    moved[:, [4]] = project_bones(points, np.array([4]), BoneConstraints(bones, wanted))
    missed = lengths(moved, bones)[0] - wanted
    along = (moved[0, 4] - corners) / lengths(moved, bones)[0][:, None]
    np.testing.assert_allclose(missed @ along, 0, atol=1e-6)
    assert np.sum(missed**2) < 0.04


def test_missing_ends_do_not_count_and_coincident_points_are_no_trouble():
    points = np.array([[[np.nan] * 3, [1.0, 0, 0], [1.0, 0, 0]]])
    bones = BoneConstraints(np.array([[0, 1], [1, 2]]), np.array([5.0, 5.0]))
    moved = project_bones(points, np.array([1]), bones)
    np.testing.assert_array_equal(moved, [[[1, 0, 0]]])


def test_nothing_to_move_is_nothing():
    points = np.zeros((0, 2, 3))
    bones = BoneConstraints(np.array([[0, 1]]), np.array([1.0]))
    assert project_bones(points, np.array([1]), bones).shape == (0, 1, 3)
