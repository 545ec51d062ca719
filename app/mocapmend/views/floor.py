"""The ground grid under the body."""

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms import Recording


def floor_grid(
    recording: Recording, turn: NDArray[np.float64], path: NDArray[np.float64], size: float
) -> NDArray[np.float64]:
    """Return the line ends of a grid under the whole capture.

    Parameters
    ----------
    recording : Recording
        Its lowest markers give the height of the ground.
    turn : ndarray, shape (3, 3)
        Brings the file's axes upright: points @ turn.
    path : ndarray, shape (places, 3)
        Where the body goes, upright.
    size : float
        Radius of the body in the recording's unit.

    Returns
    -------
    ndarray, shape (2 * lines, 3)
        Pairs of ends; cells of half a metre, coarser where the capture is large.
    """
    step = max(1, recording.frames // 300)
    heights = (recording.points[::step] @ turn)[:, :, 2]
    heights = heights[np.isfinite(heights)]
    if not heights.size:
        return np.empty((0, 3))
    ground = float(np.percentile(heights, 0.5))
    # Most files put the ground at zero; a marker's height above it is not the ground's.
    if 0.0 <= ground < 0.25 * size:
        ground = 0.0
    cell = 500.0 / recording.mm
    low = path[:, :2].min(axis=0) - 1.5 * size
    high = path[:, :2].max(axis=0) + 1.5 * size
    while (high - low).max() / cell > 30:
        cell *= 2.0
    low, high = np.floor(low / cell) * cell, np.ceil(high / cell) * cell
    lines = []
    for axis in (0, 1):
        other = 1 - axis
        count = round((high[axis] - low[axis]) / cell) + 1
        # Cut into cells, so that a line that passes the camera loses only its near part.
        cuts = np.linspace(low[other], high[other], round((high[other] - low[other]) / cell) + 1)
        for at in np.linspace(low[axis], high[axis], count):
            ends = np.full((2 * (len(cuts) - 1), 3), ground)
            ends[:, axis] = at
            ends[0::2, other] = cuts[:-1]
            ends[1::2, other] = cuts[1:]
            lines.append(ends)
    return np.concatenate(lines)
