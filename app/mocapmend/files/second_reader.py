"""A second opinion on a saved file: what the c3d library reads in it."""

import struct
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_encode import SampleRun, Slots, encode_runs
from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_reader import C3DFile
from mocapmend.files.opening import open_file
from mocapmend_algorithms.progress import Progress, no_progress

REFUSALS = (
    ArithmeticError,
    AssertionError,
    AttributeError,
    LookupError,
    MemoryError,
    NameError,
    TypeError,
    ValueError,
    struct.error,
)
"""What the library raises for files that it does not understand."""

CHUNK = 256
"""Frames that are compared at a time."""

TINY = 1e-30
"""The library reads DEC numbers below about 1e-37 four times too large: lengths of nothing."""


@dataclass(frozen=True, eq=False)
class _Frames:
    """Frames as the library reads them.

    Attributes
    ----------
    first : int
        The first of them, from 0.
    points : ndarray, shape (frames, points, 5), float32
        x, y, z, residual or -1, cameras.
    analog : ndarray, shape (frames, analog values)
        In their units.
    """

    first: int
    points: NDArray[np.float32]
    analog: NDArray[np.float64]


class _RefusedError(Exception):
    """The library cannot read a file, or not as we do."""


@dataclass(frozen=True, eq=False)
class Claim:
    """What a saved file is said to hold; another process may confirm it.

    Attributes
    ----------
    original, saved : Path
        The file before and after.
    layout, saved_layout : Layout
        Of both.
    slots : Slots
        What was written.
    """

    original: Path
    saved: Path
    layout: Layout
    saved_layout: Layout
    slots: Slots

    @classmethod
    def of(cls, source: C3DFile, saved: Path, runs: Sequence[SampleRun]) -> "Claim":
        """Return what is said of a copy.

        Parameters
        ----------
        source : C3DFile
            The original as our own reader read it.
        saved : Path
            The copy.
        runs : sequence of SampleRun
            What was written.
        """
        saved_layout = _layout_of(saved, source.layout)
        slots = encode_runs(source, runs, saved_layout)
        return cls(source.path, saved, source.layout, saved_layout, slots)

    @np.errstate(all="ignore")
    def confirm(self, progress: Progress = no_progress) -> str:
        """Read both files with the c3d library and compare them frame by frame.

        Parameters
        ----------
        progress : Progress
            Called often; may cancel.

        Returns
        -------
        str
            A sentence that says what was confirmed, or that the library cannot read the original.

        Raises
        ------
        MocapmendError
            If the library reads the original, but cannot read the saved file or reads something
            else in it than what was written.
        """
        layout, saved, slots = self.layout, self.saved, self.slots
        converted = self.saved_layout.is_float and not layout.is_float
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            before, after = _read(self.original, layout), _read(saved, self.saved_layout)
            count = 0
            while True:
                try:
                    expected = next(before, None)
                except _RefusedError as error:
                    return f"No second check, the c3d library cannot read this file: {error}."
                try:
                    read = next(after, None)
                except _RefusedError as error:
                    raise _contradiction(saved, f"it cannot read it: {error}") from error
                if expected is None and read is None:
                    break
                if expected is None or read is None or len(expected.points) != len(read.points):
                    raise _contradiction(saved, "it reads another number of frames")
                _compare(expected, read, slots, saved, self.saved_layout, converted=converted)
                count += len(read.points)
                progress(min(1.0, count / max(1, layout.frames)))
        samples = int(np.count_nonzero(slots.frames < count))
        return (
            f"The c3d library read {count} frames of both files: {samples} of {len(slots)} written "
            "samples decode as they should, and all else is the same."
        )


def _layout_of(path: Path, expected: Layout) -> Layout:
    """Read the layout of a file; what cannot be read is left for the library to find."""
    with open_file(path) as (stream, stamp):
        try:
            return read_layout(stream, stamp.size, str(path))
        except MocapmendError:
            return expected


def _read(path: Path, layout: Layout) -> Iterator[_Frames]:
    """Yield what the library reads."""
    # Imported late: only saving needs it.
    import c3d

    try:
        stream = path.open("rb")
    except OSError as error:
        raise MocapmendError(f"The file cannot be read: {error.strerror}.", str(path)) from error
    with stream:
        try:
            reader = c3d.Reader(stream)
            if _shape(reader) != _own_shape(layout):
                raise _RefusedError("it finds other numbers of points, analog values or scale")
            yield from _in_chunks(reader.read_frames(copy=False), layout)
        except REFUSALS as error:
            reason = f"{type(error).__name__} {error}".strip(". \n")
            raise _RefusedError(reason) from error


def _in_chunks(frames: Iterator[tuple[int, Any, Any]], layout: Layout) -> Iterator[_Frames]:
    """Gather the library's single frames; the arrays are used again for the next ones."""
    size = max(1, min(CHUNK, layout.frames))
    points = np.empty((size, layout.points, 5), np.float32)
    analog = np.empty((size, layout.channels * layout.analog_samples))
    first = count = 0
    # What the library takes for further frames lies behind the last one: other checks look at it.
    for _, frame_points, frame_analog in islice(frames, layout.frames):
        points[count] = frame_points
        analog[count] = frame_analog.reshape(-1)
        count += 1
        if count == size:
            yield _Frames(first, points, analog)
            first, count = first + size, 0
    if count:
        yield _Frames(first, points[:count], analog[:count])


def _shape(reader: Any) -> tuple[int, int, int, float]:
    """Return points, analog values, data block and scale as the library sees them."""
    values = reader.analog_used * reader.analog_per_frame
    return reader.point_used, values, reader.header.data_block, float(reader.point_scale)


def _own_shape(layout: Layout) -> tuple[int, int, int, float]:
    return (
        layout.points,
        layout.channels * layout.analog_samples,
        layout.data_start // BLOCK + 1,
        -layout.scale if layout.is_float else layout.scale,
    )


def _compare(
    expected: _Frames,
    read: _Frames,
    slots: Slots,
    saved: Path,
    layout: Layout,
    *,
    converted: bool,
) -> None:
    """Compare frames of the original with the same frames of the saved file."""
    inside = slots.within(read.first, len(read.points))
    rows, points, origins = (
        part[inside] for part in (slots.frames - read.first, slots.points, slots.origins)
    )
    own = origins < 0
    copied = expected.points[rows[~own], origins[~own]]
    at = rows[own], points[own]
    written, fourth, got = slots.values[inside][own], slots.fourth[inside][own], read.points[at]
    missing = np.isnan(written[:, 0])
    target = np.where(missing[:, None], 0.0, written).astype(np.float32)
    allowed = TINY if layout.is_float else 0.5 * layout.scale + np.spacing(np.abs(target))
    near = np.abs(got[:, :3].astype(np.float64) - target) <= allowed
    # Of another fourth word the library makes residuals and cameras in its own way.
    plain = missing | (fourth == 0)
    if not (near.all() and np.array_equal(got[plain, 3], np.where(missing, -1, 0)[plain])):
        raise _contradiction(saved, "written samples read differently")
    expected.points[at] = got
    expected.points[rows[~own], points[~own]] = copied
    for one, other in ((expected.points, read.points), (expected.analog, read.analog)):
        # The library rounds the products of integers and their scale otherwise than we do.
        close = converted and bool(np.allclose(one, other, 1e-6, 1e-9))
        # Bytes, because a NaN is not equal to itself.
        if not (close or one.tobytes() == other.tobytes()):
            raise _contradiction(
                saved, f"data that were not written differ after frame {read.first} (from 0)"
            )


def _contradiction(saved: Path, what: str) -> MocapmendError:
    return MocapmendError(
        f"The c3d library does not confirm the saved file: {what}.",
        str(saved),
        "Do not use the file, and report this.",
    )
