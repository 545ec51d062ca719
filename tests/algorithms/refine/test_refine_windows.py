"""Windows of a recording: each frame is kept once, from the window that sees most around it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mocapmend_algorithms.refine.windows import LENGTH, STRIDES, Windows


@given(st.integers(1, 700), st.sampled_from([*STRIDES, 7, LENGTH]))
def test_what_is_cut_out_is_joined_again(frames: int, stride: int) -> None:
    points = np.arange(frames, dtype=float)[:, None]
    windows = Windows.over(frames, stride)
    np.testing.assert_array_equal(windows.joined(windows.cut_out(points)), points)


@given(st.integers(LENGTH, 700), st.sampled_from(STRIDES))
def test_frames_are_from_the_middle_of_windows(frames: int, stride: int) -> None:
    windows = Windows.over(frames, stride)
    places = np.broadcast_to(np.arange(LENGTH)[:, None], (len(windows.starts), LENGTH, 1))
    found = windows.joined(places.astype(float))[:, 0]
    low, high = (LENGTH - stride) // 2, (LENGTH + stride) // 2
    inner = found[low : frames - (LENGTH - low) + 1]
    # The last window ends with the recording and takes over from the one before in its own middle.
    assert ((inner >= low) & (inner <= high + stride)).all()
    assert found[0] == 0
    assert found[-1] == LENGTH - 1


def test_with_stride_1_each_frame_but_at_the_ends_is_the_middle_one() -> None:
    windows = Windows.over(300, 1)
    places = np.broadcast_to(np.arange(LENGTH)[:, None], (len(windows.starts), LENGTH, 1))
    found = windows.joined(places.astype(float))[:, 0]
    np.testing.assert_array_equal(found[59:240], 59)


def test_the_last_frame_of_a_short_recording_holds() -> None:
    windows = Windows.over(3, 60).cut_out(np.array([[1.0], [2.0], [5.0]]))
    assert windows.shape == (1, LENGTH, 1)
    assert windows[0, :4, 0].tolist() == [1, 2, 5, 5]


@pytest.mark.parametrize(("frames", "stride"), [(0, 60), (10, 0), (10, LENGTH + 1)])
def test_impossible_windows_are_refused(frames: int, stride: int) -> None:
    with pytest.raises(ValueError, match="no windows"):
        Windows.over(frames, stride)
