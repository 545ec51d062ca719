"""A method that learns from a training set, for tests of what surrounds such methods."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from mocapmend_algorithms import Gap, Progress, Recording
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.registry import METHODS, Method
from mocapmend_algorithms.params import training_option
from mocapmend_algorithms.sparse.training_set import (
    gather,
    read_training_set,
    write_training_set,
)
from mocapmend_resources import training


@dataclass(frozen=True)
class TaughtParams:
    training: str = training_option("What to learn from.")


def fill(
    recording: Recording, gaps: Sequence[Gap], params: TaughtParams, progress: Progress, /
) -> FillResult:
    """Put the mean pose of the training set into the gaps; zeros without one."""
    places = np.zeros((recording.markers, 3))
    if params.training:
        known = read_training_set(Path(params.training))
        places[known.places_of(recording.labels)] = known.poses.mean(axis=0) / recording.mm
    progress(1.0)
    sure = [np.ones(gap.length) for gap in gaps]
    values = [np.tile(places[gap.marker], (gap.length, 1)) for gap in gaps]
    return FillResult(
        tuple(Patch(gap, v, s, s) for gap, v, s in zip(gaps, values, sure, strict=True))
    )


def install(monkeypatch: pytest.MonkeyPatch) -> Method:
    """Make the method one of the program's."""
    method = Method("taught", "Taught", "Low rank", fill, TaughtParams, "Learns.", True)
    monkeypatch.setitem(METHODS, method.id, method)
    return method


def ship(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the files of a folder be those that ship with the program."""
    folder.mkdir(exist_ok=True)
    monkeypatch.setattr(training, "FOLDER", folder)


def write_set(path: Path, recording: Recording, shift: float = 0.0) -> Path:
    """Write a training set of a recording, moved by some mm."""
    moved = recording.with_points(recording.points + shift / recording.mm)
    write_training_set(gather([moved]), path)
    return path
