"""Training a network so that it can be broken off at any time and gone on with later."""

import hashlib
import io
import json
import pickle
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mocapmend.errors import MocapmendError
from mocapmend.files.atomic import write_bytes
from mocapmend.files.opening import read_whole
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.refine.model import LARGEST_FILE, Model
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.train.pairs import Pair
from mocapmend_algorithms.refine.train.settings import Settings

if TYPE_CHECKING:
    from mocapmend_algorithms.refine.train.loop import Training

STATE = ".training"
"""Behind the name of a model: what is needed to go on with its training."""
BROKEN = (RuntimeError, ValueError, KeyError, TypeError, EOFError, pickle.UnpicklingError)


@dataclass(frozen=True)
class Course:
    """What is trained, from what, and where its state is kept.

    Attributes
    ----------
    profile : Profile
        What is learnt.
    settings : Settings
        How.
    state : Path
        A file that is written after each round.
    card : mapping
        What the model's card says beside what the training knows itself.
    """

    profile: Profile
    settings: Settings
    state: Path
    card: Mapping[str, Any] = field(default_factory=dict)


def state_path(out: Path) -> Path:
    """Return where the training of a model keeps its state."""
    return out.with_name(out.name + STATE)


def learn(course: Course, pairs: Sequence[Pair], progress: Progress, *, resume: bool) -> Model:
    """Train a network to the end.

    Parameters
    ----------
    course : Course
        What and how.
    pairs : sequence of Pair
        To learn from.
    progress : Progress
        Called after each step; where it raises, the rounds that are done are kept.
    resume : bool
        Whether to go on with the state that is there, if there is one.

    Raises
    ------
    MocapmendError
        If PyTorch is not installed, an output is nowhere to be seen, or the state is of another
        training.
    """
    loop = _loop()
    _check(course, pairs)
    training: Training = loop.Training(pairs, course.profile, course.settings)
    key = _key(course, pairs)
    if resume and course.state.exists():
        _restore(training, course.state, key)
    training.run(progress, lambda done: _keep(done, course.state, key))
    return _model(course, training, pairs)


def _loop() -> Any:
    try:
        from mocapmend_algorithms.refine.train import loop
    except ImportError as error:
        raise MocapmendError(
            f"Training needs PyTorch, which cannot be loaded: {error}.",
            todo="Install it with: pip install “mocapmend[train]”. Refining does not need it.",
        ) from error
    return loop


def _check(course: Course, pairs: Sequence[Pair]) -> None:
    """Refuse pairs that do not show what is to be learnt."""
    seen = np.any([~np.isnan(pair.markers[..., 0]).all(axis=0) for pair in pairs], axis=0)
    labels = zip(course.profile.outputs, seen.tolist(), strict=True)
    if lacking := [label for label, there in labels if not there]:
        raise MocapmendError(
            f"No reference shows these markers: {', '.join(lacking)}.",
            todo="Add pairs that do, or choose another profile.",
        )


def _key(course: Course, pairs: Sequence[Pair]) -> str:
    """Return a digest of all that the outcome depends on."""
    digest = hashlib.sha256()
    for part in (course.profile, course.settings):
        digest.update(json.dumps(asdict(part), sort_keys=True).encode())
    for pair in pairs:
        for array in (pair.joints, pair.markers):
            digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def _keep(training: "Training", path: Path, key: str) -> None:
    import torch

    stream = io.BytesIO()
    torch.save({"key": key, **training.state()}, stream)
    write_bytes(path, stream.getvalue())


def _restore(training: "Training", path: Path, key: str) -> None:
    import torch

    todo = "Leave out --resume to begin anew, or give the same pairs and settings."
    try:
        raw = read_whole(path, 4 * LARGEST_FILE)
        state = torch.load(io.BytesIO(raw), weights_only=True)
        same = state["key"] == key
        if same:
            training.resume(state)
    except BROKEN as error:
        raise MocapmendError("This is no state of a training.", str(path), todo) from error
    if not same:
        raise MocapmendError(
            "The training that was broken off had other pairs or settings.", str(path), todo
        )


def _model(course: Course, training: "Training", pairs: Sequence[Pair]) -> Model:
    import torch

    frames = sum(len(pair.joints) for pair in pairs)
    card = {
        **course.card,
        "settings": asdict(course.settings),
        "pairs": len(pairs),
        "frames": frames,
        "performers": len({pair.performer for pair in pairs}),
        "movements": len({pair.movement for pair in pairs}),
        "curve": [[one.stage, one.number, round(one.loss, 5)] for one in training.curve],
        "pytorch": torch.__version__,
    }
    shape = course.settings.shape(course.profile)
    return Model(
        course.profile,
        shape,
        training.scaling,
        training.weights(),
        card,
        mirrored=course.settings.changes.mirrors,
    )
