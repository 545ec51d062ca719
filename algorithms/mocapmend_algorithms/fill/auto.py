"""The method that chooses for each gap by test: a blend of regressions on the pose of the donors.

Each gap is filled by several Gaussian processes, each in a frame of reference of its own that moves
with the body near the marker. Stretches like the gap are hidden from each of them, in this very
recording and with the gap's companions, and what they leave over sets the weights of the blend,
the expected error and the band. Where the marker has no donors, time alone is left.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import IntArray
from mocapmend_algorithms.fill import pose_regression
from mocapmend_algorithms.fill.band import SPEED_DONORS, band
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.donors import Donors
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.gaussian import Kernel
from mocapmend_algorithms.fill.lessons import Size
from mocapmend_algorithms.fill.model_params import (
    LEFT_OPEN,
    ModelEdges,
    donors_option,
    model_edges_option,
)
from mocapmend_algorithms.fill.pose_regression import Candidate, View
from mocapmend_algorithms.fill.stack import LEAST_MM, Stack, blend
from mocapmend_algorithms.fill.survey import Survey
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

DRIFT = (0.1, 10.0)
"""Skin and marker shift slowly against the donors."""
POSE = Kernel(
    linear=5.0, pose=0.5, temporal=((0.01, 0.04), (0.01, 0.2), (0.01, 1.0), DRIFT), noise=1e-3
)
BOTH = Kernel(
    linear=0.5, pose=2.0, temporal=((0.1, 0.1), (0.1, 0.3), (0.1, 1.0)), noise=1e-5, smooth=True
)
TIME = Kernel(linear=0.02, pose=5.0, temporal=((1.0, 0.3), (1.0, 1.0)), noise=1e-6, smooth=True)
SLOW = Kernel(linear=0.02, pose=5.0, temporal=((1.0, 0.6), (1.0, 2.0)), noise=1e-6, smooth=True)
QUICK = Kernel(linear=0.02, pose=5.0, temporal=((1.0, 0.1), (1.0, 0.3)), noise=1e-4, smooth=True)

NEAR = View(frame=4, donors=20, power=1.5)
TIGHT = View(frame=3, donors=12, power=2.0, up=0.0, acceleration=0.0)
WIDE = View(frame=12, donors=30, power=1.5, nearness=0.05)
WHOLE = View(frame=5, donors=40, power=1.25, nearness=0.01)

CANDIDATES: tuple[tuple[View, tuple[Kernel, ...]], ...] = (
    (NEAR, (POSE, BOTH, TIME)),
    (TIGHT, (POSE,)),
    (WIDE, (POSE, BOTH)),
    (WHOLE, (POSE,)),
)
ALONE = View(frame=0, donors=0, power=1.0, up=0.0, acceleration=0.0)
"""Of a marker without donors: nothing but its own trajectory."""
PULL = 0.1
FEW = 6
SIZE = Size(frames=400, trials=20, judged=10, rest=100)
SHORT_S = 0.05
SHORT_SIZE = Size(frames=200, trials=12, judged=8, rest=50)
"""Of the shortest gaps there are often hundreds, and the samples beside them say almost all."""
ENOUGH = 3 * SIZE.frames


@dataclass(frozen=True)
class AutoParams:
    """Parameters of `auto`."""

    edges: ModelEdges = model_edges_option()
    donors: tuple[str, ...] = donors_option("Markers that move with this one")


def auto(
    recording: Recording, gaps: Sequence[Gap], params: AutoParams, progress: Progress, /
) -> FillResult:
    """Fill gaps by a blend of regressions that is chosen by tests on the recording itself.

    Parameters
    ----------
    recording : Recording
        Not changed. Samples inside the given gaps are never looked at.
    gaps : sequence of Gap
        Those of markers that are never seen stay open, and so do those at the beginning and the
        end where the marker has no donors.
    params : AutoParams
        Whose donors to take.
    progress : Progress
        Called several times per gap.

    Returns
    -------
    FillResult
        With `donors`, `self_tests` and the `weights` of the blend in the notes.
    """
    survey = Survey(recording, gaps)

    def fill(gap: Gap, share: Progress) -> tuple[Patch, dict[str, Any]]:
        return _fill(_case(survey, gap, params), recording, share)

    return fill_each(gaps, fill, progress)


def _case(survey: Survey, gap: Gap, params: AutoParams) -> Case:
    """Collect what there is to learn from."""
    edge = gap.kind(survey.recording.frames) != "interior"
    if edge and params.edges == "leave":
        raise LeftOpenError(LEFT_OPEN)
    donors = survey.donors(gap, params.donors, at_edges=False, enough=ENOUGH)
    if edge and not len(donors):
        raise LeftOpenError(
            "it is at the beginning or the end, and no other marker is seen throughout"
        )
    short = gap.length <= SHORT_S * survey.recording.rate
    return survey.case(gap, donors[_looked_at(donors)], SHORT_SIZE if short else SIZE)


def _looked_at(donors: Donors) -> IntArray:
    """Return the places of donors that matter; the others would only cost frames and time."""
    near = [donors.best(view.donors, view.nearness) for view, _ in CANDIDATES]
    return np.unique(np.concatenate([*near, donors.best(SPEED_DONORS)]))


def _fill(case: Case, recording: Recording, progress: Progress) -> tuple[Patch, dict[str, Any]]:
    """Fill a gap, and say how sure that is."""
    candidates = _candidates(case, progress)
    errors = list(zip(*(candidate.errors for candidate in candidates), strict=True))
    prior = np.full(len(candidates), 1 / len(candidates))
    stack = Stack(errors, prior, PULL)
    weights = stack.weights()
    scaled = weights * np.array([_unit(candidate) for candidate in candidates])
    spreads = zip(*(candidate.spreads for candidate in candidates), strict=True)
    unsure = band(
        case,
        stack.left_out(),
        [blend(spread, scaled) for spread in spreads],
        blend([candidate.spread for candidate in candidates], scaled),
    )
    values = blend([candidate.values for candidate in candidates], weights)
    labels = [recording.labels[marker] for marker in case.donors.markers[case.donors.best(4)]]
    notes = {
        "donors": tuple(labels),
        "self_tests": len(errors),
        "weights": tuple(weights.round(3).tolist()),
    }
    mm = recording.mm
    return Patch(case.gap, values / mm, unsure.sigma / mm, unsure.r90 / mm), notes


def _candidates(case: Case, progress: Progress) -> list[Candidate]:
    if not len(case.donors):
        return pose_regression.regress(case, ALONE, (TIME, SLOW, QUICK))
    found = pose_regression.regress(case, ALONE, (TIME, SLOW)) if len(case.donors) < FEW else []
    for done, (view, kernels) in enumerate(CANDIDATES):
        progress(done / len(CANDIDATES))
        found += pose_regression.regress(case, view, kernels)
    return found


def _unit(candidate: Candidate) -> float:
    """Return how many mm a candidate's unit of spread stands for, by its trials."""
    if not candidate.errors:
        return 1.0
    error = max(float(np.mean(np.concatenate(candidate.errors) ** 2)) * 3, LEAST_MM**2)
    return float(np.sqrt(error / np.mean(np.concatenate(candidate.spreads) ** 2)))
