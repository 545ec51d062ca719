"""Short runs of samples judged by the samples on both sides of them.

A run that does not belong to a trajectory can be left out, and what remains is smooth. So a cubic
is fitted to a few samples on both sides: how far the run is from it, against how badly it fits
those, tells a jump from fast motion, whose corners no cubic fits. This is the innovation gate of a
tracking filter made two-sided.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray

SIDE = 4
"""Samples on either side that are looked at."""
DEGREE = 3


class Fits(NamedTuple):
    """How some blocks compare with the samples beside them; one entry per block.

    Attributes
    ----------
    away : ndarray, shape (blocks,)
        Root mean square distance of the block's samples from the fit.
    least, first, last : ndarray, shape (blocks,)
        The smallest of these distances, and those of the first and the last sample.
    misfit : ndarray, shape (blocks,)
        Standard error of the fit on the samples beside the block; infinite where they are too few.
    """

    away: FloatArray
    least: FloatArray
    first: FloatArray
    last: FloatArray
    misfit: FloatArray


def fit_blocks(points: FloatArray, start: IntArray, length: int) -> Fits:
    """Compare blocks of one length with cubics through the samples beside them.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        One trajectory, NaN = missing.
    start : ndarray of int, shape (blocks,)
        First frames; a block with a missing sample compares as NaN.
    length : int
        Frames of each block.

    Returns
    -------
    Fits
        A block needs at least two samples on either side and six in all.
    """
    inside, power_inside, beside, power_beside = _windows(length)
    outer = _take(points, start[:, None] + beside)
    seen = ~np.isnan(outer[:, :, 0])
    left, right = seen[:, :SIDE].sum(axis=1), seen[:, SIDE:].sum(axis=1)
    usable = (left >= 2) & (right >= 2) & (left + right >= DEGREE + 3)
    coefficients, misfit = _least_squares(power_beside, outer, seen, usable)
    inner = _take(points, start[:, None] + inside)
    apart = inner - power_inside @ coefficients
    square = np.einsum("nkc,nkc->nk", apart, apart)
    return Fits(
        np.sqrt(square.mean(axis=1)),
        np.sqrt(square.min(axis=1)),
        np.sqrt(square[:, 0]),
        np.sqrt(square[:, -1]),
        np.where(usable, misfit, np.inf),
    )


def usual_away(points: FloatArray, start: IntArray, length: int) -> FloatArray:
    """Return how far blocks around some blocks are from where the samples beside them lead.

    Parameters
    ----------
    points : ndarray, shape (frames, 3)
        One trajectory, NaN = missing.
    start : ndarray of int, shape (blocks,)
        First frames.
    length : int
        Frames of each block.

    Returns
    -------
    ndarray, shape (blocks,)
        Median of up to 16 blocks that have nothing to do with it; 0 where there are none.
    """
    clear = length + SIDE
    steps = clear + np.arange(8) * max(1, clear // 4)
    around = start[:, None] + np.concatenate((-steps[::-1], steps))
    around = np.clip(around, 0, max(0, len(points) - length))
    around[np.abs(around - start[:, None]) < clear] = 0
    fits = fit_blocks(points, around.ravel(), length)
    away = np.where(np.isfinite(fits.misfit), fits.away, np.nan).reshape(around.shape)
    away[np.abs(around - start[:, None]) < clear] = np.nan
    away.sort(axis=1)  # NaN last
    count = np.count_nonzero(~np.isnan(away), axis=1)
    middle: FloatArray = away[np.arange(len(start)), np.maximum(count - 1, 0) // 2]
    return np.nan_to_num(middle)


def block_offsets(points: FloatArray, start: int, length: int) -> FloatArray:
    """Return how far the samples of one block are from the fit, shape (length, 3)."""
    inside, power_inside, beside, power_beside = _windows(length)
    outer = _take(points, np.array([start])[:, None] + beside)
    seen = ~np.isnan(outer[:, :, 0])
    usable = np.array([min(seen[0, :SIDE].sum(), seen[0, SIDE:].sum()) >= 2])
    usable &= seen.sum() >= DEGREE + 3
    if not usable[0]:
        return np.full((length, 3), np.nan)
    coefficients, _ = _least_squares(power_beside, outer, seen, usable)
    offsets: FloatArray = _take(points, start + inside) - power_inside @ coefficients[0]
    return offsets


@lru_cache(maxsize=64)
def _windows(length: int) -> tuple[IntArray, FloatArray, IntArray, FloatArray]:
    """Return the frames inside and beside a block, counted from its first, and their powers."""
    inside: IntArray = np.arange(length, dtype=np.int64)
    beside: IntArray = np.concatenate((np.arange(-SIDE, 0), np.arange(length, length + SIDE)))
    middle, scale = (length - 1) / 2, length / 2 + SIDE
    degrees = np.arange(DEGREE + 1)
    return (
        inside,
        np.power((inside[:, None] - middle) / scale, degrees),
        beside,
        np.power((beside[:, None] - middle) / scale, degrees),
    )


def _take(points: FloatArray, frames: IntArray) -> FloatArray:
    """Return samples at frames, NaN outside of the recording."""
    outside = (frames < 0) | (frames >= len(points))
    taken = points[np.clip(frames, 0, len(points) - 1)]
    taken[outside] = np.nan
    return taken


def _least_squares(
    powers: FloatArray, samples: FloatArray, seen: BoolArray, usable: BoolArray
) -> tuple[FloatArray, FloatArray]:
    """Fit a cubic to the samples that are seen; return coefficients and standard error."""
    weight = seen.astype(np.float64)
    # A trifle of ridge keeps those solvable that are not usable.
    ridge = np.where(usable, 1e-12, 1.0)[:, None, None] * np.eye(powers.shape[1])
    products = powers[:, :, None] * powers[:, None, :]
    gram = np.tensordot(weight, products, axes=1) + ridge
    values = np.where(seen[:, :, None], samples, 0.0)
    # Far from the origin, nothing of the precision is lost.
    centre = values.sum(axis=1) / np.maximum(weight.sum(axis=1), 1.0)[:, None]
    values = np.where(seen[:, :, None], values - centre[:, None], 0.0)
    coefficients = np.linalg.solve(gram, np.einsum("pi,npc->nic", powers, values))
    left = (values - powers @ coefficients) * weight[:, :, None]
    freedom = np.maximum(weight.sum(axis=1) - powers.shape[1], 1.0)
    misfit = np.sqrt(np.einsum("npc,npc->n", left, left) / freedom)
    coefficients[:, 0] += centre
    return coefficients, misfit
