"""Writing .npz files of NumPy."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.export import export_labels, write_verified
from mocapmend.files.formats.npz import read_npz
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.zip_arrays import write_arrays


def write_npz(
    recording: Recording,
    out: Path,
    *,
    bones: Sequence[tuple[int, int]] = (),
    filled: NDArray[np.bool_] | None = None,
    progress: Progress = no_progress,
) -> tuple[str, ...]:
    """Write a recording as an .npz file, with NaN for missing samples.

    Its arrays are `pos` (frames, markers, 3), `fps`, `names`, `units`, `up`, `first_frame` and,
    where they are given, `bones` and `filled`.

    Parameters
    ----------
    recording : Recording
        Every coordinate comes back exactly.
    out : Path
        Where the file shall be; what was there before is replaced.
    bones : sequence of (int, int)
        Sticks, pairs of markers.
    filled : ndarray of bool, shape (frames, markers), optional
        Which samples were filled.
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
    arrays: dict[str, NDArray[Any]] = {
        "pos": points,
        "fps": np.array(float(recording.rate)),
        "names": np.array(labels),
        "units": np.array(recording.unit),
        "up": np.array(recording.up.removeprefix("+")),
        "first_frame": np.array(recording.first_frame),
    }
    if bones:
        arrays["bones"] = np.array(bones, np.int64)
    if filled is not None:
        arrays["filled"] = filled & recording.present

    def write(stream: BinaryIO) -> None:
        write_arrays(stream, arrays, compress=False)
        progress(0.5)

    write_verified(Path(out), write, read_npz, points, progress)
    return tuple(notes)
