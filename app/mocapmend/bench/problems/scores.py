"""How well what was found agrees with what was done."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from mocapmend.bench.grid import share
from mocapmend.bench.problems.corruption import Canvas
from mocapmend_algorithms.arrays import BoolArray
from mocapmend_algorithms.problems import BadRun


@dataclass
class Score:
    """Counts over some recordings.

    Attributes
    ----------
    right, false, missed : int
        Samples: bad and found, found but not bad, bad but not found.
    earlier : int
        Samples that were found and that the recording's own errors may explain.
    errors, found : int
        Errors that were put in, and those of which a sample was found.
    latencies : list of int
        Frames from the first bad sample to the first found one, of each error found.
    """

    right: int = 0
    false: int = 0
    earlier: int = 0
    missed: int = 0
    errors: int = 0
    found: int = 0
    latencies: list[int] = field(default_factory=list)

    def count(self, canvas: Canvas, flagged: BoolArray, own: BoolArray) -> None:
        """Count one recording.

        Parameters
        ----------
        canvas : Canvas
            What was done to it.
        flagged : ndarray of bool, shape (frames, markers)
            What was found.
        own : ndarray of bool, shape (frames, markers of the source)
            Errors that the recording has had before; they are counted apart.
        """
        truth = canvas.truth()
        false = flagged & ~truth
        earlier = np.zeros_like(truth)
        earlier[:, : own.shape[1]] = own
        self.right += int(np.count_nonzero(truth & flagged))
        self.false += int(np.count_nonzero(false & ~earlier))
        self.earlier += int(np.count_nonzero(false & earlier))
        self.missed += int(np.count_nonzero(truth & ~flagged))
        for error in canvas.errors:
            inside = flagged[error.start : error.stop, list(error.markers)].any(axis=1)
            self.errors += 1
            if inside.any():
                self.found += 1
                self.latencies.append(int(np.argmax(inside)))

    @property
    def precision(self) -> float:
        """Share of the samples found that are bad."""
        return share(self.right, self.right + self.false)

    @property
    def strict_precision(self) -> float:
        """The same where the recordings are held for faultless."""
        return share(self.right, self.right + self.false + self.earlier)

    @property
    def recall(self) -> float:
        """Share of the bad samples that were found."""
        return share(self.right, self.right + self.missed)

    @property
    def f1(self) -> float:
        """Harmonic mean of precision and recall."""
        return share(2 * self.right, 2 * self.right + self.false + self.missed)

    @property
    def strict_f1(self) -> float:
        """F1 where the recordings are held for faultless."""
        wrong = self.false + self.earlier + self.missed
        return share(2 * self.right, 2 * self.right + wrong)

    @property
    def latency(self) -> tuple[float, float]:
        """Median and 95th percentile of the latencies, in frames."""
        if not self.latencies:
            return float("nan"), float("nan")
        return float(np.median(self.latencies)), float(np.quantile(self.latencies, 0.95))


def flagged(shape: tuple[int, int], runs: Sequence[BadRun], *, both: bool = False) -> BoolArray:
    """Return which samples some runs call bad, shape (frames, markers); of both where asked."""
    mask = np.zeros(shape, dtype=np.bool_)
    for run in runs:
        mask[run.start : run.stop, run.marker] = True
        if both and run.other is not None:
            mask[run.start : run.stop, run.other] = True
    return mask
