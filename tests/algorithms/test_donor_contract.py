"""What the methods that look at other markers promise beyond what all do."""

import numpy as np
import pytest
from donor_samples import (
    GAPS,
    body,
    broken_bodies,
    jittery,
    punched,
    rms,
    scattered,
    truth_of,
    with_up,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from promises import (
    check_bands,
    check_same_bytes,
)
from scipy.spatial.transform import Rotation
from synthetic import DONOR_VARIANTS, fill_with, record

from mocapmend_algorithms import Gap, find_gaps
from mocapmend_algorithms.fill.model_params import LEFT_OPEN

EVERY = pytest.mark.parametrize("variant", DONOR_VARIANTS, ids=str)
DEFAULTS = ["rigid", "pattern", "local-frame", "auto"]
AXES = {"+x": [2, 0, 1], "-x": [2, 0, 1], "+y": [1, 2, 0]}


def patches(variant, recording, gaps=GAPS):
    filled = fill_with(variant, recording, gaps).patches
    assert [patch.gap for patch in filled] == list(gaps)
    return filled


@EVERY
@settings(max_examples=40)
@given(recording=broken_bodies(), data=st.data())
def test_fills_bodies_of_any_kind_each_gap_alone(variant, recording, data):
    before = recording.points.tobytes()
    gaps = find_gaps(recording.present)
    gaps = data.draw(st.permutations(gaps)) if len(gaps) <= 6 else gaps[:: len(gaps) // 6]
    result = fill_with(variant, recording, gaps)
    assert recording.points.tobytes() == before
    whole = {patch.gap: patch for patch in result.patches}
    assert {*whole, *(unfilled.gap for unfilled in result.unfilled)} == set(gaps)
    check_bands(result)
    some = [gap for gap in gaps if data.draw(st.booleans())]
    for patch in fill_with(variant, recording, some[::-1]).patches:
        check_same_bytes(patch, whole[patch.gap])


@EVERY
def test_each_gap_stands_alone_where_a_third_is_missing(variant):
    recording = record(scattered(jittery(body(400, 12)), 0.3))
    gaps = [gap for gap in find_gaps(recording.present) if gap.length > 8][::6]
    whole = fill_with(variant, recording, gaps)
    assert len(whole.patches) >= (5 if variant[0] == "auto" else 1) or "donors" in variant[1]
    for patch in whole.patches:
        (alone,) = patches(variant, recording, [patch.gap])
        check_same_bytes(alone, patch)


@EVERY
def test_never_looks_into_a_gap_that_it_is_given(variant):
    points = jittery(body(240, 8))
    hidden = patches(variant, punched(points))
    for gap in GAPS:
        points[gap.start : gap.stop, gap.marker] += 100.0
    for patch, same in zip(patches(variant, record(points)), hidden, strict=True):
        check_same_bytes(patch, same)


@EVERY
def test_moves_and_turns_with_the_recording(variant):
    points = jittery(body(240, 8))
    here = patches(variant, punched(points))
    turn = Rotation.from_euler("z", 130, degrees=True).as_matrix()
    shift = np.array([3000.0, -200.0, 7.0])
    there = patches(variant, punched(points @ turn.T + shift))
    for a, b in zip(here, there, strict=True):
        np.testing.assert_allclose(b.values, a.values @ turn.T + shift, atol=1e-5)
        np.testing.assert_allclose(b.sigma, a.sigma, rtol=1e-5)
        np.testing.assert_allclose(b.r90, a.r90, rtol=1e-5)


@EVERY
@pytest.mark.parametrize("up", AXES)
def test_knows_which_way_is_up(variant, up):
    points = jittery(body(240, 8))
    here = patches(variant, punched(points))
    there = points[:, :, AXES[up]]
    if up == "-x":
        there = there * [-1, -1, 1]
    for a, b in zip(here, patches(variant, with_up(punched(there), up)), strict=True):
        expected = a.values[:, AXES[up]] * ([-1, -1, 1] if up == "-x" else 1)
        np.testing.assert_allclose(b.values, expected, atol=1e-5)
        np.testing.assert_allclose(b.r90, a.r90, rtol=1e-5)


def test_auto_sees_gravity_and_the_others_do_not():
    recording = punched(jittery(body(240, 8)))
    for name in DEFAULTS:
        pairs = zip(
            patches((name, {}), recording),
            patches((name, {}), with_up(recording, "+x")),
            strict=True,
        )
        same = all(a.values.tobytes() == b.values.tobytes() for a, b in pairs)
        assert same == (name != "auto")


@EVERY
@pytest.mark.parametrize(("unit", "mm"), [("m", 1000), ("cm", 10), ("in", 25.4)])
def test_the_unit_of_length_does_not_matter(variant, unit, mm):
    points = jittery(body(240, 8))
    millimetres = patches(variant, punched(points))
    others = patches(variant, punched(points / mm, unit=unit))
    for a, b in zip(millimetres, others, strict=True):
        np.testing.assert_allclose(b.values * mm, a.values, atol=1e-5)
        np.testing.assert_allclose(b.sigma * mm, a.sigma, rtol=1e-5)
        np.testing.assert_allclose(b.r90 * mm, a.r90, rtol=1e-5)


@pytest.mark.parametrize("name", DEFAULTS)
@pytest.mark.parametrize("offset", [0.0, 1e6])
@settings(max_examples=10)
@given(seed=st.integers(0, 1000), start=st.integers(0, 199), length=st.integers(1, 60))
def test_recovers_rigid_motion(name, offset, seed, start, length):
    # A pattern does not turn: its marker is found again where the body does not.
    points = body(200, 8, seed=seed, skin=0.0, turn=float(name != "pattern")) + offset
    gap = Gap(0, start, min(start + length, 200))
    (patch,) = patches((name, {}), punched(points, [gap]), [gap])
    most = 1e-6 if name in ("rigid", "pattern") else 0.3
    assert rms(patch.values, truth_of(points, gap)) < most


@EVERY
@pytest.mark.parametrize(("start", "stop"), [(0, 40), (190, 240)])
def test_the_start_and_the_end_are_filled_where_asked(variant, start, stop):
    points = jittery(body(240, 8))
    gap = Gap(0, start, stop)
    result = fill_with(variant, punched(points, [gap]), [gap])
    if variant[1].get("edges") == "leave":
        assert [unfilled.reason for unfilled in result.unfilled] == [LEFT_OPEN]
        return
    (patch,) = result.patches
    # Beside the body's turns and travels, of some 500 mm.
    most = 200.0 if variant[0] == "pattern" else 15.0
    assert rms(patch.values, truth_of(points, gap)) < most
    # The sample beside a gap is known, so that the fill beside it is surer than that far away.
    inner, outer = (-1, 0) if start == 0 else (0, -1)
    assert patch.r90[inner] < patch.r90[outer]


@EVERY
def test_meets_the_samples_at_both_edges(variant):
    points = body(800, 8, rate=1000.0)
    gap = Gap(0, 300, 500)
    (patch,) = patches(variant, punched(points, [gap], rate=1000.0), [gap])
    # At 1000 frames per second no marker goes further than this in a frame.
    step = 3 * np.abs(np.diff(points[:, 0], axis=0)).max()
    assert np.abs(patch.values[0] - points[299, 0]).max() < step
    assert np.abs(patch.values[-1] - points[500, 0]).max() < step


@pytest.mark.parametrize("name", DEFAULTS)
def test_says_whose_motion_it_was_computed_from(name):
    recording = punched(jittery(body(240, 8)))
    for gap, notes in fill_with((name, {}), recording, GAPS).notes.items():
        assert 1 <= len(notes["donors"]) <= 4
        assert set(notes["donors"]) <= set(recording.labels) - {recording.labels[gap.marker]}
    named = fill_with((name, {"donors": "M5,M6,M7"}), recording, GAPS)
    assert all(set(notes["donors"]) <= {"M5", "M6", "M7"} for notes in named.notes.values())


@pytest.mark.parametrize("name", DEFAULTS)
def test_the_band_holds_about_nine_tenths(name):
    points = jittery(body(1500, 10, seed=4))
    inside = []
    for start in range(60, 1400, 60):
        gap = Gap(start % 10, start, start + 40)
        (patch,) = patches((name, {}), punched(points, [gap]), [gap])
        error = np.linalg.norm(patch.values - truth_of(points, gap), axis=1)
        inside.append(np.mean(error <= patch.r90))
    assert 0.8 < np.mean(inside) <= 1.0
