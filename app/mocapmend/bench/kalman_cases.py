"""The recordings of `bench kalman`: a hip and a knee marker are lost for long spans (L21)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files import read_recording
from mocapmend.files.formats import FORMATS
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.arrays import FloatArray

RATE, FRAMES = 120.0, 600
BUNDLED = "walk_cmu_02_01.c3d"
LOST = {"RFWT": (160, 340), "RKNE": (330, 510)}
"""Marker and frames lost, of 600: L21's raw curve drops at 160 and 330."""
SEGMENTS = (
    ("LFHD", "RFHD", "LBHD", "RBHD", "ANT", "NOSE"),
    ("C7", "T10", "CLAV", "STRN", "RBAC"),
    ("LFWT", "RFWT", "LBWT", "RBWT"),
    ("LSHO", "LUPA", "LELB"),
    ("RSHO", "RUPA", "RELB"),
    ("LELB", "LFRM", "LWRA", "LWRB", "LFIN"),
    ("RELB", "RFRM", "RWRA", "RWRB", "RFIN"),
    ("LFWT", "LTHI", "LKNE"),
    ("RFWT", "RTHI", "RKNE"),
    ("LKNE", "LSHN", "LANK", "LHEE", "LTOE", "LMT5"),
    ("RKNE", "RSHN", "RANK", "RHEE", "RTOE", "RMT5"),
)
"""Eleven rigid segments, as many as the paper's, on the 41-marker set of the CMU database."""


@dataclass(frozen=True, eq=False)
class Case:
    """A recording without gaps, and what is lost of it.

    Attributes
    ----------
    name : str
        Of the file.
    reference : Recording
        600 frames, or all where there are fewer.
    gaps : tuple of Gap
        The spans that are lost.
    segments : tuple of tuple of int
        Markers of each rigid segment.
    """

    name: str
    reference: Recording
    gaps: tuple[Gap, ...]
    segments: tuple[tuple[int, ...], ...]

    @property
    def raw(self) -> Recording:
        """The recording without the lost samples."""
        points = self.reference.points.copy()
        for gap in self.gaps:
            points[gap.start : gap.stop, gap.marker] = np.nan
        return self.reference.with_points(points)

    def frame(self, of_600: int) -> int:
        """Return the frame of this recording that stands for one of 600."""
        return of_600 * self.reference.frames // FRAMES


def bundled() -> list[Case]:
    """Return the bundled walk, whose 343 frames stand for 600."""
    with as_file(files("mocapmend_resources") / "samples" / BUNDLED) as path:
        recording = read_recording(path).recording
    found = make_case(BUNDLED, recording, recording.frames)
    assert found is not None
    return [found]


def of_folder(folder: Path) -> list[Case]:
    """Return the recordings of a folder that have the markers and 600 frames at 120 Hz.

    Raises
    ------
    MocapmendError
        If there is no such folder, or no such recording in it.
    """
    if not folder.is_dir():
        raise MocapmendError("There is no such folder.", str(folder), "Check its name.")
    found = list(_cases(folder))
    if not found:
        raise MocapmendError(
            "No recording here has the 41-marker set and 600 frames at 120 Hz without gaps.",
            str(folder),
            "Leave out --data to use the bundled walk.",
        )
    return found


def make_case(name: str, recording: Recording, frames: int) -> Case | None:
    """Lose the markers in the middle frames of a recording; None where it does not suit."""
    labels = [label.rpartition(":")[2].upper() for label in recording.labels]
    at = {label: marker for marker, label in enumerate(labels)}
    if not LOST.keys() <= at.keys() or recording.frames < frames:
        return None
    start = (recording.frames - frames) // 2
    points = recording.points[start : start + frames].copy()
    lost = [at[label] for label in LOST]
    if np.isnan(points[:, lost]).any():
        return None
    segments = tuple(tuple(at[m] for m in segment if m in at) for segment in SEGMENTS)
    spans = [(a * frames // FRAMES, b * frames // FRAMES) for a, b in LOST.values()]
    gaps = tuple(Gap(m, a, b) for m, (a, b) in sorted(zip(lost, spans, strict=True)))
    return Case(name, recording.with_points(points), gaps, segments)


def filled(case: Case, values: Sequence[tuple[Gap, FloatArray]]) -> Recording:
    """Return the raw recording with some of its gaps filled."""
    points = case.raw.points.copy()
    for gap, part in values:
        points[gap.start : gap.stop, gap.marker] = part
    return case.reference.with_points(points)


def _cases(folder: Path) -> Iterator[Case]:
    known = {suffix for kind in FORMATS for suffix in kind.suffixes}
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() not in known or not path.is_file():
            continue
        try:
            recording = read_recording(path).recording
        except MocapmendError:
            continue
        if abs(recording.rate - RATE) < 1:
            case = make_case(path.name, recording, FRAMES)
            if case is not None:
                yield case
