"""The Newton solver of sparse codes, against two others and its own certificate."""

import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mocapmend_algorithms.progress import Cancelled
from mocapmend_algorithms.sparse.newton import COLUMNS, Coder


def value(dictionary, targets, weights, penalty):
    left = targets - dictionary @ weights
    return np.sum(left**2, axis=0) / 2 + penalty * np.abs(weights).sum(axis=0)


def gradient_steps(dictionary, targets, penalty, steps=5000):
    """Minimise the same by accelerated proximal gradient steps (Beck and Teboulle 2009)."""
    step = 1 / max(np.linalg.norm(dictionary, 2) ** 2, 1e-12)
    weights = ahead = np.zeros((dictionary.shape[1], targets.shape[1]))
    momentum = 1.0
    for _ in range(steps):
        moved = ahead - step * (dictionary.T @ (dictionary @ ahead - targets))
        new = moved - np.clip(moved, -step * penalty, step * penalty)
        after = (1 + np.sqrt(1 + 4 * momentum**2)) / 2
        ahead = new + (momentum - 1) / after * (new - weights)
        weights, momentum = new, after
    return weights


def much_alike(rows, atoms, seed=0):
    """Atoms that differ a lot in few directions, and ever less in others."""
    rng = np.random.default_rng(seed)
    size = 10.0 ** -np.linspace(0, 3, rows)
    turn = np.linalg.qr(rng.normal(size=(rows, rows)))[0]
    dictionary = turn @ (size[:, None] * rng.normal(size=(rows, atoms)))
    return dictionary / np.sqrt(np.mean(np.sum(dictionary**2, axis=0)))


@pytest.mark.parametrize("penalty", [1e-1, 1e-3, 1e-5])
def test_the_value_is_that_of_scikit_learn(penalty):
    linear_model = pytest.importorskip("sklearn.linear_model")
    dictionary = much_alike(30, 120)
    targets = much_alike(30, 20, seed=1)
    found = Coder.of(dictionary).encode(targets, penalty, tolerance=1e-6)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that its steps are small on atoms so much alike
        theirs = np.stack(
            [
                linear_model.LassoLars(
                    alpha=penalty / 30, fit_intercept=False, max_iter=5000, eps=1e-14
                )
                .fit(dictionary, target)
                .coef_
                for target in targets.T
            ],
            axis=1,
        )
    ours = value(dictionary, targets, found.weights, penalty)
    reached = value(dictionary, targets, theirs, penalty)
    # Where the penalty is tiny, theirs stops a little above the minimum.
    np.testing.assert_allclose(ours, reached, rtol=0.01)
    assert (ours <= 1.0001 * reached).all()


@settings(max_examples=40)
@given(
    rows=st.integers(1, 12),
    atoms=st.integers(1, 30),
    columns=st.integers(1, 5),
    penalty=st.sampled_from([1e-3, 1e-1, 10.0]),
    seed=st.integers(0, 1000),
)
def test_gradient_steps_find_the_same_value(rows, atoms, columns, penalty, seed):
    rng = np.random.default_rng(seed)
    dictionary = rng.normal(size=(rows, atoms)) / np.sqrt(rows)
    targets = rng.normal(size=(rows, columns)) / np.sqrt(rows)
    newton = Coder.of(dictionary).encode(targets, penalty)
    steps = gradient_steps(dictionary, targets, penalty)
    ours = value(dictionary, targets, newton.weights, penalty)
    theirs = value(dictionary, targets, steps, penalty)
    energy = np.sum(targets**2, axis=0) / 2
    assert (ours <= theirs * 1.001 + 1e-6 * energy).all()
    assert (newton.gap * energy <= 1.001e-3 * ours + 1e-6 * energy).all()


def test_the_duality_gap_bounds_what_is_missing_to_the_minimum():
    dictionary, targets = much_alike(30, 120), much_alike(30, 20, seed=1)
    coder = Coder.of(dictionary)
    least = value(dictionary, targets, coder.encode(targets, 1e-2, tolerance=1e-9).weights, 1e-2)
    for tolerance in (0.5, 0.1, 1e-3):
        codes = coder.encode(targets, 1e-2, tolerance=tolerance)
        reached = value(dictionary, targets, codes.weights, 1e-2)
        energy = np.sum(targets**2, axis=0) / 2
        assert (reached - least <= codes.gap * energy + 1e-9 * energy).all()
        assert (codes.gap * energy <= tolerance * reached).all()


def test_a_larger_penalty_uses_fewer_atoms_and_a_huge_one_none():
    dictionary, targets = much_alike(30, 120), much_alike(30, 20, seed=1)
    coder = Coder.of(dictionary)
    used = [np.count_nonzero(coder.encode(targets, p).weights) for p in (1e-3, 1e-2, 1e-1, 100.0)]
    assert used == sorted(used, reverse=True)
    assert used[-1] == 0


def test_the_code_of_an_atom_is_that_atom_alone():
    dictionary = much_alike(20, 60)
    weights = Coder.of(dictionary).encode(dictionary[:, :5], 1e-6, tolerance=1e-6).weights
    np.testing.assert_allclose(dictionary @ weights, dictionary[:, :5], atol=1e-3)
    assert np.abs(weights).sum() < 5.01


@pytest.mark.parametrize("dictionary", [np.zeros((3, 4)), np.zeros((0, 4)), np.ones((3, 4))])
def test_dictionaries_without_variety_are_no_trouble(dictionary):
    codes = Coder.of(dictionary).encode(np.ones((dictionary.shape[0], 2)), 0.01)
    assert np.isfinite(codes.weights).all()
    assert codes.weights.shape == (4, 2)
    np.testing.assert_allclose(dictionary @ codes.weights, dictionary[:, :2], atol=0.01)


def test_no_columns_and_zero_columns_have_codes_of_zero():
    coder = Coder.of(much_alike(5, 9))
    assert coder.encode(np.zeros((5, 0)), 0.1).weights.shape == (9, 0)
    assert not coder.encode(np.zeros((5, 3)), 0.1).weights.any()


def test_a_penalty_of_zero_is_refused():
    with pytest.raises(ValueError, match="above 0, not 0"):
        Coder.of(np.eye(3)).encode(np.ones((3, 1)), 0.0)


def test_progress_is_called_within_a_batch_and_may_cancel():
    coder, targets = Coder.of(much_alike(20, 60)), much_alike(20, COLUMNS + 1, seed=2)
    calls = []
    coder.encode(targets, 1e-4, progress=calls.append)
    assert calls == sorted(calls)
    assert len(calls) > 6
    assert calls[-1] == 1.0

    def cancel(fraction):
        if fraction > 0:
            raise Cancelled

    with pytest.raises(Cancelled):
        coder.encode(targets, 1e-4, progress=cancel)
