"""How much better each piece's label is than any other that it could have."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.costs import NOWHERE
from mocapmend_algorithms.labelling.result import Piece


class Margin(NamedTuple):
    """The best alternative to a piece's label.

    Attributes
    ----------
    label : int
        What it would be; -1 for none.
    by : float
        What it costs more, together with what it makes others lose; negative where it is better.
    """

    label: int
    by: float


def margins(table: FloatArray, labels: IntArray, pieces: Sequence[Piece]) -> list[Margin]:
    """Return the best alternative of each piece: another label, or none.

    Where a label is another piece's at the same time, the two change labels, or the other one
    gets none: whichever costs less.

    Parameters
    ----------
    table : ndarray, shape (pieces, labels)
        Mean costs.
    labels : ndarray of int, shape (pieces,)
        -1 for none.
    pieces : sequence of Piece
        Where they are.
    """
    capped = np.minimum(np.nan_to_num(table, nan=NOWHERE), NOWHERE)
    chosen = np.where(labels >= 0, capped[np.arange(len(labels)), labels], NOWHERE)
    starts = np.array([piece.start for piece in pieces], np.int64)
    stops = np.array([piece.stop for piece in pieces], np.int64)
    holders = [np.flatnonzero(labels == label) for label in range(table.shape[1])]
    found = []
    for k, piece in enumerate(pieces):
        own = int(labels[k])
        best = Margin(-1, NOWHERE - chosen[k]) if own >= 0 else Margin(-1, np.inf)
        for label in np.flatnonzero(capped[k] < NOWHERE).tolist():
            by = capped[k, label] - chosen[k]
            if label == own or by >= best.by:
                continue
            others = holders[label]
            met = others[(starts[others] < piece.stop) & (stops[others] > piece.start)]
            if met.size:
                swapped = capped[met, own] if own >= 0 else np.full(met.size, NOWHERE)
                by += float(np.mean(np.minimum(swapped, NOWHERE) - chosen[met]))
            if by < best.by:
                best = Margin(label, float(by))
        found.append(best)
    return found
