"""Arrays in memory that other processes can read without a copy."""

import mmap
import os
from multiprocessing import resource_tracker
from multiprocessing.shared_memory import SharedMemory
from weakref import finalize

import numpy as np
from numpy.typing import NDArray

_blocks: dict[int, SharedMemory] = {}
"""The memory of each array that was made here, by the address of its samples."""


def start_tracker() -> None:
    """Start the tracker of shared memory, so that workers share it and none clears up twice."""
    resource_tracker.ensure_running()


def shared_array(shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Make an array in shared memory; it is given back when the array and its views are gone.

    Where the system has too little shared memory the array is an ordinary one.

    Parameters
    ----------
    shape : tuple of int
        Of the array.

    Returns
    -------
    ndarray, float64
        Its values are not set.
    """
    size = 8 * int(np.prod(shape))
    if not size:
        # A memory block of no bytes cannot be made: a recording may have no markers.
        return np.empty(shape)
    try:
        memory = SharedMemory(create=True, size=size)
    except OSError:
        return np.empty(shape)
    if not _has_room(memory, size):
        _release(memory)
        return np.empty(shape)
    array = np.ndarray(shape, np.float64, buffer=memory.buf)
    place = array.ctypes.data
    _blocks[place] = memory
    finalize(array, _forget, place)
    return array


def block_of(array: NDArray[np.float64]) -> str | None:
    """Return the name under which other processes find an array's memory, None if they cannot."""
    memory = _blocks.get(array.ctypes.data)
    return memory.name if memory is not None and memory.size >= array.nbytes else None


def attached(name: str, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Return another process's shared array, read-only and without a copy."""
    memory = SharedMemory(name=name)
    array = np.ndarray(shape, np.float64, buffer=memory.buf)
    array.flags.writeable = False
    finalize(array, memory.close)
    return array


def attached_to_change(name: str, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Return another process's shared array as one's own: what is written is seen here alone.

    It takes memory for what is written only, where the system can do so.
    """
    memory = SharedMemory(name=name)
    shared = np.ndarray(shape, np.float64, buffer=memory.buf)
    own = _private(memory, shared)
    array = shared.copy() if own is None else own
    del shared
    memory.close()
    return array


def _private(memory: SharedMemory, shared: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Map an array's memory so that pages are copied when they are written; None if impossible."""
    descriptor = _descriptor(memory)
    if descriptor < 0:
        return None
    try:
        pages = mmap.mmap(descriptor, shared.nbytes, access=mmap.ACCESS_COPY)
    except OSError:
        return None
    return np.ndarray(shared.shape, np.float64, buffer=pages)


def _descriptor(memory: SharedMemory) -> int:
    """Return the file of a memory block, -1 where the system has none."""
    return int(getattr(memory, "_fd", -1))


def _has_room(memory: SharedMemory, size: int) -> bool:
    """Take all pages now: without room for one, writing to it would kill the process."""
    take = getattr(os, "posix_fallocate", None)
    descriptor = _descriptor(memory)
    if take is None or descriptor < 0:
        return True
    try:
        take(descriptor, 0, size)
    except OSError:
        return False
    return True


def _forget(place: int) -> None:
    _release(_blocks.pop(place))


def _release(memory: SharedMemory) -> None:
    memory.close()
    memory.unlink()
