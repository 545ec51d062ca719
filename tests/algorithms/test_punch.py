"""What the self-tests of whole-recording fills hide, and where."""

from itertools import pairwise

import numpy as np
import pytest
from known_errors import Liar, constant_error, recurring_body
from synthetic import punch, record

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.edges import sides
from mocapmend_algorithms.fill.punch import Window, find_places
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.fill.punch_errors import measure
from mocapmend_algorithms.gaps import seen_outside


@pytest.fixture
def points():
    return recurring_body()


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
