"""The one form of a recording: what it refuses, and what it knows of its samples."""

import numpy as np
import pytest

from mocapmend_algorithms import Recording


def test_what_was_seen_already_is_not_looked_for_again() -> None:
    seen = np.array([[True, False]])
    recording = Recording(np.zeros((1, 2, 3)), ("A", "B"), 100.0, seen=seen)
    assert recording.present is seen
    with pytest.raises(ValueError, match="read-only"):
        seen[0, 0] = False


def test_other_coordinates_are_looked_at_anew() -> None:
    seen = np.array([[True, False]])
    recording = Recording(np.zeros((1, 2, 3)), ("A", "B"), 100.0, seen=seen)
    points = np.array([[[np.nan] * 3, [1.0] * 3]])
    np.testing.assert_array_equal(recording.with_points(points).present, [[False, True]])


def test_what_was_seen_must_be_of_the_same_samples() -> None:
    with pytest.raises(ValueError, match="seen must be"):
        Recording(np.zeros((1, 2, 3)), ("A", "B"), 100.0, seen=np.ones((2, 1), bool))
