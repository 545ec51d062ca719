"""What falls into each pixel column of a time axis: exact however far it is zoomed out. No Qt."""

import numpy as np
from numpy.typing import NDArray

BLOCK = 64


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
    """The extremes of one trajectory, so that a picture of 100,000 frames costs like one of 1,000.

    Parameters
    ----------
    values : ndarray, shape (frames, 3)
        A marker's coordinates, NaN where missing.
    """

    def __init__(self, values: NDArray[np.float64]) -> None:
        self._values = values
        whole = len(values) // BLOCK * BLOCK
        blocks = values[:whole].reshape(-1, BLOCK, 3)
        missing = np.isnan(blocks)
        self._low = np.where(missing, np.inf, blocks).min(axis=1, initial=np.inf)
        self._high = np.where(missing, -np.inf, blocks).max(axis=1, initial=-np.inf)

    def line(self, axis: int, start: float, stop: float, width: int) -> NDArray[np.float64]:
        """Return the polyline that draws one coordinate over a range of frames.

        Parameters
        ----------
        axis : int
            0, 1 or 2.
        start, stop : float
            The visible frames.
        width : int
            Pixels that they take.

        Returns
        -------
        ndarray, shape (n, 2)
            Frame and value; NaN values break the line. At most about four points per pixel.
        """
        first = max(0, int(np.floor(start)) - 1)
        last = min(len(self._values), int(np.ceil(stop)) + 2)
        per_pixel = (last - first) / max(1, width)
        if per_pixel <= 4:
            return np.stack((np.arange(first, last), self._values[first:last, axis]), axis=1)
        if per_pixel < 2 * BLOCK:
            bucket = int(per_pixel)
            count = (last - first) // bucket
            part = self._values[first : first + count * bucket, axis].reshape(count, bucket)
            with np.errstate(invalid="ignore"):
                low, high = np.fmin.reduce(part, axis=1), np.fmax.reduce(part, axis=1)
        else:
            bucket = int(per_pixel / BLOCK) * BLOCK
            group = bucket // BLOCK
            begin = first // BLOCK
            count = max(1, (min(last // BLOCK, len(self._low)) - begin) // group)
            part_of = slice(begin, begin + count * group)
            low = self._low[part_of, axis].reshape(count, group).min(axis=1)
            high = self._high[part_of, axis].reshape(count, group).max(axis=1)
            first = begin * BLOCK
        line = np.empty((2 * count, 2))
        line[0::2, 0] = line[1::2, 0] = first + (np.arange(count) + 0.5) * bucket
        # Low and high alternate, so that neighbouring buckets join without a zigzag.
        flip = np.arange(count) % 2 == 1
        line[0::2, 1] = np.where(flip, high, low)
        line[1::2, 1] = np.where(flip, low, high)
        line[~np.isfinite(line[:, 1]), 1] = np.nan
        return line
