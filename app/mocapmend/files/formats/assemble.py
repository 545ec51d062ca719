"""From the frames of a table to a recording: one rate, no frame left out."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.formats.frames import LARGEST_FRAME, Frames
from mocapmend.files.labels import complete_labels
from mocapmend.files.opening import ANOTHER_FILE
from mocapmend.files.space import assumed_up, length_unit
from mocapmend_algorithms.recording import Recording, UpAxis

ASSUMED_RATE = 100.0
RATES = (1e-3, 1e6)
"""Hz that are believed."""


@dataclass(frozen=True, kw_only=True)
class Stated:
    """What a file says about its recording.

    Attributes
    ----------
    labels : sequence of str
        Of the markers.
    rate : float
        Frames per second (Hz), 0 or NaN where it says nothing.
    unit : str
        Length unit, or empty.
    up : str or None
        The axis that points up.
    first_frame : int
        Number of the first frame where frames have no numbers.
    """

    labels: Sequence[str]
    rate: float = 0.0
    unit: str = ""
    up: UpAxis | None = None
    first_frame: int = 1


@np.errstate(all="ignore")
def assemble(path: Path, frames: Frames, stated: Stated, warnings: list[str]) -> Recording:
    """Make the recording of what was read and stated.

    Frames that the numbers leave out become frames without markers.

    Raises
    ------
    MocapmendError
        If it holds no marker.
    """
    if not frames.points.shape[1]:
        raise MocapmendError("The file holds no marker.", str(path), ANOTHER_FILE)
    labels = complete_labels(stated.labels, frames.points.shape[1], warnings)
    index, first_frame = _places(frames.numbers, stated.first_frame, warnings)
    points = frames.points
    if len(index) and index[-1] >= len(index):
        points = np.full((index[-1] + 1, *points.shape[1:]), np.nan)
        points[index] = frames.points
    if not len(points):
        warnings.append("The file holds no frames: there is nothing to repair.")
    return Recording(
        points,
        labels,
        _rate(frames.times, index, stated.rate, warnings),
        unit=length_unit(points, stated.unit, warnings),
        up=stated.up or assumed_up(points, warnings),
        first_frame=first_frame,
    )


def rate_of_times(times: NDArray[np.float64], index: NDArray[np.intp]) -> float:
    """Return the rate (Hz) that times at some frames say, NaN where they say none.

    Times are rounded where they are written. Of the rates that fit them a whole number is taken
    if there is one, else the rate of the last time less the first.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Seconds.
    index : ndarray of int, shape (n,)
        The frame of each time, ascending.
    """
    known = np.flatnonzero(np.isfinite(times))
    if len(known) < 2:
        return np.nan
    first, last = known[0], known[-1]
    span = times[last] - times[first]
    frames = index[last] - index[first]
    if not span > 0:
        return np.nan
    rounding = _rounding(times[known])
    rate = float(frames / span)
    whole = float(np.rint(rate))
    fits = whole > 0 and abs(frames / whole - span) <= rounding * (1 + 1e-6)
    return whole if fits else rate


def _rounding(times: NDArray[np.float64]) -> float:
    """Return the last decimal place of numbers."""
    for digits in range(9):
        scaled = times * 10.0**digits
        if (np.abs(scaled - np.rint(scaled)) < 1e-4).all():
            return float(10.0**-digits)
    return 1e-9


def _places(
    numbers: NDArray[np.float64], first_frame: int, warnings: list[str]
) -> tuple[NDArray[np.intp], int]:
    """Return each row's frame from 0, and the number of the first frame."""
    rows = np.arange(len(numbers))
    if np.isnan(numbers).all():
        return rows, first_frame
    if (
        not (np.isfinite(numbers) & (np.abs(numbers) <= LARGEST_FRAME)).all()
        or (np.rint(numbers) != numbers).any()
    ):
        warnings.append("Some frames have no number; the lines are taken as consecutive frames.")
        return rows, first_frame
    first = int(numbers[0])
    steps = np.diff(numbers)
    if (steps == 1).all():
        return rows, first
    absent = int(numbers[-1]) - first + 1 - len(numbers)
    if (steps >= 1).all() and absent <= len(numbers) and np.ptp(steps):
        warnings.append(
            f"Frames that the file leaves out are taken as frames without markers: {absent}."
        )
        return (numbers - first).astype(np.intp), first
    warnings.append(
        "The numbers of the frames do not count up by one; the lines are taken as consecutive "
        "frames."
    )
    return rows, first


def _rate(
    times: NDArray[np.float64], index: NDArray[np.intp], stated: float, warnings: list[str]
) -> float:
    timed = rate_of_times(times, index)
    believed = RATES[0] <= stated <= RATES[1]
    if RATES[0] <= timed <= RATES[1]:
        if not believed:
            warnings.append(f"The file states no frame rate; its times say {timed:g} Hz.")
            return timed
        if abs(timed - stated) > 0.02 * stated:
            warnings.append(
                f"The file states {stated:g} Hz, but its times say {timed:g} Hz; {stated:g} Hz is "
                "used."
            )
    if believed:
        return stated
    warnings.append(f"The file states no frame rate; {ASSUMED_RATE:g} Hz is assumed.")
    return ASSUMED_RATE
