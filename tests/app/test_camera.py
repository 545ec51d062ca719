"""The camera of the 3D view."""

import numpy as np
import pytest

from mocapmend.views.camera import VIEWS, Camera, upright

ALL_UP = ["+x", "-x", "+y", "-y", "+z", "-z"]


@pytest.mark.parametrize("up", ALL_UP)
def test_upright_is_a_rotation_that_brings_up_to_z(up: str) -> None:
    turn = upright(up)
    axis = np.zeros(3)
    axis["xyz".index(up[1])] = 1.0 if up[0] == "+" else -1.0
    assert np.allclose(turn @ axis, [0, 0, 1])
    assert np.allclose(turn @ turn.T, np.eye(3))
    assert np.linalg.det(turn) == pytest.approx(1.0)


@pytest.mark.parametrize("view", VIEWS)
def test_the_target_is_in_the_middle_and_up_is_up(view: str) -> None:
    camera = Camera(target=np.array([1.0, 2.0, 3.0]), distance=5.0)
    camera.look(view)
    points = np.array([[1.0, 2.0, 3.0], [1.0, 2.0, 3.5]])
    pixels, depth = camera.project(points, 400, 300)
    assert np.allclose(pixels[0], [200, 150])
    assert depth[0] == pytest.approx(5.0)
    assert pixels[1, 1] < 150


def test_the_front_view_shows_the_first_axis_to_the_right() -> None:
    camera = Camera(distance=5.0)
    camera.look("front")
    pixels, _ = camera.project(np.array([[1.0, 0.0, 0.0]]), 400, 300)
    assert pixels[0, 0] > 200


def test_missing_points_and_those_behind_the_camera_are_nan() -> None:
    camera = Camera(distance=5.0)
    camera.look("front")
    points = np.array([[np.nan] * 3, [0.0, -6.0, 0.0], [0.0, 0.0, 0.0]])
    pixels, _ = camera.project(points, 400, 300)
    assert np.isnan(pixels[:2]).all()
    assert np.isfinite(pixels[2]).all()


def test_panning_moves_the_picture_with_the_mouse() -> None:
    camera = Camera(distance=5.0)
    before, _ = camera.project(np.zeros((1, 3)), 400, 300)
    camera.pan(30.0, 20.0, 300)
    after, _ = camera.project(np.zeros((1, 3)), 400, 300)
    assert np.allclose(after - before, [[30.0, 20.0]])


@pytest.mark.parametrize("view", VIEWS)
def test_the_axes_of_the_picture_are_at_right_angles(view: str) -> None:
    camera = Camera()
    camera.look(view)
    axes = camera._axes()
    assert np.allclose(axes @ axes.T, np.eye(3))
    assert np.allclose(np.cross(axes[0], axes[1]), -axes[2])
    assert axes[1, 2] > 0
    assert camera.turned(np.array([0.0, 0.0, 1.0]))[0] == 0
