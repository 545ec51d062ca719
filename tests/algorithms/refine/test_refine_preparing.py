"""What is done before a network sees a recording is undone at the end."""

import numpy as np
import pytest
from refine_samples import PROFILE, copying, model, move, sensor, turned

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.progress import Cancelled
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.preparing import RefineError, at_rate, bridge_gaps, prepare
from mocapmend_algorithms.refine.refining import RefineParams, refine

PLAIN = RefineParams()
EDGE = 12
"""Frames at either end that the smoothing of the skip changes."""


def test_a_network_that_copies_gives_the_joints_back() -> None:
    joints, _ = move(200, 30.0)
    recording = sensor(joints)
    made = refine(recording, copying(), PLAIN, no_progress).recording
    assert made.labels == PROFILE.outputs
    assert (made.rate, made.unit, made.up, made.frames) == (30.0, "m", "+y", 200)
    expected = recording.points[:, [1, 2, 3, 4, 3, 4]]
    # The skip averages over a twelfth of a second: a few millimetres of a waving hand.
    np.testing.assert_allclose(made.points[EDGE:-EDGE], expected[EDGE:-EDGE], atol=0.006)


@pytest.mark.parametrize("angle", [0.4, 2.0, -3.0])
def test_the_heading_makes_no_difference(angle: float) -> None:
    joints, _ = move(150, 60.0)
    network = model()
    straight = refine(sensor(joints, 60.0), network, PLAIN, no_progress).recording
    aside = refine(sensor(turned(joints, angle), 60.0), network, PLAIN, no_progress).recording
    found = turned(straight.points[..., [2, 0, 1]], angle)[..., [1, 2, 0]]
    np.testing.assert_allclose(aside.points, found, atol=1e-5)


@pytest.mark.parametrize(("unit", "up"), [("mm", "+z"), ("cm", "+x"), ("in", "-y")])
def test_unit_and_axes_make_no_difference(unit: str, up: str) -> None:
    joints, _ = move(150, 60.0)
    network = model()
    plain = refine(Recording(joints, PROFILE.inputs, 60.0), network, PLAIN, no_progress)
    from mocapmend_algorithms.recording import MM_PER_UNIT
    from mocapmend_algorithms.sparse.training_set import turn_up

    turn = turn_up("+z", up)
    other = Recording(
        joints @ turn.T / MM_PER_UNIT[unit], PROFILE.inputs, 60.0, unit=unit, up=up, first_frame=7
    )
    made = refine(other, network, PLAIN, no_progress).recording
    assert made.first_frame == 7
    back = made.points * MM_PER_UNIT[unit] @ turn
    # A turn about another axis than the vertical may add a heading, which is undone.
    np.testing.assert_allclose(back, plain.recording.points, atol=1e-2)


def test_places_do_not_matter_and_other_points_neither() -> None:
    joints, _ = move(100, 30.0)
    order = [3, 0, 4, 2, 1]
    extra = np.concatenate([joints[:, order], joints[:, :1] + 5], axis=1)
    labels = (*(f"Anna:{PROFILE.inputs[at].lower()}" for at in order), "Chair")
    found = prepare(Recording(extra, labels, 30.0), PROFILE)
    expected = prepare(Recording(joints, PROFILE.inputs, 30.0), PROFILE)
    np.testing.assert_array_equal(found.joints, expected.joints)


def test_what_is_missing_is_bridged_and_told() -> None:
    joints, _ = move(120, 30.0)
    holed = joints.copy()
    holed[40:46, 3] = np.nan
    holed[:5, 4] = np.nan
    prepared = prepare(Recording(holed, PROFILE.inputs, 30.0), PROFILE)
    assert not np.isnan(prepared.joints).any()
    assert prepared.bridged.sum(axis=0).tolist() == [0, 0, 0, 6, 5]
    whole = prepare(Recording(joints, PROFILE.inputs, 30.0), PROFILE)
    assert np.abs(prepared.joints - whole.joints)[78:94, 3].max() < 5


def test_gaps_are_bridged_on_the_natural_spline_and_ends_hold() -> None:
    points = np.zeros((12, 1, 3))
    points[:, 0] = np.arange(12.0)[:, None]
    points[4:7] = np.nan
    points[10:] = np.nan
    bridge_gaps(points)
    np.testing.assert_allclose(points[4:7, 0, 0], [4, 5, 6], atol=1e-12)
    np.testing.assert_allclose(points[10:, 0, 0], 9, atol=1e-12)


def test_rates_are_changed_on_the_natural_spline() -> None:
    seconds = np.arange(31) / 30
    curve = np.sin(2 * np.pi * seconds)[:, None]
    fine = at_rate(curve, 30.0, 60.0)
    assert len(fine) == 61
    np.testing.assert_allclose(fine[::2], curve, atol=1e-12)
    np.testing.assert_allclose(fine[:, 0], np.sin(np.pi * np.arange(61) / 30), atol=1e-3)
    np.testing.assert_allclose(at_rate(fine, 60.0, 30.0, 33)[-3:], curve[[-1, -1, -1]], atol=1e-12)


@pytest.mark.parametrize("frames", [2, 5, 59, 61])
@pytest.mark.parametrize("stride", ["1", "60"])
def test_short_recordings_are_refined_too(frames: int, stride: str) -> None:
    joints, _ = move(frames, 30.0)
    made = refine(sensor(joints), model(), RefineParams(stride, 6.0), no_progress).recording
    assert made.points.shape == (frames, 6, 3)
    assert np.isfinite(made.points).all()


def test_the_output_filter_makes_the_outcome_smoother_and_keeps_its_place() -> None:
    joints, _ = move(300, 60.0)
    recording = sensor(joints, 60.0, noise=20.0)
    rough = refine(recording, copying(), PLAIN, no_progress)
    smooth = refine(recording, copying(), RefineParams(cutoff_hz=6.0), no_progress)
    bends = [np.mean(np.diff(one.poses, 2, axis=0) ** 2) for one in (rough, smooth)]
    assert bends[1] < 0.5 * bends[0]
    np.testing.assert_allclose(smooth.poses.mean(axis=0), rough.poses.mean(axis=0), atol=1.0)


def test_it_can_be_cancelled() -> None:
    def refuse(fraction: float) -> None:
        raise Cancelled

    joints, _ = move(3000, 60.0)
    with pytest.raises(Cancelled):
        refine(sensor(joints, 60.0), model(), PLAIN, refuse)


@pytest.mark.parametrize("cutoff", [0.0, -1.0, 30.0, np.nan])
def test_impossible_filters_are_refused(cutoff: float) -> None:
    joints, _ = move(100, 30.0)
    with pytest.raises(ValueError, match="cutoff_hz"):
        refine(sensor(joints), model(), RefineParams(cutoff_hz=cutoff), no_progress)


@pytest.mark.parametrize(
    ("labels", "what"),
    [
        (("Root", "LeftHip", "RightHip", "LeftHand", "Chair"), "1 of 5.*RightHand"),
        (("Root", "LeftHip", "RightHip", "LeftHand", "RightHand", "x:righthand"), "more than one"),
    ],
)
def test_other_joints_are_refused(labels: tuple[str, ...], what: str) -> None:
    points = np.zeros((50, len(labels), 3)) + np.arange(50)[:, None, None]
    with pytest.raises(RefineError, match=what):
        prepare(Recording(points, labels, 30.0), PROFILE)


def test_impossible_recordings_are_refused() -> None:
    joints, _ = move(50, 30.0)
    with pytest.raises(RefineError, match="too long: 50000 s"):
        prepare(Recording(joints, PROFILE.inputs, 1e-3), PROFILE)
    for far in (1e6, 1e30):
        wild = joints.copy()
        wild[20, 4] = far
        with pytest.raises(RefineError, match="RightHand is impossibly far"):
            prepare(Recording(wild, PROFILE.inputs, 30.0), PROFILE)


def test_a_joint_that_is_never_seen_is_refused() -> None:
    joints, _ = move(50, 30.0)
    joints[1:, 3] = np.nan
    with pytest.raises(RefineError, match="never seen: LeftHand"):
        prepare(Recording(joints, PROFILE.inputs, 30.0), PROFILE)
    with pytest.raises(RefineError, match="two frames"):
        prepare(Recording(joints[:1], PROFILE.inputs, 30.0), PROFILE)
