"""Fills by sparse codes of windows: bones keep their lengths, and what there is to learn from."""

from dataclasses import replace

import numpy as np
import pytest
from joint_samples import NAMES, hidden, walker
from synthetic import bending_body, body_motion, fill_with, punch, record
from taught_walk import another_subject

from mocapmend_algorithms import Gap, find_gaps
from mocapmend_algorithms.fill.keep_bones import joined_by_bones
from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.training_set import (
    TrainingSetError,
    gather,
    up_vector,
    write_training_set,
)

THREE = ("lhumerus", "lradius", "lwrist")
SIX = ("root", "lhipjoint", "lfemur", "ltibia", "lfoot", "ltoes")
FEW = {"atoms": "40"}
SOFT = FEW | {"keep_bones": "false"}


def fill(recording, gaps=None, **params):
    gaps = find_gaps(recording.present) if gaps is None else gaps
    return fill_with(("bone-dictionary", FEW | params), recording, gaps)


def lose(recording, names, start, stop):
    return hidden(recording, [NAMES.index(name) for name in names], start, stop)


def repaired(recording, result):
    points = recording.points.copy()
    for patch in result.patches:
        points[patch.gap.start : patch.gap.stop, patch.gap.marker] = patch.values
    return points


def off(recording, raw, points):
    """Return by how much bones that touch a missing point miss their length, in mm."""
    body = find_body(recording, recording.present)
    lost = ~raw.present
    touching = lost[:, body.bones[:, 0]] | lost[:, body.bones[:, 1]]
    away = points[:, body.bones[:, 0]] - points[:, body.bones[:, 1]]
    miss = np.abs(np.linalg.norm(away, axis=2) * recording.mm - body.lengths)
    return miss[touching]


def error(recording, raw, points):
    """Return the 3-D error over the missing samples in mm."""
    away = np.linalg.norm(points - recording.points, axis=2)[~raw.present]
    return float(np.sqrt(np.mean(away**2))) * recording.mm


def patches_of(result):
    return {patch.gap: patch.values for patch in result.patches}


# --- bones -----------------------------------------------------------------------------------


@pytest.mark.parametrize(("names", "unit"), [(THREE, "cm"), (THREE, "mm"), (SIX, "cm")])
def test_bones_have_their_lengths_and_errors_are_small(names, unit):
    recording = walker(320, unit=unit)
    raw = lose(recording, names, 150, 250)
    result = fill(raw)
    points = repaired(raw, result)
    assert np.isfinite(points).all()
    assert off(recording, raw, points).max() < 1e-6
    np.testing.assert_array_equal(points[raw.present], recording.points[raw.present])
    spline = fill_with(("cubic", {}), raw, find_gaps(raw.present))
    assert error(recording, raw, points) < 0.5 * error(recording, raw, repaired(raw, spline))


def test_staggered_gaps_of_neighbours_agree_on_the_bones_between_them():
    recording = walker(320)
    raw = lose(recording, ["lhumerus"], 120, 200)
    raw = lose(raw, ["lradius"], 150, 230)
    raw = lose(raw, ["lwrist"], 140, 160)
    raw = lose(raw, ["lwrist"], 190, 260)
    raw = lose(raw, ["rtibia", "rfoot"], 100, 220)
    points = repaired(raw, fill(raw))
    assert np.isfinite(points).all()
    assert off(recording, raw, points).max() < 1e-6
    assert error(recording, raw, points) < 60


@pytest.mark.parametrize("chosen", [0, 1, 2])
def test_a_gap_filled_alone_fits_its_neighbours_filled_later(chosen):
    recording = walker(320)
    raw = lose(recording, THREE, 150, 250)
    gaps = find_gaps(raw.present)
    together = fill(raw)
    alone = fill(raw, [gaps[chosen]])
    assert [patch.gap for patch in alone.patches] == [gaps[chosen]]
    assert set(alone.notes) == {gaps[chosen]}
    np.testing.assert_array_equal(alone.patches[0].values, together.patches[chosen].values)


def test_the_order_of_the_gaps_is_kept():
    raw = lose(walker(300), THREE, 150, 200)
    gaps = find_gaps(raw.present)
    backwards = fill(raw, gaps[::-1])
    assert [patch.gap for patch in backwards.patches] == gaps[::-1]
    for gap, values in patches_of(fill(raw)).items():
        np.testing.assert_array_equal(patches_of(backwards)[gap], values)


def test_without_keep_bones_lengths_are_off():
    recording = walker(320)
    raw = lose(recording, THREE, 150, 250)
    points = repaired(raw, fill(raw, keep_bones="false"))
    assert np.median(off(recording, raw, points)) > 0.1
    assert error(recording, raw, points) < 60


def test_a_missing_root_is_filled_with_all_that_hangs_from_it():
    recording = walker(320)
    raw = lose(recording, ["root"], 150, 220)
    points = repaired(raw, fill(raw))
    assert off(recording, raw, points).max() < 1e-6
    assert error(recording, raw, points) < 20


def test_noise_on_what_is_seen_does_not_keep_bones_from_their_lengths():
    recording = walker(320)
    rng = np.random.default_rng(0)
    noisy = recording.with_points(recording.points + rng.normal(0, 0.1, recording.points.shape))
    raw = lose(noisy, THREE, 150, 220)
    points = repaired(raw, fill(raw))
    body = find_body(raw, raw.present)
    lost = [NAMES.index(name) for name in THREE]
    for (a, b), length in zip(body.bones.tolist(), body.lengths, strict=True):
        if a in lost or b in lost:
            size = 10 * np.linalg.norm(points[150:220, a] - points[150:220, b], axis=1)
            np.testing.assert_allclose(size, length, atol=1e-6)


@pytest.mark.parametrize("up", ["+z", "-y", "-x"])
def test_any_axis_may_point_up(up):
    walk = walker(300)
    # The smallest turn from +y to the axis, by hand: columns are where x, y and z go.
    up_at = up_vector(up)
    aside = np.roll(np.abs(up_at), 1)
    turn = np.stack([aside, up_at, np.cross(aside, up_at)], axis=1)
    recording = replace(walk.with_points(walk.points @ turn.T), up=up)
    raw = lose(recording, THREE, 120, 180)
    here = repaired(raw, fill(raw))
    assert off(recording, raw, here).max() < 1e-6
    straight = lose(walk, THREE, 120, 180)
    there = repaired(straight, fill(straight)) @ turn.T
    np.testing.assert_allclose(here, there, atol=0.05)


def test_gaps_that_share_frames_and_a_bone_belong_together():
    raw = lose(walker(300), ["lradius"], 100, 150)
    raw = lose(raw, ["lwrist"], 149, 200)
    raw = lose(raw, ["lhand"], 199, 220)
    raw = lose(raw, ["lhumerus"], 150, 180)
    raw = lose(raw, ["rfoot"], 100, 150)
    body = find_body(raw, raw.present)
    radius, wrist, hand, humerus, foot = (
        NAMES.index(name) for name in ("lradius", "lwrist", "lhand", "lhumerus", "rfoot")
    )
    chain = sorted([Gap(radius, 100, 150), Gap(wrist, 149, 200), Gap(hand, 199, 220)])
    assert joined_by_bones(raw.present, [Gap(radius, 100, 150)], body) == chain
    # The humerus is missing right after the radius, and no bone joins it to the wrist.
    lonely = [Gap(humerus, 150, 180)]
    assert joined_by_bones(raw.present, lonely, body) == lonely
    assert joined_by_bones(raw.present, [Gap(foot, 100, 150)], body) == [Gap(foot, 100, 150)]


# --- markers on skin -------------------------------------------------------------------------


def test_markers_on_skin_are_pulled_towards_lengths_and_do_not_get_them_exactly():
    truth = record(body_motion(300, 9, skin=2.0))
    gaps = [Gap(2, 100, 160)]
    raw = record(punch(truth.points, gaps))
    body = find_body(raw, raw.present)
    assert not body.exact
    soft, free = (
        repaired(raw, fill_with(("bone-dictionary", params), raw, gaps)) for params in (FEW, SOFT)
    )
    assert (soft[100:160, 2] != free[100:160, 2]).any()
    mine = (body.bones == 2).any(axis=1)
    assert mine.any()

    def missed(points):
        ends = points[100:160][:, body.bones[mine]]
        return np.abs(np.linalg.norm(ends[:, :, 0] - ends[:, :, 1], axis=2) - body.lengths[mine])

    assert missed(soft).mean() < missed(free).mean()
    assert missed(soft).max() > 1e-3


def test_markers_without_a_steady_bone_stay_where_the_codes_put_them():
    gaps = [Gap(2, 100, 130), Gap(5, 110, 150)]
    truth = record(bending_body(300, 12))
    raw = record(punch(truth.points, gaps))
    body = find_body(raw, raw.present)
    loose = [gap for gap in gaps if not (body.bones == gap.marker).any()]
    assert loose
    soft, free = (
        patches_of(fill_with(("bone-dictionary", params), raw, gaps)) for params in (FEW, SOFT)
    )
    for gap in loose:
        np.testing.assert_array_equal(soft[gap], free[gap])


# --- training sets ---------------------------------------------------------------------------


@pytest.fixture(scope="module")
def training(tmp_path_factory):
    path = tmp_path_factory.mktemp("training") / "bob.npz"
    write_training_set(gather([another_subject()]), path)
    return str(path)


def test_a_training_set_helps_where_the_recording_shows_too_little(training):
    recording = walker(320)
    raw = lose(recording, THREE, 60, 280)
    alone, taught = (repaired(raw, fill(raw, **params)) for params in ({}, {"training": training}))
    assert error(recording, raw, taught) < 0.5 * error(recording, raw, alone)
    assert off(recording, raw, taught).max() < 1e-6


def test_a_training_set_alone_may_be_enough_and_gets_the_lengths_of_the_recording(training):
    recording = walker(320)
    raw = lose(recording, THREE, 20, 300)
    refused = fill(raw)
    assert not refused.patches
    reason = (
        "this method needs 10 stretches that show the marker and those that predict it, and has 0"
    )
    assert {one.reason for one in refused.unfilled} == {reason}
    result = fill(raw, training=training, keep_bones="false")
    points = repaired(raw, result)
    # Bones have other lengths in the training set by up to 40 %, that is 100 mm or so.
    assert np.median(off(recording, raw, points)) < 5
    assert error(recording, raw, points) < 30
    assert min(note["examples"] for note in result.notes.values()) > 100


@pytest.mark.parametrize("seen", [1, 9])
def test_a_training_set_tells_markers_that_are_hardly_seen(training, seen):
    recording = walker(320)
    raw = lose(recording, THREE, seen, 320)
    assert {one.reason for one in fill(raw).unfilled} == {
        f"only {seen} frames show the marker and those that predict it: this method needs 10"
    }
    points = repaired(raw, fill(raw, training=training))
    assert np.isfinite(points).all()
    assert error(recording, raw, points) < 30
    assert off(recording, raw, points).max() < 1e-6


def test_a_training_set_may_have_another_axis_up(tmp_path, training):
    other = another_subject()
    turn = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    path = tmp_path / "z.npz"
    write_training_set(gather([replace(other.with_points(other.points @ turn.T), up="+z")]), path)
    recording = walker(320)
    raw = lose(recording, THREE, 60, 280)
    here = repaired(raw, fill(raw, training=str(path)))
    there = repaired(raw, fill(raw, training=training))
    np.testing.assert_allclose(here, there, atol=0.1)


def test_a_training_set_of_other_markers_is_refused(tmp_path):
    path = tmp_path / "other.npz"
    write_training_set(gather([record(bending_body(60, 5))]), path)
    raw = lose(walker(200), THREE, 60, 90)
    with pytest.raises(TrainingSetError, match="of other markers: 5 of its 5 are not in"):
        fill(raw, training=str(path))
    with pytest.raises(TrainingSetError, match="no such training set"):
        fill(raw, training=str(tmp_path / "nowhere.npz"))


# --- what is too little ----------------------------------------------------------------------


def reason(points, gap):
    (one,) = fill(record(punch(points, [gap])), [gap]).unfilled
    assert one.gap == gap
    return one.reason


def test_too_few_markers_are_named():
    told = reason(bending_body(200, 3), Gap(1, 60, 90))
    assert told.startswith("fewer than 3 other markers that are seen often enough are there")


def test_too_few_frames_are_named():
    points = bending_body(60, 6)
    points[7:, 2] = np.nan
    told = reason(points, Gap(2, 7, 60))
    assert told == ("only 7 frames show the marker and those that predict it: this method needs 10")


def test_too_few_stretches_are_named():
    # Frames that show the marker come one by one: no window is complete.
    points = bending_body(300, 6)
    points[np.arange(300) % 4 > 0, 2] = np.nan
    told = reason(points, Gap(2, 101, 104))
    assert told == (
        "this method needs 10 stretches that show the marker and those that predict it, and has 0"
    )


def test_a_marker_that_is_never_seen_stays_open():
    raw = lose(walker(100), ["head"], 0, 100)
    (one,) = fill(raw).unfilled
    assert one.reason == "the marker is never seen in this recording"


@pytest.mark.parametrize("frames", [4, 7, 12, 20, 30, 45])
def test_short_recordings_are_filled_or_refused_in_words(frames):
    gap = Gap(0, frames // 2, frames // 2 + 1)
    recording = record(punch(bending_body(frames, 6), [gap]))
    result = fill(recording, [gap])
    assert len(result.patches) + len(result.unfilled) == 1
    for patch in result.patches:
        assert np.isfinite(patch.values).all()
    for one in result.unfilled:
        assert one.reason[0].islower()


# --- what is shared and divided --------------------------------------------------------------


def test_a_gap_whose_helpers_change_is_divided():
    truth = record(bending_body(500, 14))
    long = Gap(0, 200, 380)
    # Each other marker is missing in a part of the gap: the first half has seven, the second six.
    first = [Gap(marker, 180, 250) for marker in range(1, 7)]
    then = [Gap(marker, 330, 400) for marker in range(7, 14)]
    alone = record(punch(truth.points, [long]))
    raw = record(punch(truth.points, [long, *first, *then]))
    params = {"keep_bones": "false", "meet_edges": "false", "window_ms": "100"}
    assert fill(alone, [long], **params).notes[long]["helpers"] == 13
    result = fill(raw, [long], **params)
    assert result.notes[long]["helpers"] == 6
    assert error(truth, alone, repaired(alone, result)) < 60
    # With windows as long as a quarter of the recording, no piece is far enough from all that miss.
    (one,) = fill(raw, [long], window_ms="1250").unfilled
    assert one.reason.startswith("fewer than 3 other markers")


def test_gaps_of_the_same_frames_are_the_same_alone():
    truth = record(bending_body(300, 10))
    gaps = [Gap(1, 100, 140), Gap(2, 100, 140), Gap(7, 100, 140)]
    raw = record(punch(truth.points, gaps))
    together = patches_of(fill(raw, gaps))
    for gap in gaps:
        np.testing.assert_array_equal(patches_of(fill(raw, [gap]))[gap], together[gap])
