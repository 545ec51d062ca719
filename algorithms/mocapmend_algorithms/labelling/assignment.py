"""One label for each piece, at no frame the same one twice."""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.costs import NOWHERE
from mocapmend_algorithms.labelling.result import Piece
from mocapmend_algorithms.labelling.sampling import Sampled


def assign_pieces(
    table: FloatArray, seen: Sampled, pieces: Sequence[Piece], fixed: IntArray, frames: int
) -> IntArray:
    """Give each piece the label that it has at most frames when each is assigned by itself.

    The costs are those of whole pieces, so that most frames agree. The surest piece comes first;
    one whose label is taken at one of its frames gets its next best.

    Parameters
    ----------
    table : ndarray, shape (pieces, labels)
        Mean cost of each label.
    seen : Sampled
        Frames to assign by themselves (Hungarian method: Kuhn 1955).
    pieces : sequence of Piece
        Where they are.
    fixed : ndarray of int, shape (pieces,)
        Labels that are given; -1 elsewhere.
    frames : int
        Of the recording.

    Returns
    -------
    ndarray of int, shape (pieces,)
        -1 for none.
    """
    votes = _votes(table, seen, fixed)
    labels = np.full(len(pieces), -1, np.int64)
    free = np.ones((table.shape[1], frames), np.bool_)
    for k in np.flatnonzero(fixed >= 0).tolist():
        labels[k] = fixed[k]
        free[fixed[k], pieces[k].start : pieces[k].stop] = False
    lengths = np.array([piece.length for piece in pieces])
    most = votes.max(axis=1, initial=0.0)
    for k in np.lexsort((-lengths, -most * np.minimum(lengths, 100))).tolist():
        if labels[k] >= 0:
            continue
        piece = pieces[k]
        for label in np.lexsort((table[k], -votes[k])).tolist():
            if votes[k, label] == 0 and table[k, label] >= NOWHERE:
                break
            if table[k, label] < NOWHERE and free[label, piece.start : piece.stop].all():
                labels[k] = label
                free[label, piece.start : piece.stop] = False
                break
    return labels


def _votes(table: FloatArray, seen: Sampled, fixed: IntArray) -> FloatArray:
    """Return the share of its frames in which each piece gets each label."""
    from scipy.optimize import linear_sum_assignment

    votes = np.zeros(table.shape)
    count = np.zeros(len(table))
    given = table.copy()
    for k in np.flatnonzero(fixed >= 0).tolist():
        given[k] = NOWHERE
        given[k, fixed[k]] = -NOWHERE
    given = np.minimum(np.nan_to_num(given, nan=NOWHERE), NOWHERE)
    done: dict[bytes, tuple[IntArray, IntArray]] = {}
    for row in seen.pieces:
        there = row[row >= 0]
        key = there.tobytes()
        if key not in done:
            done[key] = linear_sum_assignment(given[there])
        rows, columns = done[key]
        good = given[there[rows], columns] < NOWHERE
        votes[there[rows[good]], columns[good]] += 1.0
        count[there] += 1.0
    return votes / np.maximum(count, 1.0)[:, None]
