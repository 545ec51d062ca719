"""Calibration by paired recordings: constant errors go, wherever the body faces."""

import numpy as np
from refine_samples import PROFILE, model, move, sensor, turned

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.refine.calibrating import corrected, facing, mean_error
from mocapmend_algorithms.refine.preparing import prepare
from mocapmend_algorithms.refine.refining import RefineParams, refine

ASIDE = np.random.default_rng(0).normal(0, 30, (6, 3))


def test_a_turning_body_is_followed() -> None:
    joints, _ = move(600, 60.0)
    angles = np.linspace(0, 1.5, 600)
    spun = np.stack([turned(one, angle) for one, angle in zip(joints, angles, strict=True)])
    found = facing(spun - spun[:, :1], PROFILE)
    np.testing.assert_allclose(found[60:-60], angles[60:-60], atol=0.01)


def test_what_is_always_wrong_is_taken_away() -> None:
    joints, markers = move(300, 60.0)
    errors, seen = [], []
    for heading in (0.0, 1.0, -2.5):
        body, truth = (turned(one, heading) for one in (joints, markers))
        seen.append((body - body[:, :1], truth))
        errors.append(truth + turned(np.broadcast_to(ASIDE, truth.shape), heading))
    truths = [truth.copy() for _, truth in seen]
    truths[1][:, 4] = np.nan
    found = mean_error([body for body, _ in seen], errors, truths, PROFILE)
    np.testing.assert_allclose(found, ASIDE, atol=1e-9)
    for (body, truth), wrong in zip(seen, errors, strict=True):
        np.testing.assert_allclose(corrected(body, wrong, found, PROFILE), truth, atol=1e-8)


def test_a_marker_without_truth_stays() -> None:
    joints, markers = move(100, 60.0)
    truth = markers.copy()
    truth[:, 2] = np.nan
    found = mean_error([joints], [markers + ASIDE], [truth], PROFILE)
    assert (found[2] == 0).all()


def test_a_recording_is_refined_with_its_mean_error_taken_away() -> None:
    joints, _ = move(200, 60.0)
    recording = sensor(joints, 60.0)
    plain = refine(recording, model(), RefineParams(), no_progress)
    better = refine(recording, model(), RefineParams(), no_progress, ASIDE)
    own = prepare(recording, PROFILE).joints
    np.testing.assert_allclose(better.poses, corrected(own, plain.poses, ASIDE, PROFILE))
