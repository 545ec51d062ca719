"""When the frames of a Kinect were taken, which is not at even steps."""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.cells import number
from mocapmend.files.formats.text import open_text

RATE = 30.0
"""Of a Kinect (Hz); it falls to half of it in the dark."""
ASSUMED = f"The file states no frame rate; {RATE:g} Hz is assumed."
SAME_RATE = 0.005
"""Share by which the rate of a Kinect's clock may seem to be another."""
STEPS = 1 / 200, 1 / 5
"""Seconds from frame to frame that are believed."""
SCALES = (1.0, 1e-3, 1e-7)
"""Seconds per unit of times: seconds, milliseconds and the 100 ns of Windows. What is a believable
step in one of them is none in the others."""
POSITIONS_NAME = re.compile("JointPosition", re.IGNORECASE | re.ASCII)
UNEVEN = 0.25
"""Of a period: how much a step may differ from it, or from a multiple of it."""


@dataclass(frozen=True, eq=False)
class Timing:
    """What the times of the frames say.

    Attributes
    ----------
    rate : float
        Frames per second (Hz).
    numbers : ndarray, shape (frames,)
        Of the frames, from 1; those that the Kinect dropped are left out.
    uneven : int
        Steps that are much longer or shorter than a period, but for the dropped frames.
    """

    rate: float
    numbers: NDArray[np.float64]
    uneven: int

    def sentence(self) -> str:
        """Return a warning where the frames are not at even steps, else nothing."""
        if not self.uneven:
            return ""
        return (
            f"{self.uneven} of {len(self.numbers) - 1} steps from frame to frame are more than a "
            f"quarter longer or shorter than {1000 / self.rate:.1f} ms; the frames are taken as "
            "evenly spaced."
        )


def frame_times(
    path: Path, column: NDArray[np.float64] | None, frames: int, warnings: list[str]
) -> tuple[NDArray[np.float64], float]:
    """Find the numbers of the frames and their rate, and say where they are from.

    Parameters
    ----------
    path : Path
        Of the file of the joints. KIMORE has a file of times beside it.
    column : ndarray, shape (frames,), or None
        What the lines of the file begin with, if it is not a joint: times or numbers of frames.
    frames : int
        How many there are.
    warnings : list of str
        Gets what was assumed.

    Returns
    -------
    numbers : ndarray, shape (frames,)
        NaN without.
    rate : float
        Frames per second (Hz).
    """
    counted = column is not None and _are_numbers(column)
    where = _beside(path) if column is None else path
    nothing = np.full(frames, np.nan)
    if where is None or counted:
        warnings.append(ASSUMED)
        return nothing if column is None else column, RATE
    times = read_times(where) if column is None else column
    timing = None if times is None else timing_of(times)
    if times is None or timing is None:
        warnings += [f"The times in {where.name} cannot be used.", ASSUMED]
        return nothing, RATE
    warnings.append(f"The times in {where.name} say {timing.rate:g} Hz.")
    if len(times) != frames:
        warnings.append(
            f"{where.name} has {len(times)} times for {frames} frames; only the frame rate is "
            "taken from it."
        )
        return nothing, timing.rate
    if uneven := timing.sentence():
        warnings.append(uneven)
    return timing.numbers, timing.rate


def may_lead(column: NDArray[np.float64]) -> bool:
    """Say whether a column can be the numbers or the times of frames."""
    grows = len(column) > 1 and bool((np.diff(column) > 0).all())
    return grows and (_are_numbers(column) or timing_of(column) is not None)


@np.errstate(all="ignore")
def timing_of(times: NDArray[np.float64]) -> Timing | None:
    """Find rate and dropped frames.

    The period is the mean of the steps near their median, as times are often rounded to
    milliseconds. A step of k periods means that k - 1 frames were dropped, unless a short step
    beside it shows that a frame was only late.

    Parameters
    ----------
    times : ndarray, shape (frames,)
        In seconds, milliseconds or steps of 100 ns, whichever is believable.

    Returns
    -------
    Timing or None
        None where they are no times of frames.
    """
    steps = np.diff(times)
    if not len(steps) or not np.isfinite(times).all():
        return None
    # One of the steps, where a mean of two might have none near it.
    median = float(np.quantile(steps, 0.5, method="lower"))
    scale = next((s for s in SCALES if STEPS[0] <= median * s <= STEPS[1]), None)
    if scale is None:
        return None
    steps = steps * scale
    median *= scale
    period = float(steps[np.abs(steps - median) <= UNEVEN * median].mean())
    if abs(period * RATE - 1) <= SAME_RATE:
        period = 1 / RATE
    periods = steps / period
    whole = np.rint(periods)
    on_time = np.concatenate([[True], periods >= 1 - UNEVEN, [True]])
    dropped = (whole >= 2) & (np.abs(periods - whole) <= UNEVEN) & on_time[:-2] & on_time[2:]
    counts = np.where(dropped, whole, 1.0)
    uneven = int(np.count_nonzero(np.abs(periods - counts) > UNEVEN))
    return Timing(1 / period, 1 + np.concatenate([[0.0], np.cumsum(counts)]), uneven)


def read_times(path: Path) -> NDArray[np.float64] | None:
    """Read a file of one time in each line; None if it is something else."""
    try:
        with open_text(path) as lines:
            cells = [
                line.strip(" \t,;")
                for block in lines.blocks()
                for line in block.without_blank("\t").lines
            ]
    except MocapmendError:
        return None
    times = np.array([number(cell) for cell in cells])
    return times if np.isfinite(times).all() else None


def _beside(path: Path) -> Path | None:
    """Return the file of times beside a file of positions, by their names in KIMORE."""
    name, found = POSITIONS_NAME.subn("TimeStamp", path.name)
    beside = path.with_name(name)
    return beside if found and beside.is_file() else None


def _are_numbers(column: NDArray[np.float64]) -> bool:
    """Say whether a column counts frames."""
    counts = len(column) > 1 and np.median(np.diff(column)) == 1
    return bool(counts and (np.rint(column) == column).all())
