"""The constant-velocity filter as numbers: what a window's samples weigh inside the gap.

The state is [f, v] with f_t = f_(t-1) + v dt (L21 eqs. 2, 3) and white acceleration. The axes are
filtered alike and the covariance does not depend on the samples, so a window's fill is a fixed
matrix times its samples, shared by all axes and self-tests. Times are in frames and the process
noise is 1: the only setting is `ratio` = measurement variance / (process noise density x dt^3).
"""

from functools import lru_cache

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray

Frames = tuple[int, ...]

MIRROR = np.array([1.0, -1.0])
"""Seen backwards in time, a velocity changes its sign."""


@lru_cache(maxsize=64)
def bridge(knots: Frames, length: int, ratio: float) -> tuple[FloatArray, FloatArray]:
    """Smooth through a gap: the two-filter form of the Rauch-Tung-Striebel smoother.

    What the smoother leaves over at the two samples beside the gap is carried into it linearly.

    Parameters
    ----------
    knots : tuple of int
        Frames of the observed samples, ascending, counted from the first missing frame; at least
        one on each side.
    length : int
        Number of missing frames.
    ratio : float
        Measurement variance / (process noise density x dt^3).

    Returns
    -------
    weights : ndarray, shape (length, knots)
        The filled values are these times the observed ones.
    sigma : ndarray, shape (length,)
        Standard deviation for unit process noise.
    """
    seen, at = np.array(knots), np.arange(length)
    after = int(np.searchsorted(seen, 0))
    start, stop = seen[after - 1], seen[after]
    ends = np.concatenate(([start], at, [stop]))
    information, left = _carry(seen[:after], ends - start, ratio)
    mirrored, right = _carry(-seen[: after - 1 : -1], stop - ends, ratio)
    covariance = _inverse(information + MIRROR[:, None] * mirrored * MIRROR)
    vectors = np.concatenate((left, MIRROR[:, None] * right[:, :, ::-1]), axis=2)
    smooth = (covariance @ vectors)[:, 0]
    residual = np.eye(seen.size)[[after - 1, after]] - smooth[[0, -1]]
    share = ((at - start) / (stop - start))[:, None]
    weights = smooth[1:-1] + (1 - share) * residual[0] + share * residual[1]
    return weights, np.sqrt(covariance[1:-1, 0, 0])


@lru_cache(maxsize=64)
def prediction(
    knots: Frames, length: int, ratio: float, step: int
) -> tuple[FloatArray, FloatArray]:
    """Predict through a gap from the samples before it (L21 eqs. 3, 4).

    Parameters
    ----------
    knots : tuple of int
        Frames of the observed samples, ascending, counted from the first missing frame; at least
        two before the gap. Those after it get no weight.
    length : int
        Number of missing frames.
    ratio : float
        Measurement variance / (process noise density x dt^3).
    step : int
        Frames between the samples that the filter takes: eq. 4's constant-rate sampling, by which
        the velocity is that over a fixed interval and not that between consecutive frames.

    Returns
    -------
    weights : ndarray, shape (length, knots)
        The filled values are these times the observed ones.
    sigma : ndarray, shape (length,)
        Standard deviation for unit process noise.
    """
    seen = np.array(knots)
    before = seen[seen < 0]
    taken = constant_rate(before, step)
    states, covariance = _filter(tuple(before[taken].tolist()), ratio)
    ahead = transition(np.arange(length) - before[-1])
    weights = np.zeros((length, seen.size))
    weights[:, taken] = (ahead @ states)[:, 0]
    predicted = ahead @ covariance @ ahead.swapaxes(1, 2)
    spread = predicted + process_covariance(np.arange(length) - before[-1])
    return weights, np.sqrt(spread[:, 0, 0])


def constant_rate(frames: IntArray, step: int) -> IntArray:
    """Choose samples a fixed interval apart, counted back from the last; at least two.

    Parameters
    ----------
    frames : ndarray of int, shape (samples,)
        Ascending.
    step : int
        The interval; where a sample is missing, the last one before it is taken.

    Returns
    -------
    ndarray of int
        Indices into `frames`, ascending.
    """
    wanted = np.arange(frames[-1], frames[0] - 1, -step)
    taken = np.unique(np.searchsorted(frames, wanted, side="right") - 1)
    return taken if taken.size > 1 else np.array([0, frames.size - 1])


def transition(elapsed: IntArray) -> FloatArray:
    """Return the transition matrices [[1, dt], [0, 1]] (L21 eq. 3), shape (..., 2, 2)."""
    matrix = np.zeros((*elapsed.shape, 2, 2))
    matrix[..., 0, 0] = matrix[..., 1, 1] = 1.0
    matrix[..., 0, 1] = elapsed
    return matrix


def process_covariance(elapsed: IntArray) -> FloatArray:
    """Return what unit white acceleration adds over the elapsed frames, shape (..., 2, 2)."""
    time = elapsed.astype(np.float64)
    matrix = np.empty((*time.shape, 2, 2))
    matrix[..., 0, 0] = time**3 / 3
    matrix[..., 0, 1] = matrix[..., 1, 0] = time**2 / 2
    matrix[..., 1, 1] = time
    return matrix


@lru_cache(maxsize=1024)
def _filter(frames: Frames, ratio: float) -> tuple[FloatArray, FloatArray]:
    """Filter two or more samples: state weights (2, samples) and covariance at the last one.

    Nothing is assumed before the first sample; the state after two is exact.
    """
    elapsed = frames[1] - frames[0]
    states = np.zeros((2, len(frames)))
    states[:, :2] = [[0.0, 1.0], [-1 / elapsed, 1 / elapsed]]
    covariance = np.array(
        [[ratio, ratio / elapsed], [ratio / elapsed, 2 * ratio / elapsed**2 + elapsed / 3]]
    )
    for index in range(2, len(frames)):
        step = np.array(frames[index] - frames[index - 1])
        ahead = transition(step)
        states = ahead @ states
        covariance = ahead @ covariance @ ahead.T + process_covariance(step)
        gain = covariance[:, 0] / (covariance[0, 0] + ratio)
        states -= np.outer(gain, states[0])
        states[:, index] += gain
        covariance = covariance - np.outer(gain, covariance[0])
    return states, covariance


def _carry(frames: IntArray, elapsed: IntArray, ratio: float) -> tuple[FloatArray, FloatArray]:
    """Carry what the samples of one side say over the elapsed frames.

    Returns
    -------
    information : ndarray, shape (elapsed, 2, 2)
        Inverse covariance of the state; singular where there is one sample.
    vectors : ndarray, shape (elapsed, 2, samples)
        Information vector per unit sample.
    """
    if frames.size == 1:
        seen: FloatArray = transition(-elapsed)[:, 0, :, None]
        variance = (ratio + process_covariance(elapsed)[:, 0, 0])[:, None, None]
        vectors: FloatArray = seen / variance
        return vectors * seen.swapaxes(1, 2), vectors
    states, covariance = _filter(tuple((frames - frames[-1]).tolist()), ratio)
    ahead = transition(elapsed)
    predicted = ahead @ covariance @ ahead.swapaxes(1, 2) + process_covariance(elapsed)
    information = _inverse(predicted)
    return information, information @ (ahead @ states)


def _inverse(matrix: FloatArray) -> FloatArray:
    """Invert symmetric 2 x 2 matrices."""
    determinant = matrix[..., 0, 0] * matrix[..., 1, 1] - matrix[..., 0, 1] ** 2
    inverse = np.empty_like(matrix)
    inverse[..., 0, 0], inverse[..., 1, 1] = matrix[..., 1, 1], matrix[..., 0, 0]
    inverse[..., 0, 1] = inverse[..., 1, 0] = -matrix[..., 0, 1]
    return inverse / determinant[..., None, None]
