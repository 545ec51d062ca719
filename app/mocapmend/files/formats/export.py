"""What the writers of all formats share: labels, numbers as text, verification."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import write_atomically
from mocapmend.files.formats.columns import clean_label
from mocapmend.files.source import Source
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

CELLS_AT_A_TIME = 200_000


def export_labels(recording: Recording, notes: list[str]) -> tuple[str, ...]:
    """Return the labels as text files can hold them: on one line, never empty.

    Raises
    ------
    MocapmendError
        If the recording has no marker.
    """
    if not recording.markers:
        raise MocapmendError("There are no markers to export.", "", "Open another recording.")
    labels = tuple(
        clean_label(label) or f"point {i}" for i, label in enumerate(recording.labels, 1)
    )
    changed = sum(a != b for a, b in zip(labels, recording.labels, strict=True))
    if changed:
        notes.append(
            f"Labels that were empty or had characters that no file holds are changed: {changed}."
        )
    return labels


def slices(recording: Recording, progress: Progress) -> Iterator[slice]:
    """Yield the frames in parts that are small in memory; they are half of the work."""
    step = max(CELLS_AT_A_TIME // (3 * recording.markers), 1)
    for start in range(0, recording.frames, step):
        progress(0.5 * start / recording.frames)
        yield slice(start, min(start + step, recording.frames))


def frame_cells(recording: Recording, part: slice, separator: str) -> list[str]:
    """Return the number and the time, from the first frame, of some frames."""
    return [
        f"{recording.first_frame + i}{separator}{i / recording.rate:.6f}"
        for i in range(part.start, part.stop)
    ]


def coordinates(points: NDArray[np.float64], separator: str) -> list[str]:
    """Return the shortest text of each row that gives the same numbers, empty cells for NaN.

    Parameters
    ----------
    points : ndarray, shape (rows, n)
        Coordinates.
    separator : str
        Between cells.
    """
    if not len(points):
        return []
    rows = [separator.join(map(repr, row)) for row in points.tolist()]
    return "\n".join(rows).replace("nan", "").split("\n")


def write_verified(
    out: Path,
    write: Callable[[BinaryIO], None],
    read: Callable[[Path], Source],
    points: NDArray[np.float64],
    progress: Progress,
) -> None:
    """Write a file atomically; before it gets its name, read it again and compare.

    Raises
    ------
    MocapmendError
        If it cannot be written, or what is read differs.
    """

    def verify(temporary: Path) -> None:
        if not np.array_equal(read(temporary).recording.points, points, equal_nan=True):
            raise MocapmendError(
                "The written file does not hold what it should; it was deleted.",
                str(out),
                "Try another disk.",
            )
        progress(1.0)

    write_atomically(out, write, verify)
