"""A scrambled recording, labelled; and how much of it is right."""

import time
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from mocapmend.bench.labels.naive import label_naively
from mocapmend.bench.labels.pairs import Pair, load
from mocapmend.bench.labels.scrambling import GHOST, Scrambled, scramble
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.labelling import LabelModel, LabelParams, label

HALF_LABELLED = 0.5
"""Share of the markers that keep their names."""


@dataclass(frozen=True, eq=False)
class Trial:
    """A pair, tried once.

    Attributes
    ----------
    pair : Pair
        What labels what.
    seed : int
        Of the scrambling.
    keep : float
        Share of the markers that kept their names; those samples are not counted.
    samples, right, none : int
        Samples of markers that the model knows; those that got their label; those that got none.
    ghosts, ghosts_labelled : int
        Samples of ghosts and of markers that the model does not know, and those with a label.
    naive : int or None
        How many the rival has right; None where it was not asked.
    seconds : float
        CPU time of the labelling.
    frames, points, pieces : int
        Size of what was labelled.
    confidence : ndarray, shape (proposals,)
        Of each piece that was given a label.
    correct : ndarray of bool, shape (proposals,)
        Whether it was right.
    lengths : ndarray of int, shape (proposals,)
        Its frames.
    """

    pair: Pair
    seed: int
    keep: float
    samples: int
    right: int
    none: int
    ghosts: int
    ghosts_labelled: int
    naive: int | None
    seconds: float
    frames: int
    points: int
    pieces: int
    confidence: FloatArray
    correct: BoolArray
    lengths: IntArray


@lru_cache(maxsize=16)
def model_of(data: Path, name: str) -> LabelModel:
    """Learn a recording."""
    return LabelModel.learn([load(data, name)])


def attempt(data: Path, pair: Pair, seed: int, keep: float, *, naive: bool) -> Trial:
    """Scramble a recording, label it, and compare."""
    model = model_of(data, pair.source)
    scrambled = scramble(load(data, pair.target), seed, keep=keep)
    recording = scrambled.recording
    start = time.process_time()
    found = label(recording, model, LabelParams(), no_progress)
    seconds = time.process_time() - start
    truth = _truth(scrambled, model)
    given = found.by_sample(truth.shape)
    open_ = np.ones(truth.shape, np.bool_)
    for proposal in found.proposals:
        if proposal.kept:
            open_[proposal.piece.start : proposal.piece.stop, proposal.piece.point] = False
    known, ghost = (truth >= 0) & open_, (truth == GHOST) & open_
    rival = label_naively(recording, model) if naive else None
    judged = [each for each in found.proposals if each.label is not None and not each.kept]
    share = np.array(
        [
            np.mean(truth[each.piece.start : each.piece.stop, each.piece.point] == each.label)
            for each in judged
        ]
    )
    return Trial(
        pair=pair,
        seed=seed,
        keep=keep,
        samples=int(known.sum()),
        right=int((given == truth)[known].sum()),
        none=int((given < 0)[known].sum()),
        ghosts=int(ghost.sum()),
        ghosts_labelled=int((given >= 0)[ghost].sum()),
        naive=None if rival is None else int((rival == truth)[known].sum()),
        seconds=seconds,
        frames=recording.frames,
        points=recording.markers,
        pieces=len(found.proposals),
        confidence=np.array([each.confidence for each in judged]),
        correct=share > 0.5,
        lengths=np.array([each.piece.length for each in judged], np.int64),
    )


def _truth(scrambled: Scrambled, model: LabelModel) -> IntArray:
    """Return the model's label of each sample; what the model does not know is a ghost."""
    index = {name: k for k, name in enumerate(model.labels)}
    known = np.array([index.get(name, GHOST) for name in scrambled.labels])
    truth = scrambled.truth
    return np.where(truth >= 0, known[np.maximum(truth, 0)], truth)
