"""Missing markers from sparse codes of windows of motion, with bones that keep their lengths.

W18 = Wang, Lu, Han 2018, "Distorted human motion capture data recovery based on skeleton
constraint", Computer Systems & Applications 27(5):17-25. Windows of several frames, as differences
of neighbouring markers, are coded sparsely over a dictionary of motion; the code of what is seen
tells what is lost; overlapping windows are averaged; bones keep their lengths.

What is different here, each by measurement (`bench paper`):

- differences and not their signed squares (eq. 5);
- the whole body and not five parts (tables 1 and 2), with differences bridged across missing
  markers (see `sparse.rows`);
- windows whose frames are spread over 0.33 or 0.6 s, with the body's heading taken out;
- the dictionary is windows of the recording itself, or of a training set, and its lost rows are
  fitted to further windows (see `sparse.code_model`);
- what the dictionary leaves over at the edges of the gap is carried into it;
- in the end the bones of a skeleton get their exact lengths (see `skeleton.projection`), and what
  missed the examples by more, or together, moves so; between markers on skin, which slide, points
  are pulled towards them as far as their lengths are sure.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Literal

from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.edges import Modelled, meet_edges
from mocapmend_algorithms.fill.keep_bones import joined_by_bones, only, projected, pulled
from mocapmend_algorithms.fill.motion_codes import MotionCodeParams, Way, read_motions, tell_gaps
from mocapmend_algorithms.fill.punch_bands import fill_with_bands
from mocapmend_algorithms.fill.trained_parts import TrainedParts
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body, find_body
from mocapmend_algorithms.sparse.examples import Motion
from mocapmend_algorithms.sparse.training_set import TrainingSetError, read_training_set

WINDOW_ALONE_MS = 330.0
WINDOW_TRAINED_MS = 600.0
"""Where a training set shows enough of such long stretches."""
FADE_S = 0.3
"""Time in which what is left over at the edges of a gap falls to 1/e: 0.25 to 0.5 s do as well."""


@dataclass(frozen=True)
class BoneDictionaryParams(MotionCodeParams):
    """Parameters of `bone-dictionary`."""

    dictionary: Literal["examples", "trained"] = option(
        "examples",
        label="Dictionary",
        text="Examples: stretches of motion as they are. Trained: the dictionaries of the five "
        "parts of a skeleton that a training set has, as printed in the paper; less exact.",
    )
    window_ms: float | None = option(
        None,
        label="Window",
        text="The stretch of motion that is coded as one: six frames spread over it. Automatic: "
        "330 ms, or 600 ms with a training set.",
        minimum=0.0,
        maximum=5000.0,
        unit="ms",
    )
    keep_bones: bool = option(
        default=True,
        label="Keep bone lengths",
        text="The bones of a skeleton get their exact lengths; markers on skin are pulled towards "
        "theirs as far as these are sure.",
    )

    def window(self, others: Sequence[Motion]) -> float:
        """Return what a window spans in ms, given the training set."""
        if self.window_ms is not None:
            return self.window_ms
        return WINDOW_TRAINED_MS if others else WINDOW_ALONE_MS


def bone_dictionary(
    recording: Recording, gaps: Sequence[Gap], params: BoneDictionaryParams, progress: Progress, /
) -> FillResult:
    """Fill gaps by sparse codes of windows of motion (W18).

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill.
    params : BoneDictionaryParams
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
    if params.dictionary == "trained":
        if not params.training:
            raise TrainingSetError(
                "trained dictionaries come with a training set, and none is given"
            )
        parts = TrainedParts(read_training_set(Path(params.training)), recording)
        fill = partial(fill_bare, params=params, body=body, others=(), parts=parts)
    else:
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
    params: BoneDictionaryParams,
    body: Body,
    others: Sequence[Motion],
    parts: TrainedParts | None = None,
) -> FillResult:
    """Fill gaps without a word on the errors; see `punch_errors.BareFill`.

    Parameters
    ----------
    recording, observed, gaps, progress
        See `BareFill`.
    params : BoneDictionaryParams
        See there; the training set is not read.
    body : Body
        The bones.
    others : sequence of Motion
        The training set.
    parts : TrainedParts, optional
        Its trained dictionaries, which are used instead where they are given.

    Returns
    -------
    FillResult
    """
    exact = params.keep_bones and body.exact
    asked = joined_by_bones(observed, gaps, body) if exact else list(gaps)
    if parts is not None:
        said = parts.tell(recording, observed, asked, params, progress)
    else:
        codes = params.codes(others, guided=True)
        way = Way(params.window(others), rows="bones", heading=True, parts=False, codes=codes)
        said = tell_gaps(recording, observed, asked, way, body, others, params, progress)
    filled = meet_edges(recording, observed, asked, said, params, FADE_S)
    if exact:
        doubts = {gap: one.doubt for gap, one in said.items() if isinstance(one, Modelled)}
        filled = projected(recording, observed, filled, body, doubts)
    elif params.keep_bones:
        filled = pulled(recording, observed, filled, body)
    return only(filled, gaps)
