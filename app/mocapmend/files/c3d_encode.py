"""Repaired samples as the bytes that a C3D file stores for them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_numbers import encode_floats, encode_integers
from mocapmend.files.c3d_reader import C3DFile
from mocapmend.files.c3d_samples import Words

NOT_ZERO = 1e-6
"""Length that is written for a coordinate of a sample at exactly (0, 0, 0)."""


@dataclass(frozen=True, eq=False)
class SampleRun:
    """Samples to be written.

    Attributes
    ----------
    marker : int
        The marker of the recording.
    start : int
        The first frame, from 0.
    values : ndarray, shape (n, 3), float64
        Coordinates in the recording's unit, a row of NaN to make a sample missing.
    fourth : ndarray, shape (n,), float32, optional
        What is stored beside them. By default 0 (computed, seen by no camera), and -1 where the
        sample is missing.
    origin : int, optional
        The marker that has these samples in the file: all of their bytes are copied from there.
    """

    marker: int
    start: int
    values: NDArray[np.float64]
    fourth: NDArray[np.float32] | None = None
    origin: int | None = None


@dataclass(frozen=True, eq=False)
class Slots:
    """Places in a file and what belongs there, ordered by frame, each place once.

    Attributes
    ----------
    frames : ndarray of int, shape (n,)
        Frames from 0.
    points : ndarray of int, shape (n,)
        Stored points.
    raw : ndarray of uint8, shape (n, layout.slot)
        The bytes.
    values : ndarray, shape (n, 3), float64
        The coordinates that they stand for, NaN for a missing sample.
    fourth : ndarray, shape (n,), float32
        The fourth words.
    origins : ndarray of int, shape (n,)
        The stored points whose bytes in the file belong there instead of `raw`; else -1.
    notes : tuple of str
        What was not written exactly as it was given.
    """

    frames: NDArray[np.int64]
    points: NDArray[np.int64]
    raw: NDArray[np.uint8]
    values: NDArray[np.float64]
    fourth: NDArray[np.float32]
    origins: NDArray[np.int64]
    notes: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.frames)

    def within(self, first: int, count: int) -> slice:
        """Return which slots lie in `count` frames from `first`."""
        start, stop = np.searchsorted(self.frames, [first, first + count])
        return slice(int(start), int(stop))


def fits(source: C3DFile, runs: Sequence[SampleRun]) -> bool:
    """Say whether the integers of a file, if it has them, can hold all values."""
    layout = source.layout
    if layout.is_float:
        return True
    limit = 32767.5 * layout.scale
    return all(np.nanmax(np.abs(run.values), initial=0.0) < limit for run in runs)


def encode_runs(source: C3DFile, runs: Sequence[SampleRun], layout: Layout | None = None) -> Slots:
    """Encode runs for a copy of the file that they repair; where they overlap, the last one counts.

    Parameters
    ----------
    source : C3DFile
        The file.
    runs : sequence of SampleRun
        What to write.
    layout : Layout, optional
        Of the copy, where it is not that of the file.

    A missing sample gets coordinates 0 and the fourth word -1, which every reader understands.

    Raises
    ------
    MocapmendError
        If a value does not fit into the number format of the file.
    ValueError
        If a run lies outside the recording or its values are not samples.
    """
    layout = layout or source.layout
    frames, markers, values, given, origins = _flatten(source, runs)
    # The last one stands for no marker.
    stored = np.array([*source.marker_points, -1], np.int64)
    missing = np.isnan(values[:, 0])
    present = np.where(missing[:, None], 0.0, values)
    limit = layout.processor.largest if layout.is_float else 32767.5 * layout.scale
    too_large = np.flatnonzero((np.abs(present) >= limit).any(axis=1))
    if len(too_large):
        at = too_large[0]
        raise _does_not_fit(source, int(markers[at]), int(frames[at]), present[at], limit)
    words, zeros, moved = _words(present, ~missing & (origins < 0), layout)
    fourth = np.where(np.isnan(given), np.where(missing, -1, 0), given).astype(np.float32)
    words[:, 3] = fourth
    values[zeros] = moved
    raw = (encode_floats if layout.is_float else encode_integers)(words, layout.processor)
    notes = []
    if zeros.any():
        notes.append(
            f"{int(zeros.sum())} samples at (0, 0, 0), which means missing in a C3D file, were "
            f"moved by {np.abs(moved).max():.3g} {source.recording.unit}."
        )
    return Slots(
        frames,
        stored[markers],
        raw.reshape(-1, layout.slot),
        values,
        fourth,
        stored[origins],
        tuple(notes),
    )


class _Samples(NamedTuple):
    """All samples, ordered and each one once; NaN for a fourth word, and -1 for no origin."""

    frames: NDArray[np.int64]
    markers: NDArray[np.int64]
    values: NDArray[np.float64]
    fourth: NDArray[np.float64]
    origins: NDArray[np.int64]


def _flatten(source: C3DFile, runs: Sequence[SampleRun]) -> _Samples:
    recording = source.recording
    for run in runs:
        inside = 0 <= run.start <= recording.frames - len(run.values)
        if run.values.ndim != 2 or run.values.shape[1] != 3:
            raise ValueError(f"values must be (n, 3), not {run.values.shape}")
        markers = (run.marker, run.marker if run.origin is None else run.origin)
        if run.fourth is not None and run.fourth.shape != run.values.shape[:1]:
            raise ValueError(f"{len(run.fourth)} fourth words for {len(run.values)} samples")
        if not (inside and 0 <= min(markers) <= max(markers) < recording.markers):
            raise ValueError(
                f"marker {run.marker}, frames {run.start} to {run.start + len(run.values) - 1} "
                f"are not all in {recording.markers} markers and {recording.frames} frames"
            )
    lengths = [len(run.values) for run in runs]
    if not sum(lengths):
        none = np.zeros(0, np.int64)
        return _Samples(none, none, np.zeros((0, 3)), np.zeros(0), none)
    frames = np.concatenate([run.start + np.arange(len(run.values)) for run in runs])
    numbers = np.repeat([run.marker for run in runs], lengths)
    origins = np.repeat([-1 if run.origin is None else run.origin for run in runs], lengths)
    given = [np.full(len(run.values), np.nan) if run.fourth is None else run.fourth for run in runs]
    fourth = np.concatenate(given).astype(np.float64)
    values = np.concatenate([run.values for run in runs]).astype(np.float64)
    if (np.isnan(values).any(axis=1) != np.isnan(values).all(axis=1)).any():
        raise ValueError("a sample has some coordinates and not others")
    keys = frames * recording.markers + numbers
    _, last = np.unique(keys[::-1], return_index=True)
    chosen = len(keys) - 1 - last
    return _Samples(
        frames[chosen], numbers[chosen], values[chosen], fourth[chosen], origins[chosen]
    )


def _words(
    values: NDArray[np.float64], present: NDArray[np.bool_], layout: Layout
) -> tuple[Words, NDArray[np.bool_], NDArray[np.float64]]:
    """Return the words (n, 4), which samples would read as missing, and where these went."""
    words = np.zeros((len(values), 4), np.float32 if layout.is_float else np.int16)
    words[:, :3] = values if layout.is_float else np.rint(values / layout.scale)
    zeros = move_from_zero(words, values, present, NOT_ZERO if layout.is_float else 1)
    step = 1.0 if layout.is_float else layout.scale
    return words, zeros, words[zeros, :3].astype(np.float64) * step


def move_from_zero(
    words: Words, values: NDArray[np.float64], present: NDArray[np.bool_], step: float
) -> NDArray[np.bool_]:
    """Move the present samples that would read as missing, in place.

    Parameters
    ----------
    words : ndarray, shape (n, 4)
        The samples as they are stored; changed.
    values : ndarray, shape (n, 3)
        The coordinates before they were rounded; they say in which direction.
    present : ndarray of bool, shape (n,)
        Which samples are not missing.
    step : float
        How far, in the unit of the words.

    Returns
    -------
    ndarray of bool, shape (n,)
        Which samples were moved.
    """
    zeros: NDArray[np.bool_] = present & ~words[:, :3].any(axis=1)
    at = np.flatnonzero(zeros)
    if len(at):
        axis = np.abs(values[at]).argmax(axis=1)
        words[at, :3] = 0
        words[at, axis] = np.where(values[at, axis] < 0, -step, step)
    return zeros


def _does_not_fit(
    source: C3DFile, marker: int, frame: int, value: NDArray[np.float64], limit: float
) -> MocapmendError:
    recording = source.recording
    kind = "numbers" if source.layout.is_float else "integers"
    return MocapmendError(
        f"Marker {recording.labels[marker]} at frame {recording.first_frame + frame}: "
        f"{value[np.abs(value).argmax()]:g} {recording.unit} does not fit into the {kind} of "
        f"this file, which end at {limit:g}.",
        str(source.path),
        "Leave this sample out, or fill it in another way.",
    )
