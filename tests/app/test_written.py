"""Runs of samples, all at once: as a loop over them would have it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from mocapmend.written import differing_runs, places_of, shares_of
from mocapmend_algorithms import Gap

FRAMES, MARKERS = 12, 3
RUNS = st.lists(
    st.builds(
        lambda marker, start, length: Gap(marker, start, min(FRAMES, start + length)),
        st.integers(0, MARKERS - 1),
        st.integers(0, FRAMES - 1),
        st.integers(1, 6),
    ),
    max_size=6,
)


@given(RUNS)
def test_places_are_those_of_the_runs_in_their_order(runs: list[Gap]) -> None:
    frames, markers = places_of(runs)
    expected = [(frame, gap.marker) for gap in runs for frame in range(gap.start, gap.stop)]
    assert list(zip(frames.tolist(), markers.tolist(), strict=True)) == expected
    for gap, own in zip(runs, shares_of(runs), strict=True):
        assert frames[own].tolist() == list(range(gap.start, gap.stop))


@given(RUNS, st.sets(st.tuples(st.integers(0, FRAMES - 1), st.integers(0, MARKERS - 1))))
def test_differing_runs_are_whole_and_hold_what_is_there(
    runs: list[Gap], changed: set[tuple[int, int]]
) -> None:
    stored = np.full((FRAMES, MARKERS, 3), np.nan)
    points = stored.copy()
    written = {(f, gap.marker) for gap in runs for f in range(gap.start, gap.stop)}
    for frame, marker in changed & written:
        points[frame, marker] = frame
    places = places_of(runs)
    found = list(differing_runs(points[places], stored, places))
    samples = {
        (run.start + row, run.marker): tuple(value)
        for run in found
        for row, value in enumerate(run.values)
    }
    assert samples == {place: (place[0],) * 3 for place in changed & written}
    assert found == sorted(found, key=lambda run: (run.marker, run.start))
    for run in found:
        assert (run.start - 1, run.marker) not in samples
        assert (run.start + len(run.values), run.marker) not in samples
