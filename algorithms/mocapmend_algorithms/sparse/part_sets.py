"""Training sets with dictionaries of the parts of a skeleton: made, gone on with, and used."""

from collections.abc import Callable
from dataclasses import asdict, replace

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.sparse.body import Body, find_body
from mocapmend_algorithms.sparse.part_rows import SPAN, PartDictionary
from mocapmend_algorithms.sparse.part_training import PartSettings, assemble_part, train_part
from mocapmend_algorithms.sparse.training_set import TrainingSet, TrainingSetError


def train_parts(
    training: TrainingSet,
    settings: PartSettings,
    progress: Progress,
    keep: Callable[[TrainingSet], None] = lambda _: None,
) -> TrainingSet:
    """Train the dictionaries of all parts on a training set, and put them into it.

    Parameters
    ----------
    training : TrainingSet
        Of a skeleton. Dictionaries that it has already with the same settings are kept, so that
        a training that was broken off goes on.
    settings : PartSettings
        How.
    progress : Progress
        Called often.
    keep : callable, optional
        Gets the training set after each part, to keep what is done.

    Returns
    -------
    TrainingSet
        With `part 0`, ... among its atoms, and the settings and the objectives after each round.

    Raises
    ------
    TrainingSetError
        If its bones do not keep their lengths exactly, as those between markers on skin, or its
        parts are too short for a window.
    """
    body = body_of(training)
    motions = _long_enough(training)
    if training.settings.get("parts") != asdict(settings):
        training = replace(training, atoms={}, settings={"parts": asdict(settings)})
    for at in range(len(body.parts)):
        name = f"part {at}"
        if name not in training.atoms:
            share = part(progress, at / len(body.parts), (at + 1) / len(body.parts))
            state = train_part(motions, body, at, settings, share)
            objectives = {**training.settings.get("objectives", {}), name: list(state.objectives)}
            training = replace(
                training,
                atoms={**training.atoms, name: state.dictionary},
                settings={**training.settings, "objectives": objectives},
            )
            keep(training)
    progress(1.0)
    return training


def going_on(training: TrainingSet, earlier: TrainingSet | None) -> TrainingSet:
    """Take over the dictionaries of an earlier set of the same motion; those of another are not."""
    if (
        earlier is None
        or earlier.labels != training.labels
        or earlier.lengths != training.lengths
        or not np.array_equal(earlier.poses, training.poses.astype(np.float32))
    ):
        return training
    return replace(training, atoms=earlier.atoms, settings=earlier.settings)


def parts_of(training: TrainingSet, body: Body) -> dict[int, PartDictionary]:
    """Return the trained dictionaries of a training set, whose bones are those of `body_of`.

    Raises
    ------
    TrainingSetError
        If it has none, or not for all parts of its skeleton.
    """
    motions = _long_enough(training)
    atoms = [training.atoms.get(f"part {at}") for at in range(len(body.parts))]
    found = {
        at: assemble_part(motions, body, at, part)
        for at, part in enumerate(atoms)
        if part is not None
    }
    if len(found) < len(atoms) or any(
        part.atoms.shape[0] != part.mean.size for part in found.values()
    ):
        raise TrainingSetError("the training set has no trained dictionaries of all parts")
    return found


def body_of(training: TrainingSet) -> Body:
    """Return the bones of a training set.

    Raises
    ------
    TrainingSetError
        If they do not keep their lengths exactly.
    """
    first = training.poses[: training.lengths[0]]
    recording = Recording(first, training.labels, training.rate, "mm", training.up)
    body = find_body(recording, recording.present)
    if not body.exact or np.count_nonzero(body.parents < 0) != 1:
        raise TrainingSetError(
            "dictionaries with bones are trained on skeletons, whose bones keep their lengths; "
            "these are markers on skin"
        )
    return body


def _long_enough(training: TrainingSet) -> list[FloatArray]:
    motions = [m for m in training.motions(training.up) if len(m) >= SPAN.reach]
    if not motions:
        raise TrainingSetError(
            f"no unbroken part of the training set has the {SPAN.reach} frames of a window"
        )
    return motions
