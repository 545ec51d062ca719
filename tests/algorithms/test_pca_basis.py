"""The reconstruction by principal components against a second implementation."""

import numpy as np

from mocapmend_algorithms.fill.pca_basis import reconstruction


def test_the_reconstruction_is_that_of_the_scaled_columns():
    rng = np.random.default_rng(1)
    rows = rng.normal(size=(80, 4)) @ rng.normal(size=(4, 9)) + rng.normal(0, 0.2, (80, 9))
    rows[:, 6:] *= 0.02
    coefficients, kept = reconstruction(rows.T @ rows, 6, 0.9)
    zeroed = np.hstack((rows[:, :6], np.zeros((80, 3))))
    full = np.linalg.svd(rows, full_matrices=False)
    zero = np.linalg.svd(zeroed, full_matrices=False)
    enough = [int(np.argmax(np.cumsum(s) >= 0.9 * s.sum())) + 1 for s in (full[1], zero[1])]
    assert kept == max(enough)
    pairing = np.diag(np.sum(full[2][:kept] * zero[2][:kept], axis=1))
    expected = zeroed @ zero[2][:kept].T @ pairing @ full[2][:kept]
    np.testing.assert_allclose(rows[:, :6] @ coefficients, expected[:, 6:], atol=1e-10)
