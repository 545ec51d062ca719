"""Sparse codes: the optimum, its certificate, and a second implementation."""

import numpy as np
import pytest
from sklearn.linear_model import Lasso

from mocapmend_algorithms import Cancelled
from mocapmend_algorithms.sparse.lasso import encode, encode_gram

ROWS, ATOMS, COLUMNS = 40, 90, 25


def correlated_dictionary(seed=0):
    """Make atoms that resemble each other, as the poses of a recording do."""
    rng = np.random.default_rng(seed)
    atoms = rng.normal(size=(ROWS, ATOMS))
    atoms[:, 1:] += 0.8 * atoms[:, :-1]
    return atoms / np.linalg.norm(atoms, axis=0), rng.normal(size=(ROWS, COLUMNS))


def cost(dictionary, targets, weights, penalty):
    residual = targets - dictionary @ weights
    return 0.5 * np.sum(residual**2, axis=0) + penalty * np.abs(weights).sum(axis=0)


@pytest.mark.parametrize("penalty", [0.1, 0.5, 2.0])
def test_the_optimum_is_that_of_scikit_learn(penalty):
    atoms, targets = correlated_dictionary()
    codes = encode(atoms, targets, penalty, tolerance=1e-9, most_iterations=20_000)
    peer = Lasso(alpha=penalty / ROWS, fit_intercept=False, tol=1e-9, max_iter=100_000)
    theirs = peer.fit(atoms, targets).coef_.T
    np.testing.assert_allclose(
        cost(atoms, targets, codes.weights, penalty),
        cost(atoms, targets, theirs, penalty),
        rtol=1e-7,
    )
    np.testing.assert_allclose(codes.weights, theirs, atol=1e-3)
    assert (codes.gap <= 1e-9).all()


def test_the_duality_gap_bounds_what_is_missing_to_the_optimum():
    atoms, targets = correlated_dictionary(1)
    best = encode(atoms, targets, 0.3, tolerance=1e-10, most_iterations=50_000)
    least = cost(atoms, targets, best.weights, 0.3)
    for steps in (10, 30, 100):
        codes = encode(atoms, targets, 0.3, tolerance=0.0, most_iterations=steps)
        excess = (cost(atoms, targets, codes.weights, 0.3) - least) / np.sum(targets**2 / 2, axis=0)
        assert codes.iterations == steps
        assert (excess <= codes.gap + 1e-9).all()
        assert (codes.gap > 0).all()


def test_a_column_stops_when_it_is_good_enough_and_does_not_depend_on_the_others():
    atoms, targets = correlated_dictionary(2)
    together = encode(atoms, targets, 0.3, tolerance=1e-5, most_iterations=5000)
    assert (together.gap <= 1e-5).all()
    for column in (0, 7):
        alone = encode(atoms, targets[:, [column]], 0.3, tolerance=1e-5, most_iterations=5000)
        np.testing.assert_allclose(alone.weights[:, 0], together.weights[:, column], atol=1e-9)


def test_a_larger_penalty_uses_fewer_atoms_and_a_huge_one_none():
    atoms, targets = correlated_dictionary(3)
    used = [
        np.count_nonzero(encode(atoms, targets, penalty, tolerance=1e-7).weights)
        for penalty in (0.05, 0.5, 5.0)
    ]
    assert used == sorted(used, reverse=True)
    assert not encode(atoms, targets, 100.0).weights.any()


def test_a_good_start_needs_fewer_steps_to_the_same_codes():
    atoms, targets = correlated_dictionary(4)
    cold = encode(atoms, targets, 0.3, tolerance=1e-8, most_iterations=5000)
    warm = encode(atoms, targets, 0.3, tolerance=1e-8, most_iterations=5000, start=cold.weights)
    assert warm.iterations < cold.iterations
    np.testing.assert_array_equal(warm.weights, cold.weights)


def test_products_that_are_known_give_the_same_codes():
    atoms, targets = correlated_dictionary(5)
    direct = encode(atoms, targets, 0.3)
    gram = encode_gram(atoms.T @ atoms, atoms.T @ targets, np.sum(targets**2, axis=0), 0.3)
    np.testing.assert_allclose(gram.weights, direct.weights, atol=1e-10)


def test_nothing_to_code_and_silent_atoms_are_no_trouble():
    atoms, targets = correlated_dictionary(6)
    assert encode(atoms, targets[:, :0], 0.1).weights.shape == (ATOMS, 0)
    assert not encode(np.zeros_like(atoms), targets, 0.1).weights.any()
    assert not encode(atoms, np.zeros_like(targets), 0.1).weights.any()


def test_impossible_requests_are_refused():
    atoms, targets = correlated_dictionary()
    with pytest.raises(ValueError, match="must be above 0, not 0"):
        encode(atoms, targets, 0.0)
    with pytest.raises(ValueError, match="atoms have 40 rows, targets 39"):
        encode(atoms, targets[:-1], 0.1)


def test_progress_rises_to_one_and_may_cancel():
    atoms, targets = correlated_dictionary()
    told = []
    encode(atoms, targets, 0.1, tolerance=0.0, most_iterations=200, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def cancel(fraction):
        if fraction > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        encode(atoms, targets, 0.1, tolerance=0.0, most_iterations=200, progress=cancel)
