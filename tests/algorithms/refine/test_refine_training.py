"""Training: it learns, it is reproducible, and it can be broken off and gone on with."""

from dataclasses import replace

import numpy as np
import pytest
from refine_samples import PROFILE, move, sensor, turned

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.progress import Cancelled
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.refine.measures import errors_of
from mocapmend_algorithms.refine.model import Model
from mocapmend_algorithms.refine.preparing import RefineError, headings
from mocapmend_algorithms.refine.refining import refined_poses
from mocapmend_algorithms.refine.ridge import Ridge
from mocapmend_algorithms.refine.train.drawing import NO_CHANGES, Changes, Drawer
from mocapmend_algorithms.refine.train.pairs import Pair, make_pair
from mocapmend_algorithms.refine.train.settings import Settings

QUICK = Settings(stacks=1, width=16, first_width=16, first_rounds=2, rounds=3, batch=4)


def pairs(count: int = 2, frames: int = 240, noise: float = 5.0) -> list[Pair]:
    made = []
    for seed in range(count):
        joints, markers = move(frames // 2, 30.0, seed)
        truth = Recording(np.ascontiguousarray(markers), PROFILE.outputs, 30.0)
        identity = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
        known = (0.0, identity)
        recording = sensor(joints, noise=noise, seed=seed)
        made.append(make_pair(recording, truth, PROFILE, known, performer=seed, repetition=seed))
    return made


def training(settings: Settings, learnt: list[Pair]):
    loop = pytest.importorskip(
        "mocapmend_algorithms.refine.train.loop", reason="PyTorch is not installed"
    )
    return loop.Training(learnt, PROFILE, settings)


def trained(settings: Settings, learnt: list[Pair]) -> Model:
    course = training(settings, learnt)
    course.run(no_progress, lambda done: None)
    return Model(PROFILE, settings.shape(PROFILE), course.scaling, course.weights())


def test_a_network_learns_a_tiny_pair_by_heart() -> None:
    learnt = pairs(1, 150, noise=30.0)
    settings = replace(QUICK, width=24, first_width=24, rounds=250, step=1e-2, changes=NO_CHANGES)
    settings = replace(settings, latent=0.0)
    model = trained(settings, learnt)
    pair = learnt[0]
    made = errors_of(refined_poses(pair.joints, model, 60, no_progress), pair.markers, PROFILE)
    ridge = Ridge([pair.joints], [pair.markers], PROFILE)(pair.joints)
    assert made.position < 0.5 * errors_of(ridge, pair.markers, PROFILE).position


def test_both_stages_bring_the_loss_down() -> None:
    settings = replace(QUICK, first_rounds=20, rounds=20, step=1e-2, changes=NO_CHANGES)
    course = training(settings, pairs(3, noise=30.0))
    course.run(no_progress, lambda done: None)
    for stage in ("perceptual", "stack"):
        losses = [one.loss for one in course.curve if one.stage == stage]
        assert len(losses) == 20
        assert losses[-1] < 0.8 * losses[0]


def test_the_perceptual_autoencoder_rests_in_the_second_stage() -> None:
    course = training(replace(QUICK, projected=True), pairs())
    kept = {}

    def note(done) -> None:
        kept[len(done.curve)] = done.weights()["perceptual.encoder.dense.0.weight"]

    course.run(no_progress, note)
    assert (kept[1] != kept[2]).any()
    np.testing.assert_array_equal(kept[2], kept[5])


@pytest.mark.parametrize("stop", [1, 2, 3, 4])
def test_a_training_that_was_broken_off_ends_with_the_same_weights(stop: int) -> None:
    learnt = pairs()
    whole = training(QUICK, learnt)
    whole.run(no_progress, lambda done: None)
    first = training(QUICK, learnt)
    states = []

    def until(done) -> None:
        if len(done.curve) == stop:
            states.append(done.state())
            raise Cancelled

    with pytest.raises(Cancelled):
        first.run(no_progress, until)
    second = training(QUICK, learnt)
    second.resume(states[0])
    second.run(no_progress, lambda done: None)
    assert second.curve == whole.curve
    for name, array in whole.weights().items():
        np.testing.assert_array_equal(second.weights()[name], array)


def test_seeds_make_other_networks() -> None:
    quick = replace(QUICK, rounds=1, first_rounds=1)
    learnt = pairs()
    one, same, other = (
        trained(replace(quick, seed=seed), learnt).weights["stack.0.encoder.dense.0.weight"]
        for seed in (0, 0, 1)
    )
    np.testing.assert_array_equal(one, same)
    assert (one != other).any()


def test_states_of_other_networks_are_refused() -> None:
    learnt = pairs()
    state = training(QUICK, learnt).state()
    with pytest.raises(ValueError, match="another training"):
        training(replace(QUICK, width=8), learnt).resume(state)
    with pytest.raises(ValueError, match="another training"):
        training(QUICK, learnt).resume({"curve": []})


def test_without_pairs_nothing_can_be_learnt() -> None:
    with pytest.raises(ValueError, match="no pairs"):
        training(QUICK, [])


def test_windows_face_the_same_way_and_have_missing_truth_beyond_the_end() -> None:
    short = pairs(1, 100)[0]
    drawn = Drawer([short], PROFILE, NO_CHANGES).round(np.random.default_rng(0))
    assert drawn.joints.shape == (1, 120, 5, 3)
    np.testing.assert_allclose(headings(drawn.joints, PROFILE), 0, atol=1e-9)
    missing = np.isnan(drawn.markers).any(axis=(0, 2, 3))
    assert missing.tolist() == [False] * len(short.joints) + [True] * (120 - len(short.joints))


def test_a_mirror_exchanges_left_and_right() -> None:
    pair = pairs(1, 240, noise=0.0)[0]
    mirror = Changes(1.0, scale=0.0, turn=0.0, offset=0.0, mirror=True, hidden=0.0)
    found = Drawer([pair] * 8, PROFILE, mirror).round(np.random.default_rng(0))
    plain = Drawer([pair] * 8, PROFILE, NO_CHANGES).round(np.random.default_rng(0))
    flipped = ~np.isclose(found.joints, plain.joints).all(axis=(1, 2, 3))
    assert 0 < flipped.sum() < len(flipped)
    across = np.array([-1.0, 1, 1])
    swapped = plain.markers[flipped][:, :, [1, 0, 3, 2, 5, 4]] * across
    np.testing.assert_allclose(found.markers[flipped], swapped, atol=1e-6)
    swapped = plain.joints[flipped][:, :, [0, 2, 1, 4, 3]] * across
    np.testing.assert_allclose(found.joints[flipped], swapped, atol=1e-6)


def test_joints_that_hide_are_bridged_and_the_truth_stays() -> None:
    pair = pairs(1, 240)[0]
    hidden = Changes(1.0, scale=0.0, turn=0.0, offset=0.0, mirror=False, hidden=1.0)
    found = Drawer([pair], PROFILE, hidden).round(np.random.default_rng(1))
    plain = Drawer([pair], PROFILE, NO_CHANGES).round(np.random.default_rng(1))
    assert not np.isnan(found.joints).any()
    # Hidden hips turn the heading a little; lengths do not know of it.
    moved = np.linalg.norm(found.joints, axis=-1) - np.linalg.norm(plain.joints, axis=-1)
    assert (np.abs(moved[..., 1:]) > 1e-6).any(axis=1).all()
    np.testing.assert_allclose(
        np.linalg.norm(found.markers, axis=-1), np.linalg.norm(plain.markers, axis=-1)
    )


def test_pairs_in_other_axes_and_at_other_times_are_brought_together() -> None:
    joints, markers = move(200, 30.0)
    shifted = turned(markers[12:], 0.7)
    truth = Recording(np.ascontiguousarray(shifted), PROFILE.outputs, 30.0)
    found = make_pair(sensor(joints), truth, PROFILE)
    turn = np.array([[np.cos(0.7), -np.sin(0.7), 0], [np.sin(0.7), np.cos(0.7), 0], [0, 0, 1]])
    axes = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])
    known = make_pair(sensor(joints), truth, PROFILE, (0.4, turn @ axes))
    np.testing.assert_array_equal(found.joints, known.joints)
    # Hips are no markers of the pelvis: the best turn is not quite the true one.
    assert np.abs(found.markers - known.markers).max() < 80


def test_pairs_without_half_a_second_in_common_are_refused() -> None:
    joints, markers = move(60, 30.0)
    truth = Recording(np.ascontiguousarray(markers), PROFILE.outputs, 30.0)
    with pytest.raises(RefineError, match="half a second"):
        make_pair(sensor(joints), truth, PROFILE, (1.8, np.eye(3)))


def test_the_paper_s_settings_are_its_own() -> None:
    printed = Settings.printed()
    assert (printed.width, printed.first_width, printed.stacks) == (226, 128, 6)
    assert (printed.batch, printed.step, printed.dropout) == (16, 1e-5, 0.2)
    assert (printed.skip, printed.projected, printed.changes) == (False, True, NO_CHANGES)
    assert printed.bones == pytest.approx(3.48)
    assert printed.smoothness == pytest.approx(10.62)
