"""The candidates that look at the marker alone: samples beside the gap, and nothing else."""

from dataclasses import replace

import numpy as np
import pytest
from donor_samples import body, jittery, punched, rms, truth_of
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, Matern
from synthetic import smooth_motion

from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.auto import TIMES
from mocapmend_algorithms.fill.lessons import BORDERS, Lesson, Size
from mocapmend_algorithms.fill.survey import Survey
from mocapmend_algorithms.fill.time_regression import regress

RATE = 100.0


def case_of(points, gap):
    survey = Survey(punched(points, [gap]), [gap])
    donors = survey.donors(gap, (), at_edges=False, enough=1000)
    return survey.case(gap, donors, Size(200, 8, 6, 50))


@pytest.mark.parametrize("kernel", TIMES)
def test_values_and_spread_are_those_of_scikit_learn(kernel):
    points, gap = jittery(smooth_motion(400, 1)), Gap(0, 200, 220)
    (candidate,) = regress(case_of(points, gap), [kernel])
    knots = np.concatenate((gap.start - BORDERS[::-1], gap.stop - 1 + BORDERS))
    parts = [ConstantKernel(v) * Matern(scale, nu=2.5) for v, scale in kernel.temporal]
    peer = GaussianProcessRegressor(parts[0] + parts[1], alpha=kernel.noise, optimizer=None)
    mean = points[knots, 0].mean(axis=0)
    peer.fit(knots[:, None] / RATE, points[knots, 0] - mean)
    asked = np.arange(gap.start, gap.stop)[:, None] / RATE
    values, spread = peer.predict(asked, return_std=True)
    np.testing.assert_allclose(candidate.values, mean + values, atol=1e-4)
    expected = np.sqrt(spread[:, 0] ** 2 + kernel.noise)
    # In its own unit: the size of the motion beside the gap.
    np.testing.assert_allclose(candidate.spread / candidate.spread[0], expected / expected[0], 1e-3)


@pytest.mark.parametrize("start", [0, 150, 370])
def test_what_is_left_over_in_a_trial_is_what_a_fill_of_it_leaves(start):
    points, gap = jittery(body(400, 5)), Gap(0, start, start + 30)
    case = case_of(points, gap)
    candidates = regress(case, TIMES)
    assert len(case.lesson.trials) >= 3
    for place, trial in enumerate(case.lesson.trials):
        hidden = Gap(0, trial.start, trial.stop)
        seen = case.seen.copy()
        seen[case.lesson.frames[trial.hidden]] = False
        seen[trial.start : trial.stop] = False
        judged = case.lesson.frames[trial.hidden[trial.judged]]
        if gap.start == 0:
            seen[: trial.stop] = False
        elif gap.stop == 400:
            seen[trial.start :] = False
        without = replace(
            case,
            gap=hidden,
            lesson=Lesson(case.lesson.frames, ()),
            frames=np.concatenate((case.lesson.frames, judged)),
            seen=seen,
        )
        for candidate, again in zip(candidates, regress(without, TIMES), strict=True):
            np.testing.assert_allclose(
                candidate.errors[place], points[judged, 0] - again.values, atol=1e-6
            )
            unit = candidate.spreads[place] / again.spread
            np.testing.assert_allclose(unit, unit[0], rtol=1e-6)


def test_donors_that_are_gone_beside_the_gap_change_nothing():
    points, gap = jittery(body(400, 6)), Gap(0, 200, 210)
    gone = points.copy()
    gone[150:260, 3:] = np.nan
    for one, other in zip(
        regress(case_of(points, gap), TIMES), regress(case_of(gone, gap), TIMES), strict=True
    ):
        assert one.values.tobytes() == other.values.tobytes()


def test_a_brief_gap_is_filled_well():
    points, gap = jittery(smooth_motion(400, 1), 0.01), Gap(0, 200, 210)
    errors = [
        rms(candidate.values, truth_of(points, gap))
        for candidate in regress(case_of(points, gap), TIMES)
    ]
    assert min(errors) < 0.2
    assert max(errors) < 5.0


def test_the_spread_follows_the_motion_beside_the_gap():
    # A marker that rests for most of the recording: what its rest shows is no promise for a swing.
    swing = smooth_motion(600, 1)
    swing[:450] = swing[450] + (swing[:450] - swing[450]) / 50
    points = jittery(swing, 0.01)
    resting, swinging = (
        regress(case_of(points, Gap(0, start, start + 20)), TIMES) for start in (200, 520)
    )
    for rest, move in zip(resting, swinging, strict=True):
        apart = 1 / np.median([np.median(spread) for spread in rest.spreads])
        others = 1 / np.median([np.median(spread) for spread in move.spreads])
        assert np.median(move.spread) * others > 5 * np.median(rest.spread) * apart


def test_a_marker_that_stands_still_is_filled_where_it_stands():
    points, gap = np.ones((100, 1, 3)), Gap(0, 50, 60)
    for candidate in regress(case_of(points, gap), TIMES):
        np.testing.assert_allclose(candidate.values, 1.0, atol=1e-9)
        assert (candidate.spread > 0).all()
