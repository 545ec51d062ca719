"""The pictures of long recordings are exact: no gap and no extreme is lost by zooming out."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.views.columns import Envelope, column_edges, columns_with
from mocapmend.views.lane import ticks, value_range
from mocapmend_algorithms.gaps import runs


@given(
    mask=st.lists(st.booleans(), min_size=1, max_size=400),
    width=st.integers(1, 300),
    data=st.data(),
)
def test_a_column_is_flagged_exactly_when_a_run_touches_it(
    mask: list[bool], width: int, data: st.DataObject
) -> None:
    flags = np.array(mask)
    start = data.draw(st.floats(0, len(mask) - 1))
    stop = data.draw(st.floats(start + 0.5, len(mask)))
    edges = column_edges(start, stop, width)
    found = columns_with(np.array(runs(flags), dtype=np.int64).reshape(-1, 2), edges)
    for column in range(width):
        first, end = edges[column], max(edges[column + 1], edges[column] + 1)
        assert found[column] == flags[first:end].any()


def test_a_single_missing_frame_shows_in_a_hundred_thousand() -> None:
    edges = column_edges(0, 100_000, 800)
    assert columns_with(np.array([[54_321, 54_322]]), edges).sum() == 1


@given(
    frames=st.integers(1, 30_000),
    width=st.integers(20, 500),
    seed=st.integers(0, 99),
    share=st.tuples(st.floats(0, 0.9), st.floats(0.05, 1)),
)
def test_the_drawn_extremes_are_those_of_the_data(
    frames: int, width: int, seed: int, share: tuple[float, float]
) -> None:
    rng = np.random.default_rng(seed)
    values = rng.normal(size=(frames, 3))
    values[rng.random(frames) < 0.2] = np.nan
    start = share[0] * frames
    stop = min(frames, start + max(10.0, share[1] * frames))
    for axis in range(3):
        line = Envelope(values).line(axis, start, stop, width)
        seen = values[int(start) : int(stop), axis]
        drawn = line[:, 1]
        if np.isfinite(seen).any() and np.isfinite(drawn).any():
            # A bucket may reach over the end by its own length, and the last is cut off.
            reach = int(np.ceil((stop - start) / width)) + 130
            inner = values[int(start) : max(int(start) + 1, int(stop) - reach), axis]
            if np.isfinite(inner).any():
                assert np.nanmax(drawn) >= np.nanmax(inner)
                assert np.nanmin(drawn) <= np.nanmin(inner)
            around = values[max(0, int(start) - reach) : int(stop) + reach, axis]
            assert np.nanmax(drawn) <= np.nanmax(around)
        assert len(line) <= 8 * width + 300


def test_missing_frames_break_the_line() -> None:
    values = np.zeros((100, 3))
    values[40:60] = np.nan
    line = Envelope(values).line(0, 0, 100, 500)
    assert np.isnan(line[(line[:, 0] >= 40) & (line[:, 0] < 60), 1]).all()


@pytest.mark.parametrize("value", [0.0, 93.02, -1500.0])
def test_the_axis_of_a_constant_has_few_digits(value: float) -> None:
    rng = np.random.default_rng(0)
    noise = 1e-12 * rng.standard_normal(50)
    low, high = value_range([np.stack((np.arange(50.0), value + noise), axis=1)])
    assert low < value < high
    marks, decimals = ticks(low, high, 3)
    assert len(marks) >= 1
    assert decimals <= 3


def test_the_axis_spans_what_varies_with_a_margin() -> None:
    line = np.array([[0.0, 1.0], [1.0, np.nan], [2.0, 3.0]])
    assert value_range([line]) == pytest.approx((0.84, 3.16))
    assert value_range([]) == (0.0, 1.0)
