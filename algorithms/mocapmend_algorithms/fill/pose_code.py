"""Missing markers from the sparse code of a whole pose over known poses.

X13 = patent CN103020984 (Xiao, Feng, Zhuang; Zhejiang University, 2013). The columns of a
dictionary are complete poses. The seen part f_o of an incomplete pose gets the code

    x* = argmin |Phi_o x - f_o|^2 / 2 + lambda |x|_1

over the same part of the dictionary, and its missing part is f_m = Phi_m x*.

Deviations, each an option where it was measured to help: poses are relative to the body (where it
is and faces is told by the very markers that are seen); the mean pose is taken out; markers near
the missing one count more, by the weight of Gløersen and Federolf 2016 (see `pca`); and the
residual at the edges is carried into the gap (`meet_edges`). The print gives no scale for lambda:
here the weighted poses have a mean square of 1. It solves every frame; here, about 20 frames per
second, with a spline between them. A marker that leaves too few poses complete is left out of them.

All frames of a gap are coded over the same markers, those that are seen throughout it. A gap in
which these are much fewer than are seen at a time is halved, again and again.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import EdgeParams, Modelled, meet_edges, obstacle, with_edges
from mocapmend_algorithms.fill.known_poses import KnownPoses, Library, of_recording, of_training_set
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.fill.punch_errors import BareFill
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option, training_option
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.pose_dictionary import PoseDictionary, Reading
from mocapmend_algorithms.sparse.training_set import read_training_set

LEAST_MARKERS = 3
KEY_RATE = 20.0
"""Frames per second that are coded."""
SAME_MM = 1e-3
MOST_KEPT = 8
"""Dictionaries kept for the next gap of the same marker and company."""
ENOUGH = 0.75
"""Share of the markers seen at a time that must be seen throughout, or the gap is halved."""
CHUNK = 4096
"""Frames at a time, so that long gaps need little memory."""


@dataclass(frozen=True)
class PoseCodeParams(EdgeParams):
    """Parameters of `pose-code`."""

    training: str = training_option(
        "Poses to tell this recording's by, in place of its own complete frames."
    )
    poses: int = option(
        400,
        label="Poses",
        text="At most so many known poses, evenly spread, make up the dictionary.",
        minimum=10,
        maximum=5000,
    )
    penalty: float = option(
        1e-4,
        label="Penalty",
        text="The larger, the fewer known poses a pose is made of, and the nearer to the mean "
        "pose it is.",
        minimum=1e-6,
        maximum=1.0,
    )
    weight_scale_mm: float = option(
        200.0,
        label="Distance scale",
        text="Markers much farther away than this from the missing one hardly count. As printed, "
        "all count alike: 100000 mm.",
        minimum=10.0,
        maximum=100000.0,
        unit="mm",
    )
    relative_to: Literal["body", "place", "world"] = option(
        "body",
        label="Relative to",
        text="What poses are compared by: body = wherever it is and faces, place = wherever it "
        "is, world = nothing is taken out, as printed.",
    )
    centred: bool = option(
        default=True,
        label="Mean pose taken out",
        text="Code what differs from the mean pose. Off: as printed.",
    )


def pose_code(
    recording: Recording, gaps: Sequence[Gap], params: PoseCodeParams, progress: Progress, /
) -> FillResult:
    """Fill gaps from the sparse code of each pose over known poses (X13).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : PoseCodeParams
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With the number of `poses` in the dictionary, of markers that pose was told by (`helpers`,
        the fewest) and of poses in a code on average (`poses_used`) in the notes. Gaps stay open
        where fewer than 3 other markers are seen, fewer than 10 poses are known, or the training
        set lacks the marker.

    Raises
    ------
    TrainingSetError
        If the training set cannot be read, or has markers that the recording lacks.
    """
    fill = bare_pose_code(recording, params)
    return fill_with_bands(recording, gaps, fill, progress, taught=bool(params.training))


def bare_pose_code(recording: Recording, params: PoseCodeParams) -> BareFill:
    """Return the fill of `pose_code` without a word on its errors; see there."""
    if params.training:
        training = read_training_set(Path(params.training))
        library = of_training_set(training, recording, params.poses)
    else:
        library = of_recording(recording, params.poses)
    return partial(_fill, params=params, library=library)


def _fill(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: PoseCodeParams,
    library: Library,
) -> FillResult:
    known = lru_cache(maxsize=MOST_KEPT)(partial(library, observed))
    reading = Reading(
        recording.up,
        params.relative_to,
        params.centred,
        params.weight_scale_mm / recording.mm,
        SAME_MM / recording.mm,
    )

    @lru_cache(maxsize=MOST_KEPT)
    def dictionary(marker: int, helpers: bytes) -> PoseDictionary:
        poses, own = known(marker).poses, np.searchsorted(known(marker).markers, marker)
        return PoseDictionary.of(
            poses[:, np.frombuffer(helpers, dtype=np.bool_)], poses[:, own], reading
        )

    said: dict[Gap, Modelled | str] = {}
    for done, gap in enumerate(gaps):
        share = part(progress, done / len(gaps), (done + 1) / len(gaps))
        reason = obstacle(observed, gap, params) or known(gap.marker).few
        said[gap] = reason or _say(
            recording,
            observed,
            gap,
            known(gap.marker),
            partial(dictionary, gap.marker),
            params.penalty,
            share,
        )
    progress(1.0)
    return meet_edges(recording, observed, gaps, said, params)


def _say(
    recording: Recording,
    observed: BoolArray,
    gap: Gap,
    known: KnownPoses,
    dictionary: Callable[[bytes], PoseDictionary],
    penalty: float,
    progress: Progress,
) -> Modelled | str:
    """Say where a marker is in its gap and beside it, or why that cannot be said."""
    start, stop = with_edges(observed, gap)
    others = known.markers != gap.marker
    pieces = list(_pieces(observed[:, known.markers] & others, start, stop))
    fewest = min(np.count_nonzero(helpers) for _, _, helpers in pieces)
    if fewest < LEAST_MARKERS:
        return (
            f"fewer than {LEAST_MARKERS} other markers that are seen often enough are there in "
            "some of the gap: this method has too little to tell the pose by"
        )
    values, used = np.empty((stop - start, 3)), 0.0
    for first, last, helpers in pieces:
        share = part(progress, (first - start) / (stop - start), (last - start) / (stop - start))
        points = recording.points[first:last, known.markers[helpers]]
        found, atoms = dictionary(helpers.tobytes()).find(
            points, _keys(last - first, recording.rate), penalty, share
        )
        values[first - start : last - start] = found
        used += atoms * (last - first) / (stop - start)
    notes = {"poses": known.poses.shape[0], "helpers": int(fewest), "poses_used": round(used, 1)}
    return Modelled(values, notes)


def _pieces(seen: BoolArray, start: int, stop: int) -> Iterator[tuple[int, int, BoolArray]]:
    """Cut frames into pieces that many markers are seen throughout, with these markers."""
    throughout: BoolArray = np.asarray(seen[start:stop].all(axis=0))
    usual = np.median(np.count_nonzero(seen[start:stop], axis=1))
    middle = (start + stop) // 2
    few = np.count_nonzero(throughout) < ENOUGH * usual
    if stop - start > CHUNK or (few and stop - start > 1):
        yield from _pieces(seen, start, middle)
        yield from _pieces(seen, middle, stop)
    else:
        yield start, stop, throughout


def _keys(frames: int, rate: float) -> IntArray:
    """Choose the frames that are coded."""
    count = int(np.ceil((frames - 1) / rate * KEY_RATE)) + 1
    return np.unique(np.linspace(0, frames - 1, count).round().astype(np.int64))
