"""Analog channels of a file, ready to be drawn. No Qt."""

from collections.abc import Sequence

import numpy as np

from mocapmend.files import C3DFile
from mocapmend.files.opening import too_large
from mocapmend.views.columns import Envelope
from mocapmend_algorithms.progress import Progress

SMALL = 16 * 2**20
"""Samples of all channels up to which all of them are read at once."""


def wanted_at_once(source: C3DFile, chosen: Sequence[int]) -> list[int]:
    """Return the channels to read when some are chosen: all of them if the file has few samples."""
    channels = len(source.analog_labels)
    samples = source.layout.frames * source.layout.analog_samples
    return list(range(channels)) if channels * samples <= SMALL else list(chosen)


def read_channels(
    source: C3DFile, channels: Sequence[int], progress: Progress
) -> dict[int, Envelope]:
    """Read analog channels.

    Parameters
    ----------
    source : C3DFile
        The file.
    channels : sequence of int
        Which of them.
    progress : Progress
        May cancel.

    Returns
    -------
    dict
        By channel: its samples in its unit as float32; NaN where they are not finite.

    Raises
    ------
    MocapmendError
        If the file is not there any more, or not as it was, or does not fit into memory.
    """
    try:
        values = source.read_analog(channels)
        progress(0.5)
        with np.errstate(over="ignore"):
            columns = np.ascontiguousarray(values.T.astype(np.float32))
    except MemoryError:
        raise too_large(str(source.path)) from None
    columns[~np.isfinite(columns)] = np.nan
    found = {channel: Envelope(columns[i : i + 1]) for i, channel in enumerate(channels)}
    progress(1.0)
    return found
