"""Gaussian-process regression of one marker's place on the pose of its donors and on time.

Rasmussen and Williams 2006, Gaussian Processes for Machine Learning, eqs. 2.25 and 2.26 (the
posterior) and 5.12 (what is predicted for a sample that is left out, from the inverse of the
whole; the same algebra holds for blocks of samples). A kernel's numbers are relative to each
other: the scale of what is regressed does not matter.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray

MOST_SPREAD = 16
"""Inputs at which the posterior's standard deviation is computed; between them, a line."""
MOST_ASKED = 2000
"""Inputs that are worked on at a time: their covariances with the samples are held in memory."""
LEAST_TYPICAL = 1e-3
"""Poses nearer to each other than this are the same: the rest is rounding."""
MOST_NOISE = 1e3


@dataclass(frozen=True)
class Kernel:
    """What a regression believes before it sees a sample.

    Attributes
    ----------
    linear : float
        Variance of a linear function of the pose.
    pose : float
        Squared length scale of a Matern-3/2 function of the pose with unit variance, relative to
        the typical squared distance of two poses.
    temporal : tuple of (float, float)
        Variance and time scale (s) of functions of time alone.
    noise : float
        Variance of a sample that nothing explains.
    smooth : bool
        Whether the functions of time are Matern-5/2, with a continuous acceleration, instead of
        Matern-3/2.
    """

    linear: float
    pose: float
    temporal: tuple[tuple[float, float], ...]
    noise: float
    smooth: bool = False


@dataclass(frozen=True, eq=False)
class Regression:
    """What a kernel makes of the samples.

    Attributes
    ----------
    values : ndarray, shape (asked, 3)
        Posterior mean where it was asked for.
    spread : ndarray, shape (asked,)
        Posterior standard deviation of a sample there, relative to a unit variance of the pose's
        function.
    left_out : tuple of ndarray, shape (block, 3)
        Per block, the samples minus what is predicted for them without the block.
    left_out_spread : tuple of ndarray, shape (block,)
        `spread` of these.
    """

    values: FloatArray
    spread: FloatArray
    left_out: tuple[FloatArray, ...]
    left_out_spread: tuple[FloatArray, ...]


class Times:
    """When samples were taken and when values are wanted, which all regressions of a gap share.

    Parameters
    ----------
    frames : ndarray of int, shape (samples,)
        Of the samples.
    asked : ndarray of int, shape (asked,)
        Where values are wanted, ascending.
    rate : float
        Frames per second (Hz).
    blocks : sequence of ndarray of int
        Indices of samples that are left out together.
    """

    def __init__(
        self, frames: IntArray, asked: IntArray, rate: float, blocks: Sequence[IntArray]
    ) -> None:
        count = frames.size
        tested = np.unique(np.concatenate(blocks)) if blocks else np.zeros(0, dtype=np.int64)
        # Those that are left out come last: their part of the inverse is that of a corner alone.
        self.order = np.concatenate((np.delete(np.arange(count), tested), tested))
        place = np.empty(count, dtype=np.int64)
        place[self.order] = np.arange(count)
        self.tested = int(tested.size)
        self.blocks = [place[block] - (count - self.tested) for block in blocks]
        self.parts = [
            np.arange(first, min(first + MOST_ASKED, asked.size))
            for first in range(0, asked.size, MOST_ASKED)
        ]
        few = np.linspace(0, max(asked.size - 1, 0), min(asked.size, MOST_SPREAD))
        self.few = np.unique(few.round().astype(np.int64))
        self._frames = frames[self.order]
        self._asked = asked
        self._rate = rate
        self._known: dict[tuple[Kernel, int], FloatArray] = {}
        self._apart: dict[int, IntArray] = {}
        both = np.concatenate((frames, asked))
        self._longest = int(both.max() - both.min())

    def among(self, kernel: Kernel) -> FloatArray:
        """Return the temporal covariance of the samples."""
        return self._covariance(kernel, -1, self._frames)

    def with_part(self, kernel: Kernel, part: int) -> FloatArray:
        """Return the temporal covariance of a part of the asked frames with the samples."""
        return self._covariance(kernel, part, self._asked[self.parts[part]])

    def few_of(self, part: int) -> IntArray:
        """Return the places within a part at which the spread is computed."""
        first, last = self.parts[part][[0, -1]]
        few: IntArray = self.few[(self.few >= first) & (self.few <= last)] - first
        return few

    def _covariance(self, kernel: Kernel, which: int, frames: IntArray) -> FloatArray:
        key = kernel, which
        if key in self._known:
            return self._known[key]
        table = of_time(kernel, np.arange(self._longest + 1) / self._rate)
        covariance: FloatArray = table[self._distances(which, frames)]
        if len(self.parts) <= 1:
            self._known[key] = covariance
        return covariance

    def _distances(self, which: int, frames: IntArray) -> IntArray:
        if which in self._apart:
            return self._apart[which]
        apart = frames[:, None] - self._frames
        np.abs(apart, out=apart)
        if len(self.parts) <= 1:
            self._apart[which] = apart
        return apart


def regress(
    times: Times,
    poses: FloatArray,
    values: FloatArray,
    asked: FloatArray,
    kernels: Sequence[Kernel],
) -> list[Regression]:
    """Return what kernels make of the same samples.

    Parameters
    ----------
    times : Times
        When they were taken.
    poses : ndarray, shape (samples, features)
        The pose at each.
    values : ndarray, shape (samples, 3)
        The samples.
    asked : ndarray, shape (asked, features)
        The pose where values are wanted.
    kernels : sequence of Kernel
        All need a positive noise.

    Returns
    -------
    list of Regression
        One per kernel.
    """
    poses = poses[times.order]
    mean: FloatArray = values.mean(axis=0)
    among = _Pairs(poses, poses)
    fits = [_Fit(kernel, times, among, values[times.order] - mean) for kernel in kernels]
    filled: list[list[FloatArray]] = [[np.zeros((0, 3))] for _ in kernels]
    spread: list[list[FloatArray]] = [[np.zeros(0)] for _ in kernels]
    for part, places in enumerate(times.parts):
        pairs = _Pairs(asked[places], poses, among)
        few = times.few_of(part)
        for kernel, fit, means, spreads in zip(kernels, fits, filled, spread, strict=True):
            covariance = pairs.covariance(kernel, times.with_part(kernel, part))
            means.append(mean + fit.predict(covariance))
            spreads.append(fit.spread(covariance[few], pairs.square[few] / pairs.scale))
    return [
        Regression(
            np.concatenate(means),
            _between(np.concatenate(spreads), times.few, asked.shape[0]),
            *fit.left_out(times),
        )
        for fit, means, spreads in zip(fits, filled, spread, strict=True)
    ]


class _Pairs:
    """Products and distances of poses with those of the samples, and what is typical of them."""

    def __init__(
        self, poses: FloatArray, samples: FloatArray, among: "_Pairs | None" = None
    ) -> None:
        product: FloatArray = poses @ samples.T
        square: FloatArray = np.einsum("ij,ij->i", poses, poses)
        distance: FloatArray = -2 * product
        distance += square[:, None]
        distance += square if among is None else among.square
        np.maximum(distance, 0.0, out=distance)
        np.sqrt(distance, out=distance)
        self.square: FloatArray = square
        self.product: FloatArray = product
        self.distance: FloatArray = distance
        self.scale: float = _size(square) if among is None else among.scale
        self.typical: float = _typical(distance) if among is None else among.typical

    def covariance(self, kernel: Kernel, of_time: FloatArray) -> FloatArray:
        # In place: these are the largest arrays, and fresh memory costs as much as the numbers.
        scaled = self.distance * (-np.sqrt(3 / kernel.pose) / self.typical)
        covariance: FloatArray = np.exp(scaled)
        np.subtract(1.0, scaled, out=scaled)
        covariance *= scaled
        np.multiply(self.product, kernel.linear / self.scale, out=scaled)
        covariance += scaled
        covariance += of_time
        return covariance


class _Fit:
    """The samples' covariance, factorised, and their weights."""

    def __init__(self, kernel: Kernel, times: Times, among: _Pairs, values: FloatArray) -> None:
        self._kernel = kernel
        self._root = self._factorise(kernel.noise, among, times.among(kernel))
        self._weights = _solve(self._root, values)

    def _factorise(self, noise: float, among: _Pairs, of_time: FloatArray) -> FloatArray:
        covariance = among.covariance(self._kernel, of_time)
        np.einsum("ii->i", covariance)[:] += noise
        try:
            # Its transpose is the same and in the order of columns, which spares a copy.
            return _root(covariance.T)
        except np.linalg.LinAlgError:
            # Poses that are alike beside one far away: their distances are little but rounding.
            if noise > MOST_NOISE:
                raise
            return self._factorise(10 * noise, among, of_time)

    def predict(self, covariance: FloatArray) -> FloatArray:
        """Return the posterior mean, from the covariance with the samples."""
        predicted: FloatArray = covariance @ self._weights
        return predicted

    def spread(self, covariance: FloatArray, square: FloatArray) -> FloatArray:
        """Return the posterior standard deviation, from that and the sizes of the poses."""
        from scipy.linalg.lapack import dtrtrs

        kernel = self._kernel
        known = dtrtrs(self._root, covariance.T, lower=1)[0]
        prior = 1 + sum(variance for variance, _ in kernel.temporal) + kernel.linear * square
        variance = prior - np.einsum("ij,ij->j", known, known)
        spread: FloatArray = np.sqrt(np.maximum(variance, 0.0) + kernel.noise)
        return spread

    def left_out(self, times: Times) -> tuple[tuple[FloatArray, ...], tuple[FloatArray, ...]]:
        """Return what is left over of each block without it, and how unsure that is."""
        if not times.blocks:
            return (), ()
        first = self._root.shape[0] - times.tested
        factor = _inverse_factor(self._root[first:, first:])
        weights = self._weights[first:]
        residuals, spreads = [], []
        for block in times.blocks:
            # The indices of a block ascend, and above them there are only zeros.
            columns = factor[block[0] :, block]
            root = _root(columns.T @ columns)
            residuals.append(_solve(root, weights[block]))
            own = _inverse_factor(root)
            variance = np.einsum("ij,ij->j", own, own)
            spreads.append(np.sqrt(np.maximum(variance, self._kernel.noise)))
        return tuple(residuals), tuple(spreads)


# Straight from LAPACK: there are hundreds of small systems per gap, and all that scipy.linalg does
# around each takes longer than solving it.


def _root(matrix: FloatArray) -> FloatArray:
    """Return the Cholesky factor, lower, of a matrix that may be overwritten."""
    from scipy.linalg.lapack import dpotrf

    root, failed = dpotrf(matrix, lower=1, clean=1, overwrite_a=1)
    if failed:
        raise np.linalg.LinAlgError("not positive definite")
    factor: FloatArray = root
    return factor


def _solve(root: FloatArray, values: FloatArray) -> FloatArray:
    """Solve the equations of the matrix of which this is the Cholesky factor."""
    from scipy.linalg.lapack import dpotrs

    solution: FloatArray = dpotrs(root, values, lower=1)[0]
    return solution


def _inverse_factor(root: FloatArray) -> FloatArray:
    """Return the inverse of a Cholesky factor: its columns' products are the matrix's inverse."""
    from scipy.linalg.lapack import dtrtri

    factor: FloatArray = dtrtri(root, lower=1)[0]
    return factor


def of_time(kernel: Kernel, seconds: FloatArray) -> FloatArray:
    """Return the covariance of the functions of time at two moments that far apart."""
    total = np.zeros_like(seconds)
    for variance, scale in kernel.temporal:
        scaled = seconds * (np.sqrt(5 if kernel.smooth else 3) / scale)
        polynomial = 1 + scaled + scaled**2 / 3 if kernel.smooth else 1 + scaled
        total += variance * polynomial * np.exp(-scaled)
    return total


def _size(square: FloatArray) -> float:
    return max(float(np.mean(square)), LEAST_TYPICAL**2)


def _typical(distance: FloatArray) -> float:
    step = max(1, distance.shape[0] // 100)
    return max(float(np.median(distance[::step, ::3])), LEAST_TYPICAL)


def _between(values: FloatArray, places: IntArray, count: int) -> FloatArray:
    if not count:
        return np.zeros(0)
    filled: FloatArray = np.interp(np.arange(count), places, values)
    return filled
