"""Writing CSV files, with a line per frame or a line per sample."""

from itertools import chain
from pathlib import Path
from typing import BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.delimited import read_delimited
from mocapmend.files.formats.export import (
    coordinates,
    export_labels,
    frame_cells,
    slices,
    write_verified,
)
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording

STATES = ("measured", "filled", "missing")


def write_csv(
    recording: Recording,
    out: Path,
    *,
    layout: Literal["wide", "long"] = "wide",
    filled: NDArray[np.bool_] | None = None,
    progress: Progress = no_progress,
) -> tuple[str, ...]:
    """Write a recording as a CSV file; cells of missing samples are empty.

    Comments before the table hold the rate, the unit, the axis that points up and the first
    frame. Every coordinate comes back exactly.

    Parameters
    ----------
    recording : Recording
        What to write.
    out : Path
        Where the file shall be; what was there before is replaced.
    layout : str
        "wide": a line per frame with the columns frame, time, LASI_x, LASI_y, LASI_z, ...;
        "long": a line per sample with the columns frame, time, marker, x, y, z.
    filled : ndarray of bool, shape (frames, markers), optional
        Which samples were filled; the long layout gets the column state: measured, filled or
        missing. The wide layout has no place for it.
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
    points = np.where(recording.present[..., None], recording.points, np.nan)
    states = None
    if filled is not None and layout == "long":
        states = np.where(recording.present, np.where(filled, 1, 0), 2)
    comments = {
        "rate_hz": repr(float(recording.rate)),
        "unit": recording.unit,
        "up": recording.up,
        "first_frame": recording.first_frame,
        "missing": "empty",
    }
    names = (
        ["frame", "time", *(f"{label}_{axis}" for label in labels for axis in "xyz")]
        if layout == "wide"
        else ["frame", "time", "marker", "x", "y", "z", *(["state"] if states is not None else [])]
    )
    head = "".join(f"# {key}={value}\n" for key, value in comments.items())
    head += ",".join(map(_cell, names)) + "\n"

    def write(stream: BinaryIO) -> None:
        stream.write(head.encode())
        for part in slices(recording, progress):
            frames = frame_cells(recording, part, ",")
            if layout == "wide":
                rows = coordinates(points[part].reshape(len(frames), -1), ",")
                lines = [f"{a},{b}\n" for a, b in zip(frames, rows, strict=True)]
            else:
                some = states[part] if states is not None else None
                lines = _sample_lines(frames, labels, points[part], some)
            stream.write("".join(lines).encode())

    write_verified(Path(out), write, read_delimited, points, progress)
    return tuple(notes)


def _cell(text: str) -> str:
    """Return a text in quotation marks where a reader would take it for more than one cell."""
    if any(mark in text for mark in ',;\t"#') or text != text.strip():
        return '"' + text.replace('"', '""') + '"'
    return text


def _sample_lines(
    frames: list[str],
    labels: tuple[str, ...],
    points: NDArray[np.float64],
    states: NDArray[np.int_] | None,
) -> list[str]:
    """Return a line for each marker of each frame."""
    rows = coordinates(points.reshape(-1, 3), ",")
    cells = [f",{_cell(label)}," for label in labels]
    before = chain.from_iterable([frame + cell for cell in cells] for frame in frames)
    if states is None:
        return [f"{a}{b}\n" for a, b in zip(before, rows, strict=True)]
    after = [STATES[state] for state in states.reshape(-1).tolist()]
    return [f"{a}{b},{c}\n" for a, b, c in zip(before, rows, after, strict=True)]
