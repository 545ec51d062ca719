"""Lost rows from sparse codes of known rows: what is fitted, what is scaled, what says nothing."""

from dataclasses import replace

import numpy as np
import pytest

from mocapmend_algorithms import no_progress
from mocapmend_algorithms.sparse.code_model import CodeModel, CodeSettings

EXAMPLES, KNOWN, LOST = 240, 12, 5
OWN_ROWS = CodeSettings(atoms=80, examples=0, penalty=0.02, guided=False)
FITTED = CodeSettings(atoms=80, examples=160, penalty=0.02, guided=False)
GUIDED = CodeSettings(atoms=80, examples=160, penalty=0.02, guided=True)
EVERY = pytest.mark.parametrize("settings", [OWN_ROWS, FITTED, GUIDED], ids=str)


def motions(count, seed=0, *, silent=0, loud=1.0):
    """Make known and lost rows of one cause, and known rows that say nothing of the lost ones."""
    rng = np.random.default_rng(seed)
    mix = np.random.default_rng(100).normal(size=(4, KNOWN + LOST))
    rows = rng.normal(size=(count, 4)) @ mix + np.arange(KNOWN + LOST)
    nothing = loud * rng.normal(size=(count, silent))
    return np.concatenate([rows[:, :KNOWN], nothing], axis=1), rows[:, KNOWN:]


def error(settings, known, lost, asked, expected):
    told = CodeModel(known, lost, settings, no_progress)(asked, no_progress)
    return np.sqrt(np.mean((told - expected) ** 2)) / np.std(expected)


@EVERY
def test_lost_rows_are_told_from_known_rows(settings):
    assert error(settings, *motions(EXAMPLES), *motions(50, seed=1)) < 0.15


def test_without_further_examples_the_lost_rows_of_the_atoms_are_their_own():
    rng = np.random.default_rng(0)
    known, lost = rng.normal(size=(8, KNOWN)), rng.normal(size=(8, LOST))
    settings = CodeSettings(atoms=8, examples=0, penalty=1e-6, guided=False)
    model = CodeModel(known, lost, settings, no_progress)
    # Nothing but an atom itself is sparse and like it.
    np.testing.assert_allclose(model(known, no_progress), lost, atol=0.05)


def test_fitted_lost_rows_undo_that_the_penalty_pulls_to_the_mean():
    case = (*motions(2000), *motions(80, seed=1))
    own = replace(OWN_ROWS, atoms=40, penalty=0.3)
    fitted = replace(own, examples=1000)
    assert error(fitted, *case) < 0.6 * error(own, *case)


def test_what_is_left_over_is_what_further_examples_are_missed_by():
    known, lost = motions(200)
    model = CodeModel(known, lost, replace(FITTED, atoms=30, examples=100), no_progress)
    expected = lost[1::2] - model(known[1::2], no_progress)
    np.testing.assert_allclose(model.left_over, expected, atol=1e-6 * np.std(lost))


def test_guided_is_not_led_astray_by_rows_that_say_nothing():
    case = (*motions(EXAMPLES, silent=40, loud=3.0), *motions(60, seed=1, silent=40, loud=3.0))
    assert error(GUIDED, *case) < 0.6 * error(FITTED, *case)
    assert error(GUIDED, *case) < 0.35


@EVERY
@pytest.mark.parametrize("scale", [1e-3, 1e6])
def test_units_do_not_matter(settings, scale):
    known, lost = motions(EXAMPLES)
    asked, _ = motions(30, seed=1)
    here = CodeModel(known, lost, settings, no_progress)(asked, no_progress)
    there = CodeModel(scale * known, scale * lost, settings, no_progress)(
        scale * asked, no_progress
    )
    np.testing.assert_allclose(there / scale, here, atol=1e-4 * np.std(lost))


@EVERY
def test_a_common_offset_goes_into_the_mean(settings):
    known, lost = motions(EXAMPLES)
    asked, _ = motions(30, seed=1)
    here = CodeModel(known, lost, settings, no_progress)(asked, no_progress)
    there = CodeModel(known + 500, lost - 300, settings, no_progress)(asked + 500, no_progress)
    np.testing.assert_allclose(there + 300, here, atol=1e-4)


@EVERY
def test_constant_rows_change_nothing(settings):
    known, lost = motions(EXAMPLES)
    asked, _ = motions(30, seed=1)
    here = CodeModel(known, lost, settings, no_progress)(asked, no_progress)
    fixed = np.concatenate([known, np.full((EXAMPLES, 3), 7.0)], axis=1)
    also = np.concatenate([lost, np.full((EXAMPLES, 1), -2.0)], axis=1)
    model = CodeModel(fixed, also, settings, no_progress)
    told = model(np.concatenate([asked, np.full((30, 3), 7.0)], axis=1), no_progress)
    np.testing.assert_allclose(told[:, -1], -2.0)
    # The ridge is a share of the mean row, and three rows of nothing lower that.
    np.testing.assert_allclose(told[:, :-1], here, atol=0.02 * np.std(lost))


@EVERY
@pytest.mark.parametrize("count", [1, 2, 3, 10])
def test_examples_that_are_all_alike_tell_themselves(settings, count):
    known, lost = np.full((count, KNOWN), 3.0), np.full((count, LOST), -1.0)
    model = CodeModel(known, lost, settings, no_progress)
    np.testing.assert_allclose(model(known[:1] + 5.0, no_progress), lost[:1])


@EVERY
def test_the_same_example_many_times_is_no_trouble(settings):
    known, lost = motions(7)
    model = CodeModel(np.tile(known, (20, 1)), np.tile(lost, (20, 1)), settings, no_progress)
    told = model(known, no_progress)
    assert np.isfinite(told).all()
    assert np.sqrt(np.mean((told - lost) ** 2)) < 0.3 * np.std(lost)


@EVERY
def test_a_column_is_told_the_same_alone_and_in_company(settings):
    model = CodeModel(*motions(EXAMPLES), settings, no_progress)
    asked, _ = motions(20, seed=1)
    together = model(asked, no_progress)
    alone = np.concatenate([model(asked[[at]], no_progress) for at in range(20)])
    np.testing.assert_allclose(alone, together, atol=1e-8)
