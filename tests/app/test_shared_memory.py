"""Arrays in shared memory are given back, and ordinary ones do where there is no room."""

import gc
import os
from multiprocessing.shared_memory import SharedMemory

import numpy as np
import pytest

from mocapmend.shared_memory import (
    attached,
    attached_to_change,
    block_of,
    shared_array,
    start_tracker,
)


@pytest.fixture(autouse=True)
def tracker() -> None:
    start_tracker()


def test_another_map_of_the_memory_has_the_same_samples() -> None:
    array = shared_array((4, 2, 3))
    array[:] = np.arange(24.0).reshape(4, 2, 3)
    name = block_of(array)
    assert name is not None
    other = attached(name, (4, 2, 3))
    assert other.tobytes() == array.tobytes()
    assert not other.flags.writeable


@pytest.mark.parametrize("mapped", [True, False])
def test_what_is_written_to_a_private_map_is_seen_there_alone(
    monkeypatch: pytest.MonkeyPatch, mapped: bool
) -> None:
    array = shared_array((4, 2, 3))
    array[:] = np.arange(24.0).reshape(4, 2, 3)
    name = block_of(array)
    assert name is not None
    if not mapped:
        monkeypatch.setattr("mocapmend.shared_memory._descriptor", lambda memory: -1)
    own = attached_to_change(name, (4, 2, 3))
    assert own.tobytes() == array.tobytes()
    own[2] = -1.0
    assert (own[2] == -1.0).all()
    np.testing.assert_array_equal(array, np.arange(24.0).reshape(4, 2, 3))
    del array
    gc.collect()
    assert (own[2] == -1.0).all()
    assert own[3, 1, 2] == 23.0


def test_the_memory_lives_as_long_as_a_view_and_no_longer() -> None:
    array = shared_array((4, 2, 3))
    array[:] = 7.0
    name = block_of(array)
    assert name is not None
    view = array[2]
    del array
    gc.collect()
    assert (view == 7.0).all()
    del view
    gc.collect()
    with pytest.raises(FileNotFoundError):
        SharedMemory(name=name)


def test_an_ordinary_array_has_no_block() -> None:
    assert block_of(np.zeros((4, 2, 3))) is None
    assert shared_array((4, 0, 3)).shape == (4, 0, 3)


@pytest.mark.skipif(not hasattr(os, "posix_fallocate"), reason="there is no way to ask for room")
def test_without_room_the_array_is_an_ordinary_one(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(descriptor: int, start: int, size: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "posix_fallocate", full)
    array = shared_array((4, 2, 3))
    assert array.shape == (4, 2, 3)
    assert block_of(array) is None
