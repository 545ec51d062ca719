"""A label for each piece of a recording.

As Holzreiter 2005 (Clinical Biomechanics 20:1-8) and Clouthier, Ross, Mavor, Coll, Boyle, Graham
2021 (IEEE Access 9:36664-36675), single frames are labelled and the verdict is the whole
trajectory's; after Ghorbani, Etemad, Troje 2019 (Computer Graphics International, LNCS 11542:167)
the labels of a frame exclude each other and time corrects what a frame alone gets wrong. In place
of a trained network there is one labelled recording: its poses give the first labels, and its
distances, which are those of rigid segments above all, the final ones.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.adapting import adapted
from mocapmend_algorithms.labelling.assignment import assign_pieces
from mocapmend_algorithms.labelling.costs import NOWHERE, Expectation, Tolerance, costs
from mocapmend_algorithms.labelling.costs import label_places
from mocapmend_algorithms.labelling.likenesses import likenesses
from mocapmend_algorithms.labelling.rearranging import best_order
from mocapmend_algorithms.labelling.model import LabelModel
from mocapmend_algorithms.labelling.pieces import cut_pieces
from mocapmend_algorithms.labelling.result import Labelled, Labelling, Piece
from mocapmend_algorithms.labelling.sampling import Sampled, sample
from mocapmend_algorithms.labelling.start import FIRST_TOLERANCE, label_frame, size_of
from mocapmend_algorithms.labelling.upright import upright
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

KEY_FRAMES = 12
DOUBT = 4.0
"""How fast a key frame loses weight with its cost."""
FIRST_ROUNDS = 6
LAST_ROUNDS = 8
LAST_TOLERANCE = Tolerance(share=0.03, mm=8.0, loose=1.3)
CHUNK = 64
"""Frames whose costs are worked out at once."""


@dataclass
class State:
    """What is believed so far.

    Attributes
    ----------
    labels : ndarray of int, shape (pieces,)
        -1 for none.
    table : ndarray, shape (pieces, labels)
        Mean cost of each label for each piece.
    scale : float
        Size of the body beside the model's.
    """

    labels: IntArray
    table: FloatArray
    scale: float


def propose(
    recording: Recording,
    model: LabelModel,
    fixed_points: dict[int, int],
    left_alone: set[int],
    progress: Progress,
) -> tuple[list[Piece], Sampled, State]:
    points = upright(recording)
    pieces = [p for p in cut_pieces(points, recording.rate) if p.point not in left_alone]
    fixed = np.array([fixed_points.get(p.point, -1) for p in pieces], np.int64)
    seen = sample(points, pieces)
    state = _begin(model, seen, pieces, fixed, part(progress, 0.0, 0.4))
    state.labels = assign_pieces(state.table, seen, pieces, fixed, len(points))
    count = len(pieces)

    def settle(most, expect, until):
        for _ in range(most):
            state.scale = size_of(model, seen.points, seen.labels(state.labels), state.scale)
            state.table = piece_costs(expect(), seen, state.labels, count, lambda f: None)
            new = assign_pieces(state.table, seen, pieces, fixed, len(points))
            same = np.array_equal(new, state.labels)
            state.labels = new
            if same:
                break

    def plain():
        return Expectation.of(model, state.scale, FIRST_TOLERANCE)

    def own():
        mine = adapted(model, seen.points, seen.labels(state.labels), state.scale)
        return Expectation.of(mine, 1.0, LAST_TOLERANCE)

    settle(FIRST_ROUNDS, plain, 0.6)
    orders = likenesses(model)
    held = set(fixed[fixed >= 0].tolist())
    if held:
        orders = [o for o in orders if not any(o[k] != k for k in held)]
    places = label_places(seen.points, seen.labels(state.labels), len(model.labels))
    state.order = best_order(plain(), places, orders, lambda f: None)
    state.labels = np.where(state.labels >= 0, state.order.order[state.labels], -1)
    settle(3, plain, 0.6)
    settle(LAST_ROUNDS, own, 1.0)
    places = label_places(seen.points, seen.labels(state.labels), len(model.labels))
    state.order2 = best_order(plain(), places, orders, lambda f: None)
    progress(1.0)
    return pieces, seen, state


def piece_costs(
    expected: Expectation, seen: Sampled, labels: IntArray, count: int, progress: Progress
) -> FloatArray:
    """Average the costs of each label over the frames of each piece, shape (pieces, labels)."""
    of_slots = seen.labels(labels)
    found = np.full((*seen.pieces.shape, len(expected.wander)), np.nan)
    for start in range(0, len(seen.frames), CHUNK):
        progress(start / len(seen.frames))
        some = slice(start, start + CHUNK)
        found[some] = costs(expected, seen.points[some], of_slots[some])
    return seen.mean(found, count)


def _begin(
    model: LabelModel, seen: Sampled, pieces: Sequence[Piece], fixed: IntArray, progress: Progress
) -> State:
    """Label key frames, and let them vote."""
    votes = np.zeros((len(pieces), len(model.labels)))
    starts = []
    count = (seen.pieces >= 0).sum(axis=1)
    spans = [span for span in np.array_split(np.arange(len(seen.frames)), KEY_FRAMES) if span.size]
    for number, span in enumerate(spans):
        progress(number / len(spans))
        row = int(span[np.argmax(count[span])])
        there = seen.pieces[row] >= 0
        found = label_frame(model, seen.points[row, there])
        if found:
            starts.append((found[0], seen.pieces[row, there]))
    best = min((start.cost for start, _ in starts), default=0.0)
    for start, there in starts:
        good = start.labels >= 0
        votes[there[good], start.labels[good]] += np.exp(-DOUBT * (start.cost - best))
    scale = float(np.median([start.scale for start, _ in starts])) if starts else np.nan
    return State(np.where(fixed >= 0, fixed, -1), NOWHERE - votes, scale)
