"""Completion by the smallest nuclear norm: the optimum, its certificate, a second method."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mocapmend_algorithms import Cancelled
from mocapmend_algorithms.sparse.nuclear_norm import complete, complete_rows, row_weights


def low_rank(rows, columns, rank, *, seed=0, noise=0.0):
    rng = np.random.default_rng(seed)
    matrix = rng.normal(size=(rows, rank)) @ rng.normal(size=(rank, columns))
    return matrix + noise * rng.normal(size=matrix.shape)


def nuclear(matrix):
    return np.linalg.svd(matrix, compute_uv=False).sum()


def singular_value_thresholding(matrix, known, threshold, steps):
    """Iterate as Cai, Candes and Shen 2010 do, equation 2.7 and section 5.1."""
    step, data = 1.2 * known.size / known.sum(), np.where(known, matrix, 0.0)
    dual = np.ceil(threshold / (step * np.linalg.norm(data, 2))) * step * data
    for _ in range(steps):
        u, s, v = np.linalg.svd(dual, full_matrices=False)
        found = (u * np.maximum(s - threshold, 0.0)) @ v
        dual = dual + step * np.where(known, data - found, 0.0)
    return found


def certificate(completed, known):
    """Return a lower bound of the nuclear norm of all matrices with these known entries.

    For each L that is zero at unknown entries and has no singular value above 1, <L, Z> is at most
    |Z|_*, and it is the same for all of them.
    """
    u, _, v = np.linalg.svd(completed, full_matrices=False)
    dual = np.where(known, u @ v, 0.0)
    return np.sum(dual * completed) / max(np.linalg.norm(dual, 2), 1.0)


@settings(max_examples=10)
@given(seed=st.integers(0, 1000), rank=st.integers(1, 4), wide=st.booleans())
def test_a_matrix_of_low_rank_is_recovered_from_two_thirds_of_its_entries(seed, rank, wide):
    matrix = low_rank(80, 50, rank, seed=seed)
    matrix = matrix.T if wide else matrix
    known = np.random.default_rng(seed).random(matrix.shape) < 2 / 3
    found = complete(np.where(known, matrix, np.nan), known)
    np.testing.assert_array_equal(found[known], matrix[known])
    np.testing.assert_allclose(found, matrix, atol=1e-3)


@pytest.mark.parametrize("seed", range(3))
def test_no_matrix_with_the_known_entries_has_a_smaller_nuclear_norm(seed):
    matrix = low_rank(40, 25, 3, seed=seed, noise=0.3)
    known = np.ones(matrix.shape, dtype=bool)
    known[10:25, 5:11] = False
    known[20:30, 20:] = False
    found = complete(matrix, known)
    assert nuclear(found) < nuclear(matrix)
    assert certificate(found, known) > (1 - 1e-3) * nuclear(found)
    assert certificate(np.where(known, matrix, 0.0), known) < 0.99 * nuclear(found)


@pytest.mark.parametrize("noise", [0.0, 0.2])
def test_singular_value_thresholding_comes_to_the_same(noise):
    matrix = low_rank(30, 20, 2, noise=noise)
    known = np.random.default_rng(1).random(matrix.shape) < 0.7
    peer = singular_value_thresholding(matrix, known, 500.0, 8000)
    np.testing.assert_allclose(peer[known], matrix[known], atol=1e-3)
    found = complete(matrix, known)
    assert nuclear(found) == pytest.approx(nuclear(np.where(known, matrix, peer)), rel=1e-4)
    np.testing.assert_allclose(found, peer, atol=0.05)


def test_each_step_at_the_threshold_comes_nearer_to_the_smallest_sum():
    matrix = low_rank(40, 20, 3, noise=0.5)
    known = np.random.default_rng(2).random(matrix.shape) < 0.6
    least = 0.2 * np.linalg.norm(np.where(known, matrix, 0.0), 2)
    sums = []
    for steps in (1, 2, 4, 8, 16, 300):
        weights = row_weights(matrix, known, threshold=0.2, tolerance=0.0, most_iterations=steps)
        values = np.linalg.svd(complete_rows(matrix, known, weights), compute_uv=False)
        sums.append(np.sqrt(values**2 + least**2).sum())
    assert (np.diff(sums) < 1e-9).all()
    assert sums[-1] < sums[0] - 0.1
    gradient = complete_rows(matrix, known, weights) @ weights
    assert np.abs(gradient[~known]).max() < 1e-9


def test_the_weights_of_a_part_of_the_rows_complete_the_others():
    matrix = low_rank(300, 20, 2)
    known = np.random.default_rng(3).random(matrix.shape) < 0.8
    part = slice(0, 150)
    weights = row_weights(matrix[part], known[part], threshold=1e-6, tolerance=1e-6)
    np.testing.assert_allclose(complete_rows(matrix, known, weights), matrix, atol=1e-3)


def test_a_block_is_drawn_towards_zero_the_less_the_smaller_its_columns():
    matrix = low_rank(300, 12, 3)
    known = np.ones(matrix.shape, dtype=bool)
    known[:100, 9:] = False
    errors = []
    for size in (1.0, 0.3, 0.01):
        scale = np.where(np.arange(12) < 9, 1.0, size)
        found = complete(matrix * scale, known) / scale
        assert np.linalg.norm(found[~known]) < np.linalg.norm(matrix[~known])
        errors.append(np.abs(found - matrix).max())
    assert errors[0] > 0.5
    assert errors[1] < 0.5 * errors[0]
    assert errors[2] < 0.05


def test_what_is_unknown_is_not_looked_at_and_the_scale_does_not_matter():
    matrix = low_rank(30, 20, 2, noise=0.2)
    known = np.random.default_rng(1).random(matrix.shape) < 0.7
    expected = complete(matrix, known)
    hidden = np.where(known, matrix, np.inf)
    np.testing.assert_array_equal(complete(hidden, known), expected)
    assert np.isinf(hidden).any()
    np.testing.assert_allclose(complete(1e-6 * matrix, known), 1e-6 * expected, rtol=1e-6)


def test_rows_and_columns_without_any_known_entry_are_zero():
    matrix = low_rank(12, 8, 2)
    known = np.ones(matrix.shape, dtype=bool)
    known[3], known[:, 5] = False, False
    found = complete(matrix, known)
    np.testing.assert_allclose(found[3], 0.0, atol=1e-9)
    np.testing.assert_allclose(found[:, 5], 0.0, atol=1e-9)
    np.testing.assert_array_equal(found[known], matrix[known])
    assert not complete(matrix, np.zeros_like(known)).any()
    assert not complete(np.zeros_like(matrix), known).any()
    np.testing.assert_array_equal(complete(matrix, np.ones_like(known)), matrix)


def test_progress_rises_to_one_and_may_cancel():
    matrix = low_rank(30, 20, 2, noise=0.2)
    known = np.random.default_rng(1).random(matrix.shape) < 0.7
    told = []
    complete(matrix, known, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0

    def cancel(fraction):
        if fraction > 0.01:
            raise Cancelled

    with pytest.raises(Cancelled):
        complete(matrix, known, progress=cancel)
