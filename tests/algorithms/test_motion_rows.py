"""Headings, windows and rows: how motion is described to sparse codes."""

from typing import get_args

import numpy as np
import pytest
from joint_samples import NAMES, walker
from scipy.spatial.transform import Rotation

from mocapmend_algorithms.recording import UpAxis
from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.examples import Motion, choose_places, complete_places
from mocapmend_algorithms.sparse.heading import headings, mean_pose, turned
from mocapmend_algorithms.sparse.rows import Rows, differences
from mocapmend_algorithms.sparse.training_set import up_vector
from mocapmend_algorithms.sparse.windows import Span


@pytest.fixture(scope="module")
def body():
    recording = walker(60)
    return find_body(recording, recording.present)


@pytest.mark.parametrize("up", get_args(UpAxis))
def test_a_turn_about_the_vertical_is_found_and_undone(up):
    pose = np.random.default_rng(0).normal(size=(9, 3))
    angles = np.linspace(-3, 3, 13)
    about = Rotation.from_rotvec(np.outer(angles, up_vector(up)))
    away = np.array([5.0, -2.0, 9.0])
    poses = np.stack([turn.apply(pose) + away for turn in about])
    np.testing.assert_allclose(headings(poses, pose, up), angles, atol=1e-12)
    expected = np.stack([turn.apply(pose) for turn in about])
    np.testing.assert_allclose(turned(np.tile(pose, (13, 1, 1)), angles, up), expected)


def test_the_mean_pose_does_not_depend_on_places_and_headings():
    rng = np.random.default_rng(1)
    poses = rng.normal(size=(1, 8, 3)) + 0.05 * rng.normal(size=(21, 8, 3))
    scattered = turned(poses, rng.uniform(-3, 3, 21), "+y") + rng.normal(0, 100, (21, 1, 3))
    one, other = mean_pose(poses, "+y"), mean_pose(scattered, "+y")
    aligned = turned(other[None], -headings(other[None], one, "+y"), "+y")[0]
    np.testing.assert_allclose(aligned, one, atol=1e-3)


@pytest.mark.parametrize(
    ("length", "offsets"),
    [
        (0, (-3, -2, -1, 0, 1, 2)),
        (5, (-3, -2, -1, 0, 1, 2)),
        (10, (-5, -3, -1, 1, 3, 5)),
        (40, (-20, -12, -4, 4, 12, 20)),
    ],
)
def test_a_window_is_spread_evenly(length, offsets):
    assert Span.over(6, length).offsets == offsets


def test_overlapping_windows_are_averaged():
    span = Span((-1, 0, 2))
    places = span.touching(10, 14, 40)
    assert places.tolist() == [8, 9, 10, 11, 12, 13, 14]
    frames = span.frames(places)
    exact = span.average(frames.astype(float)[..., None], places, 10, 14)
    np.testing.assert_array_equal(exact[:, 0], [10, 11, 12, 13])
    ones = span.average(places[:, None].repeat(3, axis=1).astype(float), places, 11, 12)
    np.testing.assert_allclose(ones, [(9 + 11 + 12) / 3])


def test_frames_that_no_window_holds_are_unknown():
    span = Span((-5, 5))
    places = span.touching(0, 3, 20)
    assert places.tolist() == [5, 6, 7]
    assert np.isnan(span.average(np.zeros((3, 2)), places, 0, 4)).tolist() == [False] * 3 + [True]


def test_only_the_frames_of_a_window_must_be_seen():
    seen = np.ones((30, 4), dtype=bool)
    seen[10, 2] = False
    motion = Motion(np.zeros((30, 4, 3)), seen)
    span = Span((-4, 0, 4))
    places = complete_places(motion, np.array([0, 2]), span)
    assert sorted(set(range(4, 26)) - set(places.tolist())) == [6, 10, 14]
    assert complete_places(motion, np.array([0, 3]), span).size == 22


def test_half_of_the_examples_at_most_are_the_recordings_own():
    def motion(frames):
        return Motion(np.zeros((frames, 3, 3)), np.ones((frames, 3), dtype=bool))

    own, other, span = motion(500), motion(300), Span((-1, 0, 1))
    everyone = np.arange(3)
    counts = [p.size for _, p in choose_places(own, [other, other], everyone, span, 200)]
    assert counts[0] == 100
    assert sum(counts) == 200
    assert [p.size for _, p in choose_places(own, [], everyone, span, 200)] == [200]
    assert [p.size for _, p in choose_places(own, [motion(12)], everyone, span, 200)] == [190, 10]


def test_helpers_are_joined_across_missing_markers_and_targets_to_both_sides(body):
    lost = np.array([NAMES.index(name) for name in ("lhumerus", "lradius", "lwrist")])
    helpers = np.setdiff1d(np.arange(31), lost)
    rows = Rows.along_bones(body, helpers, lost)
    hand, clavicle = NAMES.index("lhand"), NAMES.index("lclavicle")
    assert [hand, clavicle] in rows.known.tolist()
    assert len(rows.known) == len(helpers) - 1
    assert len(rows.lost) == 5
    points = walker(20).points
    found = rows.places(differences(points, rows.lost), np.where(rows.targets[0] >= 0, points, 0))
    np.testing.assert_allclose(found, points[:, lost], atol=1e-9)


@pytest.mark.parametrize("lost", [[0], [0, 1, 7], [6], [30], list(range(31))[1:]])
def test_targets_are_found_wherever_they_hang(body, lost):
    helpers = np.setdiff1d(np.arange(31), lost)
    points = walker(20).points
    left = points.copy()
    left[:, lost] = np.nan
    for make in (Rows.along_bones, Rows.around_root):
        rows = make(body, helpers, np.array(lost))
        found = rows.places(differences(points, rows.lost), left)
        np.testing.assert_allclose(found, points[:, lost], atol=1e-9)


def test_around_the_root_all_are_relative_to_it_or_to_the_nearest_to_it(body):
    rows = Rows.around_root(body, np.arange(1, 31), np.array([0]))
    centre = set(rows.known[:, 1].tolist())
    assert len(centre) == 1
    assert body.parents[centre.pop()] == 0
