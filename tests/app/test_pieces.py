"""A result that travels in pieces arrives as it was."""

import pickle

import numpy as np

from mocapmend.pieces import PIECE, Pieces, in_pieces
from mocapmend_algorithms import Gap
from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled


def result(filled: int, left: int) -> FillResult:
    rng = np.random.default_rng(0)
    gaps = [Gap(0, 5 * row, 5 * row + 3) for row in range(filled + left)]
    patches = tuple(
        Patch(gap, rng.normal(size=(3, 3)), rng.normal(size=3), rng.normal(size=3))
        for gap in gaps[:filled]
    )
    unfilled = tuple(Unfilled(gap, f"reason {gap.start}") for gap in gaps[filled:])
    return FillResult(patches, unfilled, {gap: {"donors": ("A", str(gap.start))} for gap in gaps})


def test_a_large_result_arrives_whole_and_in_order() -> None:
    sent = result(2 * PIECE + 7, PIECE + 3)
    made = in_pieces(sent)
    assert isinstance(made, Pieces)
    received = pickle.loads(pickle.dumps(made))
    assert received.unfilled == sent.unfilled
    assert received.notes == sent.notes
    assert list(received.notes) == list(sent.notes)
    for one, other in zip(received.patches, sent.patches, strict=True):
        assert one.gap == other.gap
        for name in ("values", "sigma", "r90"):
            assert getattr(one, name).tobytes() == getattr(other, name).tobytes()


def test_a_small_result_and_any_other_travel_as_they_are() -> None:
    small = result(3, 2)
    assert in_pieces(small) is small
    assert in_pieces("report") == "report"
