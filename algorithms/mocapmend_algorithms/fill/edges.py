"""The edges of a gap: what a model leaves over at the samples beside it is carried into it.

A model sees other markers and seldom passes exactly through the samples next to the gap. Its
residual there is blended linearly from one edge to the other. Where one side has no sample beside
the gap (an *open* side, as at the beginning of a recording), the other side's residual decays.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled
from mocapmend_algorithms.fill.model_params import ModelEdges, model_edges_option
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.recording import Recording

DECAY_S = 1.0
"""Time in which a residual falls to 1/e: it is mostly a slow offset of the marker on its skin."""


@dataclass(frozen=True)
class EdgeParams:
    """Parameters that all methods with a model of the markers share."""

    edges: ModelEdges = model_edges_option()
    meet_edges: bool = option(
        default=True,
        label="Meet the edges",
        text="Carry what the model leaves over at the edges of the gap into it. Off: as printed.",
    )


def sides(observed: BoolArray, gap: Gap) -> tuple[bool, bool]:
    """Say whether a gap has an observed sample right before and right after it.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gap : Gap
        The gap.

    Returns
    -------
    before, after : bool
    """
    before = gap.start > 0 and observed[gap.start - 1, gap.marker]
    after = gap.stop < observed.shape[0] and observed[gap.stop, gap.marker]
    return bool(before), bool(after)


def with_edges(observed: BoolArray, gap: Gap) -> tuple[int, int]:
    """Return the frames (start, stop) of a gap and the observed samples beside it."""
    before, after = sides(observed, gap)
    return gap.start - before, gap.stop + after


def obstacle(observed: BoolArray, gap: Gap, params: EdgeParams) -> str:
    """Say why a gap stays open whatever the model; empty where it need not.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gap : Gap
        The gap.
    params : EdgeParams
        Whether gaps at the beginning and the end of the recording are to be filled.

    Returns
    -------
    str
    """
    if not observed[:, gap.marker].any():
        return "the marker is never seen in this recording"
    kind = gap.kind(observed.shape[0])
    if params.edges == "leave" and kind != "interior":
        where = "beginning" if kind == "leading" else "end"
        return f"the gap lies at the {where} of the recording, and such gaps are to be left open"
    return ""


@dataclass(frozen=True, eq=False)
class Doubt:
    """How unsure a model is of markers that it tells together.

    Attributes
    ----------
    markers : ndarray of int, shape (markers,)
        Ascending.
    covariance : ndarray, shape (markers, markers)
        Of what it misses a coordinate of each by, in mm squared.
    """

    markers: IntArray
    covariance: FloatArray


@dataclass(frozen=True, eq=False)
class Modelled:
    """What a model says of a gap.

    Attributes
    ----------
    values : ndarray, shape (frames, 3)
        Coordinates in the frames of `with_edges`, in the recording's unit.
    notes : dict
        For the diagnostics.
    doubt : Doubt, optional
        Of the marker and those that are told with it.
    """

    values: FloatArray
    notes: dict[str, Any]
    doubt: Doubt | None = None


def meet_edges(
    recording: Recording,
    observed: BoolArray,
    gaps: Sequence[Gap],
    said: Mapping[Gap, Modelled | str],
    params: EdgeParams,
    fade_s: float = math.inf,
) -> FillResult:
    """Make a result, without bands, of what a model says.

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    gaps : sequence of Gap
        In the order of the result.
    said : mapping of Gap to Modelled or str
        What the model says, or why it says nothing.
    params : EdgeParams
        Whether the residual at the edges is carried into the gap.
    fade_s : float
        Time in which a residual falls to 1/e on its way to the other edge; by default it falls
        linearly.

    Returns
    -------
    FillResult
        With NaN for `sigma` and `r90`.
    """
    patches, unfilled, notes = [], [], {}
    for gap in gaps:
        model = said[gap]
        if isinstance(model, str):
            unfilled.append(Unfilled(gap, model))
            continue
        values = model.values[gap.start - with_edges(observed, gap)[0] :][: gap.length]
        if params.meet_edges:
            values = values + _residual(recording, observed, gap, model.values, fade_s)
        patches.append(Patch(gap, values, *np.full((2, gap.length), np.nan)))
        notes[gap] = model.notes
    return FillResult(tuple(patches), tuple(unfilled), notes)


def _residual(
    recording: Recording, observed: BoolArray, gap: Gap, model: FloatArray, fade_s: float
) -> FloatArray:
    before, after = sides(observed, gap)
    points, at = recording.points[:, gap.marker], np.arange(1, gap.length + 1)
    first = points[gap.start - 1] - model[0] if before else np.zeros(3)
    last = points[gap.stop] - model[-1] if after else np.zeros(3)
    if before and after:
        fading = _bridge(at, gap.length + 1, fade_s * recording.rate)
    else:
        fading = np.exp(-at / (DECAY_S * recording.rate))
    return np.outer(fading, first) + np.outer(fading[::-1], last)


def _bridge(at: IntArray, length: int, fade: float) -> FloatArray:
    """Fall from 1 at frame 0 to 0 at a frame, as an Ornstein-Uhlenbeck bridge does on average."""
    if math.isinf(fade):
        return 1 - at / length
    left = np.exp(-at / fade) * -np.expm1(-2 * (length - at) / fade)
    bridge: FloatArray = left / -np.expm1(-2 * length / fade)
    return bridge
