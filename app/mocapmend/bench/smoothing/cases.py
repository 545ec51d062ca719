"""The recordings, and which half each is in."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.formats import FORMATS
from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import BoolArray, FloatArray

FOLDERS = ("cmu_joints", "cmu_markers")
BAD_TRUTH = {
    "05_06": "a leg flips for single frames",
    "05_18": "a leg flips for single frames",
    "cmu_02_01": "jittery itself",
    "mr_135_02": "has spikes itself",
}
"""Recordings that are left out, and why."""
HALVES = ("train", "validation")
LEAST_FRAMES = 64
IMPACT_S = 0.02
IMPACT_SHARE = 0.01


@dataclass(frozen=True, eq=False)
class Case:
    """A recording.

    Attributes
    ----------
    name : str
        Of the file, without its suffix.
    folder : str
        Where it was found.
    half : str
        One of `HALVES`; all recordings of a subject are in the same.
    truth : Recording
        Its middle frames, as they are.
    """

    name: str
    folder: str
    half: str
    truth: Recording

    def noisy(self, noise_mm: float) -> Recording:
        """Add white noise; the same for the same recording."""
        rng = np.random.default_rng(list(self.name.encode()))
        noise = rng.normal(0.0, noise_mm / self.truth.mm, self.truth.points.shape)
        return self.truth.with_points(self.truth.points + noise)

    def impacts(self) -> BoolArray:
        """Say which samples are at impacts, shape (frames, markers)."""
        lag = max(1, round(IMPACT_S * self.truth.rate))
        change = bend(self.truth.points, lag)
        known = change[~np.isnan(change)]
        found = np.zeros(self.truth.present.shape, dtype=np.bool_)
        found[lag:-lag] = change >= np.quantile(known, 1 - IMPACT_SHARE)
        return found


def bend(points: FloatArray, lag: int) -> FloatArray:
    """Return the size of second differences, shape (frames - 2 lag, markers)."""
    second = points[2 * lag :] - 2 * points[lag:-lag] + points[: -2 * lag]
    return np.asarray(np.linalg.norm(second, axis=2), dtype=np.float64)


def read_cases(data: Path, half: str | None, most_frames: int) -> list[Case]:
    """Read the recordings of a folder.

    Parameters
    ----------
    data : Path
        Has the folders `FOLDERS`, or recordings itself.
    half : str or None
        One half alone.
    most_frames : int
        So many frames from the middle of each.

    Raises
    ------
    MocapmendError
        If there is no such folder, or no recording in it.
    """
    if not data.is_dir():
        raise MocapmendError("There is no such folder.", str(data), "Check its name.")
    folders = [data / name for name in FOLDERS if (data / name).is_dir()] or [data]
    found = [
        case
        for number, folder in enumerate(folders)
        for case in _of_folder(folder, number, half, most_frames)
    ]
    if not found:
        raise MocapmendError(
            f"There is no recording of {LEAST_FRAMES} or more frames here.",
            str(data),
            "Give a folder of recordings with --data DIR.",
        )
    return found


def subject(name: str) -> int:
    """Return the first number in a recording's name; 0 without."""
    number = re.search(r"\d+", name)
    return int(number[0]) if number else 0


def _of_folder(folder: Path, turn: int, half: str | None, most: int) -> Iterator[Case]:
    known = {suffix for kind in FORMATS for suffix in kind.suffixes}
    paths = [
        path
        for path in sorted(folder.iterdir())
        if path.suffix.lower() in known and path.is_file() and path.stem not in BAD_TRUTH
    ]
    # The turn puts the kicks of the two folders into different halves.
    order = {one: at + turn for at, one in enumerate(sorted({subject(p.stem) for p in paths}))}
    for path in paths:
        own = HALVES[order[subject(path.stem)] % 2]
        if half in (None, own):
            truth = _middle(read_recording(path).measured, most)
            if truth.frames >= LEAST_FRAMES and truth.present.any():
                yield Case(path.stem, folder.name, own, truth)


def _middle(recording: Recording, most: int) -> Recording:
    start = max(0, (recording.frames - most) // 2)
    return recording.with_points(recording.points[start : start + most].copy())
