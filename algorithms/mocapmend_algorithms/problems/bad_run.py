"""What a detector says about samples that are there but wrong."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class BadRun:
    """A run of samples of one marker that a detector holds for wrong.

    Attributes
    ----------
    kind : str
        Id of the detector; see `problems.registry`.
    marker : int
        Index of the marker.
    start, stop : int
        Frames start to stop - 1, counted from 0.
    score : float
        How sure, from 0 to 1.
    deviation : float
        Estimated distance between what is stored and the truth, in the recording's unit; NaN where
        unknown.
    reason : str
        One plain sentence with numbers.
    other : int or None
        The second marker of a swap or a coincidence, or the one that a fragment belongs to.
    """

    kind: str
    marker: int
    start: int
    stop: int
    score: float
    deviation: float
    reason: str
    other: int | None = None

    @property
    def length(self) -> int:
        """Number of frames."""
        return self.stop - self.start

    @property
    def harm(self) -> float:
        """Deviation times frames, which compares with gaps; 0 where the deviation is unknown."""
        return 0.0 if math.isnan(self.deviation) else self.deviation * self.length


def frames_in_words(count: int) -> str:
    """Return "1 frame" or "7 frames", for a reason."""
    return "1 frame" if count == 1 else f"{count} frames"
