"""Short names of array types."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


def running_count(values: ArrayLike) -> IntArray:
    """Return how many there are before each place along the first axis, and in all.

    Parameters
    ----------
    values : array_like of bool or int, shape (places, ...)

    Returns
    -------
    ndarray of int, shape (places + 1, ...)
        What lies from a to b is the difference of the counts at b and a.
    """
    values = np.asarray(values)
    counts = np.zeros((values.shape[0] + 1, *values.shape[1:]), dtype=np.int64)
    np.cumsum(values, axis=0, out=counts[1:])
    return counts


def evenly(items: IntArray, most: int) -> IntArray:
    """Return at most so many of the items, evenly spread, the first and the last among them."""
    if items.size <= most:
        return items
    return items[np.linspace(0, items.size - 1, most).round().astype(np.int64)]


def add_ridge(gram: FloatArray, weight: float) -> None:
    """Add a share of the mean of a Gram matrix' diagonal to the diagonal, in place.

    Parameters
    ----------
    gram : ndarray, shape (n, n)
        Changed.
    weight : float
        The share; a trifle more is added, so that nothing but zeros can be solved too.
    """
    gram[np.diag_indices_from(gram)] += weight * np.trace(gram) / len(gram) + 1e-12
