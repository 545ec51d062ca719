"""What the members of a blend say of a gap and of its trials."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class Candidate:
    """A fill, and what it leaves over in the trials; in mm, in the world's axes.

    Attributes
    ----------
    values : ndarray, shape (length, 3)
    spread : ndarray, shape (length,)
        How unsure it is, in its own unit.
    errors : tuple of ndarray, shape (judged, 3)
        Per trial: the truth minus the fill.
    spreads : tuple of ndarray, shape (judged,)
        `spread` of the same.
    """

    values: FloatArray
    spread: FloatArray
    errors: tuple[FloatArray, ...]
    spreads: tuple[FloatArray, ...]

    @property
    def error(self) -> float:
        """Root mean square of what it leaves over along each axis; NaN without trials."""
        if not self.errors:
            return float("nan")
        return float(np.sqrt(np.mean(np.concatenate(self.errors) ** 2)))
