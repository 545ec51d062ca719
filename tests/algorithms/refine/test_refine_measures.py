"""Errors of positions, bone lengths and smoothness, in closed form; alignment in time."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from refine_samples import PROFILE, move, turned
from scipy.spatial.transform import Rotation

from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.aligning import align_in_time
from mocapmend_algorithms.refine.comparing import compare
from mocapmend_algorithms.refine.measures import Errors, errors_of, pooled, second_differences
from mocapmend_algorithms.refine.preparing import RefineError
from mocapmend_algorithms.refine.profile import Profile, mirrored, root_track


def still(frames: int = 50) -> np.ndarray:
    return np.random.default_rng(0).normal(0, 300, (1, 6, 3)).repeat(frames, axis=0)


def test_nothing_is_wrong_with_the_truth() -> None:
    found = errors_of(still(), still(), PROFILE)
    assert (found.position, found.smoothness, found.frames) == (0.0, 0.0, 50)
    assert found.bones == pytest.approx(0, abs=1e-18)


def test_a_shift_is_wrong_in_position_alone() -> None:
    found = errors_of(np.add(still(), [3.0, 0.0, 4.0]), still(), PROFILE)
    assert found.position == pytest.approx(25 / 3)
    assert found.bones == pytest.approx(0, abs=1e-18)


def test_a_larger_body_is_wrong_in_its_bones() -> None:
    poses = still()
    lengths = [np.linalg.norm(poses[0, a] - poses[0, b]) for a, b in PROFILE.bones]
    found = errors_of(1.1 * poses, poses, PROFILE)
    assert found.bones == pytest.approx(np.mean(np.square(lengths)) / 100)


def test_a_zigzag_is_rough() -> None:
    poses = still(400)
    poses[::2, 2, 1] += 2.0
    # Second differences of 4 mm, of one coordinate of 18; the held ends differ a little.
    assert errors_of(poses, poses, PROFILE).smoothness == pytest.approx(16 / 18, rel=0.02)


def test_second_differences_hold_the_ends() -> None:
    line = np.arange(5.0)[:, None]
    assert second_differences(line)[:, 0].tolist() == [0, 1, 0, 0, 0, -1, 0]


def test_missing_truth_counts_for_nothing() -> None:
    truth = still()
    poses = truth + 1.0
    truth[10:20, 3] = np.nan
    truth[:, 5] = np.nan
    found = errors_of(poses, truth, PROFILE)
    assert found.position == pytest.approx(1.0)
    assert found.bones == pytest.approx(0, abs=1e-18)


def test_recordings_are_pooled_by_their_frames() -> None:
    parts = [Errors(1.0, 2.0, 3.0, 10), Errors(4.0, np.nan, 6.0, 30)]
    found = pooled(parts)
    assert (found.position, found.bones, found.smoothness) == pytest.approx((3.25, 2.0, 5.25))
    assert found.frames == 40


@given(st.integers(-55, 55), st.integers(0, 1000))
def test_lag_and_rotation_are_found(lag: int, seed: int) -> None:
    _, markers = move(240, 60.0, seed)
    poses = markers - root_track(markers, PROFILE.output_root)
    turn = Rotation.random(random_state=seed).as_matrix()
    recording = poses[-lag:] if lag < 0 else poses
    reference = (poses if lag < 0 else poses[lag:]) @ turn.T
    found = align_in_time(recording, reference)
    assert found.lag == lag
    np.testing.assert_allclose(found.rotation, turn, atol=1e-6)
    assert found.rms < 1e-6


def test_a_reference_in_other_axes_and_at_another_time_is_compared() -> None:
    _, markers = move(300, 60.0)
    poses = markers - root_track(markers, PROFILE.output_root)
    seen = turned(markers[20:], 1.2) / 10
    reference = Recording(np.ascontiguousarray(seen), PROFILE.outputs, 60.0, unit="cm")
    found = compare(np.add(poses, [0.0, 0.0, 5.0]), reference, PROFILE)
    assert found.alignment.lag == 20
    assert found.errors.frames == 280
    assert found.errors.position == pytest.approx(25 / 3, rel=1e-6)
    np.testing.assert_allclose(found.rms, 5.0, rtol=1e-6)
    assert found.truth.position == 0


def test_what_has_too_little_in_common_is_refused() -> None:
    _, markers = move(29, 60.0)
    with pytest.raises(RefineError, match="half a second"):
        compare(markers, Recording(markers, PROFILE.outputs, 60.0), PROFILE)
    with pytest.raises(RefineError, match="6 of 6 are not"):
        compare(markers, Recording(markers, tuple("abcdef"), 60.0), PROFILE)


def test_sides_are_told_by_labels() -> None:
    labels = ("LASI", "RASI", "C7", "RBAK", "LeftHand", "RightHand", "Handleft", "HandRight")
    assert mirrored((*labels, "Root")) == (1, 0, 2, -1, 5, 4, 7, 6, 8)


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"inputs": ()}, "inputs and outputs"),
        ({"outputs": ("A", "a", "B", "C", "D", "E")}, "twice"),
        ({"left": ()}, "as many"),
        ({"bones": ()}, "bones"),
        ({"bones": ((0, 6),)}, "does not have"),
        ({"bones": ((2, 2),)}, "itself"),
        ({"matches": ((5, 0),)}, "does not have"),
        ({"input_root": (-1,)}, "does not have"),
    ],
)
def test_profiles_that_contradict_themselves_are_refused(
    changes: dict[str, object], what: str
) -> None:
    with pytest.raises(ValueError, match=what):
        Profile(**{**vars(PROFILE), **changes})
