"""Samples that repeat the one before them exactly, while the marker goes on moving.

A marker that really stands still is measured with noise, and one that was held goes on with a jump.
A file in which repeats are usual, because all is still, up-sampled or made by a computer, is not
full of frozen markers: what is usual in it is left alone.
"""

from dataclasses import dataclass

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.gaps import runs
from mocapmend_algorithms.params import option
from mocapmend_algorithms.problems.bad_run import BadRun
from mocapmend_algorithms.problems.mates import mates_of
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.skeleton import Skeleton

MANY_RUNS = 0.02
"""Per frame: where a marker has more, only runs much longer than its others count."""
LEAST_RUNS = 6
MUCH_LONGER = 5.0
JUMP_MM, TIMES_BEFORE = 30.0, 5.0
"""A jump to where it stands still: at least so far, and so many times the steps before."""
TIMES_STEP = 1.8
"""How much longer than the steps after it the jump at the end of a freeze is."""


@dataclass(frozen=True)
class FrozenParams:
    """Parameters of `frozen`."""

    least_frames: int = option(
        2,
        label="Fewest repeats",
        text="Shorter runs of repeated samples are left alone.",
        minimum=1,
        unit="frames",
    )
    least_mm: float = option(
        3.0,
        label="Smallest deviation",
        text="Repeats are left alone where the marker has moved less in the meantime.",
        minimum=0.0,
        unit="mm",
    )


def frozen(
    recording: Recording, skeleton: Skeleton, params: FrozenParams, progress: Progress
) -> list[BadRun]:
    """Find samples that repeat the one before them while the marker goes on moving.

    Parameters
    ----------
    recording : Recording
        What to look at.
    skeleton : Skeleton
        Not used.
    params : FrozenParams
        The thresholds.
    progress : Progress
        Called once per marker.

    Returns
    -------
    list of BadRun
        Ordered by marker and start. The sample that is repeated is right and not among them.
    """
    del skeleton
    found: list[BadRun] = []
    mates: list[list[int]] | None = None
    for marker in range(recording.markers):
        done = marker / recording.markers
        progress(done)
        points = recording.points[:, marker]
        still = np.zeros(len(points), dtype=np.bool_)
        still[1:] = (points[1:] == points[:-1]).all(axis=1)
        for start, stop in _unusual(still, recording.present[:, marker], params.least_frames):
            if mates is None:
                mates = mates_of(recording, part(progress, done, done))
            jump = _jumped(recording, marker, start) * recording.mm
            if jump >= JUMP_MM:
                # What it stands still at is wrong as well.
                found.append(_after_jump(recording, marker, start - 1, stop, jump))
                continue
            away = _moved(recording, mates[marker], marker, start, stop) * recording.mm
            if away >= params.least_mm:
                found.append(_described(recording, marker, start, stop, away))
    return found


def _unusual(still: BoolArray, present: BoolArray, least: int) -> list[tuple[int, int]]:
    """Return the runs of repeats that are long, and much longer than what is usual."""
    held = runs(still)
    if len(held) > max(LEAST_RUNS, MANY_RUNS * int(present.sum())):
        usual = float(np.median([stop - start for start, stop in held]))
        least = max(least, int(MUCH_LONGER * usual) + 1)
    return [(a, b) for a, b in held if b - a >= least]


def _jumped(recording: Recording, marker: int, start: int) -> float:
    """Return how far a marker has jumped to where it stands still; 0 where it went there."""
    before = recording.points[max(0, start - 6) : start, marker]
    steps = np.sqrt(np.sum(np.diff(before, axis=0) ** 2, axis=1))
    if steps.size < 3 or np.isnan(steps).any():
        return 0.0
    jump = float(steps[-1])
    return jump if jump >= TIMES_BEFORE * float(np.median(steps[:-1])) else 0.0


def _moved(recording: Recording, mates: list[int], marker: int, start: int, stop: int) -> float:
    """Estimate how far the marker has gone while its samples stood still; 0 where it has not."""
    points = recording.points
    if stop < recording.frames and recording.present[stop, marker]:
        after = points[stop : stop + 3, marker]
        jump = _length(after[0] - points[stop - 1, marker])
        steps = np.sqrt(np.sum(np.diff(after, axis=0) ** 2, axis=1))
        steps = steps[~np.isnan(steps)]
        usual = float(steps.mean()) if steps.size else 0.0
        return jump if jump >= TIMES_STEP * usual else 0.0
    # It never goes on: only the neighbours can tell.
    paths = [points[start - 1 : stop, mate] for mate in mates]
    moved = [_spread(path - points[start - 1 : stop, marker]) for path in paths]
    known = [value for value in moved if not np.isnan(value)]
    return float(np.min(known)) if len(known) > 1 else 0.0


def _spread(apart: FloatArray) -> float:
    """Return by how much a distance changes."""
    length = np.sqrt(np.einsum("tk,tk->t", apart, apart))
    length = length[~np.isnan(length)]
    return float(length.max() - length.min()) if length.size > 1 else float("nan")


def _length(vector: FloatArray) -> float:
    return float(np.sqrt(vector @ vector))


def _after_jump(recording: Recording, marker: int, start: int, stop: int, jump: float) -> BadRun:
    return BadRun(
        kind="frozen",
        marker=marker,
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-jump / 50.0)),
        deviation=jump / recording.mm,
        reason=f"It jumps {jump:.0f} mm, and then the same coordinates are repeated "
        f"{stop - start - 1} times.",
    )


def _described(recording: Recording, marker: int, start: int, stop: int, away: float) -> BadRun:
    length = stop - start
    times = "once" if length == 1 else f"{length} times"
    return BadRun(
        kind="frozen",
        marker=marker,
        start=start,
        stop=stop,
        score=float(1.0 - 0.5 * np.exp(-away / 20.0 - length / 10.0)),
        # It has moved by and by: half of the way is what the samples are away on average.
        deviation=away / 2.0 / recording.mm,
        reason=f"The same coordinates are repeated {times}, while it has moved by {away:.0f} mm.",
    )
