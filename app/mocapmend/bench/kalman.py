"""The constant-velocity filter: its paper's experiment on real recordings, and its speed.

L21 = Wang, Lü, Mu 2021, Techniques of Automation and Applications 40(4):116-119. A hip and a knee
marker are lost for long spans of 600 frames at 120 Hz. A segment is tracked when all its markers
are there, do not jump (eq. 1) and lie within 10 mm of the reference. The paper's reference and raw
data were separate takes; here the reference is the recording before the loss.
"""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from mocapmend.bench import kalman_speed
from mocapmend.bench.arguments import at_least
from mocapmend.bench.kalman_cases import Case, bundled, filled, of_folder
from mocapmend.bench.table import Row, Table
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.detection import jump_threshold, jumps
from mocapmend_algorithms.fill.kalman import KalmanParams, kalman
from mocapmend_algorithms.metrics import SuccessCurves, success_curves, tracked

AT = (160, 330, 510, 600)
"""Frames, of 600, at which the curves are told: each loss begins or ends, and the end."""
WAYS = {
    "causal, world frame (as printed)": KalmanParams(direction="causal", frame="world"),
    "causal, local frame": KalmanParams(direction="causal"),
    "two-sided, world frame": KalmanParams(frame="world"),
    "two-sided, local frame (default)": KalmanParams(),
    "two-sided, world frame, pulled to bones": KalmanParams(frame="world", bone_pull=True),
    "two-sided, local frame, pulled to bones": KalmanParams(bone_pull=True),
}
PRINTED, WORLD, DEFAULT, BONES = (tuple(WAYS)[at] for at in (0, 2, 3, 5))
NOMINAL = 90.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument("--runs", type=at_least(1), default=5, help="counted runs of the speed")
    parser.add_argument(
        "--data",
        type=Path,
        metavar="DIR",
        help="the recordings in this folder that suit, and not the bundled walk",
    )


def run(arguments: argparse.Namespace) -> Table:
    """Repeat the experiment on one or more recordings; figures are medians over them."""
    cases = of_folder(arguments.data) if arguments.data else bundled()
    frames = cases[0].reference.frames
    names = ", ".join(case.name for case in cases)
    title = f"Constant-velocity filter, {frames} frames of {names}"
    outcomes = [_repair(case) for case in cases]
    return Table(
        title,
        [
            *_curves(cases, outcomes),
            *_errors(outcomes),
            *kalman_speed.rows(cases[0], arguments.runs),
        ],
    )


class Outcome:
    """One way to repair a case.

    Parameters
    ----------
    case : Case
        The case.
    params : KalmanParams
        The way.

    Attributes
    ----------
    recording : Recording
        What was repaired.
    rmse_mm : float
        3-D error over the lost samples that were filled.
    inside : float
        Share (%) of these within `r90`.
    """

    def __init__(self, case: Case, params: KalmanParams) -> None:
        result = kalman(case.raw, case.gaps, params, no_progress)
        self.recording = filled(case, [(patch.gap, patch.values) for patch in result.patches])
        truth = case.reference.points
        errors, inside = [], []
        for patch in result.patches:
            gap = patch.gap
            away = np.linalg.norm(patch.values - truth[gap.start : gap.stop, gap.marker], axis=1)
            errors.append(away * case.reference.mm)
            inside.append(away <= patch.r90)
        self.rmse_mm = float(np.sqrt(np.mean(np.concatenate(errors) ** 2)))
        self.inside = 100 * float(np.mean(np.concatenate(inside)))


Outcomes = Mapping[str, Outcome]


def _repair(case: Case) -> Outcomes:
    return {way: Outcome(case, params) for way, params in WAYS.items()}


def _curves(cases: Sequence[Case], outcomes: Sequence[Outcomes]) -> list[Row]:
    versions = {
        "reference": [case.reference for case in cases],
        "raw": [case.raw for case in cases],
        **{
            f"repaired, {way}": [outcome[way].recording for outcome in outcomes]
            for way in (PRINTED, WORLD, DEFAULT, BONES)
        },
    }
    rows = []
    for name, recordings in versions.items():
        curves = [success(case, version) for case, version in zip(cases, recordings, strict=True)]
        for at in AT:
            shares = [
                c.running_mean[case.frame(at) - 1] for c, case in zip(curves, cases, strict=True)
            ]
            what = f"segments tracked up to frame {at} of 600, {name}"
            rows.append(Row(what, 100 * float(np.median(shares)), "%"))
        survived = [100 * float(curve.survival[-1]) for curve in curves]
        rows.append(Row(f"segments never lost, {name}", float(np.median(survived)), "%"))
    return rows


def success(case: Case, version: Recording) -> SuccessCurves:
    """Draw the curves of tracking success of a version of a case, counting segments."""
    reference = case.reference
    bad = jumps(version.points, jump_threshold(reference.points))
    good = tracked(version, bad=bad, reference=reference)
    everyone = np.ones(reference.markers, dtype=np.bool_)
    return success_curves(good, counted=everyone, segments=case.segments)


def _errors(outcomes: Sequence[Outcomes]) -> list[Row]:
    world = np.array([outcome[WORLD].rmse_mm for outcome in outcomes])
    rows = []
    for way in WAYS:
        errors = np.array([outcome[way].rmse_mm for outcome in outcomes])
        ratio = float(np.median(errors / world))
        against = "" if way == WORLD else WORLD
        figure = float(np.median(errors))
        rows.append(Row(f"RMSE, {way}", figure, "mm", against, ratio if against else None))
    for way in (WORLD, DEFAULT, BONES):
        inside = float(np.median([outcome[way].inside for outcome in outcomes]))
        rows.append(
            Row(f"samples within r90, {way}", inside, "%", "nominal 90 %", inside / NOMINAL)
        )
    return rows
