"""Whole-pose sparse codes: exact where they must be, and whatever the place, heading and unit."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from synthetic import bending_body, fill_with, punch, record

from mocapmend_algorithms import Gap, Recording, find_gaps
from mocapmend_algorithms.fill.known_poses import of_recording
from mocapmend_algorithms.fill.pose_code import LEAST_MARKERS, _keys, _pieces
from mocapmend_algorithms.sparse.pose_dictionary import PoseDictionary, Reading
from mocapmend_algorithms.sparse.poses import stance, usual_pose
from mocapmend_algorithms.sparse.training_set import TrainingSetError, gather, write_training_set

BARE = {"meet_edges": "false"}
AS_PRINTED = {
    "relative_to": "world",
    "centred": "false",
    "weight_scale_mm": "100000",
    "poses": "800",
    "meet_edges": "false",
}


def fill(points_or_recording, gaps, **params):
    recording = points_or_recording
    if not isinstance(recording, Recording):
        recording = record(punch(points_or_recording, gaps))
    return fill_with(("pose-code", params), recording, gaps)


def worst(result, points):
    return max(
        np.linalg.norm(p.values - points[p.gap.start : p.gap.stop, p.gap.marker], axis=1).max()
        for p in result.patches
    )


def turned(points, angle, by=(0.0, 0.0, 0.0)):
    return points @ Rotation.from_euler("z", angle).as_matrix().T + np.array(by)


AWAY = (900.0, -20.0, 400.0)


@pytest.mark.parametrize("variant", [BARE, AS_PRINTED], ids=["default", "as printed"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_poses_that_the_dictionary_has_are_recovered(variant, seed):
    once = bending_body(100, 12, seed=seed, modes=4)
    once -= once.mean(axis=1, keepdims=True)  # in place, so that the world is as good as the body
    points = np.concatenate((once, once))
    gaps = [Gap(3, 40, 70), Gap(7, 40, 70)]
    result = fill(points, gaps, **variant | {"penalty": "1e-5"})
    assert worst(result, points) < 1.5


def test_known_motion_at_another_place_and_heading_is_known():
    once = bending_body(100, 12, modes=4)
    points = np.concatenate((once, turned(once[39:71], 2.0, by=(5000.0, -3000.0, 20.0))))
    gaps = [Gap(3, 101, 131)]
    assert worst(fill(points, gaps, penalty="1e-5", **BARE), points) < 1.5
    world = fill(points, gaps, penalty="1e-5", relative_to="world", **BARE)
    place = fill(points, gaps, penalty="1e-5", relative_to="place", **BARE)
    assert worst(world, points) > 5
    assert worst(place, points) > 5


@pytest.mark.parametrize("angle", [0.3, 2.0, -3.0])
@pytest.mark.parametrize("unit", ["mm", "m"])
def test_turning_moving_and_units_do_not_matter(angle, unit):
    points = bending_body(200, 9)
    gaps = [Gap(0, 40, 55), Gap(2, 90, 100), Gap(3, 0, 12)]
    here = fill(points, gaps)
    scale = {"mm": 1.0, "m": 1e-3}[unit]
    moved = turned(points, angle, by=AWAY) * scale
    there = fill(record(punch(moved, gaps), unit=unit), gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        expected = turned(a.values, angle, by=AWAY)
        np.testing.assert_allclose(b.values / scale, expected, atol=1e-3)
        np.testing.assert_allclose(b.r90 / scale, a.r90, rtol=1e-3, atol=1e-3)


@pytest.mark.parametrize("frame", ["body", "place", "world"])
def test_a_stance_is_taken_out_and_put_back(frame):
    points = bending_body(50, 6)
    where = stance(points, usual_pose(points, "+z", frame), "+z", frame)
    np.testing.assert_allclose(where.to_world(where.to_body(points)), points, atol=1e-9)
    assert (frame == "world") == bool(np.array_equal(where.to_body(points), points))


def test_the_codes_are_those_of_scikit_learn_on_a_real_gap(samples):
    linear_model = pytest.importorskip("sklearn.linear_model")
    from mocapmend.files import read_recording

    recording = read_recording(samples / "walk_cmu_02_01.c3d").recording
    marker, gap, penalty = 8, slice(150, 170), 1e-3
    observed = recording.present.copy()
    observed[gap, marker] = False
    known = of_recording(recording, 100)(observed, marker)
    others = known.markers != marker
    reading = Reading(recording.up, "body", centred=True, reach=200.0, least=1e-3)
    dictionary = PoseDictionary.of(known.poses[:, others], known.poses[:, marker], reading)
    points = recording.points[gap][:, known.markers[others]]
    found, _ = dictionary.find(points, np.arange(20), penalty, lambda fraction: None)
    # The same from the definition, with poses normalised by a general solver and coded by theirs.
    reference = dictionary.reference

    def facing(pose):
        flat = [1.0, 1.0, 0.0]
        around = pose - pose.mean(axis=0)
        angle = np.arctan2(
            np.sum(np.cross(around * flat, reference * flat)), np.sum(around * flat * reference)
        )
        return Rotation.from_euler("z", angle)

    bodies = [facing(p[others]).apply(p - p[others].mean(axis=0)) for p in known.poses]
    bodies = np.array(bodies)
    seen, missing = bodies[:, others], bodies[:, marker]
    weight = np.exp(-(np.linalg.norm(seen - missing[:, None], axis=2).mean(axis=0) ** 2) / 80000)
    weight = np.repeat(weight + 1e-3, 3)
    rows = (seen.reshape(100, -1) - seen.reshape(100, -1).mean(axis=0)) * weight
    size = np.sqrt(np.mean(np.sum(rows**2, axis=1)))
    for pose, ours in zip(points, found, strict=True):
        turn = facing(pose)
        body = turn.apply(pose - pose.mean(axis=0)).ravel() - seen.reshape(100, -1).mean(axis=0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that its last steps are small
            lars = linear_model.LassoLars(
                alpha=penalty / rows.shape[1], fit_intercept=False, max_iter=5000
            ).fit(rows.T / size, body * weight / size)
        there = (missing - missing.mean(axis=0)).T @ lars.coef_ + missing.mean(axis=0)
        theirs = turn.inv().apply(there) + pose.mean(axis=0)
        assert np.linalg.norm(ours - theirs) < 1.0


def training_file(tmp_path, points, labels=None, **more):
    markers = points.shape[1]
    labels = labels or tuple(f"M{marker}" for marker in range(markers))
    path = tmp_path / "set.npz"
    write_training_set(gather([Recording(points, labels, 100.0, **more)]), path)
    return path


def test_a_training_set_knows_what_the_recording_does_not(tmp_path):
    points = bending_body(200, 12, modes=4)
    gap = Gap(3, 0, 60)
    short = points[:80]
    path = training_file(
        tmp_path,
        turned(points, 1.0)[:, ::-1] / 1000,
        tuple(f"m{m}" for m in range(12))[::-1],
        unit="m",
    )
    taught = fill(short, [gap], training=str(path), penalty="1e-5", **BARE)
    alone = fill(short, [gap], penalty="1e-5", **BARE)
    assert worst(taught, short) < 2
    assert worst(taught, short) < 0.3 * worst(alone, short)
    assert taught.notes[gap]["poses"] == 200


def test_markers_outside_the_training_set_are_neither_used_nor_filled(tmp_path):
    points = bending_body(200, 9)
    path = training_file(tmp_path, points[:, :7])
    gaps = [Gap(2, 50, 70), Gap(8, 50, 70)]
    result = fill(points, gaps, training=str(path))
    assert [p.gap for p in result.patches] == gaps[:1]
    assert result.notes[gaps[0]]["helpers"] == 6
    assert result.unfilled[0].reason == "the training set does not have this marker"


def test_training_sets_of_other_markers_or_none_are_refused(tmp_path):
    points = bending_body(100, 6)
    with pytest.raises(TrainingSetError, match="no such training set"):
        fill(points, [Gap(0, 10, 20)], training=str(tmp_path / "none.npz"))
    path = training_file(tmp_path, points, tuple("abcdef"))
    with pytest.raises(TrainingSetError, match="of other markers: 6 of its 6"):
        fill(points, [Gap(0, 10, 20)], training=str(path))


def test_markers_that_stand_still_are_filled_where_they_stand():
    points = np.tile(np.arange(18.0).reshape(6, 3) * 50, (100, 1, 1))
    result = fill(points, [Gap(2, 30, 60)])
    assert worst(result, points) < 1e-6


def test_without_complete_frames_the_markers_that_are_missing_most_are_left_out():
    points = bending_body(120, 8)
    points[::2, 6] = np.nan
    points[1::2, 7] = np.nan
    gap = Gap(1, 40, 60)
    result = fill(points, [gap])
    assert [p.gap for p in result.patches] == [gap]
    lonely = bending_body(100, 5)
    for marker in range(5):
        lonely[:, marker][np.arange(100) % 5 != marker] = np.nan
    recording = record(lonely)
    result = fill_with(("pose-code", {}), recording, find_gaps(recording.present))
    assert not result.patches


def test_a_gap_with_changing_company_is_cut_into_pieces():
    seen = np.ones((64, 8), dtype=bool)
    assert len(list(_pieces(seen, 5, 60))) == 1
    seen[:32, :4] = False
    seen[32:, 4:] = False
    pieces = list(_pieces(seen, 0, 64))
    assert [(start, stop) for start, stop, _ in pieces] == [(0, 32), (32, 64)]
    for start, stop, helpers in pieces:
        assert helpers.sum() == 4 > LEAST_MARKERS
        assert seen[start:stop, helpers].all()


@given(st.integers(1, 500), st.floats(10.0, 500.0))
def test_the_first_and_the_last_frame_are_coded(frames, rate):
    keys = _keys(frames, rate)
    assert keys[0] == 0
    assert keys[-1] == frames - 1
    assert (np.diff(keys) > 0).all()
    assert np.diff(keys).max(initial=1) <= max(rate / 20 + 1, 1)


def test_frames_between_the_coded_ones_lose_little():
    rate = 200.0
    points = bending_body(900, 12, modes=3, rate=rate)
    gaps = [Gap(4, 300, 500)]
    recording = record(punch(points, gaps), rate=rate)
    # At 20 frames per second every frame is coded.
    slow = record(punch(points, gaps)[::10], rate=rate / 10)
    often = fill_with(("pose-code", BARE), slow, find_gaps(slow.present)).patches[0]
    (seldom,) = fill_with(("pose-code", BARE), recording, gaps).patches
    truth = points[300:500, 4]
    coarse = np.linalg.norm(often.values - truth[::10], axis=1)
    fine = np.linalg.norm(seldom.values - truth, axis=1)
    assert np.sqrt(np.mean(fine**2)) < 1.5 * np.sqrt(np.mean(coarse**2)) + 1.0


def test_up_is_the_recordings_own():
    points = bending_body(200, 9)
    gaps = [Gap(0, 40, 55)]
    upright = fill(points, gaps)
    lying = replace(record(punch(points[:, :, [1, 2, 0]], gaps)), up="+y")
    (other,) = fill_with(("pose-code", {}), lying, gaps).patches
    np.testing.assert_allclose(other.values, upright.patches[0].values[:, [1, 2, 0]], atol=1e-3)
