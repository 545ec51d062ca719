"""Detectors on corrupted recordings."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mocapmend.bench.problems.corruption import Canvas, Corrupt, Corruptor, spike, swap
from mocapmend.bench.problems.recordings import HALVES, load
from mocapmend.bench.problems.rivals import RIVALS, best_threshold
from mocapmend.bench.problems.scores import Score, flagged
from mocapmend_algorithms import no_progress
from mocapmend_algorithms.problems import BadRun
from mocapmend_algorithms.problems.registry import detector
from mocapmend_algorithms.skeleton import skeleton_from_distances


@dataclass(frozen=True)
class Experiment:
    """A kind of error, and the detector that is to find it."""

    key: str
    detector: str
    errors: str
    corrupt: Corrupt
    target_f1: float | None = None
    rivals: bool = False


EXPERIMENTS = (
    Experiment("spikes-1", "spikes", "1 frame, 20-200 mm", spike(20, 200, 1, 1), 0.98, True),
    Experiment("spikes-5", "spikes", "2-5 frames, 20-200 mm", spike(20, 200, 2, 5), 0.98, True),
    Experiment("spikes-small", "spikes", "1-5 frames, 5-20 mm", spike(5, 20, 1, 5), None, True),
    Experiment("swaps", "swaps", "1-500 frames, 50 mm apart or more", swap(50, 1e9, 500), 0.95),
    Experiment("swaps-near", "swaps", "1-500 frames, 20-50 mm apart", swap(20, 50, 500)),
)


@dataclass(frozen=True, eq=False)
class Outcome:
    """What one way of finding errors did in an experiment on one half of the recordings."""

    experiment: Experiment
    half: str
    way: str
    score: Score
    seconds: float


def run_experiment(experiment: Experiment, data: Path, half: str, repeats: int) -> list[Outcome]:
    """Corrupt the recordings of a half, and look for the errors with the detector and its rivals."""
    corruptor = Corruptor(experiment.corrupt, seed=7 + repeats)
    score, seconds = Score(), 0.0
    canvases: list[Canvas] = []
    for _ in range(repeats):
        for name in HALVES[half]:
            canvas = corruptor.corrupted(load(data, name))
            start = time.process_time()
            runs = detect_one(experiment.detector, canvas)
            seconds += time.process_time() - start
            score.count(canvas, flagged(canvas.points.shape[:2], runs, both=True))
            canvases.append(canvas)
    outcomes = [Outcome(experiment, half, experiment.detector, score, seconds)]
    if experiment.rivals:
        outcomes += [_rival(experiment, half, canvases, name) for name in RIVALS]
    return outcomes


def detect_one(detector_id: str, canvas: Canvas) -> list[BadRun]:
    """Run one detector alone."""
    recording = canvas.recording
    way = detector(detector_id)
    skeleton = skeleton_from_distances(recording, no_progress)
    return way.function(recording, skeleton, way.params(), no_progress)


def _rival(experiment: Experiment, half: str, canvases: Sequence[Canvas], name: str) -> Outcome:
    measure, unit = RIVALS[name]
    start = time.process_time()
    sizes = [measure(canvas.recording) for canvas in canvases]
    truths = [canvas.truth() for canvas in canvases]
    limit = best_threshold(
        np.concatenate([size.ravel() for size in sizes]),
        np.concatenate([truth.ravel() for truth in truths]),
    )
    score = Score()
    for canvas, size in zip(canvases, sizes, strict=True):
        score.count(canvas, size >= limit)
    way = f"{name}, best: {limit:.3g} {unit}"
    return Outcome(experiment, half, way, score, time.process_time() - start)
