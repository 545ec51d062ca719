"""The recordings of `bench poses`: what is lost of them, and which other trials teach."""

from dataclasses import dataclass
from functools import cached_property
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.gaps import runs

BUNDLED = "walk_cmu_02_01.c3d"
REPETITIVE, COMPLEX = "repetitive", "complex"
MOST_LOST = 0.5
"""Share of a recording that a gap may take."""
LEAST_SEEN = 5
"""Markers that must be left."""


@dataclass(frozen=True)
class Trial:
    """A recording of the shared folder.

    Attributes
    ----------
    motion : str
        What is done in it.
    kind : str
        `REPETITIVE` or `COMPLEX`.
    file : str
        In the folder.
    others : tuple of str
        Names of trials of the same motion by the same person, in the folder of joints.
    """

    motion: str
    kind: str
    file: str
    others: tuple[str, ...] = ()


JOINTS, MARKERS = "cmu_joints", "cmu_markers"
TRIALS = (
    Trial("walk", REPETITIVE, f"{JOINTS}/07_03.npz", ("07_01", "07_02", "07_12")),
    Trial(
        "run",
        REPETITIVE,
        f"{JOINTS}/09_05.npz",
        ("09_02", "09_03", "09_04", "09_06", "09_08", "09_09", "09_10", "09_11"),
    ),
    Trial("walk, swinging shoulders", REPETITIVE, f"{MARKERS}/132_43.npz"),
    Trial("dance", COMPLEX, f"{JOINTS}/05_18.npz", ("05_02", "05_06")),
    Trial(
        "basketball",
        COMPLEX,
        f"{JOINTS}/06_15.npz",
        ("06_03", "06_04", "06_05", "06_06", "06_07", "06_08", "06_09", "06_10", "06_11", "06_14"),
    ),
    Trial("football, catch and throw", COMPLEX, f"{MARKERS}/143_22.npz"),
)
"""None is among those that the defaults of `pose-code` were chosen on."""


@dataclass(frozen=True, eq=False)
class Subject:
    """A complete recording to be repaired.

    Attributes
    ----------
    motion, kind : str
        See `Trial`.
    truth : Recording
        Without gaps.
    others : tuple of Recording
        That teach; none where there are none.
    """

    motion: str
    kind: str
    truth: Recording
    others: tuple[Recording, ...] = ()


@dataclass(frozen=True, eq=False)
class Case:
    """What is lost of a recording.

    Attributes
    ----------
    subject : Subject
        Whose.
    gaps : tuple of Gap
        Of the same frames.
    """

    subject: Subject
    gaps: tuple[Gap, ...]

    @cached_property
    def recording(self) -> Recording:
        """What is left."""
        points = self.subject.truth.points.copy()
        for gap in self.gaps:
            points[gap.start : gap.stop, gap.marker] = np.nan
        return self.subject.truth.with_points(points)


def bundled() -> list[Subject]:
    """Return the bundled walk."""
    with as_file(files("mocapmend_resources") / "samples" / BUNDLED) as path:
        return [Subject("walk", REPETITIVE, _complete(path))]


def of_folder(folder: Path) -> list[Subject]:
    """Return the recordings of the shared folder that are there.

    Raises
    ------
    MocapmendError
        If none is, or one cannot be read.
    """
    found = [
        Subject(
            trial.motion,
            trial.kind,
            _complete(folder / trial.file),
            tuple(_complete(path) for path in _others(folder, trial)),
        )
        for trial in TRIALS
        if (folder / trial.file).exists()
    ]
    if not found:
        raise MocapmendError(
            "None of the recordings that this benchmark knows is here.",
            str(folder),
            "Give the folder that holds cmu_joints and cmu_markers, or leave out --data.",
        )
    return found


def lose(subject: Subject, seconds: float, markers: int, number: int, count: int) -> Case | None:
    """Lose markers drawn by lot, all in the same frames.

    Parameters
    ----------
    subject : Subject
        Of which.
    seconds : float
        How long.
    markers : int
        How many.
    number, count : int
        Which of how many cases of the kind: they are evenly spread over the recording.

    Returns
    -------
    Case or None
        None where the gap would take more than half the recording, or nearly all markers.
    """
    truth = subject.truth
    length = max(round(seconds * truth.rate), 1)
    if length > MOST_LOST * truth.frames or markers > truth.markers - LEAST_SEEN:
        return None
    start = 1 + round((number + 0.5) / count * (truth.frames - length - 2))
    lot = np.random.default_rng([number, truth.frames]).permutation(truth.markers)
    lost = sorted(lot[:markers].tolist())
    return Case(subject, tuple(Gap(marker, start, start + length) for marker in lost))


def _others(folder: Path, trial: Trial) -> list[Path]:
    paths = [folder / JOINTS / f"{name}.npz" for name in trial.others]
    return [path for path in paths if path.exists()]


def _complete(path: Path) -> Recording:
    """Read the longest run of frames that shows all markers."""
    recording = read_recording(path).recording
    whole = runs(np.asarray(recording.present.all(axis=1))) or [(0, 0)]
    start, stop = max(whole, key=lambda run: run[1] - run[0])
    return recording.with_points(recording.points[start:stop].copy())
