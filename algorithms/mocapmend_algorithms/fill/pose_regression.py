"""Candidates of `auto`: Gaussian processes in a frame that moves with donors of the marker."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.alignment import Alignment
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill import gaussian
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.gaussian import Kernel, Regression

SPREAD_FLOOR_MM = 0.5
TYPICAL_SPREAD_MM = 5.0
ACCELERATION_S = 0.05
GRAVITY = 9810.0
MOST_GRAVITIES = 3.0
LEAST_SHARE = 1e-9


@dataclass(frozen=True)
class View:
    """What of the donors a regression sees.

    Attributes
    ----------
    frame : int
        How many of the most rigid donors carry the frame of reference.
    donors : int
        How many donors' places in that frame are features.
    power : float
        A donor's feature counts 1 / spread^power.
    nearness : float
        What a millimetre of distance counts beside one of spread in the order of the donors.
    up : float
        What the direction of gravity in the frame counts; 0 leaves it out.
    acceleration : float
        What the frame's acceleration counts, per g; 0 leaves it out.
    """

    frame: int
    donors: int
    power: float
    nearness: float = 0.02
    up: float = 2.0
    acceleration: float = 0.3


def regress(case: Case, view: View, kernels: Sequence[Kernel]) -> list[Candidate]:
    """Fill a gap by regression on what a view sees of the donors.

    Parameters
    ----------
    case : Case
        The gap.
    view : View
        The frame of reference and the features.
    kernels : sequence of Kernel
        What is believed of the marker's motion in that frame.

    Returns
    -------
    list of Candidate
        One per kernel.
    """
    order = case.donors.best(len(case.donors), view.nearness)
    frame = order[: view.frame]
    apart = view.nearness * case.donors.distance[frame]
    weights = 1 / (case.donors.spread[frame] ** 2 + 1 + apart**2)
    alignment = case.aligned(frame, weights)
    poses = _features(case, view, order[: view.donors], frame, weights, alignment)
    fits = gaussian.regress(
        case.times,
        poses[: case.samples],
        alignment[: case.samples].to_local(case.target),
        poses[case.samples :],
        kernels,
    )
    return [_candidate(case, alignment, fit) for fit in fits]


def _features(
    case: Case,
    view: View,
    donors: IntArray,
    frame: IntArray,
    weights: FloatArray,
    alignment: Alignment,
) -> FloatArray:
    local = alignment.to_local(case.at(donors))
    spread = case.donors.spread[donors]
    scale = TYPICAL_SPREAD_MM ** (view.power - 1) / (spread + SPREAD_FLOOR_MM) ** view.power
    places = (local - local[: case.samples].mean(axis=0)) * scale[:, None]
    features = [places.reshape(case.frames.size, -1)]
    if view.up:
        features.append(view.up * (case.up @ alignment.rotation))
    if view.acceleration:
        features.append(view.acceleration * _acceleration(case, frame, weights, alignment))
    return np.concatenate(features, axis=1)


def _acceleration(
    case: Case, frame: IntArray, weights: FloatArray, alignment: Alignment
) -> FloatArray:
    """Return the frame's acceleration in its own axes, in g; 0 where it is not known."""
    step = max(1, round(ACCELERATION_S * case.rate))
    share = weights / weights.sum()
    before, after = (np.einsum("fgi,g->fi", case.at(frame, s), share) for s in (-step, step))
    change = (before + after - 2 * alignment.centre) * (case.rate / step) ** 2 / GRAVITY
    local = (change[:, None] @ alignment.rotation)[:, 0]
    # As a whole: what is bounded axis by axis depends on how the axes lie.
    size = np.maximum(np.linalg.norm(local, axis=1, keepdims=True) / MOST_GRAVITIES, LEAST_SHARE)
    bounded: FloatArray = np.nan_to_num(local * np.tanh(size) / size)
    return bounded


def _candidate(case: Case, alignment: Alignment, fit: Regression) -> Candidate:
    gap = alignment[case.samples :]
    errors, spreads = [], []
    for trial, left, spread in zip(
        case.lesson.trials, fit.left_out, fit.left_out_spread, strict=True
    ):
        turned = alignment.rotation[trial.hidden[trial.judged]] @ left[trial.judged, :, None]
        errors.append(turned[:, :, 0])
        spreads.append(spread[trial.judged])
    return Candidate(gap.to_world(fit.values), fit.spread, tuple(errors), tuple(spreads))
