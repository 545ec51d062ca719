"""What the detectors find in recordings as they are."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mocapmend.bench.problems.recordings import load
from mocapmend.bench.problems.scores import flagged
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.problems import BadRun, detect
from mocapmend_algorithms.problems.registry import DETECTORS
from mocapmend_algorithms.skeleton import skeleton_from_distances


@dataclass(frozen=True)
class Found:
    """What was found in one recording.

    Attributes
    ----------
    recording : str
        Its name.
    samples : int
        Samples that are there.
    flagged : dict of str to int
        Samples that are called bad, by the kind of error.
    worst : str
        The run of the largest deviation, in words.
    """

    recording: str
    samples: int
    flagged: dict[str, int]
    worst: str

    @property
    def all_flagged(self) -> int:
        """Samples that are called bad."""
        return sum(self.flagged.values())


def look(data: Path, name: str) -> Found:
    """Run all detectors on a recording as it is."""
    recording = load(data, name)
    runs = detect(recording, skeleton_from_distances(recording, no_progress), None, no_progress)
    counts = {}
    for kind in DETECTORS:
        some = [run for run in runs if run.kind == kind]
        mask = flagged(recording.present.shape, some, both=kind == "swaps")
        counts[kind] = int(np.count_nonzero(mask & recording.present))
    known = [run for run in runs if run.deviation == run.deviation]
    worst = max(known, key=lambda run: run.deviation, default=None)
    text = "" if worst is None else _text(worst, recording.labels, recording.first_frame)
    return Found(name, int(recording.present.sum()), counts, text)


def _text(run: BadRun, labels: tuple[str, ...], first_frame: int) -> str:
    return f"{run.kind}, {labels[run.marker]}, frame {first_frame + run.start}: {run.reason}"
