"""A network that has learnt from mirrored windows is asked about both."""

from dataclasses import replace

import numpy as np
from refine_samples import PROFILE, copying, model

from mocapmend_algorithms.refine.mirroring import SHARE, Mirror, poses_of
from mocapmend_algorithms.refine.profile import mirrored


def windows() -> np.ndarray:
    return np.random.default_rng(1).normal(0, 300, (3, 120, len(PROFILE.inputs), 3))


def test_a_mirror_exchanges_the_sides() -> None:
    poses = windows()
    seen = Mirror(PROFILE).joints(poses)
    for one, other in zip(PROFILE.left, PROFILE.right, strict=True):
        np.testing.assert_array_equal(seen[..., one, 0], -poses[..., other, 0])
        np.testing.assert_array_equal(seen[..., one, 1:], poses[..., other, 1:])
    np.testing.assert_array_equal(Mirror(PROFILE).joints(seen), poses)


def test_a_marker_without_a_partner_is_not_seen_in_the_mirror() -> None:
    alone = replace(PROFILE, outputs=(*PROFILE.outputs[:-1], "RBAK"))
    poses = np.ones((2, len(alone.outputs), 3))
    seen = Mirror(alone).markers(poses)
    without = np.array(mirrored(alone.outputs)) < 0
    assert without[-1]
    np.testing.assert_array_equal(np.isnan(seen).all(axis=(0, 2)), without)


def test_a_profile_without_partners_has_no_mirror() -> None:
    labels = (*PROFILE.inputs[:-1], "LeftOnly")
    assert Mirror(PROFILE).possible
    assert not Mirror(replace(PROFILE, inputs=labels)).possible


def test_what_knows_no_mirror_is_asked_once() -> None:
    once = model()
    np.testing.assert_array_equal(poses_of(once, windows()), once.outputs(windows())[-1])


def test_both_estimates_count() -> None:
    both = replace(model(), mirrored=True)
    mirror = Mirror(PROFILE)
    straight = both.outputs(windows())[-1]
    other = mirror.markers(both.outputs(mirror.joints(windows()))[-1])
    made = poses_of(both, windows())
    np.testing.assert_allclose(made, (1 - SHARE) * straight + SHARE * other, atol=1e-9)
    assert np.abs(made - straight).max() > 1


def test_a_symmetric_network_says_the_same_of_both() -> None:
    symmetric = replace(copying(), mirrored=True)
    np.testing.assert_allclose(
        poses_of(symmetric, windows()), symmetric.outputs(windows())[-1], atol=1e-3
    )


def test_a_marker_without_a_partner_is_as_the_window_itself_has_it() -> None:
    alone = replace(
        model(), profile=replace(PROFILE, outputs=(*PROFILE.outputs[:-1], "RBAK")), mirrored=True
    )
    made = poses_of(alone, windows())
    np.testing.assert_array_equal(made[..., -1, :], alone.outputs(windows())[-1][..., -1, :])
    assert np.isfinite(made).all()
