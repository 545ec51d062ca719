"""What whole-recording fills say of their errors."""

import numpy as np
import pytest
from known_errors import Liar, constant_error, recurring_body
from synthetic import bending_body, punch, record

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.contract import FillResult, Unfilled
from mocapmend_algorithms.fill.punch_bands import fill_with_bands


@pytest.fixture
def points():
    return recurring_body()


def test_a_constant_error_is_measured():
    points = np.tile(bending_body(1, 6), (600, 1, 1))
    gaps = [Gap(1, 200, 220), Gap(3, 210, 240), Gap(4, 0, 15)]
    fill = Liar(points, constant_error)
    result = fill_with_bands(record(punch(points, gaps)), gaps, fill, no_progress)
    assert [p.gap for p in result.patches] == gaps
    for patch in result.patches:
        np.testing.assert_allclose(patch.sigma, 2.0, rtol=1e-6)
        np.testing.assert_allclose(patch.r90, np.sqrt(12), rtol=1e-6)
        notes = result.notes[patch.gap]
        assert notes.pop("self_tests") > 10
        assert notes == {"tested_frames": patch.gap.length, "helpers": 7}


def test_gaps_too_long_for_the_recording_are_tested_with_shorter_ones(points):
    gaps = [Gap(1, 100, 500)]
    result = fill_with_bands(
        record(punch(points, gaps)), gaps, Liar(points, constant_error), no_progress
    )
    (notes,) = result.notes.values()
    assert 0 < notes["tested_frames"] < 100
    # Errors of longer gaps are larger: what shorter ones show is not all.
    assert (result.patches[0].sigma > 2.0).all()


def test_nothing_is_said_where_nothing_can_be_tested():
    points = bending_body(12, 6)
    gaps = [Gap(1, 1, 11)]
    result = fill_with_bands(
        record(punch(points, gaps)), gaps, Liar(points, constant_error), no_progress
    )
    assert np.isnan(result.patches[0].sigma).all()
    assert np.isnan(result.patches[0].r90).all()
    assert result.notes[gaps[0]]["self_tests"] == 0


def test_what_the_fill_leaves_open_stays_open(points):
    gap = Gap(1, 100, 110)
    refused = FillResult((), (Unfilled(gap, "no"),))
    result = fill_with_bands(record(punch(points, [gap])), [gap], lambda *_: refused, no_progress)
    assert result.unfilled == refused.unfilled
    assert not result.notes


def test_postures_that_are_new_count_less_for_what_has_learned_elsewhere(points):
    points[100:120, 2:, 0] += 400.0 * np.arange(4)
    strange, usual = Gap(0, 105, 115), Gap(0, 300, 310)
    recording = record(punch(points, [strange, usual]))
    radii = {}
    for taught in (False, True):
        fill = Liar(points, constant_error)
        result = fill_with_bands(recording, [strange, usual], fill, no_progress, taught=taught)
        radii[taught] = [np.median(patch.r90) for patch in result.patches]
    surprise = [known / usually for known, usually in radii.values()]
    assert surprise[0] > 4
    assert surprise[1] == pytest.approx(np.sqrt(surprise[0]), rel=0.3)
