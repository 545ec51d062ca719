"""Interpolation of one marker across a gap: what most programs do by default.

Good below about 0.2 s, poor above. Gaps at the beginning and the end of a recording stay open, or
hold the nearest sample.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.window import (
    Edges,
    WindowMethod,
    edges_option,
    fill_windows,
)
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

SPLINE_REACH = 12
"""Samples per side of a cubic spline: each further one counts 2 - sqrt(3) = 0.27 times the last,
so a spline through the whole recording differs by less than 1e-6."""


@dataclass(frozen=True)
class ConstantParams:
    """Parameters of `constant`."""

    hold: Literal["before", "after", "nearest"] = option(
        "before",
        label="Hold the value",
        text="Which value to hold: that before the gap, that after it, or the nearer one.",
    )
    edges: Edges = edges_option()


@dataclass(frozen=True)
class LinearParams:
    """Parameters of `linear`."""

    edges: Edges = edges_option()


@dataclass(frozen=True)
class CubicParams:
    """Parameters of `cubic`."""

    edges: Edges = edges_option()


@dataclass(frozen=True)
class PchipParams:
    """Parameters of `pchip`."""

    edges: Edges = edges_option()


def constant(
    recording: Recording, gaps: Sequence[Gap], params: ConstantParams, progress: Progress, /
) -> FillResult:
    """Hold the sample before or after the gap; it does not meet the other edge."""
    solve = partial(_constant, hold=params.hold)
    method = WindowMethod.single(solve, "a constant", params.edges)
    return fill_windows(recording, gaps, method, progress)


def linear(
    recording: Recording, gaps: Sequence[Gap], params: LinearParams, progress: Progress, /
) -> FillResult:
    """Draw a straight line between the samples at the edges of the gap."""
    method = WindowMethod.single(_linear, "a straight line", params.edges)
    return fill_windows(recording, gaps, method, progress)


def cubic(
    recording: Recording, gaps: Sequence[Gap], params: CubicParams, progress: Progress, /
) -> FillResult:
    """Draw a cubic spline (not-a-knot) through the samples on both sides of the gap."""
    return fill_windows(recording, gaps, cubic_windows(params.edges), progress)


def cubic_windows(edges: Edges) -> WindowMethod:
    """Return what the windows of `cubic` look like."""
    return WindowMethod.single(_cubic, "a cubic curve", edges, reach=SPLINE_REACH, least=4)


def pchip(
    recording: Recording, gaps: Sequence[Gap], params: PchipParams, progress: Progress, /
) -> FillResult:
    """Draw a piecewise cubic Hermite curve that keeps the samples' order (Fritsch-Carlson)."""
    method = WindowMethod.single(_pchip, "a curve", params.edges)
    return fill_windows(recording, gaps, method, progress)


def _constant(knots: IntArray, values: FloatArray, length: int, *, hold: str) -> FloatArray:
    after = int(np.searchsorted(knots, 0))
    at = np.arange(length)
    late = at - knots[after - 1] > knots[after] - at
    late = {"before": np.zeros_like(late), "after": np.ones_like(late), "nearest": late}[hold]
    return values[np.where(late, after, after - 1)]


def _linear(knots: IntArray, values: FloatArray, length: int) -> FloatArray:
    after = int(np.searchsorted(knots, 0))
    share = (np.arange(length) - knots[after - 1]) / (knots[after] - knots[after - 1])
    change: FloatArray = values[after] - values[after - 1]
    filled: FloatArray = values[after - 1] + share[:, None] * change
    return filled


def _cubic(knots: IntArray, values: FloatArray, length: int) -> FloatArray:
    from scipy.interpolate import CubicSpline

    filled: FloatArray = CubicSpline(knots, values)(np.arange(length))
    return filled


def _pchip(knots: IntArray, values: FloatArray, length: int) -> FloatArray:
    from scipy.interpolate import PchipInterpolator

    filled: FloatArray = PchipInterpolator(knots, values)(np.arange(length))
    return filled
