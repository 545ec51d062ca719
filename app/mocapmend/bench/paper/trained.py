"""The dictionaries of W18 as printed: trained once for a set of trials, and kept.

They are kept in the user's cache folder, named after what they were trained on and how.
"""

import hashlib
import json
import time
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from platformdirs import user_cache_path

from mocapmend.bench.memory import peak_mb
from mocapmend.bench.paper.status import say
from mocapmend.bench.paper.trials import Trial
from mocapmend.files.atomic import write_atomically
from mocapmend_algorithms import Recording
from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.sparse.body import Body, find_body
from mocapmend_algorithms.sparse.part_rows import PartDictionary
from mocapmend_algorithms.sparse.part_training import PartSettings, assemble_part, train_part

FORMAT = 1
ATOMS = {"run": 500, "basketball": 1000, "punch": 300}
"""Of each part's dictionary: W18 has 1000, but not so few windows."""
DAMAGED = (
    OSError, EOFError, ValueError, TypeError, AttributeError, LookupError, RuntimeError,
    zipfile.BadZipFile, zlib.error,
)  # fmt: skip
"""What comes of a file whose content is not what it should be."""


@dataclass(frozen=True, eq=False)
class TrainedParts:
    """Dictionaries of the five parts, and what it took to train them.

    Attributes
    ----------
    dictionaries : mapping of int to PartDictionary
        By the number of the part.
    objectives : mapping of int to tuple of float
        After each round.
    frames : int
        That were trained on.
    seconds : float
        Of training, when it was done.
    memory_mb : float
        The most that the process held by the end of it, NaN where the system does not say.
    """

    dictionaries: Mapping[int, PartDictionary]
    objectives: Mapping[int, tuple[float, ...]]
    frames: int
    seconds: float
    memory_mb: float


def parts_for(trial: Trial, settings: PartSettings) -> TrainedParts:
    """Train the five dictionaries on a trial's teachers, or take them from the cache."""
    motions = [recording.points * recording.mm for recording in trial.teachers]
    first = trial.teachers[0]
    body = find_body(first, first.present)
    path = _path(trial.teachers, settings)
    if path.is_file():
        kept = _read(path, motions, body)
        if kept is not None:
            return kept
    began = time.perf_counter()
    atoms: dict[str, FloatArray] = {}
    objectives: dict[int, tuple[float, ...]] = {}
    for at in range(len(body.parts)):

        def tell(share: float, at: int = at) -> None:
            say(f"training part {at + 1} of 5: {100 * share:3.0f} %")

        state = train_part(motions, body, at, settings, tell)
        atoms[f"part {at}"] = state.dictionary
        objectives[at] = state.objectives
    head = {
        "format": FORMAT,
        "objectives": objectives,
        "seconds": time.perf_counter() - began,
        "memory_mb": peak_mb() or float("nan"),
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    arrays = {"head": np.array(json.dumps(head)), **atoms}
    write_atomically(path, lambda stream: np.savez(stream, **arrays), lambda _: None)  # type: ignore[arg-type]
    kept = _read(path, motions, body)
    assert kept is not None
    return kept


def _path(teachers: tuple[Recording, ...], settings: PartSettings) -> Path:
    digest = hashlib.sha256(json.dumps([FORMAT, *vars(settings).items()]).encode())
    for recording in teachers:
        digest.update(np.ascontiguousarray(recording.points).tobytes())
    return user_cache_path("mocapmend") / "bench-paper" / f"{digest.hexdigest()[:32]}.npz"


def _read(path: Path, motions: list[FloatArray], body: Body) -> TrainedParts | None:
    """Read what is kept; None where it is damaged."""
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            head = json.loads(str(archive["head"]))
            atoms = {at: archive[f"part {at}"] for at in range(len(body.parts))}
            objectives = {int(at): tuple(values) for at, values in head["objectives"].items()}
            seconds, memory_mb = float(head["seconds"]), float(head["memory_mb"])
    except DAMAGED:
        return None
    return TrainedParts(
        {at: assemble_part(motions, body, at, part) for at, part in atoms.items()},
        objectives,
        sum(len(motion) for motion in motions),
        seconds,
        memory_mb,
    )


class Trained:
    """The trained dictionaries of the trials."""

    def __init__(self, rounds: int, atoms: int | None) -> None:
        self._rounds, self._atoms = rounds, atoms
        self._known: dict[tuple[int, ...], TrainedParts] = {}

    def of(self, trial: Trial) -> TrainedParts:
        """Train, or take from memory or the cache."""
        key = tuple(id(recording) for recording in trial.teachers)
        if key not in self._known:
            settings = PartSettings(self._atoms or ATOMS[trial.motion], self._rounds)
            self._known[key] = parts_for(trial, settings)
        return self._known[key]
