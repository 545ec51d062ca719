"""Gaussian-process regression of one marker's place on the pose of its donors and on time.

Rasmussen and Williams 2006, Gaussian Processes for Machine Learning, eqs. 2.25 and 2.26 (the
posterior) and 5.12 (what is predicted for a sample that is left out, from the inverse of the
whole; the same algebra holds for blocks of samples). A kernel's numbers are relative to each
other: the scale of what is regressed does not matter.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import linalg
from scipy.spatial.distance import cdist

from mocapmend_algorithms.arrays import FloatArray, IntArray

MOST_SPREAD = 32
"""Inputs at which the posterior's standard deviation is computed; between them, a line."""
MOST_ASKED = 2000
"""Inputs that are worked on at a time: their covariances with the samples are held in memory."""


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
class Inputs:
    """Where samples are, or where values are wanted.

    Attributes
    ----------
    poses : ndarray, shape (inputs, features)
    times : ndarray, shape (inputs,)
        In seconds.
    """

    poses: FloatArray
    times: FloatArray

    def __getitem__(self, chosen: IntArray | slice) -> "Inputs":
        return Inputs(self.poses[chosen], self.times[chosen])

    def __len__(self) -> int:
        return int(self.times.size)


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


def regress(
    inputs: Inputs,
    values: FloatArray,
    asked: Inputs,
    blocks: Sequence[IntArray],
    kernels: Sequence[Kernel],
) -> list[Regression]:
    """Return what kernels make of the same samples.

    Parameters
    ----------
    inputs : Inputs
        Where the samples are.
    values : ndarray, shape (inputs, 3)
        The samples.
    asked : Inputs
        Where values are wanted, ascending in time.
    blocks : sequence of ndarray of int
        Indices of samples that are left out together.
    kernels : sequence of Kernel
        All need a positive noise.

    Returns
    -------
    list of Regression
        One per kernel.
    """
    count = len(inputs)
    tested = np.unique(np.concatenate(blocks)) if blocks else np.zeros(0, dtype=np.int64)
    # Those that are left out come last: their part of the inverse is that of a corner alone.
    order = np.concatenate((np.delete(np.arange(count), tested), tested))
    place = np.empty(count, dtype=np.int64)
    place[order] = np.arange(count)
    inputs = inputs[order]
    mean: FloatArray = values.mean(axis=0)
    scales = _scales(inputs)
    among = _Pairs(inputs, inputs, scales)
    fits = [_Fit(kernel, among, values[order] - mean) for kernel in kernels]
    corner = [place[block] - (count - tested.size) for block in blocks]
    left_out = [fit.left_out(corner, tested.size) for fit in fits]
    found: list[list[FloatArray]] = [[] for _ in kernels]
    for part in _parts(asked):
        pairs = _Pairs(part, inputs, scales)
        for fit, filled in zip(fits, found, strict=True):
            filled.append(mean + fit.predict(pairs))
    at = _few(len(asked))
    pairs = _Pairs(asked[at], inputs, scales)
    return [
        Regression(
            np.concatenate(filled) if filled else np.zeros((0, 3)),
            np.interp(np.arange(len(asked)), at, fit.spread(pairs)) if at.size else np.zeros(0),
            *left,
        )
        for fit, filled, left in zip(fits, found, left_out, strict=True)
    ]


@dataclass(frozen=True)
class _Scales:
    """Typical size of the poses: mean square, and distance of two."""

    square: float
    distance: float


def _scales(inputs: Inputs) -> _Scales:
    square = np.einsum("ij,ij->i", inputs.poses, inputs.poses)
    few = inputs.poses[:: max(1, len(inputs) // 100)]
    return _Scales(float(np.mean(square)) or 1.0, float(np.median(cdist(inputs.poses, few))) or 1.0)


class _Pairs:
    """What all kernels share of the covariance between inputs and samples."""

    def __init__(self, inputs: Inputs, samples: Inputs, scales: _Scales) -> None:
        product = inputs.poses @ samples.poses.T
        own = np.einsum("ij,ij->i", inputs.poses, inputs.poses)
        theirs = np.einsum("ij,ij->i", samples.poses, samples.poses)
        square = np.maximum(own[:, None] + theirs - 2 * product, 0.0)
        self._product = product / scales.square
        self._distance = np.sqrt(square) / scales.distance
        self._elapsed = np.abs(inputs.times[:, None] - samples.times)
        self._functions: dict[tuple[float, bool], FloatArray] = {}
        self.square = own / scales.square

    def covariance(self, kernel: Kernel) -> FloatArray:
        scaled = self._distance * np.sqrt(3 / kernel.pose)
        covariance: FloatArray = (1 + scaled) * np.exp(-scaled)
        covariance += kernel.linear * self._product
        for variance, seconds in kernel.temporal:
            covariance += variance * self._of_time(seconds, smooth=kernel.smooth)
        return covariance

    def _of_time(self, seconds: float, *, smooth: bool) -> FloatArray:
        key = seconds, smooth
        if key not in self._functions:
            scaled = self._elapsed * (np.sqrt(5 if smooth else 3) / seconds)
            polynomial = 1 + scaled + scaled**2 / 3 if smooth else 1 + scaled
            self._functions[key] = polynomial * np.exp(-scaled)
        return self._functions[key]


class _Fit:
    """The samples' covariance, factorised, and their weights."""

    def __init__(self, kernel: Kernel, among: _Pairs, values: FloatArray) -> None:
        self._kernel = kernel
        covariance = among.covariance(kernel)
        np.einsum("ii->i", covariance)[:] += kernel.noise
        self._root = linalg.cholesky(covariance, lower=True, check_finite=False)
        self._weights = linalg.cho_solve((self._root, True), values, check_finite=False)

    def predict(self, pairs: _Pairs) -> FloatArray:
        predicted: FloatArray = pairs.covariance(self._kernel) @ self._weights
        return predicted

    def spread(self, pairs: _Pairs) -> FloatArray:
        kernel = self._kernel
        covariance = pairs.covariance(kernel)
        known = linalg.solve_triangular(self._root, covariance.T, lower=True, check_finite=False)
        prior = 1 + sum(variance for variance, _ in kernel.temporal) + kernel.linear * pairs.square
        variance = prior - np.einsum("ij,ij->j", known, known)
        spread: FloatArray = np.sqrt(np.maximum(variance, 0.0) + kernel.noise)
        return spread

    def left_out(
        self, blocks: Sequence[IntArray], tested: int
    ) -> tuple[tuple[FloatArray, ...], tuple[FloatArray, ...]]:
        first = self._root.shape[0] - tested
        inverse = linalg.lapack.dpotri(self._root[first:, first:], lower=1)[0] if tested else None
        weights = self._weights[first:]
        residuals, spreads = [], []
        for block in blocks:
            assert inverse is not None
            lower = np.tril(inverse[np.ix_(block, block)])
            covariance = np.linalg.inv(lower + np.tril(lower, -1).T)
            residuals.append(covariance @ weights[block])
            spreads.append(np.sqrt(np.maximum(np.diagonal(covariance), self._kernel.noise)))
        return tuple(residuals), tuple(spreads)


def _parts(asked: Inputs) -> Iterator[Inputs]:
    for first in range(0, len(asked), MOST_ASKED):
        yield asked[first : first + MOST_ASKED]


def _few(count: int) -> IntArray:
    places = np.linspace(0, max(count - 1, 0), min(count, MOST_SPREAD))
    return np.unique(places.round().astype(np.int64))
