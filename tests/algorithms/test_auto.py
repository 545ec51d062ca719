"""The method that chooses by test."""

from dataclasses import replace

import numpy as np
import pytest
from donor_samples import GAPS, body, jittery, punched, rms, truth_of
from scipy.spatial.transform import Rotation
from synthetic import fill_with, record, smooth_motion

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill import pose_regression
from mocapmend_algorithms.fill.auto import POSE, TIGHT, WHOLE
from mocapmend_algorithms.fill.lessons import Lesson, Size
from mocapmend_algorithms.fill.limits import Limits, fill_within
from mocapmend_algorithms.fill.registry import METHODS
from mocapmend_algorithms.fill.survey import Survey

AUTO = METHODS["auto"]


def alone(points, gap, variant=("auto", {}), **options):
    (patch,) = fill_with(variant, punched(points, [gap], **options), [gap]).patches
    return patch


@pytest.mark.parametrize(
    ("donors", "length", "candidates", "tests"),
    [(0, 30, 3, 18), (0, 80, 3, 14), (3, 80, 8, 14), (9, 80, 5, 14), (9, 30, 7, 18), (9, 5, 7, 12)],
)
def test_the_notes_say_what_was_blended(donors, length, candidates, tests):
    gap = Gap(0, 100, 100 + length)
    result = fill_with(("auto", {}), punched(jittery(body(600, donors + 1)), [gap]), [gap])
    notes = result.notes[gap]
    assert len(notes["donors"]) == min(donors, 4)
    assert notes["self_tests"] == tests
    assert len(notes["weights"]) == candidates
    assert sum(notes["weights"]) == pytest.approx(1, abs=0.01)


def test_without_donors_time_alone_is_left():
    points = smooth_motion(400, 1)
    patch = alone(points, Gap(0, 100, 108))
    assert rms(patch.values, points[100:108, 0]) < 1.0
    long = alone(points, Gap(0, 100, 180))
    assert long.expected_error > 20 * patch.expected_error


def test_a_curve_takes_the_place_of_a_blend_that_cannot_be_tested():
    # Seven frames: there is no other place of this marker to hide, but of the others.
    gap = Gap(0, 2, 5)
    recording = punched(body(7, 9), [gap])
    ours, curve = (fill_with((name, {}), recording, [gap]) for name in ("auto", "cubic"))
    assert ours.patches[0].values.tobytes() == curve.patches[0].values.tobytes()
    assert np.isfinite(ours.patches[0].expected_error)
    assert ours.donors(gap) == ()
    assert ours.notes[gap]["curve"]


def test_no_curve_takes_the_place_of_what_named_donors_can_do():
    gap = Gap(0, 2, 5)
    ours = fill_with(("auto", {"donors": "M1,M2,M3"}), punched(body(7, 9), [gap]), [gap])
    assert set(ours.donors(gap)) == {"M1", "M2", "M3"}
    assert np.isnan(ours.patches[0].expected_error)


def test_donors_that_move_on_their_own_do_little_harm():
    points = smooth_motion(400, 5)
    gap = Gap(0, 100, 110)
    without = rms(alone(points[:, :1], gap).values, truth_of(points, gap))
    assert rms(alone(points, gap).values, truth_of(points, gap)) < max(3 * without, 2.0)


def test_skin_that_slides_over_a_joint_is_learned():
    # The first marker slides on its segment as the next one bends; a rigid body cannot know.
    rng = np.random.default_rng(0)
    bend = smooth_motion(800, 1)[:, 0, 0] / 300
    upper, lower = rng.uniform(-100, 100, (6, 3)), rng.uniform(-100, 100, (6, 3))
    bent = Rotation.from_rotvec(bend[:, None] * [1.0, 0, 0]).as_matrix()
    local = np.concatenate((np.tile(upper, (800, 1, 1)), lower @ bent.swapaxes(1, 2)), axis=1)
    local[:, 0] += 30 * np.sin(2 * bend)[:, None] * [0.0, 1.0, 0.5]
    turn = Rotation.from_rotvec(smooth_motion(800, 1, seed=1)[:, 0] / 400).as_matrix()
    points = jittery(local @ turn.swapaxes(1, 2) + smooth_motion(800, 1, seed=2))
    gap = Gap(0, 300, 360)
    error = {
        name: rms(alone(points, gap, (name, {})).values, truth_of(points, gap))
        for name in ("auto", "rigid", "cubic")
    }
    assert error["auto"] < 0.5 * error["rigid"]
    assert error["auto"] < 0.1 * error["cubic"]


def test_the_expected_error_is_that_of_similar_gaps():
    points = jittery(body(1200, 9, seed=2))
    expected, true = [], []
    for start in range(50, 1100, 50):
        gap = Gap(0, start, start + 30)
        patch = alone(points, gap)
        expected.append(patch.expected_error)
        true.append(rms(patch.values, truth_of(points, gap)))
    assert 0.6 < np.sqrt(np.mean(np.square(expected)) / np.mean(np.square(true))) < 1.8


def test_longer_gaps_are_less_sure():
    points = jittery(body(1200, 9, seed=2))
    errors = [alone(points, Gap(0, 500, 500 + n)).expected_error for n in (3, 30, 200)]
    assert errors == sorted(errors)


def test_a_gap_above_the_users_limit_stays_open():
    recording = punched(jittery(body(240, 8)))
    filled = fill_within(recording, GAPS, AUTO, AUTO.params(), Limits(), no_progress)
    assert [patch.gap for patch in filled.patches] == GAPS
    least = min(patch.expected_error for patch in filled.patches)
    strict = Limits(max_error_mm=0.9 * least)
    refused = fill_within(recording, GAPS, AUTO, AUTO.params(), strict, no_progress)
    assert [unfilled.gap for unfilled in refused.unfilled] == GAPS
    assert all("expected error" in unfilled.reason for unfilled in refused.unfilled)
    assert all("above the limit" in unfilled.reason for unfilled in refused.unfilled)


def test_donors_that_no_view_looks_at_cost_nothing():
    near = jittery(body(300, 60, skin=0.5))
    far = 1e4 + smooth_motion(300, 5)
    far[10:290:2] = np.nan
    points = np.concatenate((near, far), axis=1)
    gap = Gap(0, 100, 130)
    with_far, without = alone(points, gap), alone(near, gap)
    assert with_far.values.tobytes() == without.values.tobytes()


@pytest.mark.parametrize("view", [TIGHT, WHOLE])
@pytest.mark.parametrize("start", [0, 100, 270])
def test_what_is_left_over_in_a_trial_is_what_a_fill_without_it_leaves(view, start):
    # Not exactly: the frame's shape and the features' means still know the trial.
    gap = Gap(0, start, start + 30)
    points = jittery(body(300, 8))
    survey = Survey(punched(points, [gap]), [gap])
    donors = survey.donors(gap, (), at_edges=False, enough=1000)
    case = survey.case(gap, donors, Size(400, 5, 10, 100))
    (candidate,) = pose_regression.regress(case, view, (POSE,))
    assert len(candidate.errors) == len(case.lesson.trials) >= 3
    for trial, error in zip(case.lesson.trials, candidate.errors, strict=True):
        judged = case.lesson.frames[trial.hidden[trial.judged]]
        rest = np.delete(case.lesson.frames, trial.hidden)
        without = replace(
            case,
            lesson=Lesson(rest, ()),
            frames=np.concatenate((rest, judged)),
            target=points[rest, 0],
        )
        (again,) = pose_regression.regress(without, view, (POSE,))
        np.testing.assert_allclose(error, points[judged, 0] - again.values, atol=0.3 * size(error))


def size(errors):
    return np.linalg.norm(errors, axis=1).max() + 1.0


def test_a_recording_of_twenty_frames_is_filled():
    points = jittery(body(20, 8), 0.01)
    for gap in (Gap(0, 8, 11), Gap(0, 0, 4), Gap(0, 15, 20)):
        patch = alone(points, gap)
        assert rms(patch.values, truth_of(points, gap)) < 5
        assert np.isfinite(patch.r90).all()


@pytest.mark.parametrize("frames", [2, 3])
def test_recordings_with_hardly_a_frame_are_filled_or_refused(frames):
    for start in range(frames):
        gap = Gap(0, start, start + 1)
        result = fill_with(("auto", {}), punched(body(frames, 8), [gap]), [gap])
        assert len(result.patches) + len(result.unfilled) == 1
        for patch in result.patches:
            assert np.isfinite(patch.values).all()
            assert np.isnan(patch.r90).all()


@pytest.mark.parametrize("share", [0.0, 0.3])
def test_a_thousand_markers_are_no_trap(share):
    rng = np.random.default_rng(0)
    shape = rng.normal(0, 300, (1000, 3))
    points = jittery(body(150, 1, turn=0.0) + shape)
    holed = np.where(rng.random((150, 1000, 1)) < share, np.nan, points)
    gap = Gap(5, 50, 80)
    holed[[49, 80], 5] = points[[49, 80], 5]
    assert rms(alone(holed, gap).values, truth_of(points, gap)) < 1.0


def test_the_acceleration_is_not_read_from_a_long_gap_of_a_donor():
    # Too long to be bridged: the frames beside it must not reach into it.
    points = jittery(body(400, 5))
    gaps = [Gap(0, 300, 320), Gap(2, 100, 215)]
    hidden = fill_with(("auto", {"donors": "M1,M2,M3"}), punched(points, gaps), gaps).patches
    points[100:215, 2] += 100.0
    for patch, same in zip(
        fill_with(("auto", {"donors": "M1,M2,M3"}), record(points), gaps).patches,
        hidden,
        strict=True,
    ):
        assert patch.values.tobytes() == same.values.tobytes()
        assert patch.r90.tobytes() == same.r90.tobytes()
