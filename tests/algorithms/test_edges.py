"""Gaps at the start and the end of a recording, where the user asks to hold a sample."""

import numpy as np
import pytest
from scipy.signal import lfilter
from synthetic import fill_with, record, smooth_motion

from mocapmend_algorithms import Gap, find_gaps

HOLDING = pytest.mark.parametrize("method", ["constant", "linear", "cubic", "pchip", "woltring"])


@HOLDING
def test_the_nearest_sample_is_held(method):
    points = smooth_motion(300, 3)
    points[:12, 0] = np.nan
    points[280:, 1] = np.nan
    points[:, 2] = np.nan
    points[150:155, 0] = np.nan
    recording = record(points)
    gaps = find_gaps(recording.present)
    result = fill_with((method, {"edges": "hold"}), recording, gaps)
    first, inner, last = result.patches
    assert (first.gap, last.gap) == (Gap(0, 0, 12), Gap(1, 280, 300))
    np.testing.assert_array_equal(first.values, np.tile(points[12, 0], (12, 1)))
    np.testing.assert_array_equal(last.values, np.tile(points[279, 1], (20, 1)))
    assert [left.reason for left in result.unfilled] == [
        "the marker is never seen in this recording"
    ]
    (alone,) = fill_with((method, {}), recording, [inner.gap]).patches
    np.testing.assert_array_equal(alone.values, inner.values)
    # The further from the last sample, the less is known.
    assert first.r90[0] > first.r90[-1] > 0
    assert last.r90[-1] > last.r90[0] > 0
    assert np.isfinite(first.sigma).all()


def test_one_sample_is_enough_to_hold():
    points = np.full((9, 1, 3), np.nan)
    points[4] = 7.0
    recording = record(points)
    result = fill_with(("cubic", {"edges": "hold"}), recording, find_gaps(recording.present))
    assert [patch.gap for patch in result.patches] == [Gap(0, 0, 4), Gap(0, 5, 9)]
    assert all((patch.values == 7.0).all() for patch in result.patches)
    assert all(np.isnan(patch.r90).all() for patch in result.patches)


@pytest.mark.parametrize("side", ["leading", "trailing"])
def test_the_band_holds_nine_tenths(side):
    rng = np.random.default_rng(0)
    inside = []
    for trial in range(60):
        steps = (
            rng.normal(0, 1, (900, 1, 3))
            * (1 + np.sin(np.arange(900) / 25 + trial) ** 2)[:, None, None]
        )
        truth = np.cumsum(lfilter([1], [1, -0.95], steps, axis=0), axis=0)[500:]
        gap = Gap(0, 0, 15) if side == "leading" else Gap(0, 385, 400)
        points = truth.copy()
        points[gap.start : gap.stop] = np.nan
        (patch,) = fill_with(("linear", {"edges": "hold"}), record(points), [gap]).patches
        error = np.linalg.norm(patch.values - truth[gap.start : gap.stop, 0], axis=1)
        inside.append(np.mean(error <= patch.r90))
    assert 0.82 < np.mean(inside) < 0.97


def test_a_marker_at_speed_is_less_certain_than_one_at_rest():
    time = np.arange(600)
    place = np.where(time < 300, 0.0, 10.0 * (time - 300.0))
    points = (place[:, None, None] + 0.1 * np.sin(time)[:, None, None]) * np.ones((1, 1, 3))
    points[:10] = np.nan
    points[590:] = np.nan
    recording = record(points)
    early, late = fill_with(
        ("linear", {"edges": "hold"}), recording, find_gaps(recording.present)
    ).patches
    assert late.r90.max() > 2 * early.r90.max()
