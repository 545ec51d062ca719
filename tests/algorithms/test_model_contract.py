"""What every method promises that looks at other markers, whatever the recording."""

from dataclasses import replace

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
from synthetic import MODEL_VARIANTS, bending_body, broken_recordings, fill_with, punch, record

from mocapmend_algorithms import Gap, find_gaps
from mocapmend_algorithms.fill.registry import METHODS, parse_params

EVERY = pytest.mark.parametrize("variant", MODEL_VARIANTS, ids=str)
MEETING = [v for v in MODEL_VARIANTS if v[1].get("meet_edges") != "false"]
MILLIMETRES = ("weight_scale_mm", "noise_mm")
"""Parameters that are lengths."""
GAPS = [Gap(0, 40, 55), Gap(1, 90, 93), Gap(2, 90, 100), Gap(3, 0, 12), Gap(4, 190, 200)]


@st.composite
def broken_bodies(draw):
    """Recordings of some markers with missing runs that start and end anywhere."""
    frames, markers = draw(st.integers(20, 120)), draw(st.integers(4, 9))
    points = bending_body(frames, markers, seed=draw(st.integers(0, 1000)))
    points *= draw(st.sampled_from([0.0, 1e-3, 1.0, 1e3]))
    points += draw(st.sampled_from([0.0, 1e6]))
    for _ in range(draw(st.integers(1, 6))):
        start = draw(st.integers(0, frames - 1))
        length = draw(st.integers(1, frames // 2))
        points[start : start + length, draw(st.integers(0, markers - 1))] = np.nan
    return record(points, rate=draw(st.sampled_from([50.0, 120.0])))


@EVERY
@settings(max_examples=60)
@given(recording=st.one_of(broken_bodies(), broken_recordings()))
def test_fills_only_what_it_is_given(variant, recording):
    check_fills_only_what_it_is_given(variant, recording)


@EVERY
@settings(max_examples=15)
@given(recording=broken_bodies(), data=st.data())
def test_is_deterministic_and_each_gap_stands_alone(variant, recording, data):
    gaps = find_gaps(recording.present)
    some = [gap for gap in gaps if data.draw(st.booleans())]
    check_each_gap_stands_alone(variant, recording, gaps, some)


@EVERY
def test_the_same_input_gives_the_same_bytes(variant):
    recording = record(punch(bending_body(200, 9), GAPS))
    first, second = (fill_with(variant, recording, GAPS).patches for _ in range(2))
    assert len(first) == len(GAPS)
    for patch, same in zip(first, second, strict=True):
        assert patch.values.tobytes() == same.values.tobytes()
        assert patch.r90.tobytes() == same.r90.tobytes()


@EVERY
@pytest.mark.parametrize("points", [0, 1, 2])
def test_survives_almost_empty_recordings(variant, points):
    coordinates = np.full((3, 5, 3), np.nan)
    coordinates[1 : 1 + points, 0] = 5.0
    recording = record(coordinates)
    assert not fill_with(variant, recording, find_gaps(recording.present)).patches
    assert fill_with(variant, recording, []).patches == ()


@EVERY
@pytest.mark.parametrize("markers", [1, 2, 3])
def test_refuses_where_too_few_markers_help(variant, markers):
    gap = Gap(0, 50, 60)
    recording = record(punch(bending_body(100, markers), [gap]))
    result = fill_with(variant, recording, [gap])
    (left,) = result.unfilled
    assert "other markers" in left.reason


@EVERY
def test_refuses_where_too_few_frames_are_complete(variant):
    points = bending_body(100, 8)
    points[9:, 0] = np.nan
    recording = record(points)
    result = fill_with(variant, recording, [Gap(0, 9, 100)])
    assert "only 9 frames show the marker" in result.unfilled[0].reason


@EVERY
def test_reports_progress_and_lets_itself_be_cancelled(variant):
    recording = record(punch(bending_body(200, 9), GAPS))
    check_progress_and_cancel(variant, recording, GAPS)


@EVERY
def test_never_looks_into_a_gap_that_it_is_given(variant):
    points = bending_body(200, 9)
    hidden = fill_with(variant, record(punch(points, GAPS)), GAPS).patches
    for gap in GAPS:
        points[gap.start : gap.stop, gap.marker] += 100.0
    for patch, same in zip(fill_with(variant, record(points), GAPS).patches, hidden, strict=True):
        check_same_bytes(patch, same)


@EVERY
def test_moves_with_the_recording(variant):
    points = punch(bending_body(200, 9), GAPS)
    here = fill_with(variant, record(points), GAPS)
    moved = replace(record(2 * points[:, :, [2, 0, 1]] + [300.0, -20.0, 7.0]), up="+x")
    here_params = vars(parse_params(METHODS[variant[0]], variant[1]))
    doubled = variant[1] | {
        name: str(2 * here_params[name]) for name in MILLIMETRES if name in here_params
    }
    there = fill_with((variant[0], doubled), moved, GAPS)
    for a, b in zip(here.patches, there.patches, strict=True):
        expected = 2 * a.values[:, [2, 0, 1]] + [300, -20, 7]
        np.testing.assert_allclose(b.values, expected, rtol=1e-5, atol=1e-3)
        np.testing.assert_allclose(b.sigma, 2 * a.sigma, rtol=1e-3, atol=1e-3)
        np.testing.assert_allclose(b.r90, 2 * a.r90, rtol=1e-3, atol=1e-3)


@EVERY
def test_the_unit_of_length_does_not_matter(variant):
    points = punch(bending_body(200, 9), GAPS)
    millimetres = fill_with(variant, record(points), GAPS)
    metres = fill_with(variant, record(points / 1000, unit="m"), GAPS)
    for a, b in zip(millimetres.patches, metres.patches, strict=True):
        np.testing.assert_allclose(b.values * 1000, a.values, rtol=1e-6, atol=1e-4)
        np.testing.assert_allclose(b.r90 * 1000, a.r90, rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize("variant", MEETING, ids=str)
def test_meets_the_samples_beside_the_gap(variant):
    rate = 1000.0
    points = bending_body(800, 9, rate=rate)
    points[:, 0] += 30.0 * np.sin(np.arange(800) / 300)[:, None]
    gaps = [Gap(0, 300, 500), Gap(1, 0, 150), Gap(2, 700, 800)]
    step = 3 * np.abs(np.diff(points, axis=0)).max()
    for patch in fill_with(variant, record(punch(points, gaps), rate=rate), gaps).patches:
        own, gap = points[:, patch.gap.marker], patch.gap
        if gap.start > 0:
            assert np.abs(patch.values[0] - own[gap.start - 1]).max() < step
        if gap.stop < 800:
            assert np.abs(patch.values[-1] - own[gap.stop]).max() < step


@EVERY
def test_the_edges_of_a_recording_are_filled_or_left_as_the_user_wishes(variant):
    points = punch(bending_body(200, 9), GAPS)
    points[:, 8] = np.nan
    recording = record(points)
    gaps = find_gaps(recording.present)
    result = fill_with(variant, recording, gaps)
    assert [p.gap for p in result.patches] == GAPS
    assert [u.reason for u in result.unfilled] == ["the marker is never seen in this recording"]
    left = fill_with((variant[0], variant[1] | {"edges": "leave"}), recording, gaps)
    assert [u.reason for u in left.unfilled] == [
        "the gap lies at the beginning of the recording, and such gaps are to be left open",
        "the gap lies at the end of the recording, and such gaps are to be left open",
        "the marker is never seen in this recording",
    ]
