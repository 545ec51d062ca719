"""A force plate as a recording has it, whatever the format of its file."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class ForcePlate:
    """A force plate; what the file does not say is None, NaN or empty.

    Attributes
    ----------
    type : int or None
        The kind of its channels, as c3d.org numbers them.
    corners : ndarray, shape (4, 3), float64
        In the recording's unit and axes.
    origin : ndarray, shape (3,), float64
        From the origin of the sensors to the middle of the surface or back, as the type has it,
        in the recording's unit and the plate's axes.
    channels : tuple of int
        Its analog channels, from 0, as the columns of `C3DFile.read_analog`.
    """

    type: int | None
    corners: NDArray[np.float64]
    origin: NDArray[np.float64]
    channels: tuple[int, ...]

    @property
    def spans_surface(self) -> bool:
        """Whether the corners are known and not all in one line."""
        across, along = self.corners[2] - self.corners[0], self.corners[3] - self.corners[1]
        # Not greater than 0: that is also what is not a number.
        return bool(np.linalg.norm(np.cross(across, along)) > 0)
