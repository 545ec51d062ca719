"""The search for the labels of all pieces.

As in Ghorbani, Etemad, Troje 2019 (Auto-labelling of markers in optical motion capture by
permutation learning, arXiv:1907.13580), the labels of a frame exclude each other, and time corrects
what a frame alone gets wrong: here, a piece of a trajectory has one label. As in Clouthier, Ross,
Mavor, Coll, Boyle, Graham 2021 (IEEE Access, doi:10.1109/ACCESS.2021.3062748), the Hungarian
algorithm assigns them. In place of their trained networks, and that of Holzreiter 2005 (Clinical
Biomechanics, doi:10.1016/j.clinbiomech.2004.04.006), there is a labelled recording: its poses give
the first labels, and its distances, which are those of rigid segments above all, the final ones.
"""

from collections.abc import Sequence

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.labelling.adapting import adapted
from mocapmend_algorithms.labelling.assignment import assign_pieces
from mocapmend_algorithms.labelling.costs import (
    NOWHERE,
    Expectation,
    Tolerance,
    costs,
    label_places,
)
from mocapmend_algorithms.labelling.likenesses import likenesses
from mocapmend_algorithms.labelling.model import LabelModel
from mocapmend_algorithms.labelling.rearranging import Order, best_order
from mocapmend_algorithms.labelling.result import Piece
from mocapmend_algorithms.labelling.sampling import Sampled, sample
from mocapmend_algorithms.labelling.start import FIRST_TOLERANCE, Start, label_frame, size_of
from mocapmend_algorithms.progress import Progress, part

KEY_FRAMES = 12
DOUBT = 4.0
"""How fast a key frame loses weight with its cost."""
FIRST_ROUNDS, LAST_ROUNDS = 6, 8
LAST_TOLERANCE = Tolerance(share=0.03, mm=8.0, loose=1.3)
EXCESS = 1.5
"""A piece that costs so much more than is usual for a label is not that label."""


class Search:
    """Labels of pieces, improved step by step.

    Parameters
    ----------
    model : LabelModel
        What to look for.
    points : ndarray, shape (frames, points, 3)
        In mm, z up; NaN = missing.
    pieces : sequence of Piece
        What to label.
    fixed : ndarray of int, shape (pieces,)
        Labels that stay; -1 for those to be found.

    Attributes
    ----------
    labels : ndarray of int, shape (pieces,)
        What is believed so far; -1 for none.
    table : ndarray, shape (pieces, labels)
        Mean cost of each label for each piece.
    away : ndarray, shape (pieces,)
        Mean distance of a piece from where the other markers put its label, in mm; NaN unknown.
    scale : float
        Size of the body beside the model's.
    begun : bool
        Whether any label was found to begin with.
    order : Order
        How much better the labels are than what they could be taken for.
    """

    def __init__(
        self, model: LabelModel, points: FloatArray, pieces: Sequence[Piece], fixed: IntArray
    ) -> None:
        self.model, self.pieces, self.fixed = model, pieces, fixed
        self.frames = len(points)
        self.seen: Sampled = sample(points, pieces)
        self.labels: IntArray = fixed.copy()
        self.scale = 1.0
        self.table = np.full((len(pieces), len(model.labels)), NOWHERE)
        self.away = np.full(len(pieces), np.nan)
        held = set(fixed[fixed >= 0].tolist())
        self._orders = [
            order for order in likenesses(model) if all(order[label] == label for label in held)
        ]
        self.begun = bool((fixed >= 0).any())
        self.order: Order

    def run(self, progress: Progress) -> None:
        """Find the labels."""
        self._begin(part(progress, 0.0, 0.3))
        self._settle(FIRST_ROUNDS, part(progress, 0.3, 0.45), own=False)
        self._compare(part(progress, 0.45, 0.6))
        self.labels = np.where(self.labels >= 0, self.order.order[self.labels], -1)
        self._settle(FIRST_ROUNDS, part(progress, 0.6, 0.7), own=False)
        self._settle(LAST_ROUNDS, part(progress, 0.7, 0.9), own=True)
        self._compare(part(progress, 0.9, 1.0))
        self.away = self._distances()
        progress(1.0)

    def _begin(self, progress: Progress) -> None:
        """Label key frames, and let them vote."""
        count = (self.seen.pieces >= 0).sum(axis=1)
        rows = np.arange(len(self.seen.frames))
        spans = [span for span in np.array_split(rows, KEY_FRAMES) if span.size]
        starts: list[tuple[Start, IntArray]] = []
        for number, span in enumerate(spans):
            progress(number / len(spans))
            row = int(span[np.argmax(count[span])])
            there = self.seen.pieces[row] >= 0
            pieces = self.seen.pieces[row, there]
            found = label_frame(self.model, self.seen.points[row, there], self.fixed[pieces])
            if found is not None:
                starts.append((found, pieces))
        if not starts:
            return
        self.begun = True
        votes = np.zeros_like(self.table)
        best = min(start.cost for start, _ in starts)
        for start, there in starts:
            good = start.labels >= 0
            votes[there[good], start.labels[good]] += np.exp(-DOUBT * (start.cost - best))
        self.scale = float(np.median([start.scale for start, _ in starts]))
        self._assign(NOWHERE - votes)

    def _settle(self, most: int, progress: Progress, *, own: bool) -> None:
        """Work out what each piece fits best beside the others, until nothing changes.

        What is expected is the model's body, or this body's own; then what fits much worse than is
        usual for a label is ruled out.
        """
        for number in range(most):
            now = part(progress, number / most, (number + 1) / most)
            believed = self._believed()
            self.scale = size_of(self.model, self.seen.points, believed, self.scale)
            before = self.labels
            expected = self._own_body() if own else self._models_body()
            table = self._costs(expected, believed, now)
            self._assign(self._without_misfits(table) if own else table)
            if np.array_equal(before, self.labels):
                break

    def _without_misfits(self, table: FloatArray) -> FloatArray:
        """Rule out labels that a piece fits much worse than is usual for the label."""
        usual = np.full(table.shape[1], np.nan)
        for label in range(table.shape[1]):
            own = table[self.labels == label, label]
            if own.size:
                usual[label] = np.median(own)
        worst = np.nanmax(usual) if not np.isnan(usual).all() else NOWHERE
        usual[np.isnan(usual)] = worst
        return np.where(table > usual + EXCESS, NOWHERE, table)

    def _compare(self, progress: Progress) -> None:
        self.order = best_order(self._models_body(), self._places(), self._orders, progress)

    def _assign(self, table: FloatArray) -> None:
        self.table = table
        self.labels = assign_pieces(table, self.seen, self.pieces, self.fixed, self.frames)

    def _models_body(self) -> Expectation:
        return Expectation.of(self.model, self.scale, FIRST_TOLERANCE)

    def _own_body(self) -> Expectation:
        own = adapted(self.model, self._places(), self.scale)
        return Expectation.of(own, 1.0, LAST_TOLERANCE)

    def _believed(self) -> IntArray:
        return self.seen.labels(self.labels)

    def _places(self) -> FloatArray:
        return label_places(self.seen.points, self._believed(), len(self.model.labels))

    def _costs(self, expected: Expectation, believed: IntArray, progress: Progress) -> FloatArray:
        """Average the costs of each label over the frames of each piece."""

        def of(some: slice) -> FloatArray:
            progress(some.start / len(self.seen.frames))
            return costs(expected, self.seen.points[some], believed[some])

        return self.seen.mean(of, len(self.pieces), len(self.model.labels))

    def _distances(self) -> FloatArray:
        expected, places, believed = self._own_body(), self._places(), self._believed()
        frames = expected.frames(places)
        where = frames.place(expected.own)
        where[~frames.known] = np.nan
        there = np.take_along_axis(where, np.maximum(believed, 0)[:, :, None], axis=1)
        away = np.linalg.norm(self.seen.points - there, axis=2)
        away[believed < 0] = np.nan
        return self.seen.mean(lambda some: away[some, :, None], len(self.pieces), 1)[:, 0]
