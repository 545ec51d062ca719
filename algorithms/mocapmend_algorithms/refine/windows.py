"""Windows of a long recording: which a network sees, and which of their frames are kept (Y23, 2.5).

The paper moves a window of 120 frames by one frame and keeps its middle frame; moving it by 60 and
keeping its middle 60 costs a sixtieth.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray

LENGTH = 120
"""Frames of a window."""
STRIDES = (1, 60)


@dataclass(frozen=True, eq=False)
class Windows:
    """Where the windows of a recording lie.

    Attributes
    ----------
    starts : ndarray of int, shape (windows,)
        First frame of each, ascending; the last window ends with the recording.
    cuts : ndarray of int, shape (windows + 1,)
        Frames cuts[i] to cuts[i + 1] - 1 are taken from window i.
    frames : int
        Of the recording.
    """

    starts: IntArray
    cuts: IntArray
    frames: int

    @classmethod
    def over(cls, frames: int, stride: int) -> "Windows":
        """Lay windows over a recording of so many frames, at least one.

        Raises
        ------
        ValueError
            If there is no frame, or the stride leaves frames out.
        """
        if frames < 1 or not 1 <= stride <= LENGTH:
            raise ValueError(f"no windows with a stride of {stride} over {frames} frames")
        last = max(frames - LENGTH, 0)
        starts = np.append(np.arange(0, last, stride), last).astype(np.int64)
        # The middle frames of a window; those at either end of the recording have no other.
        cuts = starts + (LENGTH - stride) // 2
        cuts[0] = 0
        return cls(starts, np.append(cuts, frames), frames)

    def slice(self, first: int, last: int) -> "Windows":
        """Return the windows first to last - 1."""
        return Windows(self.starts[first:last], self.cuts[first : last + 1], self.frames)

    def cut_out(self, points: FloatArray) -> FloatArray:
        """Return the windows, shape (windows, LENGTH, ...), of points of shape (frames, ...).

        The last frame of a recording shorter than a window holds to its end.
        """
        at = np.minimum(self.starts[:, None] + np.arange(LENGTH), self.frames - 1)
        return np.asarray(points[at], dtype=np.float64)

    def joined(self, windows: FloatArray) -> FloatArray:
        """Join what is kept of windows, shape (windows, LENGTH, ...); see `cut_out`."""
        kept = [
            window[first - start : stop - start]
            for window, start, first, stop in zip(
                windows, self.starts, self.cuts[:-1], self.cuts[1:], strict=True
            )
        ]
        return np.concatenate(kept)
