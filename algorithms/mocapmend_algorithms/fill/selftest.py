"""How far a fill goes wrong, measured on the recording itself.

Stretches where the samples are known are hidden just as the gap is, filled by the same function,
and compared. Two things make the answer fit the gap at hand: the same marker is preferred, and
each error is taken relative to the *turn* of its window, which is seen from the samples around
it: a gap during a swing is harder than one during standing.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray, evenly, running_count
from mocapmend_algorithms.gaps import runs

MOST_OWN = 32
MOST_ALL = 64
LEAST_OWN = 8
LEAST_ALL = 5
LEAST_DISJOINT = 6
MOST_PLACES = 20_000
TURN_FLOOR = 0.3
COVERAGE = 0.9


@dataclass(frozen=True, eq=False)
class Trials:
    """Stretches to hide.

    Attributes
    ----------
    frames, markers : ndarray of int, shape (trials,)
        Where each hidden stretch begins.
    own : bool
        Whether all are of the marker with the gap.
    disjoint : int
        How many of them do not overlap each other.
    """

    frames: IntArray
    markers: IntArray
    own: bool
    disjoint: int


class TrialFinder:
    """Finds stretches of a recording that can be hidden.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be used.
    """

    def __init__(self, observed: BoolArray) -> None:
        self._observed = observed
        self._own: dict[int, IntArray] = {}

    def find(self, marker: int, knots: IntArray, length: int) -> Trials | None:
        """Find stretches that look like a gap.

        Parameters
        ----------
        marker : int
            The marker with the gap, preferred.
        knots : ndarray of int, shape (knots,)
            Frames of the observed samples, counted from the first missing frame.
        length : int
            Number of missing frames.

        Returns
        -------
        Trials or None
            Evenly spread over the recording; None where there are too few.
        """
        pattern = _Pattern.of(knots, length, self._observed.shape[0])
        near = pattern.thinned(MOST_PLACES)
        frames = near.places[near.fits(self._counts(marker)[:, None])[:, 0]]
        own = count_apart(frames, length)
        if frames.size >= LEAST_OWN and own >= LEAST_DISJOINT:
            chosen = evenly(frames, MOST_OWN)
            return Trials(chosen, np.full(chosen.size, marker), own=True, disjoint=own)
        places = pattern.thinned(MOST_PLACES // self._observed.shape[1])
        at, markers = np.nonzero(places.fits(self._all_counts))
        if at.size < LEAST_ALL:
            return None
        chosen = evenly(np.arange(at.size), MOST_ALL)
        frames, markers = places.places[at[chosen]], markers[chosen]
        disjoint = sum(count_apart(frames[markers == m], length) for m in np.unique(markers))
        return Trials(frames, markers, own=False, disjoint=disjoint)

    def _counts(self, marker: int) -> IntArray:
        if marker not in self._own:
            self._own[marker] = running_count(self._observed[:, marker])
        return self._own[marker]

    @cached_property
    def _all_counts(self) -> IntArray:
        return running_count(self._observed)


@dataclass(frozen=True, eq=False)
class _Pattern:
    """The samples that a trial needs, as runs, and the frames where it might begin."""

    needed: list[tuple[int, int]]
    places: IntArray

    @classmethod
    def of(cls, knots: IntArray, length: int, frames: int) -> "_Pattern":
        low, high = min(int(knots[0]), 0), max(int(knots[-1]) + 1, length)
        mask = np.zeros(high - low, dtype=bool)
        mask[knots - low] = True
        mask[-low : length - low] = True
        needed = [(a + low, b + low) for a, b in runs(mask)]
        return cls(needed, np.arange(-low, frames - high + 1))

    def thinned(self, most: int) -> "_Pattern":
        return _Pattern(self.needed, self.places[:: -(-self.places.size // max(most, 1)) or 1])

    def fits(self, counts: IntArray) -> BoolArray:
        fits = np.ones((self.places.size, counts.shape[1]), dtype=bool)
        for a, b in self.needed:
            fits &= counts[self.places + b] - counts[self.places + a] == b - a
        return fits


@dataclass(frozen=True, eq=False)
class Calibration:
    """What the errors of self-tests say about a gap of the same pattern.

    Attributes
    ----------
    sigma, r90 : ndarray, shape (length,)
        As in `Patch`, for a window of unit turn.
    floor : float
        Turn below which windows are equally easy.
    error : float
        RMS of the errors relative to their turn, by which settings are compared.
    """

    sigma: FloatArray
    r90: FloatArray
    floor: float
    error: float

    def scale(self, turn: float) -> float:
        """Return by what `sigma` and `r90` are multiplied for a window of this turn."""
        return float(_relative(np.array(turn), self.floor))


def turn(knots: IntArray, values: FloatArray, length: int) -> FloatArray:
    """How much the velocity changes across a window, in length units over the gap.

    Beside a gap that has samples on one side only it is the velocity itself.

    Parameters
    ----------
    knots : ndarray of int, shape (knots,)
        Frames of the observed samples, counted from the first missing frame.
    values : ndarray, shape (knots, trials, 3)
        What was observed there.
    length : int
        Number of missing frames.

    Returns
    -------
    ndarray, shape (trials,)
    """
    after = int(np.searchsorted(knots, 0))
    first, last = max(after - 4, 0), min(after + 3, knots.size - 1)
    left, right = max(after - 1, 0), min(after, knots.size - 1)
    ends = [(first, left), (left, right), (right, last)]
    slopes = [(values[b] - values[a]) / (knots[b] - knots[a]) if b > a else None for a, b in ends]
    chord = slopes[1] if slopes[1] is not None else 0.0
    bends = [np.sum((s - chord) ** 2, axis=-1) for s in (slopes[0], slopes[2]) if s is not None]
    return length * np.sqrt(sum(bends, start=np.zeros(values.shape[1])))


def calibrate(
    errors: FloatArray, turns: FloatArray, disjoint: int, shape: FloatArray | None = None
) -> Calibration:
    """Turn the errors of self-tests into a standard deviation and a 90 % radius.

    Parameters
    ----------
    errors : ndarray, shape (trials, length)
        3-D distance of each filled sample from the truth.
    turns : ndarray, shape (trials,)
        The turn of each window.
    disjoint : int
        How many trials do not overlap: the fewer, the higher the quantile taken.
    shape : ndarray, shape (length,), optional
        How the error grows and falls along the gap; measured where not given.

    Returns
    -------
    Calibration
    """
    floor = TURN_FLOOR * float(np.sqrt(np.mean(turns**2)))
    relative = errors / _relative(turns, floor)[:, None]
    if shape is None:
        square = np.mean(relative**2, axis=0)
        padded = np.pad(square, 1, mode="edge")
        shape = np.sqrt((padded[:-2] + 2 * square + padded[2:]) / 4)
    if not shape.max() > 0:
        return Calibration(shape, shape, floor, 0.0)
    ratio = relative / np.maximum(shape, 1e-6 * shape.max())
    sigma = np.sqrt(np.mean(ratio**2) / 3) * shape
    level = min(1.0, COVERAGE * (1 + 0.5 / disjoint))
    return Calibration(
        sigma, float(np.quantile(ratio, level)) * shape, floor, float(np.sqrt(np.mean(relative**2)))
    )


def _relative(turns: FloatArray, floor: float) -> FloatArray:
    if floor == 0.0:
        return np.ones_like(turns)
    return np.hypot(turns, floor)


def count_apart(frames: IntArray, length: int) -> int:
    """Count how many stretches of one length do not overlap, greedily.

    Parameters
    ----------
    frames : ndarray of int
        Where they begin, ascending.
    length : int
        In frames.
    """
    count, free = 0, -1
    for frame in frames.tolist():
        if frame >= free:
            count, free = count + 1, frame + length
    return count
