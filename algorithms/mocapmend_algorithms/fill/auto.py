"""The method that chooses for each gap by test: a blend of regressions on the pose of the donors.

Each gap is filled by several Gaussian processes, each in a frame of reference of its own that moves
with the body near the marker. Stretches like the gap are hidden from each of them, in this very
recording and with the gap's companions, and what they leave over sets the weights of the blend,
the expected error and the band. Brief gaps have members that look at time alone, and a cubic curve
takes the place of the blend where its own tests promise much more: donors that come and go leave
few stretches to test on. Where the marker has no donors, time alone is left.

With a training set, windows of motion that are coded by it are tested on the same stretches, and
blended with the rest where they err less there.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill import pose_regression, time_regression
from mocapmend_algorithms.fill.band import SPEED_DONORS, band
from mocapmend_algorithms.fill.blending import blended
from mocapmend_algorithms.fill.bone_dictionary import BoneDictionaryParams
from mocapmend_algorithms.fill.candidate import Candidate
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.coded_motion import CodedMotion, joined
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.donors import Donors
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.gaussian import Kernel
from mocapmend_algorithms.fill.interpolate import cubic_windows
from mocapmend_algorithms.fill.keep_bones import joined_by_bones, only, projected
from mocapmend_algorithms.fill.lessons import Size
from mocapmend_algorithms.fill.model_params import (
    LEFT_OPEN,
    ModelEdges,
    donors_option,
    model_edges_option,
)
from mocapmend_algorithms.fill.motion_codes import read_motions
from mocapmend_algorithms.fill.pose_regression import View
from mocapmend_algorithms.fill.survey import Survey
from mocapmend_algorithms.fill.window import Windows
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.params import training_option
from mocapmend_algorithms.progress import Progress, no_progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import find_body

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
WHOLE = View(frame=5, donors=30, power=1.25, nearness=0.01)
TIMES = (TIME, SLOW, QUICK)

CANDIDATES: tuple[tuple[View, tuple[Kernel, ...]], ...] = (
    (NEAR, (POSE, BOTH, TIME)),
    (TIGHT, (POSE,)),
    (WHOLE, (POSE,)),
)
BRIEF_CANDIDATES = ((NEAR, (POSE, BOTH)), *CANDIDATES[1:])
"""Of brief gaps, which the marker's own samples tell of as well as time in a frame does."""
PULL = 0.1
FEW = 6
"""With fewer donors, time alone is a candidate for gaps of any length."""
PROMISING = 0.25
"""A curve must expect this share of the blend's error to take its place."""

SIZE = Size(frames=300, trials=14, judged=7, rest=60)
BRIEF_S = 0.5
BRIEF_SIZE = Size(frames=300, trials=18, judged=6, rest=60)
"""Tests of brief gaps are cheap, and few of them say little."""
SHORT_S = 0.05
SHORT_SIZE = Size(frames=200, trials=12, judged=8, rest=50)
"""Of the shortest gaps there are often hundreds, and the samples beside them say almost all."""
CODED_TRIALS = 8
"""With a training set, where tests are dear."""
ENOUGH = 3 * SIZE.frames

OWN_SHARE = 0.2
"""Of the progress: what a gap takes where there are codes too."""

Filled = tuple[Patch, dict[str, Any]]


@dataclass(frozen=True)
class AutoParams:
    """Parameters of `auto`."""

    edges: ModelEdges = model_edges_option()
    donors: tuple[str, ...] = donors_option("Markers that move with this one")
    training: str = training_option(
        "Recordings to learn from beside this one. Windows of motion that are coded by them, as in "
        "bone-dictionary, become part of the blend as far as tests speak for it; bones of a "
        "skeleton get their exact lengths. This takes seconds a gap."
    )


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
        Whose donors to take, and what to learn from beside the recording.
    progress : Progress
        Called several times per gap.

    Returns
    -------
    FillResult
        With `donors`, `self_tests` and the `weights` of the blend in the notes; a gap with a cubic
        curve has neither donors nor weights, but `curve`.

    Raises
    ------
    TrainingSetError
        If the training set cannot be read, or is of other markers.
    """
    if not params.training:
        return _fill_all(recording, gaps, params, None, progress)
    observed = seen_outside(recording.present, gaps)
    body = find_body(recording, observed)
    coding = BoneDictionaryParams(training=params.training, edges=params.edges)
    others = read_motions(params.training, recording, body)
    coded = CodedMotion(recording, observed, coding, body, others)
    return fill_coded(recording, gaps, params, coded, progress)


def fill_coded(
    recording: Recording,
    gaps: Sequence[Gap],
    params: AutoParams,
    coded: CodedMotion,
    progress: Progress,
) -> FillResult:
    """Fill gaps with codes in the blend; the bones of a skeleton get their exact lengths.

    Parameters
    ----------
    recording, gaps, params, progress
        See `auto`; the training set is not read.
    coded : CodedMotion
        Of the recording.

    Returns
    -------
    FillResult
        As of `auto`; the weight of the codes is the last.
    """
    if not coded.body.exact:
        return _fill_all(recording, gaps, params, coded, progress)
    asked = joined_by_bones(coded.observed, gaps, coded.body)
    filled = _fill_all(recording, asked, params, coded, progress)
    return only(projected(recording, coded.observed, filled, coded.body, {}), gaps)


def _fill_all(
    recording: Recording,
    gaps: Sequence[Gap],
    params: AutoParams,
    coded: CodedMotion | None,
    progress: Progress,
) -> FillResult:
    survey = Survey(recording, gaps)
    curves = Windows(recording, gaps, cubic_windows("leave"))

    def fill(gap: Gap, share: Progress) -> Filled:
        # Who names donors wants to see what these can do.
        curve = None if params.donors else _curve(curves, gap, recording)
        others = None if params.donors else coded
        try:
            filled = _fill(_case(survey, gap, params, coded), recording, coded, share)
        except LeftOpenError:
            untested = curve or _coded_alone(others, gap, recording, share)
            if untested is None:
                raise
            return untested
        return curve if curve and _more_promising(curve[0], filled[0]) else filled

    return fill_each(gaps, fill, progress)


def _brief(gap: Gap, frames: int, rate: float) -> bool:
    """Return whether the samples beside a gap say much about it."""
    return gap.kind(frames) == "interior" and gap.length <= BRIEF_S * rate


def _curve(curves: Windows, gap: Gap, recording: Recording) -> Filled | None:
    """Draw a cubic curve through a brief gap, tested on stretches that no donor has to be in."""
    if not _brief(gap, recording.frames, recording.rate):
        return None
    try:
        patch, notes = curves.fill(gap, no_progress)
    except LeftOpenError:
        return None
    return patch, {**notes, "curve": True}


def _coded_alone(
    coded: CodedMotion | None, gap: Gap, recording: Recording, progress: Progress
) -> Filled | None:
    """Fill a gap whose marker is hardly seen in this recording, but in the training set."""
    values = None if coded is None else coded.values(gap, progress)
    if values is None:
        return None
    unknown = np.full(gap.length, np.nan)
    notes = {"donors": (), "self_tests": 0, "weights": (1.0,)}
    return Patch(gap, values / recording.mm, unknown, unknown), notes


def _more_promising(curve: Patch, blended: Patch) -> bool:
    """Return whether to trust a curve: where the blend is untested, or much worse by its tests."""
    if np.isnan(blended.expected_error):
        return True
    return curve.expected_error < PROMISING * blended.expected_error


def _case(survey: Survey, gap: Gap, params: AutoParams, coded: CodedMotion | None) -> Case:
    """Collect what there is to learn from."""
    edge = gap.kind(survey.recording.frames) != "interior"
    if edge and params.edges == "leave":
        raise LeftOpenError(LEFT_OPEN)
    donors = survey.donors(gap, params.donors, at_edges=False, enough=ENOUGH)
    if edge and not len(donors):
        raise LeftOpenError(
            "it is at the beginning or the end, and no other marker is seen throughout"
        )
    size = _size(gap, survey.recording)
    if coded is not None:
        size = replace(size, trials=CODED_TRIALS)
    return survey.case(gap, donors[_looked_at(donors)], size)


def _size(gap: Gap, recording: Recording) -> Size:
    if gap.length <= SHORT_S * recording.rate:
        return SHORT_SIZE
    return BRIEF_SIZE if gap.length <= BRIEF_S * recording.rate else SIZE


def _looked_at(donors: Donors) -> IntArray:
    """Return the places of donors that matter; the others would only cost frames and time."""
    near = [donors.best(view.donors, view.nearness) for view, _ in CANDIDATES]
    return np.unique(np.concatenate([*near, donors.best(SPEED_DONORS)]))


def _fill(
    case: Case, recording: Recording, coded: CodedMotion | None, progress: Progress
) -> Filled:
    """Fill a gap, and say how sure that is."""
    whole, weights = _whole(case, coded, progress)
    unsure = band(case, whole.errors, whole.spreads, whole.spread)
    labels = [recording.labels[marker] for marker in case.donors.markers[case.donors.best(4)]]
    notes = {
        "donors": tuple(labels),
        "self_tests": len(whole.errors),
        "weights": tuple(weights.round(3).tolist()),
    }
    mm = recording.mm
    return Patch(case.gap, whole.values / mm, unsure.sigma / mm, unsure.r90 / mm), notes


def _whole(
    case: Case, coded: CodedMotion | None, progress: Progress
) -> tuple[Candidate, FloatArray]:
    """Blend all candidates; the weight of the codes, if there are any, is the last."""
    if coded is None:
        return blended(_candidates(case, progress), PULL)
    own, weights = blended(_candidates(case, part(progress, 0.0, OWN_SHARE)), PULL)
    other = coded.candidate(case, part(progress, OWN_SHARE, 1.0))
    if other is None:
        return own, weights
    whole, theirs = joined(own, other, case.lesson.times_longer(case.gap))
    return whole, np.append((1 - theirs) * weights, theirs)


def _candidates(case: Case, progress: Progress) -> list[Candidate]:
    brief = _brief(case.gap, case.seen.size, case.rate)
    found = time_regression.regress(case, TIMES) if brief or len(case.donors) < FEW else []
    if not len(case.donors):
        return found
    candidates = BRIEF_CANDIDATES if brief else CANDIDATES
    for done, (view, kernels) in enumerate(candidates):
        progress(done / len(candidates))
        found += pose_regression.regress(case, view, kernels)
    return found
