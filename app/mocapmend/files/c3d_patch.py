"""Saving repairs: the bytes of the source, in which only the repaired samples are replaced."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import not_as_written, same_file, write_atomically
from mocapmend.files.c3d_encode import SampleRun, Slots, encode_runs
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_reader import C3DFile
from mocapmend.files.c3d_samples import (
    coordinates,
    point_slots,
    point_words,
    read_pieces,
)
from mocapmend.files.opening import changed_on_disk, open_file
from mocapmend_algorithms.progress import Progress, no_progress


@dataclass(frozen=True)
class Saved:
    """What was written.

    Attributes
    ----------
    path : Path
        The new file.
    samples : int
        Number of samples that were replaced.
    notes : tuple of str
        What the user should know about it.
    """

    path: Path
    samples: int
    notes: tuple[str, ...]


@np.errstate(all="ignore")
def save_patched(
    source: C3DFile,
    runs: Sequence[SampleRun],
    out: Path,
    *,
    replace_source: bool = False,
    accept_truncated: bool = False,
    progress: Progress = no_progress,
    confirm: Callable[[Path], None] | None = None,
) -> Saved:
    """Save a copy of a file in which only the given samples differ.

    The copy is read back and compared before it gets its name. Without runs it is the same,
    byte for byte.

    Parameters
    ----------
    source : C3DFile
        The file, as it was read.
    runs : sequence of SampleRun
        The repaired samples.
    out : Path
        Where the copy goes.
    replace_source : bool
        Whether `out` may be the source itself.
    accept_truncated : bool
        Whether a source that is truncated may be saved.
    progress : Progress
        Called often; may cancel.
    confirm : callable, optional
        Called with the finished copy before it gets its name; what it raises prevents that.

    Returns
    -------
    Saved
        Where it is and what was written.

    Raises
    ------
    MocapmendError
        If it cannot be saved. Then nothing is left behind.
    """
    layout = source.layout
    if source.truncated and not accept_truncated:
        raise MocapmendError(
            f"The file is truncated: {layout.frames} of {layout.frames_promised} frames are there.",
            str(source.path),
            "Confirm that you want to save it all the same (--accept-truncated).",
        )
    out = Path(out)
    if not source.path.exists():
        raise MocapmendError(
            "The original is not there any more; saving copies its bytes.",
            str(source.path),
            "Put it back under this name, then save again.",
        )
    if not replace_source and same_file(out, source.path):
        raise MocapmendError(
            "This is the file that the data come from.", str(out), "Choose another name."
        )
    slots = encode_runs(source, runs)

    def verify(copy: Path) -> None:
        _verify(source, slots, copy, lambda share: progress(0.5 + 0.5 * share))
        if confirm is not None:
            confirm(copy)

    write_atomically(
        out,
        lambda stream: _write(source, slots, stream, lambda share: progress(0.5 * share)),
        verify,
    )
    return Saved(out, len(slots), slots.notes)


def _write(
    source: C3DFile, slots: Slots, target: BinaryIO, report: Callable[[float], None]
) -> None:
    """Write the patched copy."""
    layout = source.layout
    with open_file(source.path) as (stream, stamp):
        if stamp != source.stamp:
            raise changed_on_disk(source.path)
        for piece in read_pieces(stream, layout, str(source.path)):
            report(piece.offset / layout.size)
            if piece.frame is not None:
                inside = slots.within(piece.frame, len(piece.raw))
                place = point_slots(piece.raw, layout)
                place[slots.frames[inside] - piece.frame, slots.points[inside]] = slots.raw[inside]
            target.write(piece.raw.data)


def _verify(source: C3DFile, slots: Slots, path: Path, report: Callable[[float], None]) -> None:
    """Read the copy back: everything else is as in the source, the samples are as given.

    Raises
    ------
    MocapmendError
        If it is not so.
    """
    layout = source.layout
    with (
        open_file(source.path) as (original, stamp),
        open_file(path) as (saved, saved_stamp),
    ):
        if stamp != source.stamp:
            raise changed_on_disk(source.path)
        if saved_stamp.size != stamp.size:
            raise not_as_written(path, "its size")
        pairs = zip(
            read_pieces(original, layout, str(source.path)),
            read_pieces(saved, layout, str(path)),
            strict=True,
        )
        for before, after in pairs:
            report(after.offset / layout.size)
            if before.frame is not None:
                inside = slots.within(before.frame, len(before.raw))
                at = slots.frames[inside] - before.frame, slots.points[inside]
                _check_samples(after.raw, at, slots.values[inside], layout, path)
                point_slots(before.raw, layout)[at] = point_slots(after.raw, layout)[at]
            if not np.array_equal(before.raw, after.raw):
                raise not_as_written(path, "bytes outside the repaired samples")
    report(1.0)


def _check_samples(
    block: NDArray[np.uint8],
    at: tuple[NDArray[np.int64], NDArray[np.int64]],
    values: NDArray[np.float64],
    layout: Layout,
    path: Path,
) -> None:
    """Compare patched samples of a block with what was to be written."""
    words = point_words(block, layout)[at]
    missing = np.isnan(values[:, 0])
    read = np.stack([coordinates(words, layout, axis) for axis in range(3)], axis=-1)
    fourth = np.where(missing, -1, 0)
    expected = np.where(missing[:, None], 0.0, values).astype(np.float32)
    if layout.is_float:
        same = (read == expected).all()
    else:
        # Half a step of the integers, and the rounding of the products.
        allowed = 0.5 * layout.scale + np.spacing(np.abs(expected))
        same = (np.abs(read.astype(np.float64) - expected) <= allowed).all()
    if not (same and np.array_equal(words[:, 3], fourth)):
        raise not_as_written(path, "repaired samples")
