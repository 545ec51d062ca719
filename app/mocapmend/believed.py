"""The measured samples of an open recording that are believed, while corrections change. No Qt."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from mocapmend.doubts import NO_CHANGE, Change, Doubt
from mocapmend.files import Source
from mocapmend.layers import Layers
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import Exchange, exchange, merged_runs, stored_places


@dataclass(frozen=True)
class Correction:
    """Samples that are exchanged, and runs that are set aside, or no longer, after that.

    Attributes
    ----------
    exchanges : tuple of Exchange
        In this order.
    doubts : Change
        All runs set aside that go or come, those that go with their samples too.
    found_as : tuple of str
        Ids of the detectors that found what is exchanged, one for each problem.
    """

    exchanges: tuple[Exchange, ...] = ()
    doubts: Change = NO_CHANGE
    found_as: tuple[str, ...] = ()

    @cached_property
    def runs(self) -> tuple[Gap, ...]:
        """Where samples change, by marker and start."""
        moved = [
            Gap(marker, each.start, each.stop)
            for each in self.exchanges
            for marker in (each.first, each.second)
        ]
        return tuple(merged_runs([*moved, *self.doubts.gone, *self.doubts.come]))

    @property
    def inverse(self) -> "Correction":
        """What undoes it."""
        doubts = Change(self.doubts.come, self.doubts.gone)
        return Correction(self.exchanges[::-1], doubts)


class Believed:
    """What fills are computed from: measured samples that nobody doubts, where they belong.

    Attributes
    ----------
    recording : Recording
        These samples. It is another object after each correction; what a former one holds may
        have changed.
    doubts : dict of Gap to Doubt
        The runs that are set aside.
    """

    def __init__(self, source: Source) -> None:
        layers = Layers.of(source)
        self._source = source
        self._origins = layers.origins
        self.doubts: Mapping[Gap, Doubt] = layers.set_aside
        self.recording: Recording = source.measured
        self._points: NDArray[np.float64] | None = None
        self._present: NDArray[np.bool_] | None = None
        self._doubted: NDArray[np.bool_] = np.zeros(source.recording.present.shape, np.bool_)
        for run in self.doubts:
            self._doubted[run.start : run.stop, run.marker] = True

    @property
    def layers(self) -> Layers:
        """A snapshot of the corrections."""
        origins = None if self._origins is None else self._origins.copy()
        return Layers(self._source, origins, dict(self.doubts))

    @property
    def doubted(self) -> NDArray[np.bool_]:
        """Which samples are set aside, shape (frames, markers); not to be changed."""
        return self._doubted

    def touched(self) -> Iterator[Gap]:
        """Yield runs outside which all samples are as in the file; see `Layers.touched`."""
        # No snapshot: of a long recording its copy would be felt.
        return Layers(self._source, self._origins, self.doubts).touched()

    def stored(self, run: Gap) -> NDArray[np.float64]:
        """Return what was measured in a run, doubtful samples included, shape (frames, 3)."""
        points, rows = self._source.as_stored.points, np.arange(run.start, run.stop)
        origins: int | NDArray[np.int32] = run.marker
        if self._origins is not None:
            origins = self._origins[run.start : run.stop, run.marker]
        values: NDArray[np.float64] = points[rows, origins]
        return values

    def apply(self, correction: Correction) -> None:
        """Make a correction."""
        if correction.exchanges:
            if self._origins is None:
                self._origins = stored_places(self._doubted.shape)
            exchange(self._origins, correction.exchanges)
        self.doubts = correction.doubts.applied(self.doubts)
        for run in correction.doubts.gone:
            self._doubted[run.start : run.stop, run.marker] = False
        for run in correction.doubts.come:
            self._doubted[run.start : run.stop, run.marker] = True
        points, present = self._own()
        for run in correction.runs:
            rows = slice(run.start, run.stop)
            values = self.stored(run)
            values[self._doubted[rows, run.marker]] = np.nan
            points[rows, run.marker] = values
            present[rows, run.marker] = ~np.isnan(values[:, 0])
        # Views: the recording makes what it gets read-only.
        self.recording = replace(self.recording, points=points.view(), seen=present.view())

    def rename(self, labels: tuple[str, ...]) -> None:
        """Give the markers other labels."""
        former = self.recording
        self.recording = replace(former, labels=labels, seen=former.present)

    def _own(self) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """Return the arrays to be written, which are copies of the file's."""
        if self._points is None or self._present is None:
            self._points = self.recording.points.copy()
            self._present = self.recording.present.copy()
        return self._points, self._present
