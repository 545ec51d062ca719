"""Missing markers by Kalman smoothing in a low-dimensional space.

BL16 = Burke and Lasenby 2016, "Estimating missing marker positions using low dimensional Kalman
smoothing", Journal of Biomechanics 49(9):1854-1858. Written anew; the steps and constants are
those of the first author's published program (MoGapFill, also in pyCGM2).

1. The complete frames, mean removed, span a space by singular value decomposition; as many
   directions are kept as make up 99.75 % of the sum of the singular values.
2. In that space the posture is a random walk. Its process noise is what the coordinates of the
   complete frames change by from frame to frame, projected: Q = V^T diag(...) V.
3. A Kalman filter sees in each frame the coordinates that are there, with measurement noise of
   variance 1e-3 mm^2, and a Rauch-Tung-Striebel smoother goes back over it.
4. The missing coordinates are those of the smoothed posture.

Deviations: the backward gain is the textbook's, with the covariance predicted for the next frame
(the published program takes that of the same frame); the first state has the covariance of the
complete frames and mean 0 (there: 1e12 and a random number), so that the result is the same each
time; the smoother runs over a gap and the frames around it, not over the whole recording: the
measurement noise is so small that complete frames a few frames away leave no trace; markers
that leave too few frames complete are left out; the process noise is taken from variances (there:
standard deviations, so that it depends on the unit); and the residual at the edges is carried into
the gap (`meet_edges`).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly
from mocapmend_algorithms.fill.company import LEAST_FRAMES, seen_together
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import (
    EdgeParams,
    Modelled,
    meet_edges,
    obstacle,
    with_edges,
)
from mocapmend_algorithms.fill.params import option
from mocapmend_algorithms.fill.punch import fill_with_bands
from mocapmend_algorithms.fill.walk_smoother import Walk, smooth
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

LEAST_MARKERS = 3
MOST_FRAMES = 3000
AROUND = 8
"""Complete frames on each side that the smoother sees; see the deviations."""
MOST_AROUND = 100
"""Where frames are seldom complete, it sees no more than this many."""
MOST_BYTES = 64e6
"""For the gains of one sweep: longer ones are cut."""
STILL_MM2 = 1e-8
"""Added to the process noise, so that it has an inverse where nothing moves."""


@dataclass(frozen=True)
class BurkeLasenbyParams(EdgeParams):
    """Parameters of `burke-lasenby`."""

    components: float = option(
        99.75,
        label="Components",
        text="Share of the sum of the singular values that the components kept make up.",
        minimum=50.0,
        maximum=99.9999,
        unit="%",
    )
    noise_mm: float = option(
        0.03,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate. More noise gives smoother postures.",
        minimum=1e-3,
        maximum=100.0,
        unit="mm",
    )


def burke_lasenby(
    recording: Recording, gaps: Sequence[Gap], params: BurkeLasenbyParams, progress: Progress, /
) -> FillResult:
    """Fill gaps by Kalman smoothing in a low-dimensional space (BL16).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : BurkeLasenbyParams
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With `components` and `complete_frames` in the notes. Gaps stay open where fewer than 3
        other markers are seen in most of the gap, or fewer than 10 frames are complete.
    """
    return fill_with_bands(recording, gaps, partial(_fill, params=params), progress)


def _fill(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: BurkeLasenbyParams,
) -> FillResult:
    said: dict[Gap, Modelled | str] = {gap: obstacle(observed, gap, params) for gap in gaps}
    groups = _groups(observed, [gap for gap in gaps if not said[gap]])
    for done, (markers, complete, among) in enumerate(groups):
        share = part(progress, done / len(groups), (done + 1) / len(groups))
        space = _Space.learn(recording, markers, complete, params)
        if isinstance(space, str):
            said |= dict.fromkeys(among, space)
            continue
        said |= {gap: _too_little(observed, gap, markers) for gap in among}
        told = [gap for gap in among if not said[gap]]
        said |= _say(recording, observed, space, told, share)
    progress(1.0)
    return meet_edges(recording, observed, gaps, said, params)


def _groups(observed: BoolArray, gaps: Sequence[Gap]) -> list[tuple[IntArray, IntArray, list[Gap]]]:
    """Put gaps together that share a space: its markers, its complete frames, the gaps."""
    seen = np.flatnonzero(observed.any(axis=0))
    chosen: dict[int, tuple[IntArray, IntArray]] = {}
    groups: dict[bytes, tuple[IntArray, IntArray, list[Gap]]] = {}
    for gap in gaps:
        if gap.marker not in chosen:
            chosen[gap.marker] = seen_together(observed, seen, gap.marker)
        markers, complete = chosen[gap.marker]
        groups.setdefault(markers.tobytes(), (markers, complete, []))[2].append(gap)
    return list(groups.values())


def _say(
    recording: Recording,
    observed: BoolArray,
    space: "_Space",
    gaps: Sequence[Gap],
    progress: Progress,
) -> dict[Gap, Modelled]:
    said: dict[Gap, Modelled] = {}
    sweeps = _sweeps(observed, space, gaps)
    for done, (start, stop, among) in enumerate(sweeps):
        share = part(progress, done / len(sweeps), (done + 1) / len(sweeps))
        said |= _Sweep(recording, observed, space, start, stop).say(among, share)
    return said


def _too_little(observed: BoolArray, gap: Gap, markers: IntArray) -> str:
    others = np.count_nonzero(observed[gap.start : gap.stop, markers], axis=1)
    if np.median(others) < LEAST_MARKERS:
        return (
            f"fewer than {LEAST_MARKERS} other markers that are seen often enough are there in "
            "most of the gap: this method has too little to tell the posture by"
        )
    return ""


def _sweeps(
    observed: BoolArray, space: "_Space", gaps: Sequence[Gap]
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
class _Space:
    """The low-dimensional space of a recording, in millimetres.

    Attributes
    ----------
    markers : ndarray of int
        Those that span it.
    complete : ndarray of int
        Frames that show them all.
    mean : ndarray, shape (3 markers,)
        Of the complete frames.
    walk : Walk
        The model in it.
    notes : dict
        For the diagnostics.
    """

    markers: IntArray
    complete: IntArray
    mean: FloatArray
    walk: Walk
    notes: dict[str, Any]

    @classmethod
    def learn(
        cls,
        recording: Recording,
        markers: IntArray,
        complete: IntArray,
        params: BurkeLasenbyParams,
    ) -> "_Space | str":
        """Find the space; where there is too little to learn from, say so."""
        pairs = complete[:-1][np.diff(complete) == 1]
        if complete.size < LEAST_FRAMES or not pairs.size:
            return (
                f"only {complete.size} frames show the marker and those that predict it: this "
                f"method needs {LEAST_FRAMES} in a row"
            )
        frames = _flat(recording, evenly(complete, MOST_FRAMES), markers)
        mean = frames.mean(axis=0)
        around = frames - mean
        values, vectors = np.linalg.eigh(around.T @ around / frames.shape[0])
        spreads = np.sqrt(np.clip(values[::-1], 0, None))
        enough = np.cumsum(spreads) <= params.components / 100 * spreads.sum()
        kept = max(int(np.count_nonzero(enough)), 1)
        loadings: FloatArray = vectors[:, ::-1][:, :kept]
        pairs = evenly(pairs, MOST_FRAMES)
        steps = _flat(recording, pairs + 1, markers) - _flat(recording, pairs, markers)
        process = (loadings.T * steps.var(axis=0)) @ loadings + STILL_MM2 * np.eye(kept)
        walk = Walk(loadings, process, params.noise_mm**2, np.diag(spreads[:kept] ** 2))
        return cls(
            markers, complete, mean, walk, {"components": kept, "complete_frames": complete.size}
        )


@dataclass(frozen=True, eq=False)
class _Sweep:
    """Frames that are smoothed together."""

    recording: Recording
    observed: BoolArray
    space: _Space
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
        values = _flat(self.recording, frames, self.space.markers) - self.space.mean
        seen = np.repeat(self.observed[np.ix_(frames, self.space.markers)], 3, axis=1)
        return smooth(self.space.walk, values, seen, progress)[first - begin :][: last - first]

    def _place(self, postures: FloatArray, marker: int) -> FloatArray:
        at = 3 * int(np.searchsorted(self.space.markers, marker))
        rows = self.space.walk.loadings[at : at + 3]
        placed: FloatArray = postures @ rows.T + self.space.mean[at : at + 3]
        return placed / self.recording.mm


def _flat(recording: Recording, frames: IntArray, markers: IntArray) -> FloatArray:
    points: FloatArray = recording.points[np.ix_(frames, markers)] * recording.mm
    return points.reshape(frames.size, -1)
