"""Labels of two markers that are exchanged."""

import numpy as np
import pytest
from bodies import body, changed, found_by
from hypothesis import given
from hypothesis import strategies as st

NAN = np.nan


def swap(points, a, b, start, stop):
    points[start:stop, [a, b]] = points[start:stop, [b, a]]


def undone(recording, runs):
    points = recording.points.copy()
    for run in runs:
        swap(points, run.marker, run.other, run.start, run.stop)
    return points


@given(
    rate=st.sampled_from([50.0, 120.0, 300.0]),
    unit=st.sampled_from(["mm", "m"]),
    noise=st.sampled_from([0.0, 0.3]),
    pair=st.tuples(st.integers(0, 14), st.integers(0, 14)).filter(lambda p: p[0] != p[1]),
    start=st.floats(0.01, 0.7),
    length=st.integers(1, 150),
)
def test_a_swap_is_taken_back_exactly(rate, unit, noise, pair, start, length):
    clean = body(8.0, rate=rate, noise=noise, unit=unit)
    first = 1 + int(start * clean.frames)

    def corrupt(points):
        swap(points, *pair, first, first + length)

    # Of the very numbers that were read: a way to millimetres and back may change the last bit.
    points = clean.points.copy()
    corrupt(points)
    recording = clean.with_points(points)
    runs = found_by("swaps", recording)
    assert [(run.marker, run.other, run.start, run.stop) for run in runs] == [
        (min(pair), max(pair), first, first + length)
    ]
    assert np.array_equal(undone(recording, runs), clean.points)
    assert runs[0].score > 0.75


def test_there_are_none_in_a_clean_recording():
    assert not found_by("swaps", body(noise=1.0))

    def gaps(points):
        for marker in range(0, 15, 2):
            points[40 * marker : 40 * marker + 50, marker] = NAN

    assert not found_by("swaps", changed(body(noise=1.0), gaps))


@pytest.mark.parametrize("start", [0, 500])
def test_the_way_there_or_back_may_be_outside_of_the_recording(start):
    clean = body(5.0)
    stop = start + 100

    def corrupt(points):
        swap(points, 6, 8, start, stop)

    (run,) = found_by("swaps", changed(clean, corrupt))
    assert (run.start, run.stop) == (start, stop)


def test_gaps_may_hide_both_ways():
    clean = body()

    def corrupt(points):
        swap(points, 6, 8, 200, 300)
        points[190:210, 6] = points[195:215, 8] = NAN
        points[290:310, 6] = points[285:305, 8] = NAN

    (run,) = found_by("swaps", changed(clean, corrupt))
    assert (run.marker, run.other) == (6, 8)
    # What is seen of the two while they are swapped is in it, and nothing else.
    assert run.start in range(190, 211)
    assert run.stop in range(285, 306)


def test_a_missing_sample_is_exchanged_like_any_other():
    clean = body()

    def corrupt(points):
        points[240:400, 8] = NAN
        swap(points, 6, 8, 250, 280)

    recording = changed(clean, corrupt)
    (run,) = found_by("swaps", recording)
    assert (run.marker, run.other, run.start, run.stop) == (6, 8, 250, 280)


def test_swaps_are_found_again_and_again():
    def corrupt(points):
        for start in (100, 160, 300):
            swap(points, 6, 8, start, start + 20)
        swap(points, 1, 3, 110, 112)

    runs = found_by("swaps", changed(body(), corrupt))
    assert [(run.marker, run.other, run.start, run.stop) for run in runs] == [
        (1, 3, 110, 112),
        (6, 8, 100, 120),
        (6, 8, 160, 180),
        (6, 8, 300, 320),
    ]


def test_near_ones_are_left_alone_where_asked():
    def corrupt(points):
        swap(points, 6, 8, 100, 130)

    recording = changed(body(), corrupt)
    (run,) = found_by("swaps", recording)
    away = run.deviation
    assert not found_by("swaps", recording, least_mm=away + 1.0)


def test_a_spike_is_no_swap():
    def corrupt(points):
        points[100, 6] = points[100, 8]

    assert not found_by("swaps", changed(body(), corrupt))
