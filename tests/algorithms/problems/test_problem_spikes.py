"""Samples that leave the trajectory and come back."""

import numpy as np
import pytest
from bodies import body, changed, found_by, spans
from hypothesis import given
from hypothesis import strategies as st

from mocapmend_algorithms import Recording
from mocapmend_algorithms.problems.steps import excursions, step_sizes


@given(
    rate=st.sampled_from([25.0, 50.0, 120.0, 250.0, 1000.0]),
    unit=st.sampled_from(["mm", "cm", "m"]),
    noise=st.sampled_from([0.0, 0.1, 0.3]),
    size=st.floats(25.0, 500.0),
    length=st.integers(1, 4),
    marker=st.integers(0, 14),
    place=st.floats(0.1, 0.9),
    seed=st.integers(0, 50),
)
def test_a_spike_is_found_exactly_and_its_size_is_known(
    rate, unit, noise, size, length, marker, place, seed
):
    clean = body(max(2.0, 60 / rate), rate=rate, noise=noise, unit=unit, seed=seed)
    # Between few frames, motion can go further.
    size *= max(1.0, 120.0 / rate)
    start = int(place * clean.frames)
    direction = np.random.default_rng(seed).normal(size=3)
    offset = size * direction / np.linalg.norm(direction)

    def spike(points):
        points[start : start + length, marker] += offset

    (run,) = found_by("spikes", changed(clean, spike))
    assert spans([run]) == [(marker, start, start + length)]
    assert run.deviation * clean.mm == pytest.approx(size, rel=0.15, abs=3.0)
    assert f"{run.deviation * clean.mm:.0f} mm" in run.reason


@pytest.mark.parametrize("rate", [25.0, 120.0, 1000.0])
@pytest.mark.parametrize("speed", [1.0, 3.0])
def test_motion_has_none(rate, speed):
    assert not found_by("spikes", body(rate=rate, noise=0.2, speed=speed), least_mm=5.0)


def test_a_kick_and_a_foot_strike_have_none():
    t = np.arange(600) / 120.0
    kick = 1500.0 / (1.0 + np.exp(-(t - 2.5) / 0.05))  # up to 7.5 m/s
    strike = 400.0 * np.abs(np.sin(3.0 * t))  # the velocity is turned round in no time
    points = np.stack((kick, strike, 0.0 * t), axis=1)[:, None]
    points += 0.1 * np.random.default_rng(1).normal(size=points.shape)
    assert not found_by("spikes", Recording(points, ("TOE",), 120.0), least_mm=5.0)


def test_a_shock_that_the_neighbours_feel_too_is_none():
    clean = body(noise=0.1)

    def shock(points):
        points[300] += (0.0, 0.0, 10.0)

    assert not found_by("spikes", changed(clean, shock), least_mm=5.0)

    def alone(points):
        points[300, 4] += (0.0, 0.0, 10.0)

    assert spans(found_by("spikes", changed(clean, alone), least_mm=5.0)) == [(4, 300, 301)]


def test_two_spikes_side_by_side_and_one_beside_a_gap():
    def spike(points):
        points[100, 3] += 60.0
        points[104, 3] -= 80.0
        points[200:230, 5] = np.nan
        points[232:234, 5] += (0.0, 50.0, 0.0)

    runs = found_by("spikes", changed(body(), spike))
    assert spans(runs) == [(3, 100, 101), (3, 104, 105), (5, 232, 234)]


def test_smaller_ones_are_left_alone():
    def spike(points):
        points[100, 3] += (12.0, 0.0, 0.0)

    recording = changed(body(), spike)
    assert len(found_by("spikes", recording, least_mm=5.0)) == 1
    assert not found_by("spikes", recording)


def test_samples_that_are_held_by_their_maker_are_no_spikes():
    held = np.repeat(body(3.0, rate=50.0, noise=0.0).points, 20, axis=0)
    recording = Recording(held, tuple(f"M{k}" for k in range(held.shape[1])), 1000.0)
    assert not found_by("spikes", recording, least_mm=5.0)


def test_a_step_is_as_large_as_it_is():
    points = np.zeros((50, 3))
    points[20:30, 1] = 40.0
    size = step_sizes(points)
    assert size[20] == size[30] == 40.0
    assert size[19] == size[21] == 20.0
    assert np.isnan(size[[0, 1, -1]]).all()
    assert excursions(points, 100.0, 10.0, 100) == [(20, 30, 40.0)]
    assert not excursions(points, 100.0, 10.0, 5)


def test_a_marker_that_drifts_away_and_snaps_back_is_one_spike():
    def drift(points):
        points[300:307, 8] += np.outer(np.arange(1, 8) * 25.0, [0.0, 0.6, 0.8])

    (run,) = found_by("spikes", changed(body(), drift))
    # Whether the first sample, the nearest one, is in it may be either way.
    assert (run.marker, run.stop) == (8, 307)
    assert run.start in (300, 301)


@pytest.mark.shared
def test_real_errors_are_found(shared):
    from mocapmend.files import read_recording

    recording = read_recording(shared / "cmu_markers/mr_135_02.c3d").measured
    runs = found_by("spikes", recording)
    wrist = [run for run in runs if recording.labels[run.marker] == "male:RWRA"]
    # Where the second difference is 185 mm.
    assert max(run.deviation for run in wrist) > 150.0
    # By its second differences of up to 185 mm it is known that there are some, and few.
    assert 10 <= sum(run.length for run in runs) <= 100
    legs = read_recording(shared / "cmu_joints/05_06.npz").measured
    knee = [run for run in found_by("spikes", legs) if legs.labels[run.marker] == "rfemur"]
    assert (459, 466) in [(run.start, run.stop) for run in knee]
