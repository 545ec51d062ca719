"""The blend of candidates against another optimiser."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize

from mocapmend_algorithms.fill.stack import Stack, blend


def trials(count, sizes, *, seed=0, common=0.5, samples=20):
    """Errors of candidates in mm, partly the same; per trial and candidate (samples, 3)."""
    rng = np.random.default_rng(seed)
    made = []
    for _ in range(count):
        hardness, shared = rng.uniform(0.2, 5), rng.normal(size=(samples, 3))
        made.append(
            [hardness * s * (common * shared + rng.normal(size=(samples, 3))) for s in sizes]
        )
    return made


def loss(weights, errors, prior, pull):
    """The squared error of the blend, trials counting alike, and the pull towards the prior."""
    total = 0.0
    for trial in errors:
        typical = np.median([np.sum(part**2) for part in trial])
        total += np.sum(blend(trial, weights) ** 2) / typical
    return total / max(len(errors), 1) + pull * np.sum((weights - prior) ** 2)


@settings(max_examples=30)
@given(
    seed=st.integers(0, 1000),
    count=st.integers(0, 12),
    sizes=st.lists(st.floats(0.5, 20), min_size=1, max_size=6),
    pull=st.sampled_from([0.01, 0.1, 1.0]),
)
def test_no_other_weights_are_better(seed, count, sizes, pull):
    errors = trials(count, sizes, seed=seed)
    prior = np.full(len(sizes), 1 / len(sizes))
    weights = Stack(errors, prior, pull).weights()
    assert weights.sum() == pytest.approx(1, abs=1e-12)
    assert (weights >= 0).all()
    found = minimize(
        loss,
        prior,
        (errors, prior, pull),
        method="SLSQP",
        bounds=[(0, 1)] * len(sizes),
        constraints={"type": "eq", "fun": lambda weights: weights.sum() - 1},
        options={"ftol": 1e-12},
    )
    np.testing.assert_allclose(weights, found.x, atol=1e-3)
    assert loss(weights, errors, prior, pull) <= found.fun * (1 + 1e-6) + 1e-12


def test_without_a_trial_the_weights_are_the_prior():
    prior = np.array([0.5, 0.3, 0.2])
    stack = Stack([], prior, 0.1)
    np.testing.assert_allclose(stack.weights(), prior, atol=1e-9)
    assert stack.left_out() == []


def test_the_best_candidate_wins():
    weights = Stack(trials(40, [10, 1, 10]), np.full(3, 1 / 3), 0.1).weights()
    assert weights[1] > 0.75
    assert Stack(trials(40, [10, 1, 10]), np.full(3, 1 / 3), 1e-3).weights()[1] > 0.95


def test_candidates_that_err_in_different_ways_share():
    weights = Stack(trials(40, [1, 1, 1], common=0.0), np.full(3, 1 / 3), 0.1).weights()
    np.testing.assert_allclose(weights, 1 / 3, atol=0.05)


def test_each_trial_is_left_out_of_its_own_weights():
    errors = trials(6, [2, 1, 3])
    prior = np.full(3, 1 / 3)
    for number, left in enumerate(Stack(errors, prior, 0.1).left_out()):
        others = errors[:number] + errors[number + 1 :]
        expected = blend(errors[number], Stack(others, prior, 0.1).weights())
        np.testing.assert_allclose(left, expected, atol=1e-9)


def test_a_single_trial_is_judged_by_the_prior():
    errors = trials(1, [5, 1])
    (left,) = Stack(errors, np.array([0.5, 0.5]), 0.1).left_out()
    np.testing.assert_allclose(left, (errors[0][0] + errors[0][1]) / 2, atol=1e-9)


@pytest.mark.parametrize("size", [0.0, 1e-13, 1e12])
def test_a_candidate_that_fails_or_is_perfect_is_no_trap(size):
    weights = Stack(trials(5, [size, 2, 1, size]), np.full(4, 0.25), 0.1).weights()
    assert np.isfinite(weights).all()
    assert weights.sum() == pytest.approx(1)
    assert (weights[[0, 3]].sum() > 0.9) == (size < 1)


def test_where_all_are_perfect_the_prior_stays():
    weights = Stack(trials(5, [0.0, 0.0]), np.array([0.7, 0.3]), 0.1).weights()
    np.testing.assert_allclose(weights, [0.7, 0.3], atol=1e-9)
