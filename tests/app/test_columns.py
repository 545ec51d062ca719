"""The pictures of long recordings are exact: no gap and no extreme is lost by zooming out."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.views.columns import Envelope, column_edges, columns_with
from mocapmend.views.lane import WIDEST_MARK, mark_text, ticks, value_range
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
    places, lines = Envelope(np.ascontiguousarray(values.T)).lines(start, stop, width)
    assert len(places) == lines.shape[1] <= max(4 * width + 8, 256)
    reach = int(np.ceil((stop - start) / width)) + 3
    for axis in range(3):
        seen = values[int(start) : int(np.ceil(stop)), axis]
        drawn = lines[axis]
        assert np.isfinite(drawn).any() or not np.isfinite(seen).any()
        if np.isfinite(seen).any():
            assert np.nanmax(drawn) >= np.nanmax(seen)
            assert np.nanmin(drawn) <= np.nanmin(seen)
            around = values[max(0, int(start) - reach) : int(stop) + reach, axis]
            assert np.nanmax(drawn) <= np.nanmax(around)
            assert np.nanmin(drawn) >= np.nanmin(around)


def test_buckets_keep_their_places_while_the_range_moves() -> None:
    rng = np.random.default_rng(0)
    envelope = Envelope(rng.normal(size=(1, 50_000)))
    before, values = envelope.lines(10_000, 30_000, 400)
    after, moved = envelope.lines(10_016, 30_016, 400)
    shared = np.isin(after, before)
    assert shared.mean() > 0.9
    np.testing.assert_array_equal(moved[0, shared], values[0, np.isin(before, after)])


def test_missing_frames_break_the_line() -> None:
    values = np.zeros((1, 100))
    values[0, 40:60] = np.nan
    places, lines = Envelope(values).lines(0, 100, 500)
    assert np.isnan(lines[0, (places >= 40) & (places < 60)]).all()
    assert np.isfinite(lines[0, (places < 40) | (places >= 60)]).all()


@pytest.mark.parametrize("value", [0.0, 93.02, -1500.0])
def test_the_axis_of_a_constant_has_few_digits(value: float) -> None:
    rng = np.random.default_rng(0)
    noise = 1e-12 * rng.standard_normal(50)
    low, high = value_range([value + noise])
    assert low < value < high
    marks, decimals = ticks(low, high, 3)
    assert len(marks) >= 1
    assert decimals <= 3


def test_the_axis_spans_what_varies_with_a_margin() -> None:
    assert value_range([np.array([1.0, np.nan]), np.array([3.0])]) == pytest.approx((0.84, 3.16))
    assert value_range([]) == (0.0, 1.0)
    assert value_range([np.full(3, np.nan), np.empty(0)]) == (0.0, 1.0)


@pytest.mark.parametrize("mark", [0.0, -1234.5, 98_765_432.1, 0.000_012])
def test_a_number_at_an_axis_fits_its_margin(mark: float) -> None:
    for decimals in (0, 1, 6):
        assert len(mark_text(mark, decimals)) <= len(WIDEST_MARK) + 1
