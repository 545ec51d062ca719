"""Where the body is and how large it is: what the camera follows. No Qt."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PER_SECOND = 10.0
"""Places of the body that are looked at to follow it."""
REACH = 5
"""Places before and after that it is smoothed over: a second in all."""
OVERVIEW = 300
"""Places of the whole recording that are looked at when it is opened."""


class BodyPath:
    """The middle of the body's extent, smoothed over a second.

    Only an overview is computed when it is made; each frame's place when it is asked for.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        NaN where missing.
    rate : float
        Frames per second (Hz).
    """

    def __init__(self, points: Array, rate: float) -> None:
        self._points = points
        self._step = max(1, round(rate / PER_SECOND))
        self._count = -(-len(points) // self._step)
        self._at = np.arange(0, self._count, max(1, self._count // OVERVIEW))
        centres = self._centres(self._at)
        seen = np.isfinite(centres[:, 0])
        self.overview = np.zeros((max(1, len(self._at)), 3))
        """Places through the whole recording, shape (places, 3): finite."""
        if seen.any():
            for axis in range(3):
                self.overview[:, axis] = np.interp(self._at, self._at[seen], centres[seen, axis])

    def at(self, frame: int) -> Array:
        """Return where the body is in a frame, shape (3,): finite."""
        if not self._points.size:
            return np.zeros(3)
        before, rest = divmod(frame, self._step)
        places = np.arange(before - REACH, before + REACH + 2).clip(0, self._count - 1)
        centres = self._centres(places)
        unseen = np.isnan(centres[:, 0])
        for axis in range(3) if unseen.any() else ():
            known = self.overview[:, axis]
            centres[unseen, axis] = np.interp(places[unseen], self._at, known)
        share = rest / self._step
        smooth: Array = (1.0 - share) * centres[:-1].mean(axis=0) + share * centres[1:].mean(axis=0)
        return smooth

    def size(self) -> float:
        """Return the radius around the path that holds nearly all markers."""
        if not self._points.size:
            return 1.0
        points = self._points[self._at * self._step]
        reach = np.linalg.norm(points - self.overview[:, None], axis=2)
        reach = reach[np.isfinite(reach)]
        radius = float(np.percentile(reach, 98.0)) if reach.size else 0.0
        return radius if radius > 0.0 else 1.0

    def _centres(self, places: NDArray[np.intp]) -> Array:
        """Return the middle of the extent at places, shape (places, 3); NaN without markers."""
        centres = np.full((len(places), 3), np.nan)
        ordered = np.sort(self._points[places * self._step], axis=1)
        count = np.count_nonzero(~np.isnan(ordered[:, :, 0]), axis=1)
        rows = np.flatnonzero(count)
        # Not the outermost markers: a ghost far from the body must not move the picture.
        outermost = np.floor(0.05 * (count[rows] - 1)).astype(np.intp)
        low, high = ordered[rows, outermost], ordered[rows, count[rows] - 1 - outermost]
        centres[rows] = (low + high) / 2.0
        return centres
