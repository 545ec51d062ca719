"""Bodies that are no bodies: lines, points, statues, ghosts, and numbers of any size."""

import numpy as np
import pytest
from donor_samples import body, jittery, punched, rms, truth_of
from scipy.spatial.transform import Rotation
from synthetic import fill_with, smooth_motion

from mocapmend_algorithms import Gap

EVERY = pytest.mark.parametrize("method", ["rigid", "pattern", "local-frame", "auto"])
GAPS = [Gap(0, 80, 110), Gap(0, 50, 51), Gap(0, 0, 15), Gap(0, 185, 200)]


def check(method, points, gaps=GAPS, **options):
    """Fill each gap alone; make sure that all is finite; return the largest error."""
    errors = []
    for gap in gaps:
        (patch,) = fill_with((method, {}), punched(points, [gap], **options), [gap]).patches
        assert np.isfinite(patch.values).all()
        assert np.isfinite(patch.sigma).all()
        assert np.isfinite(patch.r90).all()
        errors.append(rms(patch.values, truth_of(points, gap)))
    return max(errors)


def stick(frames, places):
    """Markers in one line that turns and travels."""
    angles = smooth_motion(frames, 1, seed=1)[:, 0] / 400
    axis = Rotation.from_rotvec(angles).as_matrix()[:, :, 0]
    return np.asarray(places)[:, None] * axis[:, None] + smooth_motion(frames, 1, seed=2)


@EVERY
def test_markers_in_one_line(method):
    error = check(method, stick(200, [0.0, 100, 150, 300, 400, 420]))
    assert error < {"rigid": 1e-3, "pattern": 300}.get(method, 1.0)


@EVERY
def test_markers_in_one_place(method):
    assert check(method, stick(200, [0.0] * 5)) < 1e-6


@EVERY
def test_markers_that_stand_still(method):
    points = np.tile(body(1, 6), (200, 1, 1))
    assert check(method, points) < 1e-6
    assert check(method, points + 1e6) < 1e-6


@EVERY
def test_markers_that_stand_still_and_then_move(method):
    points = body(200, 6, skin=0.0)
    points[:120] = points[120]
    check(method, points)
    check(method, points[::-1])


@EVERY
def test_a_marker_that_stands_still_beside_a_body(method):
    points = jittery(body(200, 6))
    points[:, 0] = points[0, 0]
    check(method, points)


@EVERY
def test_donors_that_stand_still(method):
    points = jittery(body(200, 6))
    points[:, 1:4] = points[0, 1:4]
    check(method, points)


@EVERY
def test_markers_that_are_never_seen(method):
    points = jittery(body(200, 9))
    points[:, [2, 5]] = np.nan
    assert check(method, points) < (300 if method == "pattern" else 20)


@EVERY
@pytest.mark.parametrize("offset", [1e6, 1e9])
def test_recordings_far_from_the_origin(method, offset):
    points = jittery(body(200, 8))
    near = check(method, points)
    assert check(method, points + offset) == pytest.approx(near, rel=0.05)


@EVERY
@pytest.mark.parametrize("jump", [1e3, 1e6, 1e9])
def test_a_donor_that_jumps(method, jump):
    points = jittery(body(200, 8))
    points[150, 3] += jump
    points[160:, 5] += jump
    check(method, points)


@EVERY
@pytest.mark.parametrize("rate", [1.0, 10_000.0])
def test_any_rate(method, rate):
    check(method, jittery(body(200, 8)), rate=rate)


@EVERY
@pytest.mark.parametrize("unit", ["mm", "in", "ft", "m"])
def test_any_size(method, unit):
    for size in (1e-6, 1e3):
        check(method, size * jittery(body(200, 8)), unit=unit)
