"""Kalman filter and Rauch-Tung-Striebel smoother of a random walk that is seen in part.

The state wanders, x_t = x_(t-1) + w, w ~ N(0, Q), and a frame shows some rows of y_t = V x_t + v,
v ~ N(0, r I). Where the same rows are missing for long, the gains settle within some frames and
are then used again, so a long gap costs no more matrix work than a short one.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.progress import Progress

SETTLED = 1e-11
"""Relative change of the covariance from frame to frame below which it counts as constant."""
PROGRESS_EVERY = 64


@dataclass(frozen=True, eq=False)
class Walk:
    """The model.

    Attributes
    ----------
    loadings : ndarray, shape (columns, states)
        V: orthonormal columns.
    process : ndarray, shape (states, states)
        Q, per frame; positive definite.
    noise : float
        r, variance of a measured coordinate, positive.
    start : ndarray, shape (states, states)
        Covariance of the first state, whose mean is 0.
    """

    loadings: FloatArray
    process: FloatArray
    noise: float
    start: FloatArray


@dataclass(frozen=True, eq=False)
class _Step:
    """What a frame's filter step does, whatever the data."""

    seen: BoolArray
    predicted: FloatArray
    filtered: FloatArray
    back: FloatArray


def smooth(walk: Walk, values: FloatArray, seen: BoolArray, progress: Progress) -> FloatArray:
    """Smooth a sequence of partly seen frames.

    Parameters
    ----------
    walk : Walk
        The model.
    values : ndarray, shape (frames, columns)
        What was seen, relative to the mean; ignored where `seen` is false.
    seen : ndarray of bool, shape (frames, columns)
        Which values count.
    progress : Progress
        Called every 64 frames.

    Returns
    -------
    ndarray, shape (frames, states)
        The mean of each state, given all that was seen.
    """
    frames = values.shape[0]
    states = np.empty((frames, walk.process.shape[0]))
    back: list[FloatArray] = []
    mean, step = np.zeros(walk.process.shape[0]), None
    for frame in range(frames):
        if frame % PROGRESS_EVERY == 0:
            progress(frame / frames)
        step = _step(walk, seen[frame], step)
        rows = walk.loadings[seen[frame]]
        surprise = values[frame, seen[frame]] - rows @ mean
        mean = mean + step.filtered @ (rows.T @ surprise) / walk.noise
        states[frame] = mean
        back.append(step.back)
    for frame in range(frames - 2, -1, -1):
        states[frame] += back[frame] @ (states[frame + 1] - states[frame])
    progress(1.0)
    return states


def _step(walk: Walk, seen: BoolArray, last: _Step | None) -> _Step:
    predicted = walk.start if last is None else last.filtered + walk.process
    if last is not None and np.array_equal(seen, last.seen):
        change = np.abs(predicted - last.predicted).max()
        if change <= SETTLED * np.abs(predicted).max():
            return last
    rows = walk.loadings[seen]
    information = rows.T @ rows / walk.noise
    # (P^-1 + V^T V / r)^-1, without the inverse of P, which may be singular.
    identity = np.eye(predicted.shape[0])
    filtered = np.linalg.solve(identity + predicted @ information, predicted)
    filtered = (filtered + filtered.T) / 2
    back = np.linalg.solve(filtered + walk.process, filtered).T
    return _Step(seen, predicted, filtered, np.asarray(back, dtype=np.float64))
