"""Where stretches can be hidden as a gap is, and how: the punching of a recording.

A stretch is hidden where its markers are observed, as long as the gap, and with it the gap's
*company*: whatever else is missing inside the gap is hidden there too. Several stretches are
punched at once.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, IntArray, evenly, running_count
from mocapmend_algorithms.fill.edges import sides
from mocapmend_algorithms.gaps import Gap

MOST_PLACES = 16
LEAST_PLACES = 3
HIDDEN_SHARE = 0.25
"""Share of the marker's frames that one run may hide: the fill learns from the others."""
LENGTH_SHARE = 0.15
"""Share that one stretch may hide."""


@dataclass(frozen=True)
class Window:
    """The frames of a gap and which of its sides are closed by an observed sample."""

    start: int
    stop: int
    before: bool
    after: bool

    @property
    def length(self) -> int:
        """Number of missing frames."""
        return self.stop - self.start

    @classmethod
    def of(cls, observed: BoolArray, gap: Gap) -> "Window":
        """Return the window of a gap."""
        return cls(gap.start, gap.stop, *sides(observed, gap))

    def alike(self, observed: BoolArray) -> BoolArray:
        """Say which markers have this very gap and are seen elsewhere, shape (markers,)."""
        missing = ~observed[self.start : self.stop].any(axis=0)
        same: BoolArray = np.asarray(observed.any(axis=0) & missing)
        if self.before:
            same &= observed[self.start - 1]
        if self.after:
            same &= observed[self.stop]
        return same


def find_places(observed: BoolArray, window: Window, members: IntArray) -> tuple[IntArray, int]:
    """Choose where to hide stretches like a window.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    window : Window
        The gap to imitate.
    members : ndarray of int
        The markers that must be observed there.

    Returns
    -------
    places : ndarray of int
        First frames, ascending: disjoint, evenly spread, where few other markers are missing.
    length : int
        Frames to hide at each: the window's length, or less where there is no room.
    """
    seen = running_count(observed[:, members].all(axis=1))
    missing = running_count((~observed).sum(axis=1))
    length = min(window.length, max(int(LENGTH_SHARE * seen[-1]), 1))
    places = _places(seen, missing, length, window)
    while places.size < LEAST_PLACES and length > 1:
        length //= 2
        places = _places(seen, missing, length, window)
    if places.size < LEAST_PLACES:
        return places[:0], 0
    return places, length


def _places(seen: IntArray, missing: IntArray, length: int, window: Window) -> IntArray:
    before, after = int(window.before), int(window.after)
    begin = np.arange(before, seen.size - length - after)
    found = seen[begin + length + after] - seen[begin - before]
    fits = begin[found == length + before + after]
    cost = missing[fits + length] - missing[fits]
    for allowed in (fits[cost <= np.median(cost)] if fits.size else fits, fits):
        places, at = [], 0
        while at < allowed.size:
            places.append(int(allowed[at]))
            # A sample or two stay between the stretches, so that each has its own edges.
            at = int(np.searchsorted(allowed, places[-1] + length + 1 + before + after))
        if len(places) >= LEAST_PLACES:
            break
    return evenly(np.array(places, dtype=np.int64), MOST_PLACES)


def deal(places: IntArray, length: int, frames: int) -> Iterator[IntArray]:
    """Deal places to runs that each hide few enough frames.

    Parameters
    ----------
    places : ndarray of int
        First frames of the stretches.
    length : int
        Frames to hide at each.
    frames : int
        In which the markers are observed.

    Yields
    ------
    ndarray of int
        The places of one run.
    """
    if not places.size:
        return
    count = -(-places.size // most_at_once(length, frames))
    for first in range(count):
        yield places[first::count]


def most_at_once(length: int, frames: int) -> int:
    """Return how many stretches may be hidden at once of so many frames."""
    return max(int(HIDDEN_SHARE * frames) // length, 1)


def punch(
    observed: BoolArray, window: Window, members: IntArray, places: IntArray, length: int
) -> BoolArray:
    """Hide stretches as a window is.

    Parameters
    ----------
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    window : Window
        The gap to imitate.
    members : ndarray of int
        The markers that have it.
    places : ndarray of int
        First frames of the stretches.
    length : int
        Frames to hide at each.

    Returns
    -------
    ndarray of bool, shape (frames, markers)
        What is left. A side of the window that is open is open beside each stretch too.
    """
    hidden = observed.copy()
    pattern = observed[window.start + np.arange(length) * window.length // length]
    for place in places.tolist():
        hidden[place : place + length] &= pattern
        if not window.before and place > 0:
            hidden[place - 1, members] = False
        if not window.after and place + length < hidden.shape[0]:
            hidden[place + length, members] = False
    return hidden
