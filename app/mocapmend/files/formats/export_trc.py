"""Writing TRC files."""

from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.columns import clean_label
from mocapmend.files.formats.export import (
    coordinates,
    export_labels,
    frame_cells,
    slices,
    write_verified,
)
from mocapmend.files.formats.trc import read_trc
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording

UNITS = ("mm", "cm", "m")
"""What readers of TRC files understand."""
NOT_ZERO = 1e-6
"""Length that is written for a coordinate of a sample at exactly (0, 0, 0)."""


def write_trc(
    recording: Recording, out: Path, *, progress: Progress = no_progress
) -> tuple[str, ...]:
    """Write a recording as a TRC file; cells of missing samples are empty.

    Parameters
    ----------
    recording : Recording
        Every coordinate comes back exactly, if its unit is mm, cm or m.
    out : Path
        Where the file shall be; what was there before is replaced.
    progress : Progress
        Called often; may cancel.

    Returns
    -------
    tuple of str
        What was not written as it is, as sentences.

    Raises
    ------
    MocapmendError
        If there are no markers, or the file cannot be written.
    """
    notes: list[str] = []
    labels = export_labels(recording, notes)
    unit = recording.unit
    points = np.where(recording.present[..., None], recording.points, np.nan)
    if unit not in UNITS:
        unit = "mm"
        points *= recording.mm
        notes.append(
            f"TRC files know mm, cm and m; the coordinates are written in mm, not {recording.unit}."
        )
    _move_off_zero(points, notes)
    rate = repr(float(recording.rate))
    head = (
        f"PathFileType\t4\t(X/Y/Z)\t{clean_label(Path(out).name)}\n"
        "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\t"
        "OrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n"
        f"{rate}\t{rate}\t{recording.frames}\t{recording.markers}\t{unit}\t"
        f"{rate}\t{recording.first_frame}\t{recording.frames}\n"
        + "\t".join(["Frame#", "Time", *(f"{label}\t\t" for label in labels)])
        + "\n\t\t"
        + "\t".join(f"X{i}\tY{i}\tZ{i}" for i in range(1, recording.markers + 1))
        + "\n\n"
    )

    def write(stream: BinaryIO) -> None:
        stream.write(head.encode())
        for part in slices(recording, progress):
            rows = coordinates(points[part].reshape(part.stop - part.start, -1), "\t")
            frames = frame_cells(recording, part, "\t")
            lines = (f"{a}\t{b}\n" for a, b in zip(frames, rows, strict=True))
            stream.write("".join(lines).encode())

    write_verified(Path(out), write, read_trc, points, progress)
    return tuple(notes)


def _move_off_zero(points: NDArray[np.float64], notes: list[str]) -> None:
    """Move samples at (0, 0, 0), which readers take as missing, in place."""
    zero = ~points.any(axis=2)
    count = int(np.count_nonzero(zero))
    if count:
        points[zero, 0] = NOT_ZERO
        notes.append(
            "Samples exactly at (0, 0, 0) would be missing to a reader; their x is written as "
            f"{NOT_ZERO:g}: {count}."
        )
