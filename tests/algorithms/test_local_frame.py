"""Fills in the frame of donors: the ridge regression, the edges, and what is refused."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from donor_samples import body, jittery, punched, rms, truth_of
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.linear_model import Ridge
from synthetic import fill_with, punch, record

from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.lessons import Size
from mocapmend_algorithms.fill.local_frame import DECAY_S, _carry, _left_over, _Ridge
from mocapmend_algorithms.fill.survey import Survey

GAP = Gap(0, 60, 75)


def regression(samples=60, features=9, seed=0):
    rng = np.random.default_rng(seed)
    poses = rng.normal(0, 2, (samples + 5, features))
    poses -= poses[:samples].mean(axis=0)
    return poses, 100 + poses[:samples, :3] + rng.normal(0, 1, (samples, 3))


def scale(poses, samples):
    """By what the penalty is multiplied, known of all samples."""
    return np.sum(poses[:samples] ** 2) / poses.shape[1]


def test_it_is_scikit_learns_ridge_regression():
    poses, values = regression()
    fit = _Ridge(poses, values, 0.01)
    theirs = Ridge(alpha=0.01 * scale(poses, 60)).fit(poses[:60], values)
    np.testing.assert_allclose(fit.predicted, theirs.predict(poses), atol=1e-9)
    np.testing.assert_allclose(fit.residual, values - theirs.predict(poses[:60]), atol=1e-9)


@settings(max_examples=30)
@given(
    hidden=st.sets(st.integers(0, 59), min_size=1, max_size=40),
    penalty=st.sampled_from([1e-4, 1e-2, 1.0]),
)
def test_hidden_samples_are_left_over_as_if_they_had_never_been_there(hidden, penalty):
    # The one thing that the hidden samples still tell is the scale of the penalty.
    poses, values = regression()
    hidden = np.array(sorted(hidden))
    rest = np.setdiff1d(np.arange(60), hidden)
    theirs = Ridge(alpha=penalty * scale(poses, 60)).fit(poses[rest], values[rest])
    residual = _Ridge(poses, values, penalty).without(hidden)
    np.testing.assert_allclose(residual, values - theirs.predict(poses[:60]), atol=1e-8)


def test_without_features_the_mean_is_left():
    values = np.arange(30.0).reshape(10, 3)
    fit = _Ridge(np.zeros((12, 0)), values, 1.0)
    np.testing.assert_allclose(fit.predicted, np.tile(values.mean(axis=0), (12, 1)))
    left = fit.without(np.array([3, 4]))
    np.testing.assert_allclose(left, values - np.delete(values, [3, 4], axis=0).mean(axis=0))


def test_features_that_do_not_move_say_nothing():
    values = np.arange(30.0).reshape(10, 3)
    fit = _Ridge(np.zeros((12, 4)), values, 1e-9)
    np.testing.assert_allclose(fit.predicted, np.tile(values.mean(axis=0), (12, 1)))


def carried(before, after):
    case = SimpleNamespace(lesson=SimpleNamespace(frames=np.array([3, 9, 19, 30])), rate=10.0)
    residual = np.array([[0.0, 0, 0], [1, 2, 3], [11, 2, -3], [0, 0, 0]])
    return _carry(residual, before, after, np.arange(10, 19), case)


def test_what_is_left_over_at_both_edges_is_carried_linearly():
    found = carried(1, 2)
    np.testing.assert_allclose(found[:, 0], np.arange(2.0, 11))
    np.testing.assert_allclose(found[:, 1], 2.0)
    np.testing.assert_allclose(found[4], [6, 2, 0])


def test_what_is_left_over_at_one_edge_fades():
    away = np.arange(1, 10) / 10.0 / DECAY_S
    np.testing.assert_allclose(carried(1, None), np.exp(-away)[:, None] * [1, 2, 3])
    np.testing.assert_allclose(carried(None, 2), np.exp(-away[::-1])[:, None] * [11, 2, -3])


def test_without_an_edge_nothing_is_carried():
    np.testing.assert_array_equal(carried(None, None), np.zeros((9, 3)))


def test_what_is_left_over_in_a_trial_is_what_a_fill_of_it_leaves():
    points = jittery(body(300, 8))
    survey = Survey(punched(points, [GAP]), [GAP])
    case = survey.case(GAP, survey.donors(GAP, (), at_edges=True, enough=500), Size(200, 6, 10, 50))
    poses, values = regression(samples=case.samples)
    fit = _Ridge(poses, values, 0.01)
    for trial in case.lesson.trials:
        rest = np.delete(np.arange(case.samples), trial.hidden)
        theirs = Ridge(alpha=0.01 * scale(poses, case.samples)).fit(poses[rest], values[rest])
        predicted = theirs.predict(poses[: case.samples])
        edges = [trial.hidden[0] - 1, trial.hidden[-1] + 1]
        frames = case.lesson.frames[trial.hidden]
        known = case.lesson.frames[edges]
        beside = (values - predicted)[edges]
        carried = [np.interp(frames, known, axis) for axis in beside.T]
        expected = values[trial.hidden] - predicted[trial.hidden] - np.transpose(carried)
        np.testing.assert_allclose(_left_over(case, trial, fit), expected, atol=1e-8)


def test_a_pattern_moves_by_the_mean_of_its_donors_and_does_not_turn():
    points = body(200, 6)
    recording = punched(points, [GAP])
    for donors in (["M2"], ["M1", "M3"], ["M1", "M2", "M3", "M4"]):
        (patch,) = fill_with(("pattern", {"donors": ",".join(donors)}), recording, [GAP]).patches
        mean = points[:, [int(name[1:]) for name in donors]].mean(axis=1)
        beside = points[:, 0] - mean
        edges = beside[[GAP.start - 1, GAP.stop]]
        share = (np.arange(1, GAP.length + 1) / (GAP.length + 1))[:, None]
        expected = mean[GAP.start : GAP.stop] + (1 - share) * edges[0] + share * edges[1]
        np.testing.assert_allclose(patch.values, expected, atol=1e-9)


def test_three_corners_of_a_rigid_body_are_not_in_one_line():
    points = jittery(body(200, 8, skin=0.0), 0.01)
    # Two more markers on the way from one to another, as a model's joint centres lie.
    inner = np.stack([0.7 * points[:, 1] + 0.3 * points[:, 2], (points[:, 1] + points[:, 2]) / 2])
    points = np.concatenate((points[:, :3], inner.swapaxes(0, 1), points[:, 3:]), axis=1)
    points[:, 5:] += body(200, 5, seed=5, turn=0.0, travel=0.0, skin=4.0) * 0.02
    result = fill_with(("rigid", {}), punched(points, [GAP]), [GAP])
    assert not set(result.notes[GAP]["donors"]) <= {"M1", "M2", "M3", "M4"}
    assert rms(result.patches[0].values, truth_of(points, GAP)) < 5


def refused(method, recording, **params):
    result = fill_with((method, params), recording, [GAP])
    assert not result.patches
    (unfilled,) = result.unfilled
    return unfilled.reason


@pytest.mark.parametrize("method", ["rigid", "pattern", "local-frame", "auto"])
def test_donors_that_cannot_help_are_named(method):
    points = punch(body(200, 6), [GAP, Gap(2, 70, 72), Gap(4, 59, 60)])
    points[:, 5] = np.nan
    points[GAP.start - 1 : GAP.stop + 1, 5] = 0.0
    recording = record(points)
    twice = replace(recording, labels=("A", "B", "C", "D", "E", "B"))
    why = {
        "M9": "there is no marker M9 to take as a donor",
        "M1,M0": "M0 cannot be its own donor",
        "M1,M2": "the donor M2 is missing in the gap too",
        "M1,M5": "the marker and its donor M5 are hardly ever seen together",
    }
    if method != "auto":
        why["M3,M4"] = "the donor M4 is missing at an edge of the gap"
    for donors, reason in why.items():
        assert refused(method, recording, donors=donors) == reason
    assert refused(method, twice, donors="B") == "2 markers are called B: it cannot be a donor"
    assert refused(method, recording, donors="m1") == "there is no marker m1 to take as a donor"


def test_too_few_donors_are_said():
    recording = punched(body(200, 6), [GAP])
    for method in ("rigid", "local-frame"):
        reason = refused(method, recording, donors="M1,M2")
        assert reason == "it takes 3 donors and was given 2"
    few = punched(body(200, 3), [GAP])
    lonely = punched(body(200, 1), [GAP])
    seen = "seen throughout the gap and at its edges, and it takes"
    assert refused("rigid", few) == f"only 2 of the markers are {seen} 3"
    assert refused("rigid", lonely) == f"no marker is {seen} 3"
    assert refused("pattern", lonely) == f"no marker is {seen} 1"


@pytest.mark.parametrize("method", ["rigid", "pattern", "local-frame", "auto"])
def test_a_marker_that_is_never_seen_stays_open(method):
    points = body(200, 6)
    points[:, 0] = np.nan
    gap = Gap(0, 0, 200)
    (unfilled,) = fill_with((method, {}), record(points), [gap]).unfilled
    assert unfilled.reason == "the marker is never seen in this recording"


def test_auto_without_donors_leaves_the_start_open():
    gap = Gap(0, 0, 20)
    (unfilled,) = fill_with(("auto", {}), punched(body(200, 1), [gap]), [gap]).unfilled
    assert unfilled.reason == (
        "it is at the beginning or the end, and no other marker is seen throughout"
    )


def test_a_marker_that_is_hardly_seen_with_its_donors_stays_open():
    points = body(200, 6)
    points[GAP.stop + 1 :, 0] = np.nan
    points[: GAP.start - 1, 0] = np.nan
    points[GAP.start - 1, 1:] = np.nan
    reason = refused("auto", punched(points, [GAP]), donors="M1,M2,M3")
    assert "hardly ever seen together" in reason
