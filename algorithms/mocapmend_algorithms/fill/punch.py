"""How far a whole-recording fill goes wrong: punch, refill, compare, calibrate.

A method that looks at other markers is tested on the recording itself. Stretches of the marker
with the gap are hidden where it is observed, as long as the gap, and with it the gap's *company*:
whatever else is missing inside the gap is hidden there too. Several stretches are punched at once,
the punched recording is filled by the same function, and the distances from the hidden samples
say how wrong it is. Each gap is tested by itself (gaps of the same frames together), so the cost
is linear in the gaps and the answer does not depend on which others are to be filled.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray, IntArray
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.edges import sides
from mocapmend_algorithms.fill.novelty import Novelty
from mocapmend_algorithms.fill.selftest import calibrate
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

MOST_TESTS = 16
LEAST_TESTS = 3
HIDDEN_SHARE = 0.25
"""Share of the marker's frames that one run may hide: the fill learns from the others."""
LENGTH_SHARE = 0.15
"""Share that one stretch may hide."""
NOVELTY_FLOOR = 0.1
"""Share of the usual novelty below which postures are equally well known."""
GROWTH = 0.25
"""Power by which errors grow with the length where the stretches are shorter than the gap."""
BARE_SHARE = 0.2
"""Of the progress: the fill itself; the self-tests take the rest."""


class BareFill(Protocol):
    """Fills gaps without a word on its errors."""

    def __call__(
        self, recording: Recording, observed: BoolArray, gaps: Sequence[Gap], progress: Progress, /
    ) -> FillResult:
        """Fill the given gaps, in their order, with NaN for `sigma` and `r90`.

        Parameters
        ----------
        recording : Recording
            Not changed.
        observed : ndarray of bool, shape (frames, markers)
            The samples that may be looked at.
        gaps : sequence of Gap
            Runs of samples that are not observed. Where the sample next to one is not observed
            either, that side is open, as at the beginning of a recording.
        progress : Progress
            Called often.
        """


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


@dataclass(frozen=True, eq=False)
class Tests:
    """What the self-tests of a window say.

    Attributes
    ----------
    errors : mapping of int to ndarray, shape (tests, frames)
        Per marker the 3-D distances from the hidden samples. The stretches are shorter than the
        window where a recording has no room for such long ones.
    novelty : mapping of int to ndarray, shape (tests, frames)
        How unlike the known postures those in the stretches are.
    own_novelty : ndarray, shape (length,)
        The same in the window itself.
    """

    errors: Mapping[int, FloatArray]
    novelty: Mapping[int, FloatArray]
    own_novelty: FloatArray


def fill_with_bands(
    recording: Recording, gaps: Sequence[Gap], fill: BareFill, progress: Progress
) -> FillResult:
    """Fill gaps and measure on the recording itself how wrong the fill is.

    Parameters
    ----------
    recording : Recording
        Not changed. Samples inside the given gaps are never looked at.
    gaps : sequence of Gap
        The gaps to fill.
    fill : BareFill
        The method; it is called once for the gaps and a few times per gap for the self-tests.
    progress : Progress
        Called often, from 0 to 1.

    Returns
    -------
    FillResult
        That of `fill`, with `sigma` and `r90`, and with `self_tests` and `tested_frames` (their
        length) per gap in the notes; both are 0 where nothing can be tested.
    """
    progress(0.0)
    observed = seen_outside(recording.present, gaps)
    bare = fill(recording, observed, gaps, part(progress, 0.0, BARE_SHARE))
    windows: dict[Window, list[int]] = {}
    for patch in bare.patches:
        windows.setdefault(Window.of(observed, patch.gap), []).append(patch.gap.marker)
    bands: dict[Gap, tuple[Patch, int, int]] = {}
    shares = np.linspace(BARE_SHARE, 1.0, len(windows) + 1).tolist()
    by_gap = {patch.gap: patch for patch in bare.patches}
    for done, (window, markers) in enumerate(windows.items()):
        share = part(progress, shares[done], shares[done + 1])
        tests = measure(recording, observed, window, markers, fill, share)
        for marker in markers:
            gap = Gap(marker, window.start, window.stop)
            bands[gap] = _banded(by_gap[gap], tests, window)
    progress(1.0)
    notes = {
        gap: {"self_tests": tests, "tested_frames": frames, **bare.notes.get(gap, {})}
        for gap, (_, tests, frames) in bands.items()
    }
    return FillResult(tuple(bands[p.gap][0] for p in bare.patches), bare.unfilled, notes)


def measure(
    recording: Recording,
    observed: BoolArray,
    window: Window,
    markers: Sequence[int],
    fill: BareFill,
    progress: Progress,
) -> Tests:
    """Measure a fill's errors in stretches that are hidden as a window is.

    Parameters
    ----------
    recording : Recording
        Not changed.
    observed : ndarray of bool, shape (frames, markers)
        The samples that may be looked at.
    window : Window
        The gap to imitate.
    markers : sequence of int
        Markers that are missing in it.
    fill : BareFill
        The method.
    progress : Progress
        Called often.

    Returns
    -------
    Tests
    """
    members = np.flatnonzero(window.alike(observed))
    places, length = find_places(observed, window, members)
    novelty = Novelty.of(recording, observed, members, window.start, window.stop)
    errors: dict[int, list[FloatArray]] = {marker: [] for marker in markers}
    strange: dict[int, list[FloatArray]] = {marker: [] for marker in markers}
    runs = list(_runs(places, length, int(observed[:, members].all(axis=1).sum())))
    for done, at in enumerate(runs):
        hidden = _punched(observed, window, members, at, length)
        gaps = [Gap(marker, p, p + length) for marker in sorted(markers) for p in at.tolist()]
        share = part(progress, done / len(runs), (done + 1) / len(runs))
        posture = {p: novelty(hidden, p, p + length) for p in at.tolist()}
        for patch in fill(recording, hidden, gaps, share).patches:
            gap = patch.gap
            truth = recording.points[gap.start : gap.stop, gap.marker]
            errors[gap.marker].append(np.linalg.norm(patch.values - truth, axis=1))
            strange[gap.marker].append(posture[gap.start])
    return Tests(
        {marker: np.array(found).reshape(len(found), length) for marker, found in errors.items()},
        {marker: np.array(found).reshape(len(found), length) for marker, found in strange.items()},
        novelty(observed, window.start, window.stop),
    )


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
    seen = _cumulative(observed[:, members].all(axis=1))
    missing = _cumulative((~observed).sum(axis=1))
    length = min(window.length, max(int(LENGTH_SHARE * seen[-1]), 1))
    places = _places(seen, missing, length, window)
    while places.size < LEAST_TESTS and length > 1:
        length //= 2
        places = _places(seen, missing, length, window)
    if places.size < LEAST_TESTS:
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
        if len(places) >= LEAST_TESTS:
            break
    chosen = np.array(places, dtype=np.int64)
    if chosen.size > MOST_TESTS:
        chosen = chosen[np.linspace(0, chosen.size - 1, MOST_TESTS).round().astype(np.int64)]
    return chosen


def _runs(places: IntArray, length: int, frames: int) -> Iterator[IntArray]:
    """Deal the places to runs that each hide few enough frames."""
    if not places.size:
        return
    most = max(int(HIDDEN_SHARE * frames) // length, 1)
    count = -(-places.size // most)
    for first in range(count):
        yield places[first::count]


def _punched(
    observed: BoolArray, window: Window, members: IntArray, places: IntArray, length: int
) -> BoolArray:
    hidden = observed.copy()
    pattern = observed[window.start + np.arange(length) * window.length // length]
    for place in places.tolist():
        hidden[place : place + length] &= pattern
        if not window.before and place > 0:
            hidden[place - 1, members] = False
        if not window.after and place + length < hidden.shape[0]:
            hidden[place + length, members] = False
    return hidden


def _banded(patch: Patch, tests: Tests, window: Window) -> tuple[Patch, int, int]:
    errors, novelty = tests.errors[patch.gap.marker], tests.novelty[patch.gap.marker]
    count, length = errors.shape
    if count < LEAST_TESTS:
        return patch, 0, 0
    floor = NOVELTY_FLOOR * float(np.sqrt(np.mean(novelty**2)))
    if floor > 0:
        errors = errors / np.hypot(novelty, floor)
    shape = _shape(errors, symmetric=window.before == window.after)
    band = calibrate(errors, np.zeros(count), count, shape)
    at, known = np.linspace(0, 1, window.length), np.linspace(0, 1, length)
    scale = np.full(window.length, (window.length / length) ** GROWTH)
    if floor > 0:
        scale *= np.hypot(tests.own_novelty, floor)
    sigma, r90 = np.interp(at, known, band.sigma), np.interp(at, known, band.r90)
    return replace(patch, sigma=scale * sigma, r90=scale * r90), count, length


def _shape(errors: FloatArray, *, symmetric: bool) -> FloatArray:
    """How the error grows and falls along the gap, smoothed over a fifth of it."""
    square = np.mean(errors**2, axis=0)
    if symmetric:
        square = (square + square[::-1]) / 2
    half = square.size // 10
    padded = np.pad(square, half, mode="edge")
    shape: FloatArray = np.sqrt(np.convolve(padded, np.ones(2 * half + 1), "valid"))
    return shape


def _cumulative(values: Any) -> IntArray:
    return np.concatenate(([0], np.cumsum(values, dtype=np.int64)))
