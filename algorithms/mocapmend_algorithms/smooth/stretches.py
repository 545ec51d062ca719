"""Smoothing runs piece by piece: what is smoothed, what stays as it is and why, how it joins.

Missing samples break a run into pieces. Each is smoothed together with the samples that follow it
without a gap on either side of the run; of the result, what lies inside the run is kept, faded
into the samples as they were where others join it.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.gaps import runs as true_runs
from mocapmend_algorithms.progress import Progress
from mocapmend_algorithms.recording import Recording
from mocapmend_algorithms.smooth.contract import Run, SmoothedRun, SmoothResult, Untouched

CONTEXT_S = 2.0
"""Beside a run, samples further than this are not looked at."""
FADE_S = 0.04
LEAST_FADE = 3
"""Frames, at low rates."""
LONGEST_FADE = 1 / 3
"""Share of a piece."""

Smooth = Callable[[list[FloatArray]], tuple[list[FloatArray], dict[str, Any]]]
"""Smooths the pieces of one run, each (samples, 3) and without a gap, and tells what it chose."""


@dataclass(frozen=True)
class Piece:
    """A stretch without a gap, frames counted from 0.

    Attributes
    ----------
    start, stop : int
        The samples that may change.
    first, last : int
        From where to where it is looked at; `last` is not included.
    """

    start: int
    stop: int
    first: int
    last: int

    @property
    def samples(self) -> int:
        """How many samples are looked at."""
        return self.last - self.first

    @property
    def inside(self) -> slice:
        """The samples that may change, among those that are looked at."""
        return slice(self.start - self.first, self.stop - self.first)


def pieces(seen: BoolArray, run: Run, context: int) -> Iterator[Piece]:
    """Break a run at its missing samples.

    Parameters
    ----------
    seen : ndarray of bool, shape (frames,)
        Which samples of the marker are there.
    run : Run
        The run.
    context : int
        How many samples to look at beside it.
    """
    low = max(run.start - context, 0)
    for first, last in true_runs(seen[low : run.stop + context]):
        start, stop = max(low + first, run.start), min(low + last, run.stop)
        if start < stop:
            yield Piece(start, stop, low + first, low + last)


def check_runs(recording: Recording, runs: Sequence[Run]) -> None:
    """Refuse runs that are outside the recording, or overlap.

    Raises
    ------
    ValueError
        With one sentence.
    """
    for run in runs:
        inside = 0 <= run.marker < recording.markers and 0 <= run.start < run.stop
        if not (inside and run.stop <= recording.frames):
            raise ValueError(f"{tuple(run)} is no stretch of the recording")
    for run, following in pairwise(sorted(runs)):
        if run.marker == following.marker and following.start < run.stop:
            raise ValueError(
                f"two stretches of {recording.labels[run.marker]} overlap: smooth one at a time"
            )


def smooth_runs(
    recording: Recording,
    runs: Sequence[Run],
    *,
    method: str,
    params: Any,
    least: int,
    least_longest: int = 0,
    smooth: Smooth,
    progress: Progress,
) -> SmoothResult:
    """Smooth runs one by one.

    Parameters
    ----------
    recording : Recording
        What is shown; not changed.
    runs : sequence of Run
        Where samples may change.
    method : str
        Id of the method.
    params : dataclass instance
        Its parameters.
    least : int
        Fewest samples on end that it can smooth.
    least_longest : int
        Fewest samples on end in the longest piece of a run, for what is chosen by it.
    smooth : callable
        See `Smooth`.
    progress : Progress
        Called before each run and at the end.

    Returns
    -------
    SmoothResult
    """
    done: list[SmoothedRun] = []
    untouched: list[Untouched] = []
    for number, run in enumerate(runs):
        progress(number / len(runs))
        long, left = sort_pieces(recording, run, least, least_longest)
        untouched += left
        if long:
            done.append(_smooth_run(recording, run, long, smooth))
    progress(1.0)
    return SmoothResult(method, asdict(params), tuple(done), tuple(untouched))


def sort_pieces(
    recording: Recording, run: Run, least: int, least_longest: int = 0
) -> tuple[list[Piece], list[Untouched]]:
    """Break a run and say which of its pieces are too short.

    Parameters
    ----------
    recording : Recording
        What is shown.
    run : Run
        The run.
    least, least_longest : int
        See `smooth_runs`.

    Returns
    -------
    long : list of Piece
        Those that are not.
    left : list of Untouched
        Those that are, or the whole run if no sample is there.
    """
    context = round(CONTEXT_S * recording.rate)
    found = list(pieces(recording.present[:, run.marker], run, context))
    if not found:
        return [], [Untouched(run, "There are no samples.")]
    if max(piece.samples for piece in found) < least_longest:
        least = least_longest
    short = [
        Untouched(
            Run(run.marker, piece.start, piece.stop),
            f"Only {_samples(piece.samples)} on end: this needs at least {least}.",
        )
        for piece in found
        if piece.samples < least
    ]
    return [piece for piece in found if piece.samples >= least], short


def _samples(count: int) -> str:
    return "1 sample" if count == 1 else f"{count} samples"


def cut(recording: Recording, run: Run, piece: Piece) -> FloatArray:
    """Return what is looked at of a piece, less its first sample, shape (samples, 3).

    Every method passes a constant unchanged, so taking one out costs nothing and saves digits.
    """
    points = recording.points[piece.first : piece.last, run.marker]
    shifted: FloatArray = points - points[0]
    return shifted


def _smooth_run(
    recording: Recording, run: Run, long: Sequence[Piece], smooth: Smooth
) -> SmoothedRun:
    before = recording.points[run.start : run.stop, run.marker]
    values, step = before.copy(), 0.0
    smoothed, chosen = smooth([cut(recording, run, piece) for piece in long])
    for piece, curve in zip(long, smoothed, strict=True):
        weights = _fade(piece, recording.rate)
        old = cut(recording, run, piece)[piece.inside]
        shift = weights[:, None] * (curve[piece.inside] - old)
        values[piece.start - run.start : piece.stop - run.start] += shift
        joined = _joined(piece)
        step = max(step, *np.linalg.norm(shift[joined], axis=1).tolist(), 0.0)
    return SmoothedRun(run, values, before, step, chosen)


def _joined(piece: Piece) -> list[int]:
    """Return the samples of a piece that have one beside them outside the run."""
    ends = [(0, piece.first < piece.start), (-1, piece.stop < piece.last)]
    return [place for place, joins in ends if joins]


def _fade(piece: Piece, rate: float) -> FloatArray:
    """Return how much of the curve each sample of a piece takes, from 0 to 1."""
    length = piece.stop - piece.start
    fade = min(max(LEAST_FADE, round(FADE_S * rate)), int(LONGEST_FADE * length))
    rising = np.sin(np.pi / 2 * np.arange(1, fade + 1) / (fade + 1)) ** 2
    weights = np.ones(length)
    for place in _joined(piece):
        if place == 0:
            weights[:fade] *= rising
        else:
            weights[length - fade :] *= rising[::-1]
    return weights
