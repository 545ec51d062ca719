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

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, IntArray
from mocapmend_algorithms.fill.company import LEAST_FRAMES, seen_together
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import EdgeParams, Modelled, meet_edges, obstacle
from mocapmend_algorithms.fill.posture_space import PostureSpace
from mocapmend_algorithms.fill.posture_sweeps import follow
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

LEAST_MARKERS = 3


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
        few = _few_complete(complete)
        said |= {gap: few or _few_others(observed, gap, markers) for gap in among}
        if few:
            continue
        space = PostureSpace.learn(
            recording,
            markers,
            complete,
            share=params.components / 100,
            noise_mm=params.noise_mm,
        )
        told = [gap for gap in among if not said[gap]]
        said |= follow(recording, observed, space, told, share)
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


def _few_complete(complete: IntArray) -> str:
    """Say that too few frames are complete to learn from; empty where enough are."""
    if complete.size < LEAST_FRAMES or not (np.diff(complete) == 1).any():
        return (
            f"only {complete.size} frames show the marker and those that predict it: this "
            f"method needs {LEAST_FRAMES} in a row"
        )
    return ""


def _few_others(observed: BoolArray, gap: Gap, markers: IntArray) -> str:
    others = np.count_nonzero(observed[gap.start : gap.stop, markers], axis=1)
    if np.median(others) < LEAST_MARKERS:
        return (
            f"fewer than {LEAST_MARKERS} other markers that are seen often enough are there in "
            "most of the gap: this method has too little to tell the posture by"
        )
    return ""
