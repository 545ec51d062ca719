"""Segments of rigid markers, their tree, and who moves with whom."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import record

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.skeleton import (
    Segment,
    find_segments,
    measure_distances,
    segment_mates,
    skeleton_from_distances,
)
from mocapmend_algorithms.skeleton.segments import looseness

SIZE = 4


def turning(angle, axis):
    """Rotations about one of the axes; shape (frames, 3, 3)."""
    turn = np.tile(np.eye(3), (angle.size, 1, 1))
    a, b = (axis + 1) % 3, (axis + 2) % 3
    turn[:, a, a] = turn[:, b, b] = np.cos(angle)
    turn[:, b, a], turn[:, a, b] = np.sin(angle), -np.sin(angle)
    return turn


def chain(segments, frames, rng, *, noise=0.5):
    """A chain of segments of four markers that bend at their joints; (frames, markers, 3)."""
    joint = np.cumsum(rng.normal(0, 5, (frames, 3)), axis=0)
    rotation = np.tile(np.eye(3), (frames, 1, 1))
    points = []
    for number in range(segments):
        bend = 0.9 * np.sin(np.arange(frames) / rng.uniform(20, 40) + rng.uniform(0, 6))
        rotation = rotation @ turning(bend, number % 2)
        along = np.array([0.0, 0.0, 300.0])
        body = along * np.linspace(0.15, 0.85, SIZE)[:, None] + rng.normal(0, 40, (SIZE, 3))
        points.append(joint[:, None] + body @ rotation.swapaxes(1, 2))
        joint = joint + along @ rotation.swapaxes(1, 2)
    whole = np.concatenate(points, axis=1)
    return whole + rng.normal(0, noise, whole.shape)


@settings(max_examples=15)
@given(seed=st.integers(0, 1000), missing=st.sampled_from([0.0, 0.4]))
def test_the_segments_of_a_chain_are_found_in_any_order(seed, missing):
    rng = np.random.default_rng(seed)
    points = chain(4, 700, rng)
    order = rng.permutation(4 * SIZE)
    points = points[:, order]
    points[rng.random(points.shape[:2]) < missing] = np.nan
    skeleton = skeleton_from_distances(record(points), no_progress)
    found = {frozenset(order[list(part.markers)].tolist()) for part in skeleton.segments}
    assert found == {frozenset(range(SIZE * n, SIZE * n + SIZE)) for n in range(4)}
    markers = [marker for part in skeleton.segments for marker in part.markers]
    assert sorted(markers) == list(range(4 * SIZE))


def test_neighbouring_segments_are_joined_by_one_bone():
    skeleton = skeleton_from_distances(record(chain(5, 900, np.random.default_rng(1))), no_progress)
    between = [(a // SIZE, b // SIZE) for a, b in skeleton.bones if a // SIZE != b // SIZE]
    assert sorted(between) == [(0, 1), (1, 2), (2, 3), (3, 4)]
    for part in skeleton.segments:
        inside = [pair for pair in skeleton.bones if set(pair) <= set(part.markers)]
        assert len(inside) >= SIZE - 1
        assert {end for pair in inside for end in pair} == set(part.markers)


def test_distances_and_their_spread():
    rng = np.random.default_rng(2)
    apart = 100 + rng.normal(0, 2, 1500)
    points = np.zeros((1500, 3, 3))
    points[:, 1, 0] = apart
    points[:, 2] = np.nan
    points[:5, 2] = 7.0
    for unit, factor in (("mm", 1.0), ("m", 0.001)):
        distances = measure_distances(record(points * factor, unit=unit), no_progress)
        assert distances.length[0, 1] == distances.length[1, 0] == pytest.approx(100, abs=0.5)
        assert distances.spread[0, 1] == pytest.approx(2, rel=0.15)
        # Of the frames looked at, one has the third marker.
        assert not distances.known[2].any()
        assert [part.markers for part in find_segments(distances)] == [(0, 1)]


def test_how_rigid_is_rigid():
    place = np.sin(np.arange(400.0))
    points = np.zeros((400, 5, 3))
    # The spread of a sine is about 0.6 of its size.
    points[:, 1, 0] = 50 + 6 * place
    points[:, 2, 1] = 50 + 12 * place
    points[:, 3, 2] = 250 + 12 * place
    points[:, 4, 2] = -900 + 12 * place
    distances = measure_distances(record(points), no_progress)
    share = looseness(distances)[0]
    allowed = [0.08 * 50, 0.08 * 50, 10.0, 10.0 / 3]
    np.testing.assert_allclose(share[1:], distances.spread[0, 1:] / allowed, rtol=0.05)
    np.testing.assert_array_equal(share <= 1, [True, True, False, True, False])


def test_markers_without_motion_are_one_segment():
    points = np.tile(np.random.default_rng(3).normal(0, 300, (9, 3)), (200, 1, 1))
    points[:, 8] = points[:, 7]
    skeleton = skeleton_from_distances(record(points), no_progress)
    assert skeleton.segments == (Segment(tuple(range(9))),)
    assert {end for pair in skeleton.bones for end in pair} == set(range(9))


def test_pieces_of_one_trajectory_are_not_one_segment():
    points = chain(2, 600, np.random.default_rng(4))
    points = np.concatenate((points, points[:, :1]), axis=1)
    points[300:, 0] = np.nan
    points[:300, -1] = np.nan
    skeleton = skeleton_from_distances(record(points), no_progress)
    assert all(not {0, 2 * SIZE} <= set(part.markers) for part in skeleton.segments)


def test_mates_are_the_segment_ordered_by_spread():
    rng = np.random.default_rng(5)
    points = chain(2, 600, rng, noise=0.0)
    points += rng.normal(0, 1, points.shape) * np.array([1, 4, 2, 3, 1, 1, 1, 1])[:, None] * 0.3
    points[:, 5] = np.nan
    distances = measure_distances(record(points), no_progress)
    segments = find_segments(distances)
    mates = segment_mates(distances, segments)
    assert [mate.marker for mate in mates[0]] == [2, 3, 1]
    spreads = [mate.spread for mate in mates[0]]
    assert spreads == sorted(spreads)
    assert mates[0][0].length == distances.length[0, 2]
    assert {mate.marker for mate in mates[4]} == {6, 7}
    assert 5 not in mates
    named = segment_mates(distances, [Segment((0, 5, 6), "arm")])
    assert [mate.marker for mate in named[0]] == [6]


@pytest.mark.shared
@pytest.mark.parametrize("name", ["135_07", "132_32", "143_22", "127_07"])
def test_the_segments_of_real_recordings_are_anatomical(shared, name):
    data = np.load(shared / "cmu_markers" / f"{name}.npz")
    names = data["names"].tolist()
    skeleton = skeleton_from_distances(
        record(data["pos"].astype(np.float64), rate=120.0), no_progress
    )
    found = [{names[marker] for marker in part.markers} for part in skeleton.segments]

    def together(labels):
        return any(set(labels.split()) <= part for part in found)

    assert together("LFWT RFWT LBWT RBWT")
    assert together("LFHD RFHD NOSE ANT" if "NOSE" in names else "LFHD RFHD LBHD RBHD")
    assert together("LWRA LWRB")
    assert together("RFRM RWRA RWRB")
    for side in "LR":
        assert not together(f"{side}THI {side}HEE")
        assert not together(f"{side}UPA {side}WRA")
        assert not together(f"{side}FHD {side}FWT")
    assert 11 <= len(found) <= 18
    tree = {frozenset(pair) for pair in skeleton.bones}
    piece = {0}
    for _ in names:
        piece |= {end for pair in tree if piece & pair for end in pair}
    assert piece == set(range(len(names)))
