"""Some frames of a recording, in which every piece is looked at."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.result import Piece

MOST_EVEN = 400
LEAST_OF_PIECE = 3
MOST_FRAMES = 1500
CHUNK = 64
"""Frames that are looked at at once."""


@dataclass(frozen=True, eq=False)
class Sampled:
    """The points that are seen in some frames, without the room for those that are not.

    Attributes
    ----------
    frames : ndarray of int, shape (samples,)
        Which frames.
    pieces : ndarray of int, shape (samples, slots)
        Index of the piece in each slot; -1 where the slot is empty.
    points : ndarray, shape (samples, slots, 3)
        NaN where it is empty.
    """

    frames: IntArray
    pieces: IntArray
    points: FloatArray

    def labels(self, of_pieces: IntArray) -> IntArray:
        """Return the label in each slot, from the labels of the pieces."""
        return np.where(self.pieces >= 0, np.append(of_pieces, -1)[self.pieces], -1)

    def mean(self, values: Callable[[slice], FloatArray], count: int, size: int) -> FloatArray:
        """Average what is known of slots over each piece.

        Parameters
        ----------
        values : callable
            Returns the values, shape (some samples, slots, size), of a slice of the samples: all
            at once would need much memory.
        count : int
            Pieces.
        size : int
            Values per slot.

        Returns
        -------
        ndarray, shape (pieces, size)
            NaN for pieces that are not seen.
        """
        total, number = np.zeros((count, size)), np.zeros(count)
        for start in range(0, len(self.frames), CHUNK):
            some = slice(start, start + CHUNK)
            taken = self.pieces[some] >= 0
            where = self.pieces[some][taken]
            np.add.at(total, where, values(some)[taken])
            number += np.bincount(where, minlength=count)
        number[number == 0] = np.nan
        return total / number[:, None]


def sample(points: FloatArray, pieces: Sequence[Piece]) -> Sampled:
    """Choose frames: evenly spread ones, and more where a piece would be seen in too few.

    Parameters
    ----------
    points : ndarray, shape (frames, points, 3)
        In mm.
    pieces : sequence of Piece
        All that is to be seen.
    """
    frames = points.shape[0]
    chosen = np.zeros(frames, np.bool_)
    if frames:
        chosen[np.linspace(0, frames - 1, min(frames, MOST_EVEN)).round().astype(np.int64)] = True
    for piece in sorted(pieces, key=lambda each: each.length):
        own = chosen[piece.start : piece.stop]
        lacking = min(LEAST_OF_PIECE, piece.length) - int(own.sum())
        # So many that the longest recordings are looked at in bearable time.
        if lacking > 0 and (own.sum() == 0 or chosen.sum() < MOST_FRAMES):
            places = (np.arange(lacking) + 0.5) / lacking * piece.length
            own[places.astype(np.int64)] = True
    return _gathered(points, pieces, np.flatnonzero(chosen))


def _gathered(points: FloatArray, pieces: Sequence[Piece], frames: IntArray) -> Sampled:
    """Return what is seen in given frames, which ascend."""
    there = np.full((len(frames), points.shape[1]), -1, np.int64)
    for k, piece in enumerate(pieces):
        first, stop = np.searchsorted(frames, (piece.start, piece.stop))
        there[first:stop, piece.point] = k
    slots = int((there >= 0).sum(axis=1).max(initial=0))
    order = np.argsort(there < 0, axis=1, kind="stable")[:, :slots]
    taken = np.take_along_axis(there, order, axis=1)
    places = np.take_along_axis(points[frames], order[:, :, None], axis=1)
    places[taken < 0] = np.nan
    return Sampled(frames, taken, places)
