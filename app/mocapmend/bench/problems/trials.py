"""Detectors on corrupted recordings."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from mocapmend.bench.problems.corruption import Canvas, Corruptor
from mocapmend.bench.problems.experiments import Experiment
from mocapmend.bench.problems.recordings import HALVES, load
from mocapmend.bench.problems.rivals import RIVALS, best_threshold
from mocapmend.bench.problems.scores import Score, flagged
from mocapmend_algorithms import Recording, no_progress
from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.problems import BadRun, detect
from mocapmend_algorithms.problems.registry import detector
from mocapmend_algorithms.skeleton import Skeleton, skeleton_from_distances

SEED = 7
LOOK_AT_BONES = ("fragments", "bone-breaks", "reflections")
"""Detectors; for the others the search for a skeleton can be saved."""
NO_BONES = Skeleton("", (), "none")
BESIDE = 3
"""Frames beside what is found in the untouched recording that belong to it."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """What one way of finding errors did in an experiment on one half of the recordings.

    Attributes
    ----------
    experiment : Experiment
        What was put in.
    half : str
        Which recordings.
    way : str
        Who looked for it.
    score : Score
        How well it was found.
    exact : float
        Of the swaps found, the share that an exchange takes back exactly; NaN of other errors.
    seconds : float
        CPU time of the search.
    """

    experiment: Experiment
    half: str
    way: str
    score: Score
    exact: float
    seconds: float


def run_experiment(experiment: Experiment, data: Path, half: str, repeats: int) -> list[Outcome]:
    """Corrupt the recordings of a half; look for the errors with the detector and its rivals."""
    corruptor = Corruptor(experiment.corrupt, SEED)
    canvases = [
        (corruptor.corrupted(load(data, name)), own_errors(data, name))
        for _ in range(repeats * experiment.repeats)
        for name in HALVES[half]
    ]
    score, taken_back = Score(), []
    start = time.process_time()
    for canvas, own in canvases:
        runs = detect_one(experiment, canvas.recording)
        score.count(canvas, _mask(canvas, runs), own)
        if experiment.detector == "swaps":
            taken_back += _taken_back(canvas, runs)
    seconds = time.process_time() - start
    exact = float(np.mean(taken_back)) if taken_back else float("nan")
    outcomes = [Outcome(experiment, half, experiment.detector, score, exact, seconds)]
    if experiment.rivals:
        outcomes += [_rival(experiment, half, canvases, name) for name in RIVALS]
    return outcomes


def detect_one(experiment: Experiment, recording: Recording) -> list[BadRun]:
    """Run the detector of an experiment alone."""
    way = detector(experiment.detector)
    bones = experiment.detector in LOOK_AT_BONES
    skeleton = skeleton_from_distances(recording, no_progress) if bones else NO_BONES
    params = way.params(**experiment.params)
    return way.function(recording, skeleton, params, no_progress)


@lru_cache(maxsize=64)
def own_errors(data: Path, name: str) -> BoolArray:
    """Return what all detectors find in an untouched recording, and what is next to it."""
    recording = load(data, name)
    runs = detect(recording, skeleton_from_distances(recording, no_progress), None, no_progress)
    found = flagged(recording.present.shape, runs, both=True)
    wide = found.copy()
    for shift in range(1, BESIDE + 1):
        wide[shift:] |= found[:-shift]
        wide[:-shift] |= found[shift:]
    return wide


def _mask(canvas: Canvas, runs: Sequence[BadRun]) -> BoolArray:
    """Return the samples that are found; a piece counts only if its marker is right."""
    belongs = {error.markers[0]: error.belongs_to for error in canvas.errors}
    kept = [run for run in runs if run.kind != "fragments" or belongs.get(run.marker) == run.other]
    both = any(run.kind == "swaps" for run in kept)
    return flagged(canvas.points.shape[:2], kept, both=both) & canvas.recording.present


def _taken_back(canvas: Canvas, runs: Sequence[BadRun]) -> list[bool]:
    """Exchange what is said to be swapped; tell of each swap found whether all is as it was."""
    points = canvas.points.copy()
    for run in runs:
        assert run.other is not None
        pair = [run.marker, run.other]
        points[run.start : run.stop, pair] = points[run.start : run.stop, pair[::-1]]
    right = (points == canvas.source.points) | np.isnan(points)
    exact = []
    for error in canvas.errors:
        mine = [
            run
            for run in runs
            if {run.marker, run.other} == set(error.markers)
            and run.start < error.stop
            and error.start < run.stop
        ]
        if mine:
            low = min(error.start, *(run.start for run in mine))
            high = max(error.stop, *(run.stop for run in mine))
            exact.append(bool(right[low:high, list(error.markers)].all()))
    return exact


def _rival(
    experiment: Experiment, half: str, canvases: Sequence[tuple[Canvas, BoolArray]], name: str
) -> Outcome:
    measure, unit = RIVALS[name]
    start = time.process_time()
    sizes = [measure(canvas.recording) for canvas, _ in canvases]
    truths = [canvas.truth() for canvas, _ in canvases]
    judged = [truth | ~own for truth, (_, own) in zip(truths, canvases, strict=True)]
    limit = best_threshold(
        np.concatenate([size[mask] for size, mask in zip(sizes, judged, strict=True)]),
        np.concatenate([truth[mask] for truth, mask in zip(truths, judged, strict=True)]),
    )
    score = Score()
    for (canvas, own), size in zip(canvases, sizes, strict=True):
        score.count(canvas, size >= limit, own)
    way = f"{name}, best: {limit:.3g} {unit}"
    seconds = time.process_time() - start
    return Outcome(experiment, half, way, score, float("nan"), seconds)
