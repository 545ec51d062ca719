"""The recordings, and which of them label which."""

from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import permutations
from pathlib import Path

from mocapmend.files import read_recording
from mocapmend_algorithms import Recording
from mocapmend_algorithms.names import is_meaningful, without_subject

FOLDER = "cmu_markers"
FILES = {
    "132_32": "132_32.npz",
    "132_43": "132_43.npz",
    "127_07": "127_07.npz",
    "143_22": "143_22.npz",
    "02_01": "cmu_02_01.c3d",
    "HDM_mm": "mr_HDM_mm_01-02_03_120.c3d",
    "135_07": "135_07.npz",
    "135_02": "mr_135_02.c3d",
    "85_02": "mr_85_02.c3d",
    "141_16": "141_16.npz",
}
TRAIN = ("132", "127", "143", "02", "HDM")
"""Subjects that the program was tuned on; the others are for validation."""
HALVES = ("train", "validation")
SAME, ACROSS, OTHER_SET = "same subject", "across subjects", "across, other label set"
KINDS = (SAME, ACROSS, OTHER_SET)


@dataclass(frozen=True)
class Pair:
    """A recording to label, and the one to learn from.

    Attributes
    ----------
    target, source : str
        Keys of `FILES`.
    kind : str
        One of `KINDS`.
    half : str
        One of `HALVES`; no subject is in both.
    """

    target: str
    source: str
    kind: str
    half: str


def subject(name: str) -> str:
    """Return who was recorded."""
    return name.partition("_")[0]


def half(name: str) -> str:
    """Return the half that a recording belongs to."""
    return HALVES[0] if subject(name) in TRAIN else HALVES[1]


def pairs(data: Path) -> list[Pair]:
    """Return all pairs of recordings of the same half."""
    labels = {name: set(map(without_subject, load(data, name).labels)) for name in FILES}
    found = []
    for target, source in permutations(FILES, 2):
        if half(target) != half(source):
            continue
        if subject(target) == subject(source):
            kind = SAME
        else:
            kind = ACROSS if labels[target] == labels[source] else OTHER_SET
        found.append(Pair(target, source, kind, half(target)))
    return found


@lru_cache(maxsize=len(FILES))
def load(data: Path, name: str) -> Recording:
    """Read a recording, without the points that have no name.

    Raises
    ------
    MocapmendError
        If it cannot be read.
    """
    recording = read_recording(data / FOLDER / FILES[name]).measured
    named = [k for k, label in enumerate(recording.labels) if is_meaningful(label)]
    labels = tuple(recording.labels[k] for k in named)
    return replace(recording, points=recording.points[:, named], labels=labels)
