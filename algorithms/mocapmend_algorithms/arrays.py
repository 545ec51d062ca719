"""Short names of array types."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


def evenly(items: IntArray, most: int) -> IntArray:
    """Return at most so many of the items, evenly spread, the first and the last among them."""
    if items.size <= most:
        return items
    return items[np.linspace(0, items.size - 1, most).round().astype(np.int64)]
