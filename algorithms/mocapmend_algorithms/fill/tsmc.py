"""Missing markers by completing a matrix of trajectory segments.

T13 = Tan, Hou and Chau 2013, "Human motion capture data recovery using trajectory-based matrix
completion", Electronics Letters 49(12):752-754 (TSMC). Known of it from those who compare with
it (W18 = Wang, Lu and Han 2018, Computer Systems & Applications 27(5):17-25): segments of
trajectories, not whole postures, are put into a matrix, because that has a lower rank; a local
matrix is completed by singular value thresholding, as Lai, Yuen and Lee 2011 do it with whole
recordings. The letter's text was not at hand, so the rest is filled in, by what erred least on
recordings:

1. The segments are cut around a gap: as long as the gap and 20 s before and after it, without the
   frames in which one of the markers is missing. Each coordinate of a marker is a column, its
   frames are the rows (`trajectory_segments`).
2. The matrix is local: columns of near markers are larger, by exp((n^2 - d^2) / (2 s^2)), d their
   mean distance from the nearest missing marker, n that of the nearest of them, s = 150 mm, and
   markers below 0.01 are left out. The missing markers' columns are multiplied by 0.03: the nuclear
   norm draws a missing block towards zero, even where the rank is low, but less the smaller its
   columns are.
3. The mean of the markers that are seen throughout the gap is subtracted frame by frame, then each
   column's mean over the frames around the gap. The body's heading stays as it is.
4. The matrix with the smallest nuclear norm is found by other steps to the same end (see
   `mocapmend_algorithms.sparse.nuclear_norm`).
5. The samples next to the gap are completed as if they were missing, and what is left over there
   is carried into the gap (`meet_edges`).

Shorter segments, those of other frames as further columns and delayed copies of the columns were
tried, and erred more on the whole. With a distance scale of 10000 mm, a weight of 1 and without
`meet_edges` it is plain completion, which errs up to five times as much.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.company import few_frames, few_helpers
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import EdgeParams, Modelled, meet_edges, obstacle
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.fill.trajectory_segments import LEAST_HELPERS, Segments
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording


@dataclass(frozen=True)
class TsmcParams(EdgeParams):
    """Parameters of `tsmc`."""

    around_s: float = option(
        20.0,
        label="Segments around the gap",
        text="How much of the trajectories before and after the gap is looked at, at least as "
        "much as the gap is long.",
        minimum=0.1,
        maximum=600.0,
        unit="s",
    )
    weight_scale_mm: float = option(
        150.0,
        label="Distance scale",
        text="Markers much farther away than this from the missing ones hardly count.",
        minimum=10.0,
        maximum=10000.0,
        unit="mm",
    )
    missing_weight: float = option(
        0.03,
        label="Weight of the missing markers",
        text="How much the missing markers themselves shape the matrix, 1 = as much as a marker "
        "at their place.",
        minimum=0.01,
        maximum=1.0,
    )
    threshold: float = option(
        0.003,
        label="Threshold",
        text="Singular values below this share of the largest one are taken for noise.",
        minimum=1e-4,
        maximum=10.0,
        unit="%",
    )


def tsmc(
    recording: Recording, gaps: Sequence[Gap], params: TsmcParams, progress: Progress, /
) -> FillResult:
    """Fill gaps by completing a matrix of trajectory segments (T13).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : TsmcParams
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With the number of markers (`helpers`) and `complete_frames` of the matrix in the notes.
        Gaps stay open where fewer than 3 other markers are seen throughout them, or fewer than 10
        frames are complete.
    """
    return fill_with_bands(recording, gaps, partial(_fill, params=params), progress)


def _fill(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: TsmcParams,
) -> FillResult:
    said: dict[Gap, Modelled | str] = {gap: obstacle(observed, gap, params) for gap in gaps}
    groups: dict[tuple[int, int, bytes, bytes], tuple[Segments, list[Gap]]] = {}
    for gap in gaps:
        if not said[gap]:
            segments = Segments.around(
                observed, gap, around=round(params.around_s * recording.rate)
            )
            said[gap] = few_frames(segments.complete) or few_helpers(
                segments.helpers.size, LEAST_HELPERS, "are seen throughout the gap"
            )
            if not said[gap]:
                groups.setdefault(segments.key, (segments, []))[1].append(gap)
    for done, (segments, among) in enumerate(groups.values()):
        said |= segments.say(
            recording,
            observed,
            among,
            weight_scale_mm=params.weight_scale_mm,
            missing_weight=params.missing_weight,
            threshold=params.threshold / 100,
            progress=part(progress, done / len(groups), (done + 1) / len(groups)),
        )
    progress(1.0)
    return meet_edges(recording, observed, gaps, said, params)
