"""Motion in cycles: the period, and gaps filled from other cycles."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap, no_progress
from mocapmend_algorithms.fill.cyclic import CyclicParams, cyclic
from mocapmend_algorithms.fill.period import find_period, unlikeness


def pedalling(frames, markers, period, *, seed=0, travel=(0.0, 0.0, 0.0)):
    """Closed curves of four harmonics, carried along; shape (frames, markers, 3)."""
    rng = np.random.default_rng(seed)
    phase = 2 * np.pi * np.arange(frames)[:, None, None, None] / period * np.arange(1, 5)
    size = rng.normal(0, 150, (markers, 3, 4)) / np.arange(1, 5) ** 2
    size[:, 0, 0] = 200.0
    shift = rng.uniform(0, 2 * np.pi, (markers, 3, 4))
    along = np.arange(frames)[:, None, None] * np.array(travel)
    return np.sum(size * np.sin(phase + shift), axis=3) + along


@settings(max_examples=25)
@given(
    seed=st.integers(0, 1000),
    period=st.floats(40, 150),
    noise=st.sampled_from([0.0, 2.0]),
    missing=st.sampled_from([0.0, 0.1]),
)
def test_the_period_is_found(seed, period, noise, missing):
    rng = np.random.default_rng(seed)
    points = pedalling(450, 1, period, seed=seed, travel=(12.0, 0.0, 0.1))
    points += rng.normal(0, noise, points.shape)
    points[rng.random((450, 1)) < missing] = np.nan
    assert find_period(points, 100.0) == pytest.approx(period, rel=0.02)


def test_unlikeness_is_what_it_says():
    points = pedalling(150, 2, 40.0) + smooth_motion(150, 2)
    points[20:30, 0] = np.nan
    points[90:97, 1] = np.nan
    step = 4
    found = unlikeness(points, 100.0)
    moved = points[step:] - points[:-step]
    moved -= np.nanmean(moved, axis=0)
    for lag in (1, 7, 40, 80):
        first, second = moved[:-lag], moved[lag:]
        both = ~np.isnan(first + second)
        different = np.sum((first - second)[both] ** 2)
        expected = different / (np.sum(first[both] ** 2) + np.sum(second[both] ** 2))
        assert found[lag] == pytest.approx(expected, rel=1e-6)
    assert found[0] == 0.0
    assert np.isnan(found[-1])


@pytest.mark.parametrize(
    "points",
    [
        smooth_motion(600, 1, seed=2),
        np.cumsum(np.random.default_rng(0).normal(0, 5, (600, 1, 3)), axis=0),
        np.zeros((600, 1, 3)),
        np.full((600, 1, 3), np.nan),
        pedalling(120, 1, 100.0),
        np.zeros((3, 1, 3)),
    ],
    ids=["smooth", "random walk", "still", "never seen", "one cycle", "short"],
)
def test_motion_that_does_not_repeat_has_no_period(points):
    assert find_period(points, 100.0) is None


@settings(max_examples=25)
@given(
    seed=st.integers(0, 1000),
    start=st.integers(10, 380),
    length=st.integers(1, 100),
    given_period=st.booleans(),
)
def test_a_whole_number_of_frames_per_cycle_is_filled_exactly(seed, start, length, given_period):
    points = pedalling(500, 1, 80.0, seed=seed, travel=(9.0, 1.0, 0.0))
    gap = Gap(0, start, start + length)
    params = {"period": "0.8"} if given_period else {}
    result = fill_with(("cyclic", params), record(punch(points, [gap])), [gap])
    (patch,) = result.patches
    np.testing.assert_allclose(patch.values, points[start : start + length, 0], atol=0.01)
    note = result.notes[gap]
    assert note["period_s"] == pytest.approx(0.8, rel=0.01)
    assert all(lag / 0.8 == pytest.approx(round(lag / 0.8)) for lag in note["cycles"])


def test_cycles_may_be_longer_and_shorter():
    rng = np.random.default_rng(8)
    pace = np.repeat(rng.uniform(0.95, 1.05, 12), 100)
    phase = np.cumsum(pace)
    table = pedalling(2000, 1, 100.0, seed=8)[:, 0]
    points = np.stack([np.interp(phase, np.arange(2000), axis) for axis in table.T], axis=1)
    points = points[:, None]
    gap = Gap(0, 520, 580)
    result = fill_with(("cyclic", {}), record(punch(points, [gap])), [gap])
    error = np.linalg.norm(result.patches[0].values - points[520:580, 0], axis=1)
    straight = fill_with(("cubic", {}), record(punch(points, [gap])), [gap]).patches[0].values
    assert error.max() < 40
    assert error.max() < 0.2 * np.linalg.norm(straight - points[520:580, 0], axis=1).max()
    assert len(result.notes[gap]["cycles"]) == 4
    assert np.mean(error <= result.patches[0].r90) > 0.8


def test_the_band_holds_nine_tenths():
    rng = np.random.default_rng(9)
    points = pedalling(1500, 6, 97.3, seed=9)
    points += smooth_motion(1500, 6, seed=9) * 0.2 + rng.normal(0, 1, points.shape)
    inside = []
    for start in range(60, 1400, 11):
        gap = Gap(start % 6, start, start + 30)
        (patch,) = fill_with(("cyclic", {}), record(punch(points, [gap])), [gap]).patches
        error = np.linalg.norm(patch.values - points[start : start + 30, gap.marker], axis=1)
        inside.append(np.mean(error <= patch.r90))
    assert 0.85 < np.mean(inside) < 0.95


def test_a_marker_that_does_not_repeat_itself_takes_the_period_of_all():
    points = pedalling(500, 5, 80.0)
    points[:, 0] = 0.02 * smooth_motion(500, 1, seed=2)[:, 0]
    gap = Gap(0, 200, 220)
    note = fill_with(("cyclic", {}), record(punch(points, [gap])), [gap]).notes[gap]
    assert note["period_s"] == pytest.approx(0.8, rel=0.02)


def test_it_says_why_a_gap_stays_open():
    gap = Gap(0, 200, 220)
    (left,) = fill_with(
        ("cyclic", {}), record(punch(smooth_motion(600, 1, seed=2), [gap])), [gap]
    ).unfilled
    assert left.reason == "the motion is not periodic: it does not repeat itself closely enough"
    points = punch(pedalling(300, 1, 100.0), [Gap(0, 100, 130), Gap(0, 200, 230)])
    points[:30] = np.nan
    (left,) = fill_with(("cyclic", {}), record(points), [Gap(0, 100, 130)]).unfilled
    assert left.reason == (
        "no other cycle of 1.00 s has this marker in all frames that are missing here"
    )


@pytest.mark.parametrize(("start", "stop"), [(0, 60), (440, 500)])
def test_the_edges_of_a_recording_repeat_where_asked(start, stop):
    points = pedalling(500, 1, 80.0, travel=(0.0, 0.0, 0.0))
    gap = Gap(0, start, stop)
    recording = record(punch(points, [gap]))
    assert not fill_with(("cyclic", {}), recording, [gap]).patches
    (patch,) = fill_with(("cyclic", {"edges": "repeat"}), recording, [gap]).patches
    np.testing.assert_allclose(patch.values, points[start:stop, 0], atol=0.01)


def test_a_period_shorter_than_two_frames_is_no_trap():
    recording = record(punch(smooth_motion(300, 1), [Gap(0, 50, 60)]), rate=25.0)
    assert cyclic(recording, [Gap(0, 50, 60)], CyclicParams(period=0.05), no_progress).patches
