"""The quintic smoothing spline against its closed form in exact arithmetic."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic import fill_with, punch, record, smooth_motion

from mocapmend_algorithms import Gap, find_gaps
from mocapmend_algorithms.fill.woltring import choose_smoothing, spline

KNOTS = (-9, -8, -6, -5, -4, -2, -1, 7, 8, 9, 12, 13)
LENGTH = 7


def solved(rows, right):
    """Gauss's elimination of a system of fractions."""
    rows = [[*row, value] for row, value in zip(rows, right, strict=True)]
    size = len(rows)
    for column in range(size):
        pivot = max(range(column, size), key=lambda row: abs(rows[row][column]))
        rows[column], rows[pivot] = rows[pivot], rows[column]
        for row in range(size):
            if row != column and rows[row][column]:
                factor = rows[row][column] / rows[column][column]
                rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column], strict=True)]
    return [row[size] / row[i] for i, row in enumerate(rows)]


def exact(knots, samples, places, smoothing):
    """The minimiser as a parabola plus multiples of |t - knot|^5, which is -240 times the kernel.

    Wahba 1990, Spline models for observational data, section 2.4.
    """
    kernel = [[Fraction(-(abs(a - b) ** 5), 240) for b in knots] for a in knots]
    powers = [[Fraction(a) ** power for power in range(3)] for a in knots]
    rows = [
        [value + (smoothing if i == j else 0) for j, value in enumerate(row)] + powers[i]
        for i, row in enumerate(kernel)
    ]
    rows += [[power[k] for power in powers] + [Fraction(0)] * 3 for k in range(3)]
    found = solved(rows, [*map(Fraction, samples), 0, 0, 0])
    weights, parabola = found[: len(knots)], found[len(knots) :]
    return [
        float(
            sum(w * Fraction(-(abs(t - b) ** 5), 240) for w, b in zip(weights, knots, strict=True))
            + sum(c * Fraction(t) ** power for power, c in enumerate(parabola))
        )
        for t in places
    ]


def smooth(made, samples, smoothing):
    return made.modes @ np.diag(1 / (1 + smoothing * made.penalties)) @ made.modes.T @ samples


@pytest.mark.parametrize("smoothing", [Fraction(0), Fraction(1, 100), Fraction(1), Fraction(5000)])
@pytest.mark.parametrize("stretch", [1, 40])
def test_the_spline_is_the_minimiser(smoothing, stretch):
    knots = tuple(k if k < 0 else k + stretch * LENGTH for k in KNOTS)
    length = (1 + stretch) * LENGTH
    samples = np.random.default_rng(3).integers(-50, 50, len(knots))
    made = spline(knots, length)
    at_knots = smooth(made, samples, float(smoothing))
    inside = made.inside @ at_knots
    places = [0, 3, length // 2, length - 1]
    expected = exact(knots, samples.tolist(), [*knots, *places], smoothing)
    found = np.concatenate((at_knots, inside[places]))
    np.testing.assert_allclose(found, expected, atol=1e-9 * np.abs(expected).max())


def test_cross_validation_leaves_each_sample_out():
    # GCV is ordinary cross-validation with the weights made equal: by hand, from the hat matrix.
    made = spline(KNOTS, LENGTH)
    values = np.random.default_rng(4).normal(0, 5, (len(KNOTS), 2, 3)).cumsum(axis=0)
    chosen, criteria = choose_smoothing(made, values, None)
    for index, smoothing in enumerate(made.grid()):
        hat = made.modes @ np.diag(1 / (1 + smoothing * made.penalties)) @ made.modes.T
        left = np.eye(len(KNOTS)) - hat
        for window in range(2):
            residual = np.sum((left @ values[:, window]) ** 2)
            expected = residual / np.trace(left) ** 2
            assert criteria[index, window] == pytest.approx(expected, rel=1e-6)
    assert set(chosen) <= set(made.grid())


def test_known_noise_is_smoothed_away():
    # The grid's choice comes near the best one, which is known only where the truth is.
    rng = np.random.default_rng(5)
    knots = tuple(range(-40, 0)) + tuple(range(5, 45))
    truth = np.sin(np.array(knots)[:, None, None] / 9) * [[30.0, 40.0, 50.0]]
    noisy = truth + rng.normal(0, 2, (len(knots), 20, 3))
    made = spline(knots, 5)
    columns = noisy.reshape(len(knots), -1)

    def risk(smoothing):
        return np.sum((smooth(made, columns, smoothing).reshape(noisy.shape) - truth) ** 2)

    least = min(map(risk, made.grid()))
    for noise in (2.0, None):
        chosen, _ = choose_smoothing(made, noisy, noise)
        assert risk(np.median(chosen)) < 1.1 * least


@settings(max_examples=20)
@given(
    seed=st.integers(0, 1000),
    length=st.integers(1, 60),
    smoothing=st.sampled_from(["auto", "0", "1", "1000"]),
)
def test_parabolas_pass_unchanged(seed, length, smoothing):
    factors = np.random.default_rng(seed).normal(0, 300, (3, 1, 3))
    time = np.linspace(-1, 1, 140)[:, None, None]
    points = factors[0] + factors[1] * time + factors[2] * time**2
    gap = Gap(0, 40, 40 + length)
    (patch,) = fill_with(
        ("woltring", {"smoothing": smoothing}), record(punch(points, [gap])), [gap]
    ).patches
    np.testing.assert_allclose(patch.values, points[gap.start : gap.stop, 0], atol=1e-5)


def test_without_smoothing_it_goes_through_the_samples_and_with_much_it_is_a_bridged_parabola():
    points = smooth_motion(120, 1) + np.random.default_rng(6).normal(0, 1, (120, 1, 3))
    gap = Gap(0, 50, 62)
    recording = record(punch(points, [gap]))
    near = np.r_[30:50, 62:82]
    made = spline(tuple((near - 50).tolist()), 12)
    through = fill_with(("woltring", {"smoothing": "0"}), recording, [gap]).patches[0].values
    np.testing.assert_allclose(through, made.inside @ points[near, 0], atol=0.05)
    bridged = fill_with(("woltring", {"smoothing": "1000"}), recording, [gap]).patches[0].values
    for axis in range(3):
        parabola = np.polynomial.Polynomial.fit(near, points[near, 0, axis], 2)
        left = points[[49, 62], 0, axis] - parabola(np.array([49, 62]))
        inside = np.arange(50, 62)
        expected = parabola(inside) + np.interp(inside, [49, 62], left)
        np.testing.assert_allclose(bridged[:, axis], expected, atol=0.01)


def test_it_says_what_it_lacks():
    points = np.full((20, 1, 3), np.nan)
    points[[1, 2, 3, 9, 10]] = 1.0
    recording = record(points)
    gap = next(g for g in find_gaps(recording.present) if g.start == 4)
    (unfilled,) = fill_with(("woltring", {}), recording, [gap]).unfilled
    assert unfilled.reason == "a quintic curve needs 6 samples, and the marker has only 5"
