"""Which frames of a recording teach how to fill a gap, and which of them are hidden as a test.

A *trial* is a stretch as long as the gap in which the marker is seen. It is hidden from the fill
and compared with it. The companions of the gap, the markers that are missing with it, are no
donors, so that they are hidden too.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, IntArray, evenly, running_count
from mocapmend_algorithms.gaps import Gap

BORDERS = np.array([1, 2, 3, 5, 8, 13, 21, 34, 55])
"""Distances from a gap and a trial at which samples are taken: the nearest say most."""
LONGEST_SHARE = 0.3
LEAST_LENGTH = 3
LEAST_SEEN = 0.7


@dataclass(frozen=True, eq=False)
class Trial:
    """A stretch that is hidden.

    Attributes
    ----------
    start, stop : int
        Its frames, as those of a gap.
    hidden : ndarray of int
        Indices into the lesson's frames of all that a fill of it must not know.
    judged : slice
        Those of `hidden` that lie inside the stretch.
    """

    start: int
    stop: int
    hidden: IntArray
    judged: slice


@dataclass(frozen=True, eq=False)
class Lesson:
    """Frames to learn from.

    Attributes
    ----------
    frames : ndarray of int
        Ascending; the marker and its donors are there.
    trials : tuple of Trial
        Evenly spread over the recording.
    """

    frames: IntArray
    trials: tuple[Trial, ...]

    def times_longer(self, gap: Gap) -> float:
        """Return how many times longer than the trials a gap is, at least 1."""
        if not self.trials:
            return 1.0
        return max(1.0, gap.length / (self.trials[0].stop - self.trials[0].start))


@dataclass(frozen=True)
class Size:
    """How much to learn from.

    Attributes
    ----------
    frames : int
        About how many frames.
    trials : int
        How many stretches are hidden.
    judged : int
        At how many frames each is compared.
    rest : int
        How many frames beside those of borders and trials there are at least.
    """

    frames: int = 600
    trials: int = 10
    judged: int = 20
    rest: int = 150


def plan(usable: BoolArray, gap: Gap, size: Size) -> Lesson:
    """Choose the frames of a lesson.

    Parameters
    ----------
    usable : ndarray of bool, shape (frames,)
        Where the marker and its donors are there.
    gap : Gap
        To be filled.
    size : Size
        How much to take.

    Returns
    -------
    Lesson
        Frames near the gap and the trials are taken more densely; the rest evenly.
    """
    frames = usable.size
    known = np.flatnonzero(usable)
    length = min(gap.length, max(int(LONGEST_SHARE * known.size), LEAST_LENGTH))
    starts = evenly(_starts(usable, length), size.trials)
    taken = np.zeros(frames, dtype=bool)
    for start, stop in [(gap.start, gap.stop), *((s, s + length) for s in starts.tolist())]:
        near = np.concatenate((start - BORDERS, stop - 1 + BORDERS))
        taken[near[(near >= 0) & (near < frames)]] = True
    for start in starts.tolist():
        taken[start + evenly(np.flatnonzero(usable[start : start + length]), size.judged)] = True
    taken &= usable
    rest = np.flatnonzero(usable & ~taken)
    taken[evenly(rest, max(size.frames - int(taken.sum()), size.rest))] = True
    chosen = np.flatnonzero(taken)
    kind = gap.kind(frames)
    trials = [_trial(chosen, start, start + length, kind) for start in starts.tolist()]
    most = 0.6 * chosen.size
    return Lesson(chosen, tuple(trial for trial in trials if 0 < trial.hidden.size <= most))


def _starts(usable: BoolArray, length: int) -> IntArray:
    """Find where a stretch may begin: both its borders are known, and most of its inside."""
    starts = np.arange(1, usable.size - length)
    if not starts.size:
        return starts
    counts = running_count(usable)
    inside = counts[starts + length] - counts[starts]
    good = usable[starts - 1] & usable[starts + length] & (inside >= LEAST_SEEN * length)
    return starts[good]


def _trial(frames: IntArray, start: int, stop: int, kind: str) -> Trial:
    low, high = np.searchsorted(frames, [start, stop]).tolist()
    # What lies beyond a gap at the beginning or the end of a recording is not known either.
    first = 0 if kind == "leading" else low
    last = frames.size if kind == "trailing" else high
    return Trial(start, stop, np.arange(first, last), slice(low - first, high - first))
