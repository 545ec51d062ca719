"""What falls into each pixel column of a time axis: exact however far it is zoomed out. No Qt."""

import numpy as np
from numpy.typing import NDArray

FACTOR = 4
"""Samples per sample of the next level; up to so many per pixel are drawn as they are."""
SMALLEST_LEVEL = 256

Floats = NDArray[np.floating]


def column_edges(start: float, stop: float, width: int) -> NDArray[np.int64]:
    """Return the first frame of each of `width` columns and the end of the last, (width + 1,)."""
    return np.floor(np.linspace(start, stop, width + 1)).astype(np.int64)


def columns_with(runs: NDArray[np.int64], edges: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Return which columns touch any run.

    Parameters
    ----------
    runs : ndarray, shape (n, 2)
        Disjoint half-open (start, stop) runs in ascending order.
    edges : ndarray, shape (width + 1,)
        As `column_edges` returns them. A column that is narrower than a frame shows its frame.

    Returns
    -------
    ndarray of bool, shape (width,)
    """
    first, end = edges[:-1], np.maximum(edges[1:], edges[:-1] + 1)
    begun = np.searchsorted(runs[:, 0], end, side="left")
    over = np.searchsorted(runs[:, 1], first, side="right")
    return np.asarray(begun > over)


class Envelope:
    """The extremes of some curves at coarser and coarser levels.

    A picture of a million samples costs like one of a thousand.

    Parameters
    ----------
    rows : ndarray, shape (curves, samples)
        NaN where missing.
    """

    def __init__(self, rows: Floats) -> None:
        self.rows = rows
        self._levels: list[tuple[Floats, Floats]] = []
        low = high = rows
        while low.shape[1] > SMALLEST_LEVEL:
            low, high = _coarser(low, FACTOR, np.fmin), _coarser(high, FACTOR, np.fmax)
            self._levels.append((low, high))
        self.empty = bool(np.isnan(low).all())
        """Whether no value is known."""

    def lines(self, start: float, stop: float, width: int) -> tuple[Floats, Floats]:
        """Return the polylines that draw all curves over a range of samples.

        Parameters
        ----------
        start, stop : float
            The visible samples.
        width : int
            Pixels that they take.

        Returns
        -------
        places : ndarray, shape (n,)
            Sample numbers: at most about four per pixel.
        values : ndarray, shape (curves, n)
            NaN values break the line.
        """
        first = max(0, int(np.floor(start)) - 1)
        last = min(self.rows.shape[1], int(np.ceil(stop)) + 2)
        per_pixel = (last - first) / max(1, width)
        if per_pixel <= FACTOR or not self._levels:
            return np.arange(first, last, dtype=float), self.rows[:, first:last]
        level = min(int(np.log(per_pixel) / np.log(FACTOR)), len(self._levels))
        block = FACTOR**level
        group = int(per_pixel / block)
        bucket = block * group
        # Buckets keep their places while the range moves, or the picture would flicker.
        begin, end = first // bucket, -(-last // bucket)
        part = slice(begin * group, end * group)
        low, high = self._levels[level - 1]
        low = _coarser(low[:, part], group, np.fmin)
        high = _coarser(high[:, part], group, np.fmax)
        count = low.shape[1]
        places = np.repeat((begin + np.arange(count) + 0.5) * bucket - 0.5, 2)
        values = np.empty((len(low), 2 * count))
        # Low and high alternate, so that neighbouring buckets join without a zigzag.
        values[:, 0::4], values[:, 1::4] = low[:, 0::2], high[:, 0::2]
        values[:, 2::4], values[:, 3::4] = high[:, 1::2], low[:, 1::2]
        return places, values


def _coarser(rows: Floats, factor: int, extreme: np.ufunc) -> Floats:
    """Return the extremes of every `factor` samples; of those at the end there may be fewer."""
    result: Floats = rows[:, ::factor].copy()
    for offset in range(1, factor):
        part = rows[:, offset::factor]
        inside = result[:, : part.shape[1]]
        extreme(inside, part, out=inside)
    return result
