"""The filter in its neighbours' frame, its donors, what it does not trust, and the bone pull."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from synthetic import body_motion, fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap, Recording, find_gaps
from mocapmend_algorithms.metrics import bone_lengths

GAP = Gap(0, 200, 260)
KALMAN = "kalman"


def fill(recording, gap=GAP, **params):
    result = fill_with((KALMAN, params), recording, [gap])
    return result.patches[0], result.notes[gap]


def rmse(patch, points):
    truth = points[patch.gap.start : patch.gap.stop, patch.gap.marker]
    return np.sqrt(np.mean(np.sum((patch.values - truth) ** 2, axis=1)))


@pytest.mark.parametrize("direction", ["two-sided", "causal"])
def test_the_local_frame_beats_the_world_on_a_body(direction):
    points = body_motion(600, 6)
    recording = record(punch(points, [GAP]))
    local, notes = fill(recording, direction=direction)
    world, in_world = fill(recording, direction=direction, frame="world")
    assert rmse(local, points) < rmse(world, points) / 5
    assert notes["frame"] == "local"
    assert len(notes["donors"]) == 4
    assert set(notes["donors"]) < set(recording.labels[1:])
    assert in_world["frame"] == "world"
    assert "donors" not in in_world


@settings(max_examples=10)
@given(seed=st.integers(0, 200), bones=st.booleans())
def test_a_rigid_motion_of_everything_changes_nothing_in_the_local_frame(seed, bones):
    still = body_motion(400, 6, seed=seed)
    turns = Rotation.from_rotvec(smooth_motion(400, 1, seed=seed + 7)[:, 0] / 300)
    travel = smooth_motion(400, 1, seed=seed + 8)

    def moved(points):
        return np.einsum("tij,t...j->t...i", turns.as_matrix(), points) + np.reshape(
            travel, (400, *[1] * (points.ndim - 2), 3)
        )

    params = {"bone_pull": str(bones)}
    here, notes = fill(record(punch(still, [GAP])), **params)
    there, same = fill(record(punch(moved(still), [GAP])), **params)
    assert same["donors"] == notes["donors"]
    back = turns[200:260].inv().apply(there.values - travel[200:260, 0])
    np.testing.assert_allclose(back, here.values, atol=1e-6)
    np.testing.assert_allclose(there.sigma, here.sigma, rtol=1e-6)
    np.testing.assert_allclose(there.r90, here.r90, rtol=1e-6)


def test_a_rigid_body_is_filled_exactly():
    points = body_motion(400, 5, skin=0.0)
    patch, _ = fill(record(punch(points, [GAP])))
    np.testing.assert_allclose(patch.values, points[200:260, 0], atol=1e-6)


def test_markers_that_do_not_keep_their_distance_are_no_donors():
    points = smooth_motion(400, 6)
    patch, notes = fill(record(punch(points, [GAP])))
    world, _ = fill(record(punch(points, [GAP])), frame="world")
    assert notes["frame"] == "world"
    np.testing.assert_array_equal(patch.values, world.values)


def test_donors_are_seen_throughout_gap_and_window():
    points = body_motion(400, 7)
    points[:, 1] = points[:, 0] + 20.0
    points[230, 1] = np.nan
    points[195, 2] = np.nan
    recording = record(punch(points, [GAP]))
    _, notes = fill(recording)
    assert not {"M1", "M2"} & set(notes["donors"])
    points[225, 3:5] = np.nan
    _, notes = fill(record(punch(points, [GAP])))
    assert notes["frame"] == "world"


def test_markers_missing_in_gaps_of_the_same_call_are_no_donors():
    points = body_motion(400, 5)
    gaps = [GAP, *(Gap(marker, 210, 240) for marker in (1, 2, 3))]
    flagged = fill_with((KALMAN, {}), record(points), gaps)
    hidden = fill_with((KALMAN, {}), record(punch(points, gaps)), gaps)
    assert flagged.notes[GAP]["frame"] == "world"
    for one, other in zip(flagged.patches, hidden.patches, strict=True):
        assert one.values.tobytes() == other.values.tobytes()


def test_donors_by_hand():
    points = body_motion(400, 7)
    points[100:120, 6] = np.nan
    recording = record(punch(points, [GAP]))
    patch, notes = fill(recording, donors="M6, M2, M5,M2")
    assert notes["donors"] == ("M6", "M2", "M5")
    assert rmse(patch, points) < 20
    patch, notes = fill(recording, donors="M3")
    assert notes["donors"] == ("M3",)
    offset = points[:, 0] - points[:, 3]
    moves = np.diff(patch.values - points[200:260, 3], axis=0)
    assert np.linalg.norm(moves, axis=1).max() < 3 * np.abs(np.diff(offset, axis=0)).max()


@pytest.mark.parametrize(
    ("donors", "reason"),
    [
        ("M1,Nobody", "there is no marker Nobody to take as a donor"),
        ("M1,M0", "M0 cannot be its own donor"),
        ("M1,M2", "the donor M2 is missing in the gap too"),
        ("M3,M1", "the donor M3 is missing at an edge of the gap"),
    ],
)
def test_donors_by_hand_that_cannot_serve_leave_the_gap_open(donors, reason):
    points = body_motion(400, 5)
    points[250, 2] = points[260:300, 3] = np.nan
    recording = record(punch(points, [GAP]), first_frame=101)
    result = fill_with((KALMAN, {"donors": donors}), recording, [GAP])
    assert not result.patches
    assert [(u.gap, u.reason) for u in result.unfilled] == [(GAP, reason)]
    assert fill_with((KALMAN, {"donors": donors, "frame": "world"}), recording, [GAP]).patches


def test_a_marker_that_is_seen_too_little_is_tested_on_its_neighbours():
    points = body_motion(400, 8)
    points[:150, 0] = points[300:, 0] = np.nan
    gap = Gap(0, 200, 240)
    patch, notes = fill(record(punch(points, [gap])), gap)
    assert notes["tested_on"] == "all markers"
    assert np.isfinite(patch.sigma).all()
    assert rmse(patch, points) < 2 * patch.expected_error


@pytest.mark.parametrize("frame", ["local", "world"])
@pytest.mark.parametrize(
    ("direction", "at"),
    [*(("two-sided", at) for at in (199, 198, 260, 261)), ("causal", 199), ("causal", 198)],
)
def test_a_bad_sample_beside_the_gap_does_not_throw_the_velocity(frame, direction, at):
    points = body_motion(600, 6, seed=3)
    points += np.random.default_rng(3).normal(0, 0.3, points.shape)
    spiked = points.copy()
    spiked[at, 0] += [15.0, -20.0, 10.0]
    recording = record(punch(spiked, [GAP]), first_frame=11)
    params = {"frame": frame, "direction": direction, "noise_mm": "1"}
    params |= {"velocity_interval_ms": "0"}
    good, _ = fill(record(punch(points, [GAP]), first_frame=11), **params)
    gated, notes = fill(recording, **params)
    trusting, without = fill(recording, gate="1e6", **params)
    assert notes["distrusted"] == (at + 11,)
    assert "distrusted" not in without
    moved, thrown = (np.linalg.norm(p.values - good.values) for p in (gated, trusting))
    assert moved < thrown / 3


def test_samples_that_a_marker_jumps_to_are_not_trusted():
    points = body_motion(600, 6, seed=4)
    spiked = points.copy()
    spiked[195:200, 0] += 400.0
    recording = record(punch(spiked, [GAP]))
    patch, notes = fill(recording, gate="1e6")
    assert notes["distrusted"] == (196, 197, 198, 199, 200)
    good, _ = fill(record(punch(points, [Gap(0, 195, 260)])), Gap(0, 195, 260), gate="1e6")
    np.testing.assert_allclose(patch.values, good.values[5:], atol=1.0)
    _, notes = fill(recording, gate="1e6", jump_mm="1e6")
    assert "distrusted" not in notes
    metres = Recording(recording.points / 1000, recording.labels, 100.0, "m")
    _, notes = fill(metres, gate="1e6", jump_mm="300")
    assert notes["distrusted"] == (196, 197, 198, 199, 200)


def test_a_donor_that_jumps_is_not_chosen():
    points = body_motion(600, 8, seed=5)
    _, notes = fill(record(punch(points, [GAP])))
    best = int(notes["donors"][0][1:])
    points[[205, 230], best] += 500.0
    _, notes = fill(record(punch(points, [GAP])))
    assert notes["frame"] == "local"
    assert f"M{best}" not in notes["donors"]


@pytest.mark.parametrize("frame", ["local", "world"])
def test_the_bone_pull_shrinks_bone_errors_and_moves_nothing_else(frame):
    points = body_motion(600, 6, seed=6, skin=1.0)
    recording = record(punch(points, [GAP]))
    before = recording.points.tobytes()
    free, without = fill(recording, frame=frame)
    pulled, notes = fill(recording, frame=frame, bone_pull="true")
    assert recording.points.tobytes() == before
    assert "bones" not in without
    assert 1 <= len(notes["bones"]) <= 4
    assert (pulled.sigma <= free.sigma).all()
    assert (pulled.r90 <= free.r90).all()
    bones = np.array([[0, int(label[1:])] for label in notes["bones"]])
    true = bone_lengths(points, bones).mean(axis=0)

    def bone_error(patch):
        filled = points[200:260].copy()
        filled[:, 0] = patch.values
        return np.sqrt(np.mean((bone_lengths(filled, bones) - true) ** 2))

    assert bone_error(pulled) < bone_error(free)
    if frame == "world":
        assert bone_error(pulled) < bone_error(free) / 4
        assert rmse(pulled, points) < rmse(free, points) / 2


def test_without_bones_or_tests_nothing_is_pulled():
    points = smooth_motion(400, 4)
    _, notes = fill(record(punch(points, [GAP])), bone_pull="true")
    assert "bones" not in notes
    short = body_motion(30, 6)[:, :6]
    gap = Gap(0, 10, 20)
    patch, notes = fill(record(punch(short, [gap])), gap, bone_pull="true")
    assert np.isnan(patch.sigma).all() == ("bones" not in notes)


def test_frames_far_away_hardly_matter():
    points = body_motion(6000, 6, seed=9)
    near = points.copy()
    near[4000:] += np.random.default_rng(9).normal(0, 5, near[4000:].shape)
    gap = Gap(0, 1500, 1520)
    one, notes = fill(record(punch(points, [gap])), gap)
    other, same = fill(record(punch(near, [gap])), gap, donors=",".join(notes["donors"]))
    assert same["donors"] == notes["donors"]
    np.testing.assert_allclose(other.values, one.values, atol=0.5)


@settings(max_examples=30)
@given(seed=st.integers(0, 10_000), share=st.sampled_from([0.05, 0.3]), pull=st.booleans())
def test_every_gap_of_a_broken_body_is_filled_or_explained(seed, share, pull):
    rng = np.random.default_rng(seed)
    points = body_motion(90, 7, seed=seed)
    for _ in range(int(share * 60)):
        start = rng.integers(90)
        points[start : start + rng.integers(1, 20), rng.integers(7)] = np.nan
    recording = record(points)
    gaps = find_gaps(recording.present)
    result = fill_with((KALMAN, {"bone_pull": str(pull)}), recording, gaps)
    assert sorted([p.gap for p in result.patches] + [u.gap for u in result.unfilled]) == gaps
    for patch in result.patches:
        assert np.isfinite(patch.values).all()
        alone = fill_with((KALMAN, {"bone_pull": str(pull)}), recording, [patch.gap]).patches[0]
        assert alone.values.tobytes() == patch.values.tobytes()
        assert alone.r90.tobytes() == patch.r90.tobytes()
