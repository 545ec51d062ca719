"""Large results on their way from a worker to the window.

Reading one pickle holds the interpreter to its end, whichever thread does it: ten thousand patches
would be felt in the window. Between pieces other threads have their turn. No Qt.
"""

import pickle
from typing import Any

from mocapmend_algorithms.fill.contract import FillResult, Patch, Unfilled

PIECE = 200
"""Gaps in a piece."""


class Pieces:
    """A result of a method that is put together again where it is received.

    Parameters
    ----------
    result : FillResult
        Of a method.
    """

    def __init__(self, result: FillResult) -> None:
        self._result = result

    def __reduce__(self) -> tuple[Any, ...]:
        result = self._result
        filled = [pickle.dumps(part) for part in _parts(result.patches)]
        left = [pickle.dumps(part) for part in _parts(result.unfilled)]
        notes = [pickle.dumps(part) for part in _parts(tuple(result.notes.items()))]
        return _together, (filled, left, notes)


def in_pieces(result: object) -> object:
    """Return what is to be sent in place of a result; what is small is sent as it is."""
    if not isinstance(result, FillResult):
        return result
    for patch in result.patches:
        # Worked out here, they travel along: the window asks for them of all patches at once.
        _ = patch.expected_error, patch.typical_r90
    return Pieces(result) if len(result.patches) + len(result.unfilled) > PIECE else result


def _parts(entries: tuple[Any, ...]) -> list[tuple[Any, ...]]:
    return [entries[start : start + PIECE] for start in range(0, len(entries), PIECE)]


def _together(filled: list[bytes], left: list[bytes], notes: list[bytes]) -> FillResult:
    patches: list[Patch] = []
    unfilled: list[Unfilled] = []
    about = {}
    # Our own pickles, made by our own worker.
    for piece in filled:
        patches += pickle.loads(piece)  # noqa: S301
    for piece in left:
        unfilled += pickle.loads(piece)  # noqa: S301
    for piece in notes:
        about.update(pickle.loads(piece))  # noqa: S301
    return FillResult(tuple(patches), tuple(unfilled), about)
