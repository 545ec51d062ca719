"""What the report measures: tracking success, bone lengths, errors, smoothness."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.recording import Recording

TOLERANCE_MM = 10.0
SOME_BONES = 8
CHUNK = 256
"""Frames measured at a time: what fits into the processor's cache is several times as fast."""


def tracked(
    recording: Recording | FloatArray,
    *,
    bad: BoolArray | None = None,
    reference: Recording | FloatArray | None = None,
    tolerance: float | None = None,
) -> BoolArray:
    """Say which samples count as tracked.

    A marker is tracked in a frame when it is present, is not flagged bad and, where a reference
    is present too, lies within a tolerance of it.

    Parameters
    ----------
    recording : Recording or ndarray, shape (frames, markers, 3)
        What to judge; NaN = missing.
    bad : ndarray of bool, shape (frames, markers), optional
        Samples flagged bad.
    reference : Recording or ndarray, shape (frames, markers, 3), optional
        The true coordinates in the same unit; where it is missing, presence is enough.
    tolerance : float, optional
        In the unit of the coordinates; 10 mm by default, but needed for bare arrays with a
        reference, whose unit is not known.

    Returns
    -------
    ndarray of bool, shape (frames, markers)

    Raises
    ------
    ValueError
        If a tolerance is needed and not given.
    """
    points = _points(recording)
    good = ~np.isnan(points[:, :, 0])
    if bad is not None:
        good &= ~bad
    if reference is not None:
        if tolerance is None:
            if not isinstance(recording, Recording):
                raise ValueError("bare coordinates have no unit: give the tolerance")
            tolerance = TOLERANCE_MM / recording.mm
        good &= ~(np.linalg.norm(points - _points(reference), axis=2) > tolerance)
    return good


@dataclass(frozen=True, eq=False)
class SuccessCurves:
    """Tracking success over time, each from 0 to 1.

    Attributes
    ----------
    instantaneous : ndarray, shape (frames,)
        Share of the markers (or segments) tracked in each frame.
    running_mean : ndarray, shape (frames,)
        Mean of the share up to each frame.
    survival : ndarray, shape (frames,)
        Share that was tracked in every frame so far.
    """

    instantaneous: FloatArray
    running_mean: FloatArray
    survival: FloatArray


def success_curves(
    tracked: BoolArray,
    *,
    counted: BoolArray | None = None,
    segments: Sequence[Sequence[int]] | None = None,
) -> SuccessCurves:
    """Draw the three curves of tracking success (as L21's figures 5 to 7).

    Parameters
    ----------
    tracked : ndarray of bool, shape (frames, markers)
        See `tracked`.
    counted : ndarray of bool, shape (markers,), optional
        The markers that count; by default those tracked in at least one frame, as files list
        points that were never on the body. To compare two versions of a recording, give both the
        same.
    segments : sequence of sequence of int, optional
        Groups of markers: a segment is tracked when all its counted markers are, and does not
        count where it has none. L21's curves fall below what two lost markers of 37 can explain,
        so they must count segments.

    Returns
    -------
    SuccessCurves
        NaN throughout where nothing counts.
    """
    counts = np.logical_or.reduce(tracked) if counted is None else counted
    if segments is None:
        units = tracked[:, counts]
    else:
        groups = [[m for m in segment if counts[m]] for segment in segments]
        columns = [tracked[:, group].all(axis=1) for group in groups if group]
        units = np.stack(columns, axis=1) if columns else tracked[:, :0]
    frames = units.shape[0]
    if not units.shape[1]:
        nothing = np.full(frames, np.nan)
        return SuccessCurves(nothing, nothing, nothing)
    share = units.mean(axis=1)
    survivors = np.logical_and.accumulate(units, axis=0).mean(axis=1)
    return SuccessCurves(share, np.cumsum(share) / np.arange(1, frames + 1), survivors)


def bone_lengths(points: FloatArray, bones: IntArray) -> FloatArray:
    """Measure bones over time.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates, NaN = missing.
    bones : ndarray of int, shape (bones, 2)
        Markers at the two ends.

    Returns
    -------
    ndarray, shape (frames, bones)
        NaN where an end is missing.
    """
    ends = np.asarray(bones, dtype=np.int64).reshape(-1, 2)
    lengths = np.empty((len(points), len(ends)))
    for start in range(0, len(points), CHUNK):
        some = points[start : start + CHUNK]
        along = np.take(some, ends[:, 0], axis=1) - np.take(some, ends[:, 1], axis=1)
        lengths[start : start + CHUNK] = np.sqrt(np.einsum("tbk,tbk->tb", along, along))
    return lengths


def bone_spread(lengths: FloatArray) -> FloatArray:
    """Say how constant the bones are.

    Parameters
    ----------
    lengths : ndarray, shape (frames, bones)
        See `bone_lengths`.

    Returns
    -------
    ndarray, shape (bones,)
        Coefficient of variation in %; NaN for a bone seen in fewer than two frames or of length 0.
    """
    found = np.empty(lengths.shape[1])
    # A few at a time: of all at once there would be three copies of the lengths.
    for start in range(0, lengths.shape[1], SOME_BONES):
        found[start : start + SOME_BONES] = _spread(lengths[:, start : start + SOME_BONES])
    return found


def _spread(lengths: FloatArray) -> FloatArray:
    seen = ~np.isnan(lengths)
    count = seen.sum(axis=0)
    safe = np.maximum(count, 1)
    mean = np.where(seen, lengths, 0.0).sum(axis=0) / safe
    variance = np.where(seen, lengths - mean, 0.0) ** 2
    spread = np.sqrt(variance.sum(axis=0) / safe)
    known = (count >= 2) & (mean > 0)
    return np.where(known, 100 * spread / np.where(known, mean, 1.0), np.nan)


@dataclass(frozen=True)
class ErrorSummary:
    """3-D errors over a set of samples, in the unit of the coordinates.

    Attributes
    ----------
    samples : int
        How many samples were judged.
    left_open : int
        How many more should have been, but are missing; they count in no error.
    rmse, mean, median, p95 : float
        Root mean square, mean, median and 95th percentile of the distances; NaN without samples.
    """

    samples: int
    left_open: int
    rmse: float
    mean: float
    median: float
    p95: float


def error_summary(points: FloatArray, reference: FloatArray, mask: BoolArray) -> ErrorSummary:
    """Compare coordinates with the truth.

    Parameters
    ----------
    points, reference : ndarray, shape (frames, markers, 3)
        What to judge and the truth, NaN = missing.
    mask : ndarray of bool, shape (frames, markers)
        The samples to judge.

    Returns
    -------
    ErrorSummary
    """
    error = np.linalg.norm(points[mask] - reference[mask], axis=1)
    left_open = int(np.isnan(points[mask][:, 0]).sum())
    error = error[~np.isnan(error)]
    if not error.size:
        return ErrorSummary(0, left_open, np.nan, np.nan, np.nan, np.nan)
    return ErrorSummary(
        error.size,
        left_open,
        float(np.sqrt(np.mean(error**2))),
        float(np.mean(error)),
        float(np.median(error)),
        float(np.quantile(error, 0.95)),
    )


def smoothness(points: FloatArray) -> float:
    """Return the mean squared second difference, as Y23's Ls; less is smoother.

    Y23 = Yang, Li, Liu: refinement of Kinect motion by stacked recurrent autoencoders.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Coordinates, NaN = missing.

    Returns
    -------
    float
        Length unit^2 per sample; NaN where no marker is seen in three frames running.
    """
    square = np.sum(np.diff(points, n=2, axis=0) ** 2, axis=2)
    square = square[~np.isnan(square)]
    return float(square.mean()) if square.size else float("nan")


def _points(recording: Recording | FloatArray) -> FloatArray:
    return recording.points if isinstance(recording, Recording) else recording
