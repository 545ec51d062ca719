"""The cut-offs that methods with a penalty choose from."""

import numpy as np

PER_DECADE = 20
SLOWEST = 0.012
"""Radians per frame: below, the equations lose their digits."""
SLOWEST_HZ = 0.25


def cutoff_grid(rate: float) -> tuple[float, ...]:
    """Return cut-offs in Hz, descending from half the frame rate, evenly by their logarithm."""
    highest = rate / 2
    lowest = min(max(SLOWEST_HZ, SLOWEST * rate / (2 * np.pi)), highest / 2)
    count = int(PER_DECADE * np.log10(highest / lowest)) + 2
    return tuple(np.geomspace(highest, lowest, count).tolist())
