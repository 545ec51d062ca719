"""Snapshots of a recording for background jobs: those of one state are one."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from enum import Enum, auto

import numpy as np
from numpy.typing import NDArray

from mocapmend.shared_recording import Changed, SharedRecording
from mocapmend.written import places_of
from mocapmend_algorithms import Gap, Recording


class Layer(Enum):
    """What is shared: the file's measured samples, what is believed of them, or all as it is."""

    ORIGINAL = auto()
    BASE = auto()
    CURRENT = auto()


class Shares:
    """Makes snapshots that differ from the samples of a file in some runs.

    Parameters
    ----------
    recording : Recording
        The samples as the file has them; never changed.
    """

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self._file: SharedRecording | None = None
        self._known: dict[Layer, tuple[int, SharedRecording]] = {}

    def rename(self, labels: Sequence[str]) -> None:
        """Give other labels to the markers of what is shared from now on."""
        self._recording = replace(self._recording, labels=tuple(labels))
        self._file = None
        self._known.clear()

    def get(
        self,
        layer: Layer,
        revision: int,
        runs: Callable[[], Collection[Gap]],
        points: NDArray[np.float64],
    ) -> SharedRecording:
        """Return a snapshot of a layer; all of a revision get the same.

        Parameters
        ----------
        layer : Layer
            Which.
        revision : int
            Tells its states apart.
        runs : callable
            Returns where it may differ from the file.
        points : ndarray, shape (frames, markers, 3)
            Its samples.
        """
        known = self._known.get(layer)
        if known is None or known[0] != revision:
            known = self._known[layer] = revision, self.make(runs(), points)
        return known[1]

    def make(self, runs: Collection[Gap], points: NDArray[np.float64]) -> SharedRecording:
        """Return a snapshot of the samples of the file, but those of some runs."""
        if self._file is None:
            self._file = SharedRecording(self._recording)
        if not runs:
            return self._file
        frames, markers = places = places_of(runs)
        return self._file.with_changes(Changed(frames, markers, points[places]))
