"""Fills in a frame of reference that moves with donors: rigid body, pattern, regression.

The marker's place in that frame is taken as constant (rigid body, pattern: one donor, no turning)
or as a linear function of the donors' places in it (local frame, ridge regression). What that
leaves over at the edges of the gap is carried into it, linearly between two edges, and decaying
from one edge.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from mocapmend_algorithms.alignment import Alignment
from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.band import band
from mocapmend_algorithms.fill.case import Case
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.lessons import Size, Trial
from mocapmend_algorithms.fill.model_params import (
    LEFT_OPEN,
    ModelEdges,
    donors_option,
    model_edges_option,
)
from mocapmend_algorithms.fill.survey import Survey
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

LEAST_RIGID = 3
SPREAD_FLOOR_MM = 1.0
DECAY_S = 0.5
EDGE_SHARE = 0.2
SIZE = Size()
ENOUGH = 2 * SIZE.frames


@dataclass(frozen=True)
class RigidParams:
    """Parameters of `rigid`."""

    edges: ModelEdges = model_edges_option()
    donors: tuple[str, ...] = donors_option("Three or more markers of the same rigid part")


@dataclass(frozen=True)
class PatternParams:
    """Parameters of `pattern`."""

    edges: ModelEdges = model_edges_option()
    donors: tuple[str, ...] = donors_option("A marker that moves like this one, or several")


@dataclass(frozen=True)
class LocalFrameParams:
    """Parameters of `local-frame`."""

    edges: ModelEdges = model_edges_option()
    donors: tuple[str, ...] = donors_option("Markers that move with this one")
    penalty: float = option(
        1e-4,
        label="Penalty",
        text="Of large coefficients, relative to how much the donors move: more is stiffer.",
        minimum=1e-9,
        maximum=1e3,
    )


@dataclass(frozen=True)
class _Model:
    """How many donors carry the frame, how many are regressed on, and how stiffly."""

    least: int
    frame: int
    features: int = 0
    penalty: float = 1.0
    turns: bool = True


class _Params(Protocol):
    @property
    def edges(self) -> ModelEdges: ...
    @property
    def donors(self) -> tuple[str, ...]: ...


def rigid(
    recording: Recording, gaps: Sequence[Gap], params: RigidParams, progress: Progress, /
) -> FillResult:
    """Move the marker with a rigid body of three or more donors (Kabsch 1976)."""
    count = max(len(params.donors), LEAST_RIGID)
    return _fill(recording, gaps, params, _Model(LEAST_RIGID, count), progress)


def pattern(
    recording: Recording, gaps: Sequence[Gap], params: PatternParams, progress: Progress, /
) -> FillResult:
    """Move the marker along with one donor, or with the mean of those given."""
    count = max(len(params.donors), 1)
    return _fill(recording, gaps, params, _Model(1, count, turns=False), progress)


def local_frame(
    recording: Recording, gaps: Sequence[Gap], params: LocalFrameParams, progress: Progress, /
) -> FillResult:
    """Regress the marker's place in the frame of four donors on the places of twelve."""
    return _fill(recording, gaps, params, _Model(LEAST_RIGID, 4, 12, params.penalty), progress)


def _fill(
    recording: Recording,
    gaps: Sequence[Gap],
    params: _Params,
    model: _Model,
    progress: Progress,
) -> FillResult:
    survey = Survey(recording, gaps)

    def fill(gap: Gap, share: Progress) -> tuple[Patch, dict[str, Any]]:
        case = _case(survey, gap, params, model)
        patch, frame = _fill_case(case, model, recording.mm)
        labels = tuple(recording.labels[marker] for marker in case.donors.markers[frame])
        return patch, {"donors": labels, "self_tests": len(case.lesson.trials)}

    return fill_each(gaps, fill, progress)


def _case(survey: Survey, gap: Gap, params: _Params, model: _Model) -> Case:
    if params.edges == "leave" and gap.kind(survey.recording.frames) != "interior":
        raise LeftOpenError(LEFT_OPEN)
    donors = survey.donors(gap, params.donors, at_edges=True, enough=ENOUGH)
    if len(donors) < model.least and params.donors:
        raise LeftOpenError(f"it takes {model.least} donors and was given {len(donors)}")
    if len(donors) < model.least:
        count = "no marker is" if not len(donors) else f"only {len(donors)} of the markers are"
        raise LeftOpenError(
            f"{count} seen throughout the gap and at its edges, and it takes {model.least}"
        )
    most = max(model.frame, model.features)
    corners = model.turns and most == LEAST_RIGID
    best = survey.distances.triangle(donors) if corners else donors.best(most)
    return survey.case(gap, donors[best], SIZE)


def _fill_case(case: Case, model: _Model, mm: float) -> tuple[Patch, IntArray]:
    frame = case.donors.best(model.frame)
    weights = 1 / (case.donors.spread[frame] ** 2 + 1)
    alignment = case.aligned(frame, weights) if model.turns else case.moved(frame)
    samples = case.samples
    fit = _Ridge(
        _features(case, alignment, model), alignment[:samples].to_local(case.target), model.penalty
    )
    start, stop = case.gap.start, case.gap.stop
    before, after = (_at(case.lesson.frames, edge) for edge in (start - 1, stop))
    carried = _carry(fit.residual, before, after, case.frames[samples:], case)
    values = alignment[samples:].to_world(fit.predicted[samples:] + carried)
    errors = [_left_over(case, trial, fit) for trial in case.lesson.trials]
    spreads = [
        _growth(case, trial.start, trial.stop, case.lesson.frames[trial.hidden[trial.judged]])
        for trial in case.lesson.trials
    ]
    unsure = band(case, errors, spreads, _growth(case, start, stop, case.frames[samples:]))
    return Patch(case.gap, values / mm, unsure.sigma / mm, unsure.r90 / mm), frame


def _features(case: Case, alignment: Alignment, model: _Model) -> FloatArray:
    donors = case.donors.best(model.features)
    if not donors.size:
        return np.zeros((case.frames.size, 0))
    local = alignment.to_local(case.at(donors))
    local -= local[: case.samples].mean(axis=0)
    local /= (case.donors.spread[donors] + SPREAD_FLOOR_MM)[:, None]
    return local.reshape(case.frames.size, -1)


class _Ridge:
    """A ridge regression with an intercept, and what it leaves over where samples are hidden."""

    def __init__(self, features: FloatArray, values: FloatArray, penalty: float) -> None:
        samples = values.shape[0]
        seen = features[:samples]
        square = seen.T @ seen
        size = float(np.trace(square)) / max(square.shape[0], 1) or 1.0
        square += penalty * size * np.eye(square.shape[0])
        self._seen = seen
        self._gain = np.linalg.solve(square, seen.T).T
        mean = values.mean(axis=0)
        self.predicted: FloatArray = mean + features @ (self._gain.T @ (values - mean))
        self.residual: FloatArray = values - self.predicted[:samples]

    def without(self, hidden: IntArray) -> FloatArray:
        """Return the residual of all samples when the hidden ones are not known."""
        # The rows of the hat matrix that belong to them; Cook and Weisberg 1982, eq. 2.2.7.
        influence = self._gain @ self._seen[hidden].T + 1 / self._seen.shape[0]
        own = np.linalg.solve(np.eye(hidden.size) - influence[hidden], self.residual[hidden])
        residual: FloatArray = self.residual + influence @ own
        return residual


def _left_over(case: Case, trial: Trial, fit: _Ridge) -> FloatArray:
    """Return what a fill of a trial leaves over at the frames that are judged."""
    residual = fit.without(trial.hidden)
    first, last = int(trial.hidden[0]), int(trial.hidden[-1])
    before = first - 1 if first > 0 else None
    after = last + 1 if last + 1 < case.samples else None
    judged = trial.hidden[trial.judged]
    return residual[judged] - _carry(residual, before, after, case.lesson.frames[judged], case)


def _at(frames: IntArray, frame: int) -> int | None:
    """Return where a frame is among the lesson's, if it is."""
    place = int(np.searchsorted(frames, frame))
    return place if place < frames.size and frames[place] == frame else None


def _carry(
    residual: FloatArray, before: int | None, after: int | None, frames: IntArray, case: Case
) -> FloatArray:
    """Carry what is left over at the edges of a gap to frames inside it."""
    known = case.lesson.frames
    if before is not None and after is not None:
        share = ((frames - known[before]) / (known[after] - known[before]))[:, None]
        carried: FloatArray = (1 - share) * residual[before] + share * residual[after]
        return carried
    edge = before if before is not None else after
    if edge is None:
        return np.zeros((frames.size, 3))
    share = np.exp(-np.abs(frames - known[edge]) / (DECAY_S * case.rate))[:, None]
    faded: FloatArray = share * residual[edge]
    return faded


def _growth(case: Case, start: int, stop: int, frames: IntArray) -> FloatArray:
    """How the error grows away from the edges of a gap: like a bridge between two, else rising."""
    kind = case.gap.kind(case.seen.size)
    if kind == "interior":
        share = (frames - start + 1) / (stop - start + 1)
        growth: FloatArray = 2 * np.sqrt(share * (1 - share))
    else:
        away = stop - frames if kind == "leading" else frames - start + 1
        growth = 1 - np.exp(-away / (DECAY_S * case.rate))
    return EDGE_SHARE + (1 - EDGE_SHARE) * growth
