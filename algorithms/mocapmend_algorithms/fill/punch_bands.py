"""Bands around a whole-recording fill, calibrated on how far it goes wrong where it is tested.

Each gap is tested by itself (gaps of the same frames together), so the cost is linear in the gaps
and the answer does not depend on which others are to be filled. An error counts relative to the
novelty of its posture: a gap in a posture unlike all known ones is filled worse.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.punch import LEAST_PLACES, Window
from mocapmend_algorithms.fill.punch_errors import BareFill, Measured, measure
from mocapmend_algorithms.fill.selftest import calibrate
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording

NOVELTY_FLOOR = 0.1
"""Share of the usual novelty below which postures are equally well known."""
TAUGHT_POWER = 0.5
"""Of the novelty where a method has learned elsewhere too, and knows some of what is new here."""
GROWTH = 0.25
"""Power by which errors grow with the length where the stretches are shorter than the gap."""
BARE_SHARE = 0.2
"""Of the progress: the fill itself; the self-tests take the rest."""


def fill_with_bands(
    recording: Recording,
    gaps: Sequence[Gap],
    fill: BareFill,
    progress: Progress,
    *,
    taught: bool = False,
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
    taught : bool
        Whether the method has learned from other recordings too.

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
    power = TAUGHT_POWER if taught else 1.0
    shares = np.linspace(BARE_SHARE, 1.0, len(windows) + 1).tolist()
    by_gap = {patch.gap: patch for patch in bare.patches}
    for done, (window, markers) in enumerate(windows.items()):
        share = part(progress, shares[done], shares[done + 1])
        measured = measure(recording, observed, window, markers, fill, share)
        for marker in markers:
            gap = Gap(marker, window.start, window.stop)
            bands[gap] = _banded(by_gap[gap], measured, window, power)
    progress(1.0)
    notes = {
        gap: {"self_tests": tests, "tested_frames": frames, **bare.notes.get(gap, {})}
        for gap, (_, tests, frames) in bands.items()
    }
    return FillResult(tuple(bands[p.gap][0] for p in bare.patches), bare.unfilled, notes)


def _banded(
    patch: Patch, measured: Measured, window: Window, power: float
) -> tuple[Patch, int, int]:
    errors, novelty = measured.errors[patch.gap.marker], measured.novelty[patch.gap.marker]
    count, length = errors.shape
    if count < LEAST_PLACES:
        return patch, 0, 0
    floor = NOVELTY_FLOOR * float(np.sqrt(np.mean(novelty**2)))
    if floor > 0:
        errors = errors / np.hypot(novelty, floor) ** power
    shape = _shape(errors, symmetric=window.before == window.after)
    band = calibrate(errors, np.zeros(count), count, shape)
    at, known = np.linspace(0, 1, window.length), np.linspace(0, 1, length)
    scale = np.full(window.length, (window.length / length) ** GROWTH)
    if floor > 0:
        scale *= np.hypot(measured.own_novelty, floor) ** power
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
