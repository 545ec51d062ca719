"""Labels given by hand, without a window."""

from pathlib import Path

import numpy as np
import pytest
from c3d_synthetic import Synthetic, encode

from mocapmend.document import NO_SKELETON, Document
from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_reader import read_c3d
from mocapmend.hand_labels import Given, free_and_taken, given, next_without_label, stretch
from mocapmend_algorithms.corrections import Exchange

FRAMES = 40
LABELS = ("A", "B", "*1", "*2")


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Return A in frames 0 to 19, *1 in 20 to 39 with a jump at 30, *2 in 25 to 39, B always."""
    time = np.arange(FRAMES)[:, None, None]
    points = 100.0 + 300.0 * np.arange(4)[None, :, None] + 2.0 * time + np.zeros((FRAMES, 4, 3))
    points[30:, 2] += 500.0
    fourth = np.zeros((FRAMES, 4))
    fourth[20:, 0] = fourth[:20, 2] = fourth[:25, 3] = -1
    points[fourth < 0] = 0
    path = tmp_path / "in.c3d"
    path.write_bytes(encode(Synthetic(points, fourth=fourth, labels=list(LABELS))))
    return Document(read_c3d(path), NO_SKELETON)


def test_a_stretch_reaches_from_the_playhead_to_the_next_jump_or_end(document: Document) -> None:
    assert stretch(document, 2, 22, None) == (22, 30)
    assert stretch(document, 2, 30, None) == (30, FRAMES)
    assert stretch(document, 0, 3, None) == (3, 20)
    assert stretch(document, 2, 0, (10, 25)) == (10, 25)


def test_nothing_is_meant_where_nothing_is_seen(document: Document) -> None:
    with pytest.raises(MocapmendError, match="not seen in this frame"):
        stretch(document, 2, 5, None)
    with pytest.raises(MocapmendError, match="selected frames"):
        stretch(document, 2, 5, (0, 10))


def test_a_stretch_is_exchanged_with_the_point_of_the_label(document: Document) -> None:
    assert given(document, 2, (20, 30), "A") == Given(0, Exchange(2, 0, 20, 30))


def test_a_label_without_a_point_is_a_new_name(document: Document) -> None:
    assert given(document, 2, (20, 30), "C") == Given(2, None)
    with pytest.raises(MocapmendError, match="No point has this label"):
        given(document, 0, (0, 20), "C")
    with pytest.raises(MocapmendError, match="already"):
        given(document, 0, (0, 20), "A")


def test_labels_that_are_free_come_apart_from_the_others(document: Document) -> None:
    assert free_and_taken(document, 2, (20, 30)) == ([0], [1])
    assert free_and_taken(document, 3, (10, 30)) == ([], [0, 1])


def test_the_next_point_without_a_label(document: Document) -> None:
    assert next_without_label(document, None, 27) == (2, 27)
    assert next_without_label(document, 2, 27) == (3, 27)
    assert next_without_label(document, 3, 27) == (2, 27)
    assert next_without_label(document, None, 0) == (2, 20), "the first that comes up"
    document.rename({2: "C", 3: "D"})
    assert next_without_label(document, None, 27) is None
