"""Writing new C3D files: recordings that come from another format."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import not_as_written, write_atomically
from mocapmend.files.c3d_encode import NOT_ZERO, move_from_zero
from mocapmend.files.c3d_header import BLOCK, HIGHEST_RATE, MOST_FIRST
from mocapmend.files.c3d_labels import point_labels, read_events
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_new_parameters import NewParameters, new_records
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_samples import (
    BLOCK_BYTES,
    Words,
    marked_missing,
    point_words,
    read_blocks,
    unmarked_missing,
)
from mocapmend.files.c3d_section import (
    LARGEST_WORD,
    MOST_BLOCKS,
    float_header,
    parameter_section,
    section_bytes,
)
from mocapmend.files.c3d_space import up_axis
from mocapmend.files.opening import open_file
from mocapmend.files.source import Event
from mocapmend.files.space import length_unit
from mocapmend_algorithms.progress import Progress, no_progress, part
from mocapmend_algorithms.recording import Recording


def write_new_c3d(
    recording: Recording,
    out: Path,
    *,
    events: Sequence[Event] = (),
    leading: bytes = b"",
    progress: Progress = no_progress,
) -> tuple[str, ...]:
    """Write a recording as a C3D file of Intel floats.

    It is read back and compared before it gets its name. The fourth word is 0 for a sample that
    is there, because nothing is known of residuals and cameras, and -1 for a missing one.

    Parameters
    ----------
    recording : Recording
        What to write. Coordinates are rounded to 32 bits.
    out : Path
        Where the file goes; what was there before is replaced.
    events : sequence of Event
        Written at their frames; their times follow from these.
    leading : bytes
        Further parameter records, a whole number of blocks; see `room_for_records`.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    tuple of str
        What was not written exactly as it was given, as sentences.

    Raises
    ------
    MocapmendError
        If the recording does not fit into a C3D file, or it cannot be written. Then nothing is
        left behind.
    """
    out = Path(out)
    _check_limits(recording, events, str(out))
    parameters = NewParameters.of(recording, events)
    moved = 0

    def write(stream: BinaryIO) -> None:
        nonlocal moved
        stream.writelines(_head(recording, parameters, leading, str(out)))
        for block in _blocks(recording, str(out)):
            stream.write(block.words.data)
            moved += block.moved
            progress(0.5 * block.stop / recording.frames)
        stream.write(b"\0" * (-stream.tell() % BLOCK))

    def verify(copy: Path) -> None:
        _verify(recording, parameters, copy, part(progress, 0.5, 1.0))

    write_atomically(out, write, verify)
    notes = list(parameters.notes)
    if moved:
        notes.append(
            f"{moved} samples at (0, 0, 0), which means missing in a C3D file, were moved by "
            f"{NOT_ZERO:g} {recording.unit}."
        )
    return tuple(notes)


def room_for_records(recording: Recording, events: Sequence[Event]) -> int:
    """Return how many bytes of further parameter records a new file has room for."""
    own = new_records(recording, NewParameters.of(recording, events), 0)
    return MOST_BLOCKS * BLOCK - section_bytes(own)


def _check_limits(recording: Recording, events: Sequence[Event], where: str) -> None:
    """Refuse what the format cannot say at all."""
    last = recording.first_frame + recording.frames - 1
    if not (recording.frames and recording.markers):
        raise MocapmendError("There are no samples to write.", where, "Open another recording.")
    if max(recording.markers, len(events)) > LARGEST_WORD:
        raise MocapmendError(
            f"A C3D file holds at most {LARGEST_WORD} markers and {LARGEST_WORD} events, not "
            f"{recording.markers} and {len(events)}.",
            where,
            "Save fewer of them.",
        )
    if not 0 <= recording.first_frame <= last <= MOST_FIRST:
        raise MocapmendError(
            f"A C3D file numbers its frames from 0 to {MOST_FIRST}, not from "
            f"{recording.first_frame} to {last}.",
            where,
            "Number the frames of the original from 1.",
        )
    if not 0 < np.float32(recording.rate) < HIGHEST_RATE:
        raise MocapmendError(
            f"A C3D file cannot hold a frame rate of {recording.rate:g} Hz.",
            where,
            "Correct the frame rate of the original.",
        )


def _head(
    recording: Recording, parameters: NewParameters, leading: bytes, where: str
) -> Iterator[bytes]:
    """Yield what comes before the samples."""
    section = parameter_section(
        lambda data_block: [leading, *new_records(recording, parameters, data_block)],
        Processor.INTEL,
        where,
    )
    yield float_header(
        points=recording.markers,
        analog=0,
        first=recording.first_frame,
        last=recording.first_frame + recording.frames - 1,
        data_block=2 + len(section) // BLOCK,
        analog_samples=0,
        rate=recording.rate,
        processor=Processor.INTEL,
    )
    yield section


@dataclass(frozen=True, eq=False)
class _Block:
    """Frames as they are stored.

    Attributes
    ----------
    words : ndarray, shape (frames, markers, 4), float32
        Coordinates and the fourth word.
    moved : int
        How many samples are not where they were given.
    stop : int
        The frame after the last one, from 0.
    """

    words: Words
    moved: int
    stop: int


def _blocks(recording: Recording, where: str) -> Iterator[_Block]:
    step = max(BLOCK_BYTES // (16 * recording.markers), 1)
    for start in range(0, recording.frames, step):
        points = recording.points[start : start + step]
        words, moved = _encode(points)
        wrong = np.argwhere(~np.isfinite(words[..., :3]).all(axis=2))
        if len(wrong):
            frame, marker = wrong[0]
            value = points[frame, marker]
            raise MocapmendError(
                f"Marker {recording.labels[marker]} at frame "
                f"{recording.first_frame + start + frame}: {value[np.abs(value).argmax()]:g} "
                f"{recording.unit} does not fit into the numbers of a C3D file.",
                where,
                "Delete this sample first.",
            )
        yield _Block(words, moved, start + len(words))


@np.errstate(over="ignore")
def _encode(points: NDArray[np.float64]) -> tuple[Words, int]:
    """Return words (frames, markers, 4), and how many samples were moved from (0, 0, 0)."""
    missing = np.isnan(points[..., 0])
    words = np.zeros((*missing.shape, 4), np.dtype("<f4"))
    words[..., :3] = np.where(missing[..., None], 0.0, points)
    words[missing, 3] = -1
    moved = move_from_zero(
        words.reshape(-1, 4), points.reshape(-1, 3), ~missing.reshape(-1), NOT_ZERO
    )
    return words, int(np.count_nonzero(moved))


@np.errstate(all="ignore")
def _verify(
    recording: Recording, parameters: NewParameters, path: Path, progress: Progress
) -> None:
    """Read a file back with our reader and compare everything with what was to be written."""
    with open_file(path) as (stream, stamp):
        layout = read_layout(stream, stamp.size, str(path))
        for what, same in _comparisons(recording, parameters, layout):
            if not same:
                raise not_as_written(path, what)
        for start, block in read_blocks(stream, layout, str(path)):
            words = point_words(block, layout)
            missing = marked_missing(words[..., 3])
            missing |= unmarked_missing(words, missing)
            points = recording.points[start : start + len(words)]
            same = np.array_equal(missing, np.isnan(points[..., 0]))
            if not (same and np.array_equal(words, _encode(points)[0])):
                raise not_as_written(path, "samples")
            progress((start + len(words)) / layout.frames)


def _comparisons(
    recording: Recording, parameters: NewParameters, layout: Layout
) -> Iterator[tuple[str, bool]]:
    """Yield what is compared, and whether it is as it should be."""
    ignored: list[str] = []
    labels = point_labels(layout, ignored)
    unit = length_unit(recording.points, layout.parameters.text("POINT:UNITS"), ignored)
    up = up_axis(recording.points, layout.parameters, ignored)
    shape = (layout.frames, layout.points, layout.channels, layout.is_float)
    yield "its size", shape == (recording.frames, recording.markers, 0, True)
    yield "the frame numbers", layout.first_frame == recording.first_frame
    yield "the frame rate", layout.rate == np.float32(recording.rate)
    yield "the labels", labels == parameters.shown_labels
    yield "unit and axes", (unit, up) == (recording.unit, recording.up)
    read = [(event.label, event.context, event.time) for event in read_events(layout)]
    yield "the events", read == parameters.shown_events
