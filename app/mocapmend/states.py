"""The state of every sample, and the runs and gaps that follow from it. No Qt."""

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.files import Source
from mocapmend.state import OPEN, SampleState
from mocapmend_algorithms import Gap

NO_RUNS = np.empty((0, 2), np.int64)
KINDS = tuple(SampleState)


class States:
    """What is known of every sample of a document.

    It takes a while to make for a long recording, so that who reads the file makes it.

    Parameters
    ----------
    source : Source
        The recording as it was read; its earlier repairs count as filled, and what it says is
        never to be filled is so.
    """

    def __init__(self, source: Source) -> None:
        present = source.recording.present
        # Trajectories are what is looked through: in memory each is one piece.
        self._states = np.full(present.shape, SampleState.MEASURED, np.uint8, order="F")
        self._states[np.divmod(_places(~present.reshape(-1)), max(1, present.shape[1]))] = (
            SampleState.MISSING
        )
        for run in source.smoothed:
            states = self._states[run.start : run.stop, run.marker]
            states[states == SampleState.MEASURED] = SampleState.SMOOTHED
        for run in source.set_aside:
            self._states[run.start : run.stop, run.marker] = SampleState.BAD
        for gap in source.repaired:
            self._states[gap.start : gap.stop, gap.marker] = SampleState.FILLED
        for gap in source.never_filled:
            self._states[gap.start : gap.stop, gap.marker] = SampleState.NEVER
        markers = range(present.shape[1])
        self._runs = [self._find_runs(marker) for marker in markers]
        self._open = [self._find_open(marker) for marker in markers]
        self._gaps = [_as_gaps(marker, self._open[marker]) for marker in markers]
        self._all_gaps: list[Gap] | None = None
        self._fillable: tuple[list[Gap], NDArray[np.int64]] | None = None
        _ = self.gaps, self.fillable

    @property
    def array(self) -> NDArray[np.uint8]:
        """`SampleState` of every sample, shape (frames, markers); a read-only view."""
        view = self._states.view()
        view.flags.writeable = False
        return view

    @property
    def gaps(self) -> list[Gap]:
        """The gaps that are open, by marker and start; not to be changed."""
        if self._all_gaps is None:
            self._all_gaps = [gap for of_marker in self._gaps for gap in of_marker]
        return self._all_gaps

    @property
    def fillable(self) -> tuple[list[Gap], NDArray[np.int64]]:
        """The open gaps of markers that are seen at all, and the same as an array.

        Returns
        -------
        gaps : list of Gap
            By marker and start; not to be changed.
        corners : ndarray, shape (gaps, 3)
            Marker, start and stop of each.
        """
        if self._fillable is None:
            self._fillable = self._find_fillable()
        return self._fillable

    def gaps_of(self, marker: int) -> list[Gap]:
        """Return the open gaps of one marker, by start; not to be changed."""
        return self._gaps[marker]

    def runs(self, marker: int, state: SampleState) -> NDArray[np.int64]:
        """Return the (start, stop) runs of a marker in a state, shape (runs, 2)."""
        return self._runs[marker][state]

    def as_gaps(self, marker: int, state: SampleState) -> list[Gap]:
        """Return the runs of a marker in a state, by start."""
        return _as_gaps(marker, self._runs[marker][state])

    def write(self, places: Any, values: NDArray[np.uint8], markers: Collection[int]) -> None:
        """Give samples other states.

        Parameters
        ----------
        places : tuple of ndarray
            Their frames and markers.
        values : ndarray of uint8
            `SampleState` values.
        markers : collection of int
            The markers among the places.
        """
        self._states[places] = values
        for marker in markers:
            self._runs[marker] = self._find_runs(marker)
            self._open[marker] = self._find_open(marker)
            self._gaps[marker] = _as_gaps(marker, self._open[marker])
        self._all_gaps = self._fillable = None

    def _find_fillable(self) -> tuple[list[Gap], NDArray[np.int64]]:
        frames, gaps = len(self._states), self._gaps
        seen = [marker for marker, of in enumerate(gaps) if not of or of[0].length < frames]
        of_gaps = np.repeat(np.array(seen, np.intp), [len(gaps[marker]) for marker in seen])
        spans = [NO_RUNS, *(self._open[marker] for marker in seen)]
        corners = np.column_stack((of_gaps, np.concatenate(spans)))
        return [gap for marker in seen for gap in gaps[marker]], corners

    def _find_open(self, marker: int) -> NDArray[np.int64]:
        """Return the gaps of a marker: missing samples, and bad ones beside them, are one."""
        missing, bad = (self._runs[marker][state] for state in OPEN)
        if not len(bad):
            return missing
        spans = np.concatenate((missing, bad))
        spans = spans[np.argsort(spans[:, 0])]
        begins = np.append(True, spans[1:, 0] != spans[:-1, 1])
        return np.stack((spans[begins, 0], spans[np.append(begins[1:], True), 1]), axis=1)

    def _find_runs(self, marker: int) -> dict[SampleState, NDArray[np.int64]]:
        states = self._states[:, marker]
        changes = _places(states[1:] != states[:-1]) + 1
        starts = np.concatenate(([0], changes))[: len(states)]
        spans = np.stack((starts, np.append(changes, len(states))[: len(starts)]), axis=1)
        kinds = states[starts]
        return {state: spans[kinds == state] for state in KINDS}


def _as_gaps(marker: int, spans: NDArray[np.int64]) -> list[Gap]:
    return [Gap(marker, start, stop) for start, stop in spans.tolist()]


def _places(mask: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return where a mask is true, soon where that is seldom: most words of eight are empty."""
    padded = np.zeros(-(-mask.size // 8) * 8, bool)
    padded[: mask.size] = mask
    words = np.flatnonzero(padded.view(np.uint64))
    places: NDArray[np.intp] = (8 * words[:, None] + np.arange(8)).ravel()
    return places[padded[places]]
