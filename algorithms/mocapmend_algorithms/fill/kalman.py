"""Constant-velocity Kalman filter and smoother of one marker (L21).

L21 = Wang, Lü, Mu 2021, Techniques of Automation and Applications 40(4):116-119. The state is
[f, v], position and velocity, and f_t = f_(t-1) + v dt (eqs. 2, 3); the velocity changes at random
(white acceleration). The three axes are filtered alike, so one 2 x 2 covariance serves all, and
what the filter makes of a window is a fixed matrix times the observed samples.

Two-sided, the default: filters from both sides are combined in the gap, and what is left over at
the two edge samples is carried linearly into it. Causal: the filter from the left alone, as a live
system would show; it does not meet the edges.

In the local frame, the default, the common rigid motion of the marker's neighbours is taken out
before and put back after; the world frame is as printed. Samples that the marker jumps to (eq. 1)
and those that an innovation gate refuses are not looked at. Predicted points may be pulled to the
bone lengths.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import FloatArray, IntArray
from mocapmend_algorithms.fill.bones import Bones, pull
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.donors import by_label, check_seen
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.excerpt import Excerpt, cut, excerpt_frames
from mocapmend_algorithms.fill.gate import MOST_SAMPLES, unbelievable
from mocapmend_algorithms.fill.kalman_settings import causal, two_sided, velocity_steps
from mocapmend_algorithms.fill.neighbours import choose_donors
from mocapmend_algorithms.fill.trusted import TrustedSamples
from mocapmend_algorithms.fill.window import Candidate, WindowMethod, fill_windows
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording

REACH = 16
MOST_BONES = 4
LOOSEST_BONE = 0.02
LEAST_SPREAD_MM = 0.5


@dataclass(frozen=True)
class KalmanParams:
    """Parameters of `kalman`."""

    direction: Literal["two-sided", "causal"] = option(
        "two-sided",
        label="Direction",
        text="Two-sided uses the samples before and after the gap; causal only those before, "
        "as a live system must.",
    )
    frame: Literal["local", "world"] = option(
        "local",
        label="Frame",
        text="Local: the common rigid motion of the neighbouring markers is taken out first; "
        "where fewer than three keep their distance and are seen all along, the world frame is "
        "used. World: as printed in the paper.",
    )
    donors: tuple[str, ...] = option(
        (),
        label="Donors",
        text="Local frame only: the labels of the markers whose common motion is taken out; one "
        "or two are followed without their rotation. Automatic: the four that keep their "
        "distance to the marker best.",
    )
    noise_mm: float | None = option(
        None,
        label="Measurement noise",
        text="Standard deviation of a measured coordinate. More noise means that more samples "
        "beside the gap share in its velocity. Automatic: chosen by self-tests for each gap.",
        minimum=0.0,
        maximum=1000.0,
        unit="mm",
    )
    velocity_interval_ms: float | None = option(
        None,
        label="Velocity interval",
        text="Causal only: the fixed interval over which the velocity is taken; 0 takes it "
        "between consecutive frames. Automatic: chosen by self-tests for each gap.",
        minimum=0.0,
        maximum=1000.0,
        unit="ms",
    )
    jump_mm: float | None = option(
        None,
        label="Jump",
        text="A marker that moves further between two frames was lost or is wrong there, and its "
        "samples beside such a jump are not trusted. A large number switches this off. "
        "Automatic: estimated from the motion of each marker.",
        minimum=0.0,
        maximum=1e6,
        unit="mm",
    )
    gate: float = option(
        5.0,
        label="Gate",
        text="A single sample beside the gap is not trusted if it lies more than this many "
        "standard deviations from what the filter makes of the others. A large number switches "
        "this off.",
        minimum=1.0,
        maximum=1e6,
    )
    bone_pull: bool = option(
        False,  # noqa: FBT003 - the default of a form
        label="Pull to bone lengths",
        text="Moves the predicted points towards the lengths of the bones to up to four markers "
        "at a nearly constant distance, as far as the filter is unsure and the lengths are not.",
    )


def kalman(
    recording: Recording, gaps: Sequence[Gap], params: KalmanParams, progress: Progress, /
) -> FillResult:
    """Fill gaps with the constant-velocity model.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        Those at the beginning and the end of the recording stay open.
    params : KalmanParams
        What is None is chosen per gap by self-tests.
    progress : Progress
        Called before each gap.

    Returns
    -------
    FillResult
        `sigma` is the smoother's, multiplied by a factor that the self-tests measure. The notes
        hold the `frame`; in the local one the labels of the `donors`; where there are any, the
        numbers of the `distrusted` frames in the window and the labels at the ends of the `bones`.
    """
    return fill_each(gaps, _Filler(recording, gaps, params).fill, progress)


class _Filler:
    """Fills the gaps of one recording."""

    def __init__(self, recording: Recording, gaps: Sequence[Gap], params: KalmanParams) -> None:
        self._recording = recording
        self._params = params
        self._samples = TrustedSamples(recording, gaps, params.jump_mm)
        self._method = _window_method(recording, params)

    def fill(self, gap: Gap, _: Progress) -> tuple[Patch, dict[str, Any]]:
        """Fill a gap and say how."""
        samples = self._samples
        window = samples.window(gap, self._method.reach)
        donors = self._donors(gap, window)
        frames = excerpt_frames(gap, window, self._recording.frames)
        near = partial(samples.near, gap.marker)
        span = int(np.ptp(window)) + 1 if window.size else gap.length
        excerpt = cut(self._recording, samples.seen, gap, frames, span, near, donors)
        refused = _refused(excerpt, window - frames.start, self._params.gate)
        if refused.size:
            excerpt = excerpt.without(refused)
        result = fill_windows(excerpt.recording, [excerpt.gap], self._method, no_progress)
        if result.unfilled:
            raise LeftOpenError(result.unfilled[0].reason)
        (part,) = result.patches
        patch = Patch(gap, excerpt.to_world(part.values), part.sigma, part.r90)
        notes = {**result.notes[part.gap], "frame": "local" if donors else "world"}
        if donors:
            notes["donors"] = self._labels(donors)
        if distrusted := self._distrusted(gap, window, refused + frames.start):
            notes["distrusted"] = distrusted
        return self._pulled(patch, notes) if self._params.bone_pull else (patch, notes)

    def _donors(self, gap: Gap, window: IntArray) -> tuple[int, ...]:
        after = int(np.searchsorted(window, gap.start))
        if self._params.frame == "world" or after in (0, window.size):
            return ()
        seen, labels = self._samples.seen, self._recording.labels
        if not self._params.donors:
            needed = np.concatenate((window, np.arange(gap.start, gap.stop)))
            return choose_donors(self._samples.near(gap.marker), needed, seen)
        named = by_label(labels, self._params.donors)
        check_seen(labels, seen, gap, named, at_edges=True)
        return tuple(named.tolist())

    def _distrusted(self, gap: Gap, window: IntArray, refused: IntArray) -> tuple[int, ...]:
        wrong = self._samples.wrong(gap.marker)
        wrong = wrong[(wrong >= window[0]) & (wrong <= window[-1])]
        both = np.union1d(wrong, refused) + self._recording.first_frame
        return tuple(both.tolist())

    def _pulled(self, patch: Patch, notes: dict[str, Any]) -> tuple[Patch, dict[str, Any]]:
        gap, near = patch.gap, self._samples.near(patch.gap.marker)
        partners = near.rigid(LOOSEST_BONE)[:MOST_BONES].tolist()
        if not partners or np.isnan(patch.sigma).any():
            return patch, notes
        missing = slice(gap.start, gap.stop)
        seen = np.stack([self._samples.seen(other)[missing] for other in partners], axis=1)
        ends = np.where(seen[:, :, None], self._recording.points[missing][:, partners], np.nan)
        spread = np.maximum(near.spread[partners], LEAST_SPREAD_MM / self._recording.mm)
        values, share = pull(patch.values, patch.sigma, Bones(ends, near.length[partners], spread))
        notes = {**notes, "bones": self._labels(partners)}
        shrunk = replace(patch, values=values, sigma=share * patch.sigma, r90=share * patch.r90)
        return shrunk, notes

    def _labels(self, markers: Sequence[int]) -> tuple[str, ...]:
        return tuple(self._recording.labels[marker] for marker in markers)


def _refused(excerpt: Excerpt, window: IntArray, gate: float) -> IntArray:
    """Return the frames beside the gap that the gate refuses; each side is judged alone."""
    points = excerpt.recording.points[:, 0]
    known = window[~np.isnan(points[window, 0])]
    before, after = known[known < excerpt.gap.start], known[known >= excerpt.gap.stop]
    sides = before[-MOST_SAMPLES:], after[:MOST_SAMPLES]
    return np.concatenate([side[unbelievable(points, side, gate)] for side in sides])


def _window_method(recording: Recording, params: KalmanParams) -> WindowMethod:
    rate, mm, noise = recording.rate, recording.mm, params.noise_mm
    if params.direction == "two-sided":

        def smoothers(points: FloatArray) -> list[Candidate]:
            return two_sided(points, rate, mm, noise)

        return WindowMethod(smoothers, "the filter", reach=REACH)
    steps = velocity_steps(params.velocity_interval_ms, rate)

    def filters(points: FloatArray) -> list[Candidate]:
        return causal(points, rate, mm, noise, steps)

    reach = max(REACH, 4 * max(steps))
    return WindowMethod(filters, "the filter", reach=reach, least_before=2)
