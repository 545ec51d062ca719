"""Fill a gap in periodic motion from the same phase of neighbouring cycles.

For gait, pedalling and the like. A neighbouring cycle is moved by about a whole number of
periods: by the lag, within a tenth of a period, at which it runs most like the marker beside the
gap. What it leaves over at the edge samples is carried into the gap linearly, and up to two
cycles on either side are averaged.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from mocapmend_algorithms.arrays import IntArray
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.fill.cycles import Place, from_cycles
from mocapmend_algorithms.fill.each import LeftOpenError, fill_each
from mocapmend_algorithms.fill.period import find_period
from mocapmend_algorithms.fill.selftest import Calibration, TrialFinder, calibrate
from mocapmend_algorithms.gaps import Gap, seen_outside
from mocapmend_algorithms.params import option
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording

BESIDE = 0.1
"""How much beside the gap is compared on each side, as a share of the period."""
MOST_BESIDE = 20
LEAST_TESTS = 5


@dataclass(frozen=True)
class CyclicParams:
    """Parameters of `cyclic`."""

    period: float | None = option(
        None,
        label="Period",
        text="How long a cycle lasts. Automatic: estimated from the marker, or from all markers "
        "where this one alone does not repeat itself.",
        minimum=0.05,
        maximum=60.0,
        unit="s",
    )
    edges: Literal["leave", "repeat"] = option(
        "leave",
        label="Start and end",
        text="What to do with a gap at the start or the end of the recording: leave it open, or "
        "repeat the neighbouring cycles there.",
    )


def cyclic(
    recording: Recording, gaps: Sequence[Gap], params: CyclicParams, progress: Progress, /
) -> FillResult:
    """Fill gaps from neighbouring cycles.

    Parameters
    ----------
    recording : Recording
        Not changed.
    gaps : sequence of Gap
        The gaps to fill. Those in motion that does not repeat, or without another cycle in which
        the marker is seen throughout, stay open.
    params : CyclicParams
        With `period` None it is estimated for each marker.
    progress : Progress
        Called before each gap.

    Returns
    -------
    FillResult
        With `period_s`, `cycles` (lags in seconds), `self_tests` and `tested_on` per gap.
    """
    return fill_each(gaps, _Filler(recording, gaps, params).fill, progress)


class _Filler:
    """Cycles of one recording, and what was learned from its self-tests."""

    def __init__(self, recording: Recording, gaps: Sequence[Gap], params: CyclicParams) -> None:
        self._recording = recording
        self._params = params
        self._seen = seen_outside(recording.present, gaps)
        self._finder = TrialFinder(self._seen)
        self._periods: dict[int, float | None] = {}
        self._tests: dict[tuple[int, int, bytes], tuple[Calibration | None, dict[str, Any]]] = {}

    def fill(self, gap: Gap, _: Progress) -> tuple[Patch, dict[str, Any]]:
        """Fill a gap."""
        seen = self._seen[:, gap.marker]
        if not seen.any():
            raise LeftOpenError("the marker is never seen in this recording")
        frames = np.flatnonzero(seen)
        middle = int(np.searchsorted(frames, gap.start))
        if middle in (0, frames.size) and self._params.edges == "leave":
            side, frame = ("after", frames[-1]) if middle else ("before", frames[0])
            at = int(frame) + self._recording.first_frame
            raise LeftOpenError(
                f"the marker is never seen {side} frame {at}: this method needs both sides"
            )
        period = self._period(gap.marker)
        if period is None:
            raise LeftOpenError(
                "the motion is not periodic: it does not repeat itself closely enough"
            )
        place = Place(gap.start, gap.length, _beside(frames - gap.start, gap.length, period))
        points = self._recording.points[:, gap.marker]
        made = from_cycles(points, seen, place, period)
        if made is None:
            seconds = period / self._recording.rate
            raise LeftOpenError(
                f"no other cycle of {seconds:.2f} s has this marker in all frames that are "
                "missing here"
            )
        values, lags, misfit = made
        calibration, notes = self._tested(gap.marker, place, period)
        rate = self._recording.rate
        notes = {"period_s": period / rate, "cycles": [lag / rate for lag in lags], **notes}
        if calibration is None:
            unknown = np.full(gap.length, np.nan)
            return Patch(gap, values, unknown, unknown), notes
        scale = calibration.scale(misfit)
        return Patch(gap, values, scale * calibration.sigma, scale * calibration.r90), notes

    def _period(self, marker: int) -> float | None:
        """Return the period in frames: the marker's own, else that of all markers."""
        rate = self._recording.rate
        if self._params.period is not None:
            return max(2.0, self._params.period * rate)
        for columns in ([marker], list(range(self._recording.markers))):
            key = marker if len(columns) == 1 else -1
            if key not in self._periods:
                seen = self._seen[:, columns, None]
                points = np.where(seen, self._recording.points[:, columns], np.nan)
                self._periods[key] = find_period(points, rate)
            if self._periods[key] is not None:
                return self._periods[key]
        return None

    def _tested(
        self, marker: int, place: Place, period: float
    ) -> tuple[Calibration | None, dict[str, Any]]:
        key = (marker, place.length, place.beside.tobytes())
        if key not in self._tests:
            self._tests[key] = self._test(marker, place, period)
        return self._tests[key]

    def _test(
        self, marker: int, place: Place, period: float
    ) -> tuple[Calibration | None, dict[str, Any]]:
        untested = {"self_tests": 0, "tested_on": "nothing"}
        trials = self._finder.find(marker, place.beside, place.length)
        if trials is None:
            return None, untested
        errors, misfits = [], []
        for start, column in zip(trials.frames.tolist(), trials.markers.tolist(), strict=True):
            seen = self._seen[:, column].copy()
            hidden = slice(start, start + place.length)
            seen[hidden] = False
            points = self._recording.points[:, column]
            made = from_cycles(points, seen, Place(start, place.length, place.beside), period)
            if made is not None:
                errors.append(np.linalg.norm(made[0] - points[hidden], axis=1))
                misfits.append(made[2])
        if len(errors) < LEAST_TESTS:
            return None, untested
        on = "this marker" if trials.own else "all markers"
        disjoint = max(1, trials.disjoint * len(errors) // trials.frames.size)
        calibration = calibrate(np.array(errors), np.array(misfits), disjoint)
        return calibration, {"self_tests": len(errors), "tested_on": on}


def _beside(frames: IntArray, length: int, period: float) -> IntArray:
    """Choose observed frames, counted from the start of a gap, to compare cycles in.

    Frames beyond another gap belong to another phase; more than 20 on a side say no more.
    """
    width = max(2, round(BESIDE * period))
    step = -(-width // MOST_BESIDE)
    before, after = frames[frames < 0][-width:], frames[frames >= length][:width]
    before = before[before > before.max(initial=-1) - width]
    after = after[after < after.min(initial=length) + width]
    return np.concatenate((before[::-step][::-1], after[::step]))
