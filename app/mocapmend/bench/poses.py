"""Whole poses as sparse codes of known poses: the three sweeps of a patent, beside two rivals.

X13 = patent CN103020984. Markers drawn by lot are lost together, and the error is measured over
them: for dictionaries of more and more poses, for longer and longer gaps, and for more and more
missing markers; on repetitive and on complex motion. The poses are those of the recording's other
frames, and, where there are any, of other trials of the motion by the same person.
"""

import argparse
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from mocapmend.bench.arguments import at_least
from mocapmend.bench.grid import Cell, Column, Grid, Report
from mocapmend.bench.pose_cases import COMPLEX, REPETITIVE, Case, Subject, bundled, lose, of_folder
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.interpolate import CubicParams, cubic
from mocapmend_algorithms.fill.pca import PcaR2Params, bare_r2, pca_r2
from mocapmend_algorithms.fill.pose_code import PoseCodeParams, bare_pose_code, pose_code
from mocapmend_algorithms.fill.punch_errors import BareFill
from mocapmend_algorithms.gaps import seen_outside
from mocapmend_algorithms.sparse.training_set import gather, write_training_set

SIZES = (50, 100, 200, 400, 800, 1600)
SECONDS = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0)
MARKERS = (1, 2, 3, 5, 10, 20)
USUAL_SECONDS, USUAL_MARKERS = 0.5, 3
"""Of the gaps, where something else is swept."""
OWN, OTHERS, PRINTED = "own", "others", "printed"
PCA, SPLINE = "pca", "spline"
TITLES = {
    OWN: "pose-code",
    OTHERS: "pose-code, other trials",
    PRINTED: "pose-code, as printed",
    PCA: "pca-r2",
    SPLINE: "cubic spline",
}
AS_PRINTED = PoseCodeParams(
    relative_to="world", centred=False, weight_scale_mm=100000.0, meet_edges=False
)
NOTES = (
    "RMSE in mm: 3-D, over the missing samples of a case; geometric mean over the cases.",
    f"Unless swept: {PoseCodeParams().poses} poses, {USUAL_MARKERS} markers, {USUAL_SECONDS:g} s.",
    "A recording with fewer poses puts all into the dictionary.",
    "Other trials: of the recordings of joints alone, so fewer cases than the other columns have.",
    "As printed: in absolute coordinates, all markers alike, edges not met; with our penalty.",
)
ONLY_REPETITIVE = (
    "The bundled walk is repetitive; complex motion and other trials need the recordings that "
    "--data names."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--runs", type=at_least(1), default=2, help="gaps of each kind in each recording"
    )
    parser.add_argument(
        "--data",
        type=Path,
        metavar="DIR",
        help="the folder that holds cmu_joints and cmu_markers, instead of the bundled walk",
    )


def run(arguments: argparse.Namespace) -> Report:
    """Repair all cases with all methods."""
    subjects = of_folder(arguments.data) if arguments.data else bundled()
    trials: list[Trial] = []
    with tempfile.TemporaryDirectory() as folder:
        teams = [_team(subject, Path(folder) / f"{n}.npz") for n, subject in enumerate(subjects)]
        for team in teams:
            trials += _sweeps(team, arguments.runs)
        banded = [row for team in teams for row in _banded(team, arguments.runs)]
    grids = [_swept(trials, *sweep) for sweep in SWEEPS]
    notes = NOTES if arguments.data else (*NOTES, ONLY_REPETITIVE)
    names = ", ".join(subject.motion for subject in subjects)
    every = Grid("cases", "Case by case", CASE_COLUMNS, [t.row() for t in trials], for_people=False)
    return Report(
        f"Sparse codes of poses: {names}",
        [*grids, Grid("motions", BY_MOTION, MOTION_COLUMNS, banded), every],
        notes,
    )


@dataclass(frozen=True, eq=False)
class Team:
    """A subject, and the file of the poses of its other trials; none where there are none."""

    subject: Subject
    training: str


@dataclass(frozen=True)
class Trial:
    """A case that was repaired: what was swept, and each method's RMSE in mm."""

    sweep: str
    value: float
    motion: str
    kind: str
    errors: Mapping[str, float]

    def row(self) -> dict[str, Cell]:
        """Return it as the JSON document has it."""
        head: dict[str, Cell] = {"sweep": self.sweep, "value": self.value}
        errors = {method: self.errors.get(method, float("nan")) for method in TITLES}
        return {**head, "motion": self.motion, "kind": self.kind, **errors}


SWEEPS = (
    ("poses", "Poses in the dictionary", SIZES),
    ("seconds", "Length of the gap (s)", SECONDS),
    ("markers", "Missing markers", MARKERS),
)
CASE_COLUMNS = [Column(key, key) for key in ("sweep", "value", "motion", "kind", *TITLES)]
BY_MOTION = "By motion, with bands"
MOTION_COLUMNS = [
    Column("motion", "motion"),
    Column("method", "method"),
    Column("rmse", "RMSE (mm)", ".1f"),
    Column("inside", "% within r90", ".0f"),
    Column("seconds", "seconds per case", ".2f"),
]


def _team(subject: Subject, path: Path) -> Team:
    if not subject.others:
        return Team(subject, "")
    write_training_set(gather(subject.others), path)
    return Team(subject, str(path))


def _ways(team: Team, recording: Recording, poses: int) -> Mapping[str, BareFill]:
    """Return the fills that know poses."""
    own = replace(PoseCodeParams(), poses=poses)
    ways = {
        OWN: bare_pose_code(recording, own),
        PRINTED: bare_pose_code(recording, replace(AS_PRINTED, poses=poses)),
    }
    if team.training:
        ways[OTHERS] = bare_pose_code(recording, replace(own, training=team.training))
    return ways


def _sweeps(team: Team, count: int) -> Iterator[Trial]:
    subject = team.subject
    usual = PoseCodeParams().poses
    for sweep, _, values in SWEEPS:
        rivals: dict[int, Mapping[str, float]] = {}
        for value in values:
            seconds = float(value) if sweep == "seconds" else USUAL_SECONDS
            markers = int(value) if sweep == "markers" else USUAL_MARKERS
            for number in range(count):
                case = lose(subject, seconds, markers, number, count)
                if case is None:
                    continue
                ways = _ways(team, case.recording, int(value) if sweep == "poses" else usual)
                errors = {name: _error(case, _bare(case, fill)) for name, fill in ways.items()}
                # The rivals know nothing of dictionaries: once for all sizes.
                if sweep != "poses" or number not in rivals:
                    rivals[number] = _rivals(case)
                errors |= rivals[number]
                yield Trial(sweep, float(value), subject.motion, subject.kind, errors)


def _rivals(case: Case) -> Mapping[str, float]:
    spline = cubic(case.recording, case.gaps, CubicParams(), no_progress)
    return {
        PCA: _error(case, _bare(case, bare_r2(PcaR2Params()))),
        SPLINE: _error(case, spline),
    }


def _bare(case: Case, fill: BareFill) -> FillResult:
    observed = seen_outside(case.recording.present, case.gaps)
    return fill(case.recording, observed, case.gaps, no_progress)


def _distances(case: Case, result: FillResult) -> FloatArray:
    """Return the errors of the filled samples, gap by gap, in the recording's unit."""
    truth = case.subject.truth.points
    away = [
        np.linalg.norm(
            patch.values - truth[patch.gap.start : patch.gap.stop, patch.gap.marker], axis=1
        )
        for patch in result.patches
    ]
    return np.concatenate(away) if away else np.empty(0)


def _error(case: Case, result: FillResult) -> float:
    """Return the RMSE in mm; NaN where nothing was filled."""
    away = _distances(case, result) * case.subject.truth.mm
    return float(np.sqrt(np.mean(away**2))) if away.size else float("nan")


def _swept(trials: Sequence[Trial], sweep: str, title: str, values: Sequence[float]) -> Grid:
    among = [trial for trial in trials if trial.sweep == sweep]
    rows: list[dict[str, Cell]] = []
    for kind in (REPETITIVE, COMPLEX):
        for value in values:
            these = [t for t in among if t.kind == kind and t.value == value]
            if these:
                means = {
                    method: _mean([t.errors[method] for t in these if method in t.errors])
                    for method in TITLES
                }
                rows.append({"kind": kind, "value": value, "count": len(these), **means})
    columns = [
        Column("kind", "motion"),
        Column("value", title, "g"),
        Column("count", "cases"),
        *(Column(method, TITLES[method], ".1f") for method in TITLES),
    ]
    return Grid(sweep, f"{title}: RMSE (mm)", columns, rows)


def _mean(errors: Sequence[float]) -> float:
    """Return the geometric mean of those that are known; NaN where none is."""
    known = np.array(errors)[np.isfinite(errors)]
    return float(np.exp(np.mean(np.log(known)))) if known.size else float("nan")


def _banded(team: Team, count: int) -> Iterator[dict[str, Cell]]:
    """Repair the usual gaps of a recording with bands, method by method."""
    usual = PoseCodeParams()
    fills: dict[str, Callable[[Case], FillResult]] = {
        OWN: lambda case: pose_code(case.recording, case.gaps, usual, no_progress),
        PCA: lambda case: pca_r2(case.recording, case.gaps, PcaR2Params(), no_progress),
        SPLINE: lambda case: cubic(case.recording, case.gaps, CubicParams(), no_progress),
    }
    if team.training:
        taught = replace(usual, training=team.training)
        fills[OTHERS] = lambda case: pose_code(case.recording, case.gaps, taught, no_progress)
    drawn = (lose(team.subject, USUAL_SECONDS, USUAL_MARKERS, n, count) for n in range(count))
    cases = [case for case in drawn if case is not None]
    for method in (method for method in TITLES if method in fills and cases):
        start = time.perf_counter()
        results = [fills[method](case) for case in cases]
        seconds = (time.perf_counter() - start) / len(cases)
        away = np.concatenate([_distances(*pair) for pair in zip(cases, results, strict=True)])
        radii = np.concatenate([patch.r90 for result in results for patch in result.patches])
        known = np.isfinite(radii)
        yield {
            "motion": team.subject.motion,
            "method": TITLES[method],
            "rmse": _mean([_error(*pair) for pair in zip(cases, results, strict=True)]),
            "inside": 100 * float(np.mean((away <= radii)[known])) if known.any() else None,
            "seconds": seconds,
        }
