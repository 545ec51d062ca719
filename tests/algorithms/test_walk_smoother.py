"""The smoother against a batch solution, against filterpy, and in its limits."""

import numpy as np
import pytest
from filterpy.kalman import KalmanFilter

from mocapmend_algorithms import Cancelled, no_progress
from mocapmend_algorithms.fill.walk_smoother import Walk, smooth

FRAMES, COLUMNS, STATES = 40, 9, 4


@pytest.fixture
def walk():
    rng = np.random.default_rng(3)
    loadings = np.linalg.qr(rng.normal(size=(COLUMNS, STATES)))[0]
    root = rng.normal(size=(STATES, STATES))
    return Walk(loadings, root @ root.T, 0.3, np.diag([50.0, 20.0, 9.0, 4.0]))


def seen_in_part(kind):
    """Which values are seen: here and there, one stretch without some columns, or without all."""
    rng = np.random.default_rng(5)
    seen = np.ones((FRAMES, COLUMNS), dtype=bool)
    if kind == "here and there":
        return rng.random(seen.shape) < 0.6
    seen[8:35, : 7 if kind == "few" else COLUMNS] = False
    return seen


def values_of(walk):
    rng = np.random.default_rng(7)
    states = rng.normal(size=(FRAMES, STATES)).cumsum(axis=0) * 2
    return states @ walk.loadings.T + rng.normal(0, 0.5, (FRAMES, COLUMNS))


def batch(walk, values, seen):
    """The most probable states as one least-squares problem."""
    size = FRAMES * STATES
    matrix, right = np.zeros((size, size)), np.zeros(size)
    matrix[:STATES, :STATES] = np.linalg.inv(walk.start)
    precision = np.linalg.inv(walk.process)
    for frame in range(FRAMES):
        at = slice(frame * STATES, (frame + 1) * STATES)
        rows = walk.loadings[seen[frame]]
        matrix[at, at] += rows.T @ rows / walk.noise
        right[at] += rows.T @ values[frame, seen[frame]] / walk.noise
        if frame:
            before = slice((frame - 1) * STATES, frame * STATES)
            matrix[at, at] += precision
            matrix[before, before] += precision
            matrix[at, before] -= precision
            matrix[before, at] -= precision
    return np.linalg.solve(matrix, right).reshape(FRAMES, STATES)


@pytest.mark.parametrize("kind", ["here and there", "few", "none"])
def test_agrees_with_the_batch_solution(walk, kind):
    seen = seen_in_part(kind)
    values = values_of(walk)
    states = smooth(walk, np.where(seen, values, np.nan), seen, no_progress)
    np.testing.assert_allclose(states, batch(walk, values, seen), atol=1e-8)


def test_agrees_with_filterpy(walk):
    values = values_of(walk)
    seen = np.ones((FRAMES, COLUMNS), dtype=bool)
    other = KalmanFilter(dim_x=STATES, dim_z=COLUMNS)
    other.x = np.zeros((STATES, 1))
    other.F, other.H = np.eye(STATES), walk.loadings
    other.Q, other.R = walk.process, walk.noise * np.eye(COLUMNS)
    # filterpy predicts before its first update.
    other.P = walk.start - walk.process
    means, covariances, _, _ = other.batch_filter(values[:, :, None])
    expected = other.rts_smoother(means, covariances)[0][:, :, 0]
    np.testing.assert_allclose(smooth(walk, values, seen, no_progress), expected, atol=1e-8)


def test_a_long_gap_settles_to_the_same_as_without_the_shortcut(walk, monkeypatch):
    rng = np.random.default_rng(11)
    frames = 400
    values = rng.normal(size=(frames, STATES)).cumsum(axis=0) @ walk.loadings.T
    seen = np.ones((frames, COLUMNS), dtype=bool)
    seen[50:350, :3] = False
    quick = smooth(walk, values, seen, no_progress)
    monkeypatch.setattr("mocapmend_algorithms.fill.walk_smoother.SETTLED", -1.0)
    np.testing.assert_allclose(quick, smooth(walk, values, seen, no_progress), atol=1e-8)


def test_can_be_cancelled(walk):
    def cancel(fraction):
        if fraction > 0.4:
            raise Cancelled

    frames = 300
    seen = np.ones((frames, COLUMNS), dtype=bool)
    with pytest.raises(Cancelled):
        smooth(walk, np.zeros((frames, COLUMNS)), seen, cancel)
