"""How rough a trajectory is here and there, whatever single samples do."""

import numpy as np

from mocapmend_algorithms.arrays import FloatArray

WINDOW_S = 0.25
LEAST_WINDOW = 16
MOST_WINDOW = 128


def running_level(values: FloatArray, rate: float) -> FloatArray:
    """Return the median of what is around each place, from medians of pieces.

    Parameters
    ----------
    values : ndarray, shape (frames,)
        NaN = unknown.
    rate : float
        Frames per second: a piece has about a quarter of a second, and 16 to 128 frames.

    Returns
    -------
    ndarray, shape (frames,)
        Interpolated between the middles of the pieces; 0 where nothing is known.
    """
    frames = len(values)
    window = int(np.clip(round(WINDOW_S * rate), LEAST_WINDOW, MOST_WINDOW))
    pieces = -(-frames // window)
    padded = np.full(pieces * window, np.nan)
    padded[:frames] = values
    cut = np.sort(padded.reshape(pieces, window), axis=1)  # NaN last
    count = window - np.isnan(cut).sum(axis=1)
    known = np.flatnonzero(count >= window // 4)
    if not known.size:
        seen = values[~np.isnan(values)]
        return np.full(frames, np.median(seen) if seen.size else 0.0)
    middle = cut[known, (count[known] - 1) // 2]
    level: FloatArray = np.interp(np.arange(frames), (known + 0.5) * window, middle)
    return level
