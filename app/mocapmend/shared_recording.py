"""A recording in shared memory: workers read it without a copy through a pipe."""

from multiprocessing import resource_tracker
from multiprocessing.shared_memory import SharedMemory
from typing import Any
from weakref import finalize

import numpy as np

from mocapmend_algorithms import Recording


def _release(memory: SharedMemory) -> None:
    memory.close()
    memory.unlink()


class SharedRecording:
    """A snapshot of a recording that travels to a worker by name.

    The memory lives as long as this object; a job holds it until the job has ended.

    Parameters
    ----------
    recording : Recording
        What is copied.
    revision : int
        Of the document that it was taken from.
    """

    def __init__(self, recording: Recording, revision: int) -> None:
        self.revision = revision
        self._meta: dict[str, Any] = {
            "labels": recording.labels,
            "rate": recording.rate,
            "unit": recording.unit,
            "up": recording.up,
            "first_frame": recording.first_frame,
        }
        self._shape = recording.points.shape
        # A memory block of no bytes cannot be made: a recording may have no markers.
        self._memory = SharedMemory(create=True, size=max(1, recording.points.nbytes))
        target = np.ndarray(self._shape, np.float64, buffer=self._memory.buf)
        target[:] = recording.points
        del target
        finalize(self, _release, self._memory)

    def __reduce__(self) -> tuple[Any, ...]:
        return _attach, (self._memory.name, self._shape, self._meta)


def _attach(name: str, shape: tuple[int, ...], meta: dict[str, Any]) -> Recording:
    """Copy the recording out of shared memory: what a worker gets in place of the handle."""
    memory = SharedMemory(name=name)
    shared = np.ndarray(shape, np.float64, buffer=memory.buf)
    points = shared.copy()
    del shared
    memory.close()
    return Recording(points, **meta)


def start_tracker() -> None:
    """Start the tracker of shared memory, so that workers share it and none clears up twice."""
    resource_tracker.ensure_running()
