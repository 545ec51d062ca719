"""W18's preprocessing: what it promises, and its exact inverse."""

import numpy as np
import pytest
from joint_samples import walker

from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.bone_space import (
    chain,
    preprocess,
    restore,
    signed_roots,
    signed_squares,
    with_lengths,
)


@pytest.fixture
def motion():
    recording = walker(80)
    return recording.points * 10, find_body(recording, recording.present)


def test_the_inverse_gives_the_coordinates_back(motion):
    points, body = motion
    standard = np.linspace(50, 300, 30)
    processed = preprocess(points, body, standard)
    np.testing.assert_allclose(restore(processed, body), points, rtol=0, atol=1e-9)


def test_noise_in_the_bones_survives_the_round_trip(motion):
    points, body = motion
    rough = points + np.random.default_rng(3).normal(0, 5, points.shape)
    processed = preprocess(rough, body, body.edge_lengths)
    np.testing.assert_allclose(restore(processed, body), rough, rtol=0, atol=1e-9)


def test_absolute_values_add_up_to_the_squared_standard_length(motion):
    points, body = motion
    standard = np.linspace(50, 300, 30)
    squares = preprocess(points, body, standard).squares
    np.testing.assert_allclose(
        np.abs(squares).sum(axis=2), np.broadcast_to(standard**2, squares.shape[:2]), rtol=1e-12
    )


def test_other_lengths_keep_directions_and_roots(motion):
    points, body = motion
    edges, standard = body.edges, np.linspace(50, 300, 30)
    moved = with_lengths(points, body, standard)
    before = points[:, edges[:, 0]] - points[:, edges[:, 1]]
    after = moved[:, edges[:, 0]] - moved[:, edges[:, 1]]
    np.testing.assert_allclose(np.linalg.norm(after, axis=2), np.tile(standard, (80, 1)))
    cosine = np.sum(before * after, axis=2)
    cosine /= np.linalg.norm(before, axis=2) * np.linalg.norm(after, axis=2)
    np.testing.assert_allclose(cosine, 1)
    np.testing.assert_array_equal(moved[:, body.parents < 0], points[:, body.parents < 0])


def test_the_subjects_own_lengths_change_nothing(motion):
    points, body = motion
    np.testing.assert_allclose(with_lengths(points, body, body.edge_lengths), points, atol=1e-6)


def test_differences_lead_back_along_the_bones(motion):
    points, body = motion
    away = points[:, body.edges[:, 0]] - points[:, body.edges[:, 1]]
    np.testing.assert_allclose(chain(away, points, body), points, atol=1e-9)


def test_roots_undo_squares_with_their_signs():
    values = np.array([-3.0, -1e-9, 0.0, 2.0])
    np.testing.assert_array_equal(signed_squares(values), [-9.0, -1e-18, 0.0, 4.0])
    np.testing.assert_allclose(signed_roots(signed_squares(values)), values)
