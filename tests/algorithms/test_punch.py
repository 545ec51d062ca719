"""Self-tests of whole-recording fills: where they punch, what they compare, what they say."""

from itertools import pairwise

import numpy as np
import pytest
from synthetic import bending_body, punch, record

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.fill.edges import sides
from mocapmend_algorithms.fill.novelty import Novelty
from mocapmend_algorithms.fill.punch import Window, fill_with_bands, find_places, measure
from mocapmend_algorithms.gaps import seen_outside


class Liar:
    """Fills with the truth plus an error, and notes what it was asked."""

    def __init__(self, truth, error):
        self.truth, self.error = truth, error
        self.asked = []

    def __call__(self, recording, observed, gaps, progress, /):
        self.asked.append((observed.copy(), list(gaps)))
        progress(1.0)
        patches = []
        for gap in gaps:
            assert not observed[gap.start : gap.stop, gap.marker].any()
            values = self.truth[gap.start : gap.stop, gap.marker] + self.error(gap)
            patches.append(Patch(gap, values, *np.full((2, gap.length), np.nan)))
        return FillResult(tuple(patches), (), {gap: {"helpers": 7} for gap in gaps})


def constant_error(gap):
    return np.full((gap.length, 3), 2.0)


@pytest.fixture
def points():
    # Every posture comes again, so none is stranger than another.
    return np.tile(bending_body(100, 6), (6, 1, 1))


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


def test_the_company_of_the_gap_is_hidden_too(points):
    gaps = [Gap(1, 200, 220), Gap(3, 190, 210)]
    fill = Liar(points, constant_error)
    recording = record(punch(points, gaps))
    observed = seen_outside(recording.present, gaps)
    measure(recording, observed, Window.of(observed, gaps[0]), [1], fill, no_progress)
    for hidden, asked in fill.asked:
        for gap in asked:
            assert not hidden[gap.start : gap.start + 10, [1, 3]].any()
            assert hidden[gap.start + 10 : gap.stop, 3].any()
            assert hidden[gap.start : gap.stop, [0, 2, 4, 5]].all()
            assert sides(hidden, gap) == (True, True)


def test_a_gap_at_the_beginning_is_tested_with_one_edge(points):
    gaps = [Gap(2, 0, 20), Gap(5, 580, 600)]
    fill = Liar(points, constant_error)
    fill_with_bands(record(punch(points, gaps)), gaps, fill, no_progress)
    for hidden, asked in fill.asked[1:]:
        for gap in asked:
            assert sides(hidden, gap) == ((False, True) if gap.marker == 2 else (True, False))


def test_no_run_hides_more_than_a_quarter_and_the_stretches_are_disjoint(points):
    gaps = [Gap(1, 200, 260)]
    fill = Liar(points, constant_error)
    fill_with_bands(record(punch(points, gaps)), gaps, fill, no_progress)
    runs = fill.asked[1:]
    assert len(runs) > 1
    for hidden, _ in runs:
        assert (~hidden[:, 1]).sum() - 60 <= 0.25 * 540
    stretches = sorted(gap for _, asked in runs for gap in asked)
    assert all(a.stop < b.start for a, b in pairwise(stretches))


def test_places_avoid_frames_where_others_are_missing(points):
    gaps = [Gap(1, 200, 210), Gap(0, 300, 500)]
    recording = record(punch(points, gaps))
    observed = seen_outside(recording.present, gaps)
    places, length = find_places(observed, Window.of(observed, gaps[0]), np.array([1]))
    assert length == 10
    assert not ((places > 290) & (places < 500)).any()


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


def test_postures_seen_before_are_not_novel_and_strange_ones_are(points):
    points[300:320, 2:, 0] += 400.0 * np.arange(4)
    recording = record(points)
    observed = recording.present.copy()
    observed[250:350, 0] = False
    novelty = Novelty.of(recording, observed, np.array([0]), 250, 350)
    found = novelty(observed, 250, 350)
    assert found.shape == (100,)
    assert found[:50].max() < 20
    assert found[50:70].min() > 100


def test_novelty_is_unknown_without_markers_to_compare(points):
    points[:, 2:] = np.nan
    recording = record(points)
    novelty = Novelty.of(recording, recording.present, np.array([0]), 10, 20)
    np.testing.assert_array_equal(novelty(recording.present, 10, 20), np.zeros(10))
