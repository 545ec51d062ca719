"""The method that chooses by test, with a training set among what it chooses from."""

import numpy as np
import pytest
from joint_samples import NAMES, hidden, walker
from synthetic import bending_body, fill_with, punch, record
from taught_walk import another_subject

from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.blending import blended, grown
from mocapmend_algorithms.fill.bone_dictionary import BoneDictionaryParams, fill_bare
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.coded_motion import CodedMotion, joined
from mocapmend_algorithms.fill.lessons import Size
from mocapmend_algorithms.fill.survey import Survey
from mocapmend_algorithms.sparse.body import find_body
from mocapmend_algorithms.sparse.examples import Motion
from mocapmend_algorithms.sparse.training_set import TrainingSetError, gather, write_training_set

ARM = tuple(NAMES.index(name) for name in ("lhumerus", "lradius", "lwrist"))


@pytest.fixture(scope="module")
def training(tmp_path_factory):
    path = tmp_path_factory.mktemp("training") / "bob.npz"
    write_training_set(gather([another_subject()]), path)
    return str(path)


@pytest.fixture(scope="module")
def truth():
    return walker(240)


@pytest.fixture(scope="module")
def raw(truth):
    return hidden(truth, ARM, 60, 170)


def by_auto(recording, gaps, **params):
    return fill_with(("auto", params), recording, gaps)


def values(result):
    return {patch.gap: patch.values for patch in result.patches}


def test_a_training_set_becomes_part_of_the_blend_where_tests_speak_for_it(truth, raw, training):
    gaps = find_gaps(raw.present)
    alone, taught = by_auto(raw, gaps), by_auto(raw, gaps, training=training)
    assert [patch.gap for patch in taught.patches] == gaps
    for gap in gaps:
        assert len(taught.notes[gap]["weights"]) == len(alone.notes[gap]["weights"]) + 1
        assert sum(taught.notes[gap]["weights"]) == pytest.approx(1, abs=0.01)
    wrong = {}
    for name, result in (("alone", alone), ("taught", taught)):
        away = [p.values - truth.points[60:170, p.gap.marker] for p in result.patches]
        wrong[name] = np.sqrt(np.mean(np.square(away)))
        assert all(np.isfinite(patch.expected_error) for patch in result.patches)
    assert wrong["taught"] < 0.5 * wrong["alone"]
    assert max(p.expected_error for p in taught.patches) < max(
        p.expected_error for p in alone.patches
    )


def test_bones_of_a_skeleton_have_their_lengths(raw, training):
    points = raw.points.copy()
    for gap, filled in values(by_auto(raw, find_gaps(raw.present), training=training)).items():
        points[gap.start : gap.stop, gap.marker] = filled
    body = find_body(raw, raw.present)
    touching = np.isin(body.bones, ARM).any(axis=1)
    away = points[:, body.bones[touching, 0]] - points[:, body.bones[touching, 1]]
    lengths = np.linalg.norm(away, axis=2) * raw.mm
    assert np.abs(lengths - body.lengths[touching]).max() < 1e-6


def test_a_gap_alone_is_filled_as_with_its_neighbours(raw, training):
    gaps = find_gaps(raw.present)
    together = values(by_auto(raw, gaps, training=training))
    (alone,) = by_auto(raw, gaps[1:2], training=training).patches
    np.testing.assert_allclose(alone.values, together[gaps[1]], atol=1e-9)


@pytest.mark.parametrize("seen", [1, 4])
def test_a_marker_that_is_hardly_seen_is_taken_from_the_training_set(truth, training, seen):
    raw = hidden(truth, ARM, seen, truth.frames)
    gaps = find_gaps(raw.present)
    result = by_auto(raw, gaps, training=training)
    for gap, filled in values(result).items():
        assert np.abs(filled - truth.points[gap.start :, gap.marker]).max() * truth.mm < 20
        assert result.notes[gap]["self_tests"] == 0
        assert result.notes[gap]["weights"][-1] == 1
    assert all(np.isnan(patch.expected_error) for patch in result.patches)
    left = by_auto(raw, gaps, training=training, edges="leave")
    assert not left.patches


def test_donors_that_are_named_are_not_passed_over(truth, training):
    raw = hidden(truth, [*ARM, NAMES.index("root")], 60, 100)
    result = by_auto(raw, [Gap(ARM[0], 60, 100)], training=training, donors="root")
    (unfilled,) = result.unfilled
    assert "root" in unfilled.reason


def test_a_set_without_the_marker_changes_nothing_but_the_bones(tmp_path):
    path = tmp_path / "without.npz"
    rest = [name for name in NAMES if name != NAMES[ARM[1]]]
    write_training_set(gather([another_subject()], markers=rest), path)
    # Windows that show the marker are in the recording, but fewer than it takes.
    raw = hidden(walker(160), ARM[1:2], 12, 150)
    gaps = find_gaps(raw.present)
    alone = by_auto(raw, gaps)
    taught = by_auto(raw, gaps, training=str(path))
    assert taught.notes[gaps[0]]["weights"] == alone.notes[gaps[0]]["weights"]


def test_a_training_set_of_other_motion_has_no_weight(tmp_path):
    gaps = [Gap(3, 100, 130)]
    raw = record(punch(bending_body(300, 12), gaps))
    path = tmp_path / "other.npz"
    write_training_set(gather([record(bending_body(300, 12, seed=9, modes=6))]), path)
    alone, taught = by_auto(raw, gaps), by_auto(raw, gaps, training=str(path))
    weights = taught.notes[gaps[0]]["weights"]
    assert len(weights) == len(alone.notes[gaps[0]]["weights"]) + 1
    assert weights[-1] == 0
    np.testing.assert_allclose(taught.patches[0].values, alone.patches[0].values, atol=3.0)


def test_a_training_set_of_other_markers_is_refused(tmp_path, raw):
    path = tmp_path / "other.npz"
    write_training_set(gather([record(walker(60).points)]), path)
    with pytest.raises(TrainingSetError, match="of other markers"):
        by_auto(raw, find_gaps(raw.present), training=str(path))


# --- the candidate ---------------------------------------------------------------------------


@pytest.mark.parametrize("window", [(60, 100), (0, 40), (200, 240)])
def test_what_is_left_over_in_a_trial_is_what_a_fill_without_it_leaves(truth, window):
    start, stop = window
    raw = hidden(truth, ARM, start, stop)
    gaps = find_gaps(raw.present)
    body, survey = find_body(raw, raw.present), Survey(raw, gaps)
    other = another_subject(300)
    others = [Motion(other.points * other.mm, other.present)]
    params = BoneDictionaryParams(atoms=40)
    coded = CodedMotion(raw, survey.observed, params, body, others)
    donors = survey.donors(gaps[0], (), at_edges=False, enough=1000)
    case = survey.case(gaps[0], donors, Size(300, 2, 10, 100))
    candidate = coded.candidate(case, no_progress)

    def bare(observed, asked):
        known = {"params": params, "body": body, "others": others}
        return values(fill_bare(raw, observed, asked, no_progress, **known))

    np.testing.assert_allclose(
        candidate.values, bare(survey.observed, gaps)[gaps[0]] * raw.mm, atol=1e-9
    )
    assert len(candidate.errors) == len(case.lesson.trials) >= 1
    for trial, error in zip(case.lesson.trials, candidate.errors, strict=True):
        observed = survey.observed.copy()
        # A gap at an end of the recording has a sample on one side only, and so has its trial.
        before, after = start == 0, stop == raw.frames
        observed[trial.start - before : trial.stop + after, ARM] = False
        gap = Gap(ARM[0], trial.start, trial.stop)
        judged = case.lesson.frames[trial.hidden[trial.judged]]
        told = bare(observed, [gap])[gap][judged - trial.start]
        np.testing.assert_allclose(error, (truth.points[judged, ARM[0]] - told) * raw.mm, atol=1e-9)


# --- blending --------------------------------------------------------------------------------


def candidate(value, trials):
    return Candidate(
        np.full((4, 3), value),
        np.ones(4),
        tuple(np.full((5, 3), error) for error in trials),
        tuple(np.ones(5) for _ in trials),
    )


def test_opposite_errors_cancel():
    whole, weights = blended([candidate(2.0, [2.0] * 6), candidate(-1.0, [-1.0] * 6)], 1e-6)
    np.testing.assert_allclose(weights, [1 / 3, 2 / 3], atol=1e-3)
    np.testing.assert_allclose(whole.values, 0.0, atol=1e-2)
    assert max(np.abs(error).max() for error in whole.errors) < 1e-2
    # Spreads become millimetres: 2 and 1 along each axis are the errors of the two.
    np.testing.assert_allclose(whole.spread, np.sqrt(3) * (2 / 3 + 2 / 3), rtol=1e-2)


def test_what_is_taken_to_err_more_weighs_less():
    one, other = candidate(1.0, [1.0, -1.0] * 3), candidate(0.0, [1.0, 1.0, -1.0] * 2)
    _, equal = blended([one, other], 1e-3)
    _, unequal = blended([grown(one, 3.0), other], 1e-3)
    assert equal[0] == pytest.approx(0.5, abs=0.05)
    assert unequal[0] < 0.2


def test_without_trials_all_weigh_alike():
    whole, weights = blended([candidate(1.0, []), candidate(3.0, [])], 0.1)
    np.testing.assert_allclose(weights, 0.5)
    assert whole.errors == ()
    np.testing.assert_allclose(whole.values, 2.0)


def test_codes_take_part_where_they_err_no_more_and_more_so_in_long_gaps():
    one, other = candidate(1.0, [1.0, -1.0] * 3), candidate(0.0, [1.1, 1.1, -1.1] * 2)
    assert joined(one, other, 1.0) == (one, 0.0)
    whole, weight = joined(one, other, 2.0)
    assert 0.5 < weight < 0.9
    np.testing.assert_allclose(whole.values, 1 - weight)
    assert joined(one, other, 8.0)[1] > weight


def test_codes_stand_alone_where_nothing_is_tried():
    coded = candidate(3.0, [])
    assert joined(candidate(1.0, []), coded, 1.0) == (coded, 1.0)
