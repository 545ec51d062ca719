"""Codes and dictionaries with bones: the objective, its slope, and that it never rises."""

from dataclasses import replace

import numpy as np
import pytest

from mocapmend_algorithms import Cancelled
from mocapmend_algorithms.sparse.bone_codes import Problem, encode_bones
from mocapmend_algorithms.sparse.newton import Coder
from mocapmend_algorithms.sparse.training import Trained, begin, train

BONES, COLUMNS, ATOMS = 8, 60, 30


@pytest.fixture
def problem():
    rng = np.random.default_rng(0)
    basis = rng.normal(size=(3 * BONES, 5))
    targets = basis @ rng.normal(size=(5, COLUMNS))
    held = rng.random((BONES, COLUMNS)) < 0.3
    squares = np.abs(targets).reshape(BONES, 3, COLUMNS).sum(axis=1)
    seen = np.repeat(~held, 3, axis=0)
    return Problem(targets, seen, np.sign(targets), squares, held, 1e-2, 0.4)


@pytest.fixture
def dictionary():
    atoms = np.random.default_rng(1).normal(size=(3 * BONES, ATOMS))
    return atoms / np.linalg.norm(atoms, axis=0)


def nothing(dictionary):
    return np.zeros((dictionary.shape[1], COLUMNS))


def test_the_slope_is_that_of_the_smooth_part(problem):
    rng = np.random.default_rng(2)
    image, along = rng.normal(size=(2, 3 * BONES, COLUMNS))
    _, slope = problem.smooth(image)
    ahead, _ = problem.smooth(image + 1e-6 * along)
    behind, _ = problem.smooth(image - 1e-6 * along)
    expected = np.sum(slope * along, axis=0)
    np.testing.assert_allclose((ahead - behind) / 2e-6, expected, rtol=1e-5, atol=1e-6)


def test_what_is_not_seen_does_not_count_and_bones_that_are_not_held_neither(problem, dictionary):
    other = replace(
        problem,
        targets=np.where(problem.seen, problem.targets, 77.0),
        squares=np.where(problem.held, problem.squares, 99.0),
    )
    one = encode_bones(dictionary, problem, nothing(dictionary), iterations=50)
    same = encode_bones(dictionary, other, nothing(dictionary), iterations=50)
    np.testing.assert_array_equal(one, same)


def test_no_column_ever_rises(problem, dictionary):
    def cost(weights):
        value, _ = problem.smooth(dictionary @ weights)
        return value + problem.penalty * np.abs(weights).sum(axis=0)

    weights, costs = nothing(dictionary), []
    for _ in range(30):
        costs.append(cost(weights))
        weights = encode_bones(dictionary, problem, weights, iterations=1)
    assert (np.diff(costs, axis=0) <= 1e-12).all()
    assert costs[-1].sum() < 0.2 * costs[0].sum()


def test_without_bones_and_masks_it_is_the_lasso(problem, dictionary):
    everything = np.ones_like(problem.seen)
    plain = replace(problem, seen=everything, bone_weight=0.0, penalty=0.5)
    found = encode_bones(dictionary, plain, nothing(dictionary), iterations=20_000, tolerance=1e-12)
    best = Coder.of(dictionary).encode(plain.targets, 0.5, tolerance=1e-9)
    assert plain.objective(dictionary, found) == pytest.approx(
        plain.objective(dictionary, best.weights), rel=1e-5
    )


def test_bones_pull_what_is_not_seen_to_their_lengths(problem, dictionary):
    def missed(weight):
        own = replace(problem, bone_weight=weight)
        weights = encode_bones(dictionary, own, nothing(dictionary), iterations=500, tolerance=1e-9)
        bones = (own.signs * (dictionary @ weights)).reshape(BONES, 3, COLUMNS).sum(axis=1)
        return np.abs(bones - own.squares)[own.held].mean()

    assert missed(0.4) < 0.5 * missed(0.0)


def test_the_objective_of_training_never_rises_and_atoms_stay_short(problem):
    state = begin(problem, ATOMS)
    states = [state]
    for _ in range(6):
        state = train(problem, state, rounds=1, tolerance=0.0)
        states.append(state)
        assert (np.linalg.norm(state.dictionary, axis=0) <= 1 + 1e-9).all()
    objectives = np.array(states[-1].objectives)
    assert objectives.size == 7
    assert (np.diff(objectives) <= 0).all()
    assert objectives[-1] < 0.3 * objectives[0]
    assert objectives[-1] == pytest.approx(problem.objective(state.dictionary, state.weights))


def test_training_goes_on_where_it_stopped(problem):
    whole = train(problem, begin(problem, ATOMS), rounds=4, tolerance=0.0)
    half = train(problem, begin(problem, ATOMS), rounds=2, tolerance=0.0)
    again = train(problem, half, rounds=2, tolerance=0.0)
    np.testing.assert_array_equal(again.dictionary, whole.dictionary)
    assert again.objectives == whole.objectives


def test_training_stops_when_a_round_gains_little(problem):
    state = train(problem, begin(problem, ATOMS), rounds=200, tolerance=0.05)
    assert state.done
    gains = -np.diff(state.objectives) / state.objectives[:-1]
    assert gains[-1] <= 0.05
    assert (gains[:-1] > 0.05).all()


def test_an_atom_that_nobody_uses_is_replaced_at_no_cost(problem):
    start = begin(problem, ATOMS)
    dictionary = start.dictionary.copy()
    dictionary[:, 4] = 0.0
    cost = problem.objective(dictionary, start.weights)
    idle = Trained(dictionary, start.weights, (cost,))
    state = train(problem, idle, rounds=1, tolerance=0.0)
    assert np.linalg.norm(state.dictionary[:, 4]) == pytest.approx(1)
    assert state.objectives[1] <= cost


def test_no_more_atoms_than_windows(problem):
    assert begin(problem, 500).dictionary.shape == (3 * BONES, COLUMNS)


def test_progress_rises_to_one_and_may_cancel(problem):
    told = []
    start = begin(problem, ATOMS)
    train(problem, start, rounds=3, tolerance=0.0, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    before = start.dictionary.copy()

    def cancel(fraction):
        if fraction > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        train(problem, start, rounds=3, tolerance=0.0, progress=cancel)
    np.testing.assert_array_equal(start.dictionary, before)
