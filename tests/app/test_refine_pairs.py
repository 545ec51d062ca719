"""The packed pairs of UI-PRMD, the splits, and the model card."""

from pathlib import Path

import numpy as np
import pytest
from packed_pairs import TURN, write_packed
from refine_files import ASIDE, body, model_of, nearest

from mocapmend.errors import MocapmendError
from mocapmend.files.uiprmd import is_packed, read_packed
from mocapmend.refine.card import CAUTION, card_text
from mocapmend.refine.holding_out import NOTHING, SEEN, UNSEEN, HeldOut
from mocapmend.refine.measuring import FILTERED, NETWORK, RIDGE, measure
from mocapmend.refine.models import load_model, names
from mocapmend.refine.profiles import profile_named, profiles
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.refine.profile import Profile, root_track
from mocapmend_algorithms.refine.train.pairs import Pair


@pytest.fixture
def profile() -> Profile:
    """Return the profile of UI-PRMD."""
    return profile_named("kinect22-pig39")


def test_packed_pairs_are_unpacked_and_brought_together(tmp_path: Path, profile: Profile) -> None:
    path = write_packed(tmp_path / "pairs.npz", profile)
    assert is_packed(path)
    pairs = read_packed(path, profile)
    assert [(pair.performer, pair.repetition) for pair in pairs] == [
        (performer, repetition) for performer in (1, 2) for repetition in (1, 2, 3)
    ]
    joints, markers = body(profile, 700, seed=12)
    pair = pairs[5]
    # The Kinect is in its own axes, turned to z up.
    up = TURN @ [0.0, 1.0, 0.0]
    np.testing.assert_allclose(up, [0, 0, 1], atol=1e-9)
    expected = joints - joints[:, :1]
    lengths = np.linalg.norm(expected[4:80], axis=-1)
    np.testing.assert_allclose(
        np.linalg.norm(pair.joints[::2][: len(lengths)], axis=-1), lengths, atol=0.2
    )
    relative = markers - root_track(markers, profile.output_root)
    lengths = np.linalg.norm(relative[4:80], axis=-1)
    found = np.linalg.norm(pair.markers[::2][: len(lengths)], axis=-1)
    np.testing.assert_allclose(found, lengths, atol=1.0)
    # What lies near each other does so in the pair too: axes and times are the same.
    apart = pair.joints[:, nearest(profile)] - pair.markers
    assert np.ptp(apart - apart[:, :1], axis=0).max() < 0.1 * ASIDE


def test_packed_pairs_of_another_profile_are_refused(tmp_path: Path, profile: Profile) -> None:
    path = write_packed(tmp_path / "pairs.npz", profile, performers=1, repetitions=1)
    with pytest.raises(MocapmendError, match="for the profile kinect22-pig39"):
        read_packed(path, profile_named("kinect25-neuron59"))


@pytest.mark.parametrize("name", ["nk", "Kb0", "V0", "R", "keys"])
def test_damaged_pairs_are_refused(tmp_path: Path, profile: Profile, name: str) -> None:
    path = write_packed(tmp_path / "pairs.npz", profile, performers=1, repetitions=2)
    with np.load(path) as data:
        arrays = dict(data)
    arrays[name] = arrays[name][:1] if name != "Kb0" else arrays[name][:, :-1]
    np.savez(path, **arrays)
    with pytest.raises(MocapmendError, match="pairs cannot be read"):
        read_packed(path, profile)


def test_other_files_are_no_packed_pairs(tmp_path: Path) -> None:
    np.savez(tmp_path / "other.npz", keys=np.zeros(3))
    (tmp_path / "list.csv").write_text("recording,reference\n")
    for name in ("other.npz", "list.csv", "none.npz"):
        assert not is_packed(tmp_path / name)


def test_the_shared_pairs_are_those_of_the_manifest(shared: Path, profile: Profile) -> None:
    pairs = read_packed(shared / "kinect" / "uiprmd_kinect22_vicon39.npz", profile)
    assert len(pairs) == 1671
    learnt, rest = SEEN.split(pairs)
    assert (len(learnt), len(rest)) == (1169, 502)
    assert {pair.performer for pair in UNSEEN.split(pairs)[1]} == {8, 9, 10}
    assert all(np.isfinite(pair.joints).all() for pair in pairs)


def test_splits_hold_out_what_they_say() -> None:
    nothing = np.zeros((1, 1, 3))
    pairs = [Pair(nothing, nothing, performer=p, repetition=r) for p in (1, 2) for r in (1, 8)]
    for held_out, expected in (
        (NOTHING, []), (SEEN, [1, 3]), (HeldOut("performer", (2,)), [2, 3]),
    ):  # fmt: skip
        learnt, rest = held_out.split(pairs)
        assert [pairs.index(pair) for pair in rest] == expected
        assert len(learnt) + len(rest) == 4
    assert str(UNSEEN) == "performers 8, 9, 10"


def test_a_network_is_measured_beside_a_regression(tmp_path: Path, profile: Profile) -> None:
    pairs = read_packed(write_packed(tmp_path / "pairs.npz", profile), profile)
    learnt, rest = HeldOut("repetition", (3,)).split(pairs)
    model = measure(model_of(profile, copies=True), learnt, rest, no_progress)
    figures = model.card["figures"]
    assert list(figures) == [NETWORK, FILTERED, RIDGE]
    assert figures[FILTERED] != figures[NETWORK]
    # Markers are joints, a little aside: regression finds out.
    assert figures[RIDGE]["position_mm2"] < 0.5 * figures[NETWORK]["position_mm2"]
    text = card_text(model)
    assert CAUTION in text
    assert "Measured on pairs held out (2)" in text
    assert RIDGE in text


def test_profiles_are_of_their_sensors() -> None:
    sizes = {name: (len(one.inputs), len(one.outputs)) for name, one in profiles().items()}
    assert sizes == {"kinect22-pig39": (22, 39), "kinect25-neuron59": (25, 59)}
    for one in profiles().values():
        # A tree: as many bones as joints but one, and all hang together.
        assert len(one.bones) == len(one.outputs) - 1
        reached = {one.bones[0][0]}
        for _ in one.bones:
            reached |= {end for bone in one.bones if reached & set(bone) for end in bone}
        assert len(reached) == len(one.outputs)
    with pytest.raises(MocapmendError, match="no such profile"):
        profile_named("kinect")


@pytest.mark.parametrize("name", names())
def test_networks_that_ship_are_small_and_have_a_card(name: str) -> None:
    from mocapmend.refine.models import path_of

    assert path_of(name).stat().st_size <= 8_000_000
    model = load_model(name)
    assert model.profile == profile_named(model.profile.id)
    for key in ("about", "data", "command", "held_out", "figures", "curve", "pairs"):
        assert model.card[key]
