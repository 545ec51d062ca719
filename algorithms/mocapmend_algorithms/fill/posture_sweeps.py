"""Which frames a posture is smoothed in, and where that puts the missing markers (BL16).

For the reference, the steps and where they deviate see `burke_lasenby`; these are 3 and 4.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.fill.edges import Modelled, with_edges
from mocapmend_algorithms.fill.posture_space import PostureSpace, coordinates
from mocapmend_algorithms.fill.walk_smoother import smooth
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

AROUND = 8
"""Complete frames on each side that the smoother sees; see the deviations."""
MOST_AROUND = 100
"""Where frames are seldom complete, it sees no more than this many."""
MOST_BYTES = 64e6
"""For the gains of one sweep: longer ones are cut."""


def follow(
    recording: Recording,
    observed: BoolArray,
    space: PostureSpace,
    gaps: Sequence[Gap],
    progress: Progress,
) -> dict[Gap, Modelled]:
    """Say where markers are in their gaps and beside them.

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    space : PostureSpace
        In which the posture moves.
    gaps : sequence of Gap
        Of markers that span it.
    progress : Progress
        Called often.

    Returns
    -------
    dict of Gap to Modelled
    """
    said: dict[Gap, Modelled] = {}
    sweeps = _sweeps(observed, space, gaps)
    for done, (start, stop, among) in enumerate(sweeps):
        share = part(progress, done / len(sweeps), (done + 1) / len(sweeps))
        said |= _Sweep(recording, observed, space, start, stop).say(among, share)
    return said


def _sweeps(
    observed: BoolArray, space: PostureSpace, gaps: Sequence[Gap]
) -> list[tuple[int, int, list[Gap]]]:
    """Put gaps of the same frames together: first frame to smooth, last frame + 1, the gaps."""
    complete = space.complete
    sweeps: dict[tuple[int, int], list[Gap]] = {}
    for gap in gaps:
        before = int(np.searchsorted(complete, gap.start)) - AROUND
        after = int(np.searchsorted(complete, gap.stop)) + AROUND - 1
        first = int(complete[before]) if before >= 0 else 0
        last = int(complete[after]) if after < complete.size else observed.shape[0] - 1
        first, last = max(first, gap.start - MOST_AROUND), min(last, gap.stop + MOST_AROUND)
        sweeps.setdefault((first, last + 1), []).append(gap)
    return [(start, stop, among) for (start, stop), among in sweeps.items()]


@dataclass(frozen=True, eq=False)
class _Sweep:
    """Frames that are smoothed together."""

    recording: Recording
    observed: BoolArray
    space: PostureSpace
    start: int
    stop: int

    def say(self, gaps: Sequence[Gap], progress: Progress) -> dict[Gap, Modelled]:
        """Say where the markers are in their gaps and beside them."""
        ranges = {gap: with_edges(self.observed, gap) for gap in gaps}
        values = {gap: np.empty((stop - start, 3)) for gap, (start, stop) in ranges.items()}
        states = self.space.walk.process.shape[0]
        most = max(int(MOST_BYTES / (8 * states**2)), 4 * MOST_AROUND)
        for first in range(self.start, self.stop, most):
            last = min(first + most, self.stop)
            share = self.stop - self.start
            postures = self._smooth(
                first,
                last,
                part(progress, (first - self.start) / share, (last - self.start) / share),
            )
            for gap, (start, stop) in ranges.items():
                a, b = max(start, first), min(stop, last)
                if a < b:
                    values[gap][a - start : b - start] = self._place(
                        postures[a - first : b - first], gap.marker
                    )
        return {gap: Modelled(one, self.space.notes) for gap, one in values.items()}

    def _smooth(self, first: int, last: int, progress: Progress) -> FloatArray:
        begin = max(first - MOST_AROUND, self.start)
        frames = np.arange(begin, min(last + MOST_AROUND, self.stop))
        values = coordinates(self.recording, frames, self.space.markers) - self.space.mean
        seen = np.repeat(self.observed[np.ix_(frames, self.space.markers)], 3, axis=1)
        return smooth(self.space.walk, values, seen, progress)[first - begin :][: last - first]

    def _place(self, postures: FloatArray, marker: int) -> FloatArray:
        at = 3 * int(np.searchsorted(self.space.markers, marker))
        rows = self.space.walk.loadings[at : at + 3]
        placed: FloatArray = postures @ rows.T + self.space.mean[at : at + 3]
        return placed / self.recording.mm
