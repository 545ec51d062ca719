"""The length unit and the axis that points up, as a file states them or guessed from its data."""

import numpy as np
from numpy.typing import NDArray

from mocapmend_algorithms.recording import UpAxis

AXES: dict[str, UpAxis] = {
    "+x": "+x", "-x": "-x", "+y": "+y", "-y": "-y", "+z": "+z", "-z": "-z",
}  # fmt: skip
UNITS = {
    "mm": "mm", "mill": "mm", "cm": "cm", "cent": "cm", "dm": "dm", "deci": "dm",
    "m": "m", "mete": "m", "metr": "m",
    "in": "in", "inch": "in", "ft": "ft", "feet": "ft", "foot": "ft",
}  # fmt: skip
"""Units by the first four letters of what files write."""

LARGEST_IN_METRES = 20.0
SAMPLED_FRAMES = 200
FEWEST_MARKERS = 6


def length_unit(points: NDArray[np.float64], stated: str, warnings: list[str]) -> str:
    """Return the unit as a key of `MM_PER_UNIT`.

    Where the file states none that is known: metres if no marker is farther than 20 from the
    origin, else millimetres.
    """
    unit = UNITS.get(stated.strip().lower()[:4].strip())
    if unit is not None:
        return unit
    sample = np.abs(present_samples(points))
    unit = "m" if sample.size and sample.max() < LARGEST_IN_METRES else "mm"
    said = f"an unknown length unit ({stated:.20})" if stated else "no length unit"
    if points.size:
        warnings.append(f"The file states {said}; {unit} is assumed from the size of its numbers.")
    return unit


def assumed_up(points: NDArray[np.float64], warnings: list[str]) -> UpAxis:
    """Guess the axis that points up where the file does not say it, and warn."""
    guess = guess_up(points)
    if points.size:
        warnings.append(f"The file does not say which axis points up; {guess} is a guess.")
    return guess


def present_samples(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the present samples of some frames, shape (samples, 3)."""
    some = points[:: max(len(points) // SAMPLED_FRAMES, 1)].reshape(-1, 3)
    return some[~np.isnan(some[:, 0])]


def guess_up(points: NDArray[np.float64]) -> UpAxis:
    """Guess the axis along which the body is long, travels little and stands on zero."""
    some = points[:: max(len(points) // SAMPLED_FRAMES, 1)]
    some = some[~np.isnan(some[..., 0]).all(axis=1)] if some.size else some
    if not some.size or some.shape[1] < FEWEST_MARKERS:
        return "+z"
    low, middle, high = np.nanpercentile(some, [10, 50, 90], axis=1)
    spread = np.median(high - low, axis=0)
    travel = np.std(middle, axis=0)
    below, above = np.nanpercentile(some.reshape(-1, 3), [2, 98], axis=0)
    down = (above < 0.1 * spread) & (below < -0.5 * spread)
    floor = np.where(down, -above, below)
    stands = np.select([floor < -0.1 * spread, floor < 0.3 * spread], [0.5, 2.0], 1.0)
    # Files with x up hardly exist, and most have z up.
    prior = np.array([0.7, 1.0, 1.2])
    score = prior * stands * spread**2 / (spread + 2 * travel + np.finfo(float).tiny)
    best = int(np.argmax(score))
    return AXES[("-" if down[best] else "+") + "xyz"[best]]
