"""The outline of a few points."""

import numpy as np
from numpy.typing import NDArray


def hull(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the corners of the smallest convex shape around points.

    Andrew's monotone chain: quick for the handful of markers that a segment has.

    Parameters
    ----------
    points : ndarray, shape (n, 2)
        Finite.

    Returns
    -------
    ndarray, shape (corners, 2)
        In turn around the shape; one or two where the points span no surface.
    """
    ordered = sorted(set(map(tuple, points.tolist())))
    if len(ordered) < 3:
        return np.array(ordered).reshape(-1, 2)
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return np.array(lower[:-1] + upper[:-1])


def _chain(ordered: list[tuple[float, ...]]) -> list[tuple[float, ...]]:
    """Return one side of the shape: the points where it turns left."""
    side: list[tuple[float, ...]] = []
    for x, y in ordered:
        while len(side) > 1:
            (ax, ay), (bx, by) = side[-2:]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0.0:
                break
            side.pop()
        side.append((x, y))
    return side
