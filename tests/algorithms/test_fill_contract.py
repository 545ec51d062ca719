"""What every method promises, whatever the recording."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from promises import (
    check_each_gap_stands_alone,
    check_fills_only_what_it_is_given,
    check_progress_and_cancel,
    check_same_bytes,
)
from synthetic import (
    DONOR_VARIANTS,
    EDGE_TO_EDGE,
    FILLS_ANYTHING,
    LEAVES_EDGES,
    MILLIMETRES,
    MODEL_VARIANTS,
    VARIANTS,
    broken_recordings,
    fill_with,
    punch,
    record,
    smooth_motion,
)

from mocapmend_algorithms import Gap, find_gaps, no_progress
from mocapmend_algorithms.fill.registry import METHODS

EVERY = pytest.mark.parametrize("variant", [*VARIANTS, *DONOR_VARIANTS], ids=str)
FILLING = pytest.mark.parametrize("variant", FILLS_ANYTHING, ids=str)


@EVERY
@settings(max_examples=100)
@given(recording=broken_recordings())
def test_fills_only_what_it_is_given(variant, recording):
    for patch in check_fills_only_what_it_is_given(variant, recording).patches:
        assert patch.gap.kind(recording.frames) == "interior" or variant not in LEAVES_EDGES


@EVERY
@settings(max_examples=15)
@given(recording=broken_recordings(), data=st.data())
def test_is_deterministic_and_each_gap_stands_alone(variant, recording, data):
    gaps = find_gaps(recording.present)
    some = [gap for gap in gaps if data.draw(st.booleans())]
    check_each_gap_stands_alone(variant, recording, gaps, some)


@EVERY
@pytest.mark.parametrize("points", [0, 1, 2])
def test_survives_almost_empty_recordings(variant, points):
    coordinates = np.full((3, 2, 3), np.nan)
    coordinates[1 : 1 + points, 0] = 5.0
    recording = record(coordinates)
    result = fill_with(variant, recording, find_gaps(recording.present))
    assert not result.patches or variant not in LEAVES_EDGES
    assert fill_with(variant, recording, []).patches == ()


@EVERY
def test_reports_progress_and_lets_itself_be_cancelled(variant):
    gaps = [Gap(0, 30, 35), Gap(0, 60, 64), Gap(1, 50, 52)]
    recording = record(punch(smooth_motion(100, 2), gaps))
    check_progress_and_cancel(variant, recording, gaps)


@pytest.mark.parametrize("variant", [v for v in FILLS_ANYTHING if v[0] != "constant"], ids=str)
@settings(max_examples=25)
@given(
    seed=st.integers(0, 1000),
    offset=st.sampled_from([0.0, 1e6]),
    start=st.integers(6, 60),
    length=st.integers(1, 26),
)
def test_recovers_constant_velocity(variant, seed, offset, start, length):
    rng = np.random.default_rng(seed)
    points = rng.normal(0, 20, (2, 3)) * np.arange(100)[:, None, None] + offset
    gap = Gap(0, start, start + length)
    (patch,) = fill_with(variant, record(punch(points, [gap])), [gap]).patches
    np.testing.assert_allclose(
        patch.values, points[start : start + length, 0], atol=1e-9 * (2000 + offset)
    )


@pytest.mark.parametrize("variant", [v for v in FILLS_ANYTHING if v[0] != "kalman"], ids=str)
def test_far_edits_change_no_value(variant):
    # The filter is left out: what its automatic settings choose depends on the whole recording.
    points = smooth_motion(400, 1)
    gap = Gap(0, 200, 212)
    near = fill_with(variant, record(punch(points, [gap])), [gap]).patches[0].values
    points[:100] += 50
    points[320:] = np.nan
    far = fill_with(variant, record(punch(points, [gap])), [gap]).patches[0].values
    np.testing.assert_array_equal(far, near)


@FILLING
def test_never_looks_into_a_gap_that_it_is_given(variant):
    gaps = [Gap(0, 60, 75), Gap(0, 140, 150)]
    points = smooth_motion(240, 2)
    hidden = fill_with(variant, record(punch(points, gaps)), gaps).patches
    assert len(hidden) == len(gaps)
    points[60:75, 0] += 100.0
    for patch, same in zip(fill_with(variant, record(points), gaps).patches, hidden, strict=True):
        check_same_bytes(patch, same)


@FILLING
def test_moves_with_the_recording(variant):
    gaps = [Gap(0, 40, 55), Gap(1, 90, 93)]
    points = punch(smooth_motion(160, 2), gaps)
    here = fill_with(variant, record(points), gaps)
    moved = record(2 * points[:, :, [2, 0, 1]] + [300.0, -20.0, 7.0])
    doubled = (
        variant[0],
        {k: str(2 * float(v)) if k in MILLIMETRES else v for k, v in variant[1].items()},
    )
    there = fill_with(doubled, moved, gaps)
    assert len(here.patches) == len(gaps)
    for a, b in zip(here.patches, there.patches, strict=True):
        np.testing.assert_allclose(b.values, 2 * a.values[:, [2, 0, 1]] + [300, -20, 7], rtol=1e-7)
        np.testing.assert_allclose(b.sigma, 2 * a.sigma, rtol=1e-6)
        np.testing.assert_allclose(b.r90, 2 * a.r90, rtol=1e-6)


@FILLING
def test_the_unit_of_length_does_not_matter(variant):
    gaps = [Gap(0, 40, 55), Gap(1, 90, 93)]
    points = punch(smooth_motion(160, 2), gaps)
    millimetres = fill_with(variant, record(points), gaps)
    metres = fill_with(variant, record(points / 1000, unit="m"), gaps)
    for a, b in zip(millimetres.patches, metres.patches, strict=True):
        np.testing.assert_allclose(b.values * 1000, a.values, rtol=1e-7, atol=1e-7)
        np.testing.assert_allclose(b.r90 * 1000, a.r90, rtol=1e-6)


@pytest.mark.parametrize("variant", [*EDGE_TO_EDGE, ("kalman", {"noise_mm": "50"})], ids=str)
def test_meets_the_samples_at_both_edges(variant):
    rate, gap = 1000.0, Gap(0, 300, 500)
    points = smooth_motion(800, 1, rate=rate)
    recording = record(punch(points, [gap]), rate=rate)
    values = fill_with(variant, recording, [gap]).patches[0].values
    # At 1000 frames per second no marker goes further than this in a frame.
    step = 3 * np.abs(np.diff(points[:, 0], axis=0)).max()
    assert np.abs(values[0] - points[299, 0]).max() < step
    assert np.abs(values[-1] - points[500, 0]).max() < step


@pytest.mark.parametrize("variant", [v for v in LEAVES_EDGES if v in VARIANTS], ids=str)
def test_the_edges_of_a_recording_stay_open_and_say_why(variant):
    points = smooth_motion(60, 3)
    points[:12, 0] = np.nan
    points[50:, 1] = np.nan
    points[:, 2] = np.nan
    recording = record(points, first_frame=101)
    result = fill_with(variant, recording, find_gaps(recording.present))
    reasons = [unfilled.reason for unfilled in result.unfilled]
    assert reasons == [
        "the marker is never seen before frame 113: this method needs both sides",
        "the marker is never seen after frame 150: this method needs both sides",
        "the marker is never seen in this recording",
    ]


@pytest.mark.parametrize("variant", [v for v in VARIANTS if v[0] != "cyclic"], ids=str)
def test_crosses_other_gaps(variant):
    points = smooth_motion(80, 1)
    points[[30, 31, 33, 36, 38, 41, 45], 0] = np.nan
    recording = record(points)
    gaps = find_gaps(recording.present)
    assert [p.gap for p in fill_with(variant, recording, gaps).patches] == gaps


def test_never_reads_samples_inside_the_gaps():
    points = smooth_motion(120, 1)
    gap = Gap(0, 50, 60)
    hidden = fill_with(("cubic", {}), record(punch(points, [gap])), [gap]).patches[0]
    points[50:60] += 1000
    flagged = fill_with(("cubic", {}), record(points), [gap]).patches[0]
    np.testing.assert_array_equal(flagged.values, hidden.values)
    np.testing.assert_array_equal(flagged.sigma, hidden.sigma)


def test_no_method_is_missing_from_the_variants():
    every = VARIANTS + MODEL_VARIANTS + DONOR_VARIANTS
    assert {name for name, _ in every} == set(METHODS)


def test_scipy_interpolate_is_not_loaded_at_start():
    code = "import sys, mocapmend_algorithms.fill.limits; print('scipy.interpolate' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_no_progress_is_accepted():
    gap = Gap(0, 60, 65)
    wave = np.sin(np.arange(150) / 8)[:, None, None] * [[30.0, 40.0, 50.0]]
    recording = record(punch(wave, [gap]))
    for name in dict(VARIANTS):
        method = METHODS[name]
        assert method.function(recording, [gap], method.params(), no_progress).patches
