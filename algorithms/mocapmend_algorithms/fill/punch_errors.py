"""How far a whole-recording fill goes wrong: punch, refill, compare.

A method that looks at other markers is tested on the recording itself. Stretches of the marker
with the gap are hidden where it is observed, the punched recording is filled by the same function,
and the distances from the hidden samples say how wrong it is.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from mocapmend_algorithms.arrays import BoolArray, FloatArray
from mocapmend_algorithms.fill.contract import FillResult
from mocapmend_algorithms.fill.novelty import Novelty
from mocapmend_algorithms.fill.punch import Window, deal, find_places, punch
from mocapmend_algorithms.gaps import Gap
from mocapmend_algorithms.progress import Progress, part
from mocapmend_algorithms.recording import Recording


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


@dataclass(frozen=True, eq=False)
class Measured:
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


def measure(
    recording: Recording,
    observed: BoolArray,
    window: Window,
    markers: Sequence[int],
    fill: BareFill,
    progress: Progress,
) -> Measured:
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
    Measured
    """
    members = np.flatnonzero(window.alike(observed))
    places, length = find_places(observed, window, members)
    novelty = Novelty.of(recording, observed, members, window.start, window.stop)
    errors: dict[int, list[FloatArray]] = {marker: [] for marker in markers}
    strange: dict[int, list[FloatArray]] = {marker: [] for marker in markers}
    runs = list(deal(places, length, int(observed[:, members].all(axis=1).sum())))
    for done, at in enumerate(runs):
        hidden = punch(observed, window, members, at, length)
        gaps = [Gap(marker, p, p + length) for marker in sorted(markers) for p in at.tolist()]
        share = part(progress, done / len(runs), (done + 1) / len(runs))
        posture = {p: novelty(hidden, p, p + length) for p in at.tolist()}
        for patch in fill(recording, hidden, gaps, share).patches:
            gap = patch.gap
            truth = recording.points[gap.start : gap.stop, gap.marker]
            errors[gap.marker].append(np.linalg.norm(patch.values - truth, axis=1))
            strange[gap.marker].append(posture[gap.start])
    return Measured(
        {marker: np.array(found).reshape(len(found), length) for marker, found in errors.items()},
        {marker: np.array(found).reshape(len(found), length) for marker, found in strange.items()},
        novelty(observed, window.start, window.stop),
    )
