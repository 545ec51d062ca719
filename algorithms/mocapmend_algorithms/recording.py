"""The one in-memory form of a recording that every algorithm takes."""

from dataclasses import InitVar, dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

UpAxis = Literal["+x", "-x", "+y", "-y", "+z", "-z"]
MM_PER_UNIT = {"mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1000.0, "in": 25.4, "ft": 304.8}


@dataclass(frozen=True, eq=False)
class Recording:
    """Marker trajectories, never changed after they are made.

    Attributes
    ----------
    points : ndarray, shape (frames, markers, 3), float64
        Coordinates in `unit`; all three NaN where the marker is missing.
    labels : tuple of str, length markers
        As the file has them; not unique in general, so markers are keyed by index.
    rate : float
        Frames per second (Hz).
    unit : str
        Length unit: a key of `MM_PER_UNIT`.
    up : str
        The axis that points up, as "+z".
    first_frame : int
        Number of the first frame as the file counts it.
    seen : ndarray of bool, shape (frames, markers), optional
        What `present` is to return, where it is known already.

    Raises
    ------
    ValueError
        If the shapes contradict each other, or rate or unit are impossible.
    """

    points: NDArray[np.float64]
    labels: tuple[str, ...]
    rate: float
    unit: str = "mm"
    up: UpAxis = "+z"
    first_frame: int = 1
    seen: InitVar[NDArray[np.bool_] | None] = None

    def __post_init__(self, seen: NDArray[np.bool_] | None) -> None:
        if self.points.ndim != 3 or self.points.shape[2] != 3:
            raise ValueError(f"points must be (frames, markers, 3), not {self.points.shape}")
        if self.points.dtype != np.float64:
            raise ValueError(f"points must be float64, not {self.points.dtype}")
        if len(self.labels) != self.points.shape[1]:
            raise ValueError(f"{len(self.labels)} labels for {self.points.shape[1]} markers")
        if not (np.isfinite(self.rate) and self.rate > 0):
            raise ValueError(f"the frame rate must be positive, not {self.rate}")
        if self.unit not in MM_PER_UNIT:
            raise ValueError(f"unknown length unit {self.unit!r}")
        self.points.flags.writeable = False
        if seen is not None:
            if seen.shape != self.points.shape[:2]:
                raise ValueError(f"seen must be {self.points.shape[:2]}, not {seen.shape}")
            seen.flags.writeable = False
            # Where the cached property looks first.
            self.__dict__["present"] = seen

    @property
    def frames(self) -> int:
        """Number of frames."""
        return int(self.points.shape[0])

    @property
    def markers(self) -> int:
        """Number of markers."""
        return int(self.points.shape[1])

    @property
    def mm(self) -> float:
        """Millimetres per length unit."""
        return MM_PER_UNIT[self.unit]

    @cached_property
    def present(self) -> NDArray[np.bool_]:
        """Whether each sample is there, shape (frames, markers)."""
        present = ~np.isnan(self.points[:, :, 0])
        present.flags.writeable = False
        return present

    def with_points(self, points: NDArray[np.float64]) -> "Recording":
        """Return the same recording with other coordinates."""
        return replace(self, points=points)
