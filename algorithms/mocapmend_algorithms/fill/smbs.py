"""Sparse motion bases: W18's peer, without bones.

SMBS = Xiao et al. 2015, Signal Processing 110:108-122, and Wang et al. 2016, Proc. CASA 53-60, as
W18 (see `bone_dictionary`) describes and compares them: windows of six frames next to each other,
markers relative to the root, each part of the body from the triple of parts around it, a
dictionary whose lost rows reconstruct the training motion best from the codes of what is seen.
The papers' full texts were not at hand; the dictionary is chosen from examples as in
`sparse.code_model`, without its guide.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import meet_edges
from mocapmend_algorithms.fill.motion_codes import MotionCodeParams, Way, read_motions, tell_gaps
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body, find_body
from mocapmend_algorithms.sparse.examples import Motion


@dataclass(frozen=True)
class SmbsParams(MotionCodeParams):
    """Parameters of `smbs`."""

    parts: bool = option(
        default=True,
        label="Parts of the body",
        text="Tell each part of the body from itself, the trunk and one more part. Off: from all.",
    )


def smbs(
    recording: Recording, gaps: Sequence[Gap], params: SmbsParams, progress: Progress, /
) -> FillResult:
    """Fill gaps by sparse codes over windows of motion, without bones (SMBS).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : SmbsParams
        See there.
    progress : Progress
        Called often.

    Returns
    -------
    FillResult
        With the number of markers (`helpers`) and `examples` in the notes. Gaps stay open where
        fewer than 3 markers are seen, or fewer than 10 windows show them all.

    Raises
    ------
    TrainingSetError
        If the training set cannot be read, or is of other markers.
    """
    body = find_body(recording, seen_outside(recording.present, gaps))
    others = read_motions(params.training, recording, body)
    fill = partial(fill_bare, params=params, body=body, others=others)
    return fill_with_bands(recording, gaps, fill, progress, taught=bool(params.training))


def fill_bare(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    progress: Progress,
    /,
    *,
    params: SmbsParams,
    body: Body,
    others: Sequence[Motion],
) -> FillResult:
    """Fill gaps without a word on the errors; see `bone_dictionary.fill_bare`."""
    codes = params.codes(others, guided=False)
    way = Way(0.0, rows="root", heading=True, parts=params.parts, codes=codes)
    said = tell_gaps(recording, observed, gaps, way, body, others, params, progress)
    return meet_edges(recording, observed, gaps, said, params)
