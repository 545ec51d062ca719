"""The order of a body's labels, tried against the orders that it could be taken for.

Piece by piece nothing is better where a whole foot is labelled the wrong way round, for each of
its markers is where the others say. Only all of them together can be turned.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray, evenly
from mocapmend_algorithms.labelling.costs import Expectation, own_costs
from mocapmend_algorithms.progress import Progress, part

FRAMES = 12
ROUNDS = 3
LEAST_GAIN = 1.5
"""In the sum of the costs of all labels of a frame: less may be the other body's own shape."""


@dataclass(frozen=True, eq=False)
class Order:
    """The order that fits best.

    Attributes
    ----------
    order : ndarray of int, shape (labels,)
        What each label is to be called instead.
    lead : ndarray, shape (labels,)
        By how much the best order that takes a label for another costs more, as a sum over the
        labels of a frame; infinite where there is none.
    rival : ndarray of int, shape (labels,)
        What a label is taken for in that order.
    moved : ndarray of int, shape (labels,)
        How many labels that order moves.
    """

    order: IntArray
    lead: FloatArray
    rival: IntArray
    moved: IntArray


class _Trial:
    """The costs of the labels in a few frames, and what they would be in another order."""

    def __init__(self, expected: Expectation, places: FloatArray) -> None:
        count = places.shape[1]
        self.expected, self.places = expected, places
        self.costs = own_costs(expected, places, np.arange(count))
        used = np.concatenate([expected.partners.markers, expected.company.markers], axis=1)
        self._touches = np.eye(count, dtype=np.bool_)
        np.put_along_axis(self._touches, used, values=True, axis=1)

    def gain(self, order: IntArray) -> float:
        """Return by how much an order is better, as a sum over the labels of a frame."""
        if not len(self.places):
            return 0.0
        changed = order != np.arange(len(order))
        touched = np.flatnonzero(self._touches[:, changed].any(axis=1))
        expected = self.expected.of_labels(touched)
        after = own_costs(expected, self.places[:, order], touched)
        return float((self.costs[:, touched] - after).sum(axis=1).mean())


def best_order(
    expected: Expectation, places: FloatArray, orders: Sequence[IntArray], progress: Progress
) -> Order:
    """Find the order of the labels that fits best.

    Parameters
    ----------
    expected : Expectation
        Of a model.
    places : ndarray, shape (frames, labels, 3)
        Where the labels seem to be; some of the frames that show most of them are looked at.
    orders : sequence of ndarray of int, shape (labels,)
        What to try, also one after the other.
    progress : Progress
        Called for each order.
    """
    shown = (~np.isnan(places[:, :, 0])).sum(axis=1)
    full = np.flatnonzero(shown >= np.median(shown)) if shown.size else np.zeros(0, np.int64)
    places = places[evenly(full, FRAMES)]
    chosen = np.arange(places.shape[1])
    gains: list[float] = []
    for number in range(ROUNDS):
        trial = _Trial(expected, places[:, chosen])
        now = part(progress, number / ROUNDS, (number + 1) / ROUNDS)
        gains = _gains(trial, orders, now)
        better = _improved(expected, trial, orders, gains, chosen)
        if better is None or number == ROUNDS - 1:
            break
        chosen = better
    return Order(np.argsort(chosen), *_rivals(orders, gains, len(chosen)))


def _gains(trial: _Trial, orders: Sequence[IntArray], progress: Progress) -> list[float]:
    gains = []
    for k, order in enumerate(orders):
        progress(k / len(orders))
        gains.append(trial.gain(order))
    return gains


def _improved(
    expected: Expectation,
    trial: _Trial,
    orders: Sequence[IntArray],
    gains: Sequence[float],
    chosen: IntArray,
) -> IntArray | None:
    """Apply the orders that gain, the best first, while they still do; None where none does."""
    better = None
    for k in np.argsort([-gain for gain in gains], kind="stable").tolist():
        if gains[k] < LEAST_GAIN:
            break
        if trial.gain(orders[k]) >= LEAST_GAIN:
            trial = _Trial(expected, trial.places[:, orders[k]])
            better = (chosen if better is None else better)[orders[k]]
    return better


def _rivals(
    orders: Sequence[IntArray], gains: Sequence[float], count: int
) -> tuple[FloatArray, IntArray, IntArray]:
    lead, rival, moved = np.full(count, np.inf), np.arange(count), np.zeros(count, np.int64)
    for order, gain in zip(orders, gains, strict=True):
        changed = order != np.arange(count)
        nearer = changed & (-gain < lead)
        lead[nearer], rival[nearer], moved[nearer] = -gain, order[nearer], changed.sum()
    return lead, rival, moved
