import numpy as np
from scipy.spatial.transform import Rotation

from mocapmend_algorithms.alignment import align, mean_shape, turns

SHAPE = np.array([[0.0, 0, 0], [100, 0, 0], [0, 80, 0], [10, 20, 60]])


def moved(rng, frames=20):
    turns = Rotation.random(frames, random_state=rng).as_matrix()
    shifts = rng.normal(0, 500, (frames, 3))
    return turns, shifts, SHAPE @ turns.swapaxes(1, 2) + shifts[:, None]


def test_a_rigid_group_is_found_again_exactly():
    turns, _, points = moved(np.random.default_rng(1))
    alignment = align(points, SHAPE, np.array([1.0, 2, 3, 4]))
    np.testing.assert_allclose(alignment.rotation, turns, atol=1e-12)
    np.testing.assert_allclose(
        alignment.to_local(points), np.broadcast_to(SHAPE, points.shape), atol=1e-9
    )
    world = alignment.to_world(np.broadcast_to(SHAPE[3], (20, 3)))
    np.testing.assert_allclose(world, points[:, 3], atol=1e-9)


def test_it_is_the_least_squares_rotation_of_scipy():
    rng = np.random.default_rng(2)
    _, _, points = moved(rng)
    noisy = points + rng.normal(0, 20, points.shape)
    weights = np.array([1.0, 0.5, 2.0, 1.5])
    alignment = align(noisy, SHAPE, weights)
    for rotation, centre, frame in zip(alignment.rotation, alignment.centre, noisy, strict=True):
        best, _ = Rotation.align_vectors(frame - centre, SHAPE - alignment.origin, weights)
        np.testing.assert_allclose(rotation, best.as_matrix(), atol=1e-9)


def test_a_flat_group_is_not_mirrored():
    rng = np.random.default_rng(3)
    turns = Rotation.random(20, random_state=rng).as_matrix()
    flat = SHAPE[:3]
    rotation = align(flat @ turns.swapaxes(1, 2), flat, np.ones(3)).rotation
    np.testing.assert_allclose(np.linalg.det(rotation), 1.0, atol=1e-12)
    np.testing.assert_allclose(rotation, turns, atol=1e-9)


def test_a_frame_without_one_of_the_group_has_no_alignment():
    _, _, points = moved(np.random.default_rng(4))
    points[3, 1] = np.nan
    rotation = align(points, SHAPE, np.ones(4)).rotation
    assert np.isnan(rotation[3]).all()
    assert np.isfinite(np.delete(rotation, 3, axis=0)).all()


def test_two_markers_are_only_moved():
    points = np.random.default_rng(5).normal(0, 100, (10, 2, 3))
    alignment = align(points, points[0], np.ones(2))
    np.testing.assert_array_equal(alignment.rotation, np.broadcast_to(np.eye(3), (10, 3, 3)))
    np.testing.assert_allclose(alignment.centre, points.mean(axis=1))


def test_the_mean_shape_does_not_depend_on_where_the_group_is():
    rng = np.random.default_rng(6)
    _, _, points = moved(rng, frames=400)
    noisy = points + rng.normal(0, 2, points.shape)
    shape = mean_shape(noisy, np.ones(4))
    distances = np.linalg.norm(shape[:, None] - shape, axis=2)
    true = np.linalg.norm(SHAPE[:, None] - SHAPE, axis=2)
    np.testing.assert_allclose(distances, true, atol=1.0)


def test_markers_in_one_line_turn_as_little_as_they_can():
    rng = np.random.default_rng(7)
    line = np.outer([-100.0, 0, 20, 150], [0.0, 1, 0])
    turned = Rotation.random(20, random_state=rng).as_matrix()
    rotation = align(line @ turned.swapaxes(1, 2), line, np.ones(4)).rotation
    to = turned[:, :, 1]
    np.testing.assert_allclose(rotation[:, :, 1], to, atol=1e-5)
    np.testing.assert_allclose(np.linalg.det(rotation), 1.0, atol=1e-12)
    # The angle is that between the line and its template.
    angle = Rotation.from_matrix(rotation).magnitude()
    np.testing.assert_allclose(angle, np.arccos(to[:, 1]), atol=1e-4)


def test_markers_in_one_place_do_not_turn():
    points = np.tile(np.random.default_rng(8).normal(0, 100, (10, 1, 3)), (1, 4, 1))
    rotation = align(points, points[0], np.ones(4)).rotation
    np.testing.assert_allclose(rotation, np.broadcast_to(np.eye(3), (10, 3, 3)), atol=1e-12)


def test_turns_are_the_nearest_rotations_whatever_the_shape():
    rng = np.random.default_rng(9)
    product = rng.normal(size=(4, 5, 3, 3))
    found = turns(product)
    for place in np.ndindex(4, 5):
        np.testing.assert_allclose(found[place], turns(product[place][None])[0], atol=1e-12)
        best, _ = Rotation.align_vectors(product[place].T, np.eye(3))
        gain = np.sum(found[place] * product[place])
        assert gain >= np.sum(best.as_matrix() * product[place]) - 1e-9
