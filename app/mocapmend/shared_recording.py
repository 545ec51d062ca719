"""A recording that workers read without a copy through a pipe."""

from concurrent.futures import Future
from dataclasses import dataclass
from threading import Thread
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.shared_memory import attached, attached_to_change, block_of, shared_array
from mocapmend_algorithms import Recording


@dataclass(frozen=True, eq=False)
class Changed:
    """Samples in which a recording may differ from another one.

    Attributes
    ----------
    frames, markers : ndarray of int, shape (n,)
        Where they are.
    values : ndarray, shape (n, 3)
        What is there, NaN where missing.
    """

    frames: NDArray[np.int64]
    markers: NDArray[np.int64]
    values: NDArray[np.float64]

    def write(self, points: NDArray[np.float64]) -> None:
        """Put the samples into their places."""
        points[self.frames, self.markers] = self.values


class SharedPoints:
    """Coordinates in shared memory.

    What is not there yet is copied by a thread: who needs the copy waits, the window's thread
    never does.

    Parameters
    ----------
    points : ndarray, shape (frames, markers, 3)
        Never changed.
    """

    def __init__(self, points: NDArray[np.float64]) -> None:
        self._shared: Future[NDArray[np.float64]] = Future()
        if block_of(points) is None:
            # A thread of its own: all those of the jobs may be waiting for it.
            Thread(target=self._copy, args=(points,), name="share").start()
        else:
            self._shared.set_result(points)

    def get(self) -> NDArray[np.float64]:
        """Return the shared array, once it is complete."""
        return self._shared.result()

    def _copy(self, points: NDArray[np.float64]) -> None:
        try:
            shared = shared_array(points.shape)
            shared[:] = points
        except MemoryError as error:
            self._shared.set_exception(error)
        else:
            self._shared.set_result(shared)


class SharedRecording:
    """A snapshot of a recording that travels to a worker by name.

    The memory lives as long as this object; a job holds it until the job has ended.

    Parameters
    ----------
    recording : Recording
        What is shared; it never changes.
    changed : Changed, optional
        Where the snapshot differs from the recording.
    points : SharedPoints, optional
        The recording's coordinates, where they are shared already.
    """

    def __init__(
        self,
        recording: Recording,
        changed: Changed | None = None,
        points: SharedPoints | None = None,
    ) -> None:
        self._recording = recording
        self._changed = changed
        self._points = SharedPoints(recording.points) if points is None else points

    def with_changes(self, changed: Changed) -> "SharedRecording":
        """Return another snapshot of the recording, in the same memory."""
        return SharedRecording(self._recording, changed, self._points)

    def recording(self) -> Recording:
        """Return the snapshot for a thread of this process."""
        return _with(self._recording, self._changed)

    def __reduce__(self) -> tuple[Any, ...]:
        recording = self._recording
        meta = {
            "labels": recording.labels,
            "rate": recording.rate,
            "unit": recording.unit,
            "up": recording.up,
            "first_frame": recording.first_frame,
        }
        points = self._points.get()
        name = block_of(points)
        if name is None:
            return _received, (points, meta, self._changed)
        return _attach, (name, points.shape, meta, self._changed)


def _attach(
    name: str, shape: tuple[int, ...], meta: dict[str, Any], changed: Changed | None
) -> Recording:
    """Make the recording that a worker gets in place of the handle."""
    if changed is None:
        return Recording(attached(name, shape), **meta)
    points = attached_to_change(name, shape)
    changed.write(points)
    return Recording(points, **meta)


def _received(
    points: NDArray[np.float64], meta: dict[str, Any], changed: Changed | None
) -> Recording:
    """Make the recording of a worker that got a copy of the samples."""
    return _with(Recording(points, **meta), changed)


def _with(recording: Recording, changed: Changed | None) -> Recording:
    """Return a recording with some samples changed."""
    if changed is None:
        return recording
    points = recording.points.copy()
    changed.write(points)
    return recording.with_points(points)
