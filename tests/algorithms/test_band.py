"""The band of donor fills, from known errors."""

import numpy as np
import pytest

from mocapmend_algorithms.fill.band import FEW_TRIALS, LENGTH_POWER, MANY_TRIALS, band
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.completion import Completion
from mocapmend_algorithms.fill.donors import DonorDistances, Donors
from mocapmend_algorithms.fill.lessons import Lesson, Trial
from mocapmend_algorithms.gaps import Gap

NONE = Donors(np.array([1]), np.array([1.0]), np.array([100.0]))


def case(starts, *, length=20, speed=0.0):
    """A gap at the end of 200 frames beside one donor, and trials of ten frames."""
    frames = np.arange(200)
    points = np.zeros((200 + length, 2, 3))
    # The donor stands still but in the gap.
    points[200:, 1, 0] = speed / 100 * np.arange(length)
    observed = np.ones((200 + length, 2), bool)
    observed[200:, 0] = False
    trials = [Trial(s, s + 10, np.arange(s, s + 10), slice(0, 10)) for s in starts]
    return Case(
        gap=Gap(0, 200, 200 + length),
        rate=100.0,
        up=np.array([0.0, 0, 1]),
        lesson=Lesson(frames, tuple(trials)),
        frames=np.arange(200 + length),
        donors=NONE,
        target=np.zeros((200, 3)),
        seen=observed[:, 0],
        track=points[:, 0],
        completion=Completion(points, observed, DonorDistances(points, observed), 100.0),
    )


def errors(trials, seed=0):
    return list(np.random.default_rng(seed).normal(0, 2, (trials, 10, 3)))


def spreads(trials, size=1.0):
    return [np.full(10, size)] * trials


def test_without_a_trial_nothing_is_known():
    found = band(case([]), [], [], np.ones(20))
    assert np.isnan(found.sigma).all()
    assert np.isnan(found.r90).all()


def test_the_band_is_the_quantile_of_what_was_left_over():
    left = errors(15)
    found = band(case(range(5, 155, 10), length=10), left, spreads(15), np.ones(10))
    trust = MANY_TRIALS + FEW_TRIALS / 15
    radius = np.linalg.norm(np.concatenate(left), axis=1)
    np.testing.assert_allclose(found.r90, trust * np.quantile(radius, 0.9))
    np.testing.assert_allclose(found.sigma, trust * np.sqrt(np.mean(radius**2) / 3))


def test_it_follows_how_unsure_the_fill_is():
    left = errors(5)
    spread = np.linspace(1, 3, 20)
    one = band(case(range(5, 55, 10)), left, spreads(5), spread)
    np.testing.assert_allclose(one.r90 / one.r90[0], spread)
    other = band(case(range(5, 55, 10)), left, spreads(5, 2.0), spread)
    np.testing.assert_allclose(other.r90, one.r90 / 2)


def test_trials_that_overlap_count_once():
    left = errors(4)
    apart = band(case([5, 30, 60, 90]), left, spreads(4), np.ones(20))
    same = band(case([5, 6, 7, 8]), left, spreads(4), np.ones(20))
    ratio = (MANY_TRIALS + FEW_TRIALS) / (MANY_TRIALS + FEW_TRIALS / 4)
    np.testing.assert_allclose(same.r90, ratio * apart.r90)


@pytest.mark.parametrize("length", [10, 40])
def test_gaps_longer_than_the_trials_are_less_sure(length):
    left = errors(4)
    usual = band(case([5, 30, 60, 90], length=10), left, spreads(4), np.ones(10)).r90[0]
    found = band(case([5, 30, 60, 90], length=length), left, spreads(4), np.ones(length))
    np.testing.assert_allclose(found.r90, usual * (length / 10) ** LENGTH_POWER)


def test_fast_donors_are_harder_to_follow():
    left = errors(4)
    still = band(case([5, 30, 60, 90]), left, spreads(4), np.ones(20))
    fast = band(case([5, 30, 60, 90], speed=1500.0), left, spreads(4), np.ones(20))
    inside = fast.r90[10] / still.r90[10]
    assert inside == pytest.approx(2.0, rel=0.2)
    assert (fast.r90 >= still.r90 * (1 - 1e-9)).all()


def test_the_frames_at_the_ends_have_less_time_to_move_in():
    at_ends = case([]).elapsed(10)
    assert at_ends[0] == at_ends[-1] == 10
    assert at_ends[5] == 15
    assert at_ends[100] == 20
    moved = case([], speed=500.0)
    both = moved.at(np.array([0]), 10) - moved.at(np.array([0]), -10)
    assert both[-1, 0, 0] / moved.elapsed(10)[-1] == pytest.approx(5.0)
