"""Windows of several frames, stacked to one column, and the average where they overlap."""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray


@dataclass(frozen=True)
class Span:
    """Which frames make up a window.

    Attributes
    ----------
    offsets : tuple of int
        Frames relative to the window's place, ascending.
    """

    offsets: tuple[int, ...]

    @classmethod
    def over(cls, frames: int, length: int) -> "Span":
        """Spread a number of frames evenly over a length, in frames; next to each other at least.

        W18's windows are 6 frames next to each other (its section 1.3, stride 1).
        """
        step = max(1, round(length / max(frames - 1, 1)))
        return cls(tuple((2 * at - (frames - 1)) * step // 2 for at in range(frames)))

    @property
    def before(self) -> int:
        """How many frames it reaches back."""
        return -self.offsets[0]

    @property
    def after(self) -> int:
        """How many frames it reaches ahead."""
        return self.offsets[-1]

    @property
    def middle(self) -> int:
        """The frame in the middle, relative to the place: that of the heading."""
        return self.offsets[len(self.offsets) // 2]

    @property
    def reach(self) -> int:
        """Frames from the first to the last, both counted."""
        return self.before + self.after + 1

    def frames(self, places: IntArray) -> IntArray:
        """Return the frames of windows, shape (places, frames of a window)."""
        frames: IntArray = places[:, None] + np.array(self.offsets)
        return frames

    def inside(self, start: int, stop: int) -> IntArray:
        """Return the places of all windows that lie in a stretch of frames."""
        return np.arange(start + self.before, stop - self.after)

    def touching(self, start: int, stop: int, frames: int) -> IntArray:
        """Return the places of the windows of a recording that hold frames of a stretch."""
        places = self.inside(0, frames)
        hold = self.frames(places)
        chosen: IntArray = places[((hold >= start) & (hold < stop)).any(axis=1)]
        return chosen

    def average(self, windows: FloatArray, places: IntArray, start: int, stop: int) -> FloatArray:
        """Average what overlapping windows say of each frame (W18, section 3.2).

        Parameters
        ----------
        windows : ndarray, shape (places, frames of a window, ...)
            What they say.
        places : ndarray of int
            Where they are.
        start, stop : int
            The frames asked for.

        Returns
        -------
        ndarray, shape (stop - start, ...)
            NaN where no window holds a frame.
        """
        total = np.zeros((stop - start, *windows.shape[2:]))
        count = np.zeros(stop - start)
        for at, offset in enumerate(self.offsets):
            frame = places + offset - start
            here = (frame >= 0) & (frame < stop - start)
            total[frame[here]] += windows[here, at]
            count[frame[here]] += 1
        with np.errstate(invalid="ignore"):
            mean: FloatArray = total / count.reshape(-1, *[1] * (windows.ndim - 2))
        return mean
