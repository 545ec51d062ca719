"""Which frames teach, and which of them are hidden as a test."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from mocapmend_algorithms.fill.lessons import BORDERS, LONGEST_SHARE, Size, plan
from mocapmend_algorithms.gaps import Gap

SIZE = Size(frames=120, trials=6, judged=8, rest=40)


@st.composite
def lessons(draw):
    """Where marker and donors are there, and a gap of the marker."""
    frames = draw(st.integers(2, 400))
    rng = np.random.default_rng(draw(st.integers(0, 1000)))
    usable = np.ones(frames, dtype=bool)
    for _ in range(draw(st.integers(0, 6))):
        start = rng.integers(frames)
        usable[start : start + rng.integers(1, 60)] = False
    usable[rng.random(frames) < draw(st.sampled_from([0.0, 0.2]))] = False
    start = draw(st.integers(0, frames - 1))
    gap = Gap(0, start, draw(st.integers(start + 1, frames)))
    usable[gap.start : gap.stop] = False
    return usable, gap


@settings(max_examples=300)
@given(lesson=lessons())
def test_a_lesson_is_what_it_says(lesson):
    usable, gap = lesson
    made = plan(usable, gap, SIZE)
    assert (np.diff(made.frames) > 0).all()
    assert usable[made.frames].all()
    near = 2 * BORDERS.size * (SIZE.trials + 1) + SIZE.trials * SIZE.judged
    assert made.frames.size <= max(SIZE.frames, near + SIZE.rest)
    assert made.frames.size >= min(SIZE.rest, np.count_nonzero(usable))
    assert len(made.trials) <= SIZE.trials
    known = np.count_nonzero(usable)
    for trial in made.trials:
        assert trial.stop - trial.start == min(gap.length, max(int(LONGEST_SHARE * known), 3))
        assert usable[trial.start - 1]
        assert usable[trial.stop]
        assert (np.diff(trial.hidden) == 1).all()
        assert trial.hidden.size <= 0.6 * made.frames.size
        judged = made.frames[trial.hidden[trial.judged]]
        assert ((judged >= trial.start) & (judged < trial.stop)).all()
        assert judged.size >= 1
        beyond = set(made.frames[trial.hidden]) - set(judged)
        kind = gap.kind(usable.size)
        assert all(f < trial.start if kind == "leading" else f >= trial.stop for f in beyond)
        assert not beyond or kind in ("leading", "trailing")


@settings(max_examples=50)
@given(lesson=lessons())
def test_a_fill_of_a_trial_has_the_samples_beside_it(lesson):
    usable, gap = lesson
    made = plan(usable, gap, SIZE)
    assume(made.trials)
    for trial in made.trials:
        first, last = trial.hidden[0], trial.hidden[-1]
        if gap.kind(usable.size) != "leading":
            assert made.frames[first - 1] == trial.start - 1
        if gap.kind(usable.size) != "trailing":
            assert made.frames[last + 1] == trial.stop


@pytest.mark.parametrize(
    ("gap", "hides"), [(Gap(0, 0, 30), "before"), (Gap(0, 970, 1000), "after"), (None, "")]
)
def test_nothing_is_known_beyond_a_gap_at_an_edge(gap, hides):
    gap = gap or Gap(0, 500, 530)
    usable = np.ones(1000, dtype=bool)
    usable[gap.start : gap.stop] = False
    made = plan(usable, gap, SIZE)
    assert made.trials
    for trial in made.trials:
        hidden = made.frames[trial.hidden]
        shown = np.setdiff1d(made.frames, hidden)
        assert (shown >= trial.start).any() == (hides != "after")
        assert (shown < trial.start).any() == (hides != "before")


def test_trials_are_spread_over_the_recording():
    usable = np.ones(1000, dtype=bool)
    usable[500:530] = False
    starts = [trial.start for trial in plan(usable, Gap(0, 500, 530), SIZE).trials]
    assert len(starts) == SIZE.trials
    assert starts[0] < 50
    assert starts[-1] > 900


def test_frames_near_the_gap_are_all_taken():
    usable = np.ones(5000, dtype=bool)
    gap = Gap(0, 2500, 2600)
    usable[gap.start : gap.stop] = False
    frames = set(plan(usable, gap, SIZE).frames)
    assert {2499, 2498, 2497, 2600, 2601, 2602, 2499 - 54, 2600 + 54} <= frames


@pytest.mark.parametrize("frames", [1, 2, 3, 4, 5])
def test_tiny_recordings_are_no_trap(frames):
    for start in range(frames):
        usable = np.ones(frames, dtype=bool)
        usable[start] = False
        made = plan(usable, Gap(0, start, start + 1), SIZE)
        np.testing.assert_array_equal(made.frames, np.flatnonzero(usable))
    assert plan(np.zeros(frames, dtype=bool), Gap(0, 0, frames), SIZE).frames.size == 0
