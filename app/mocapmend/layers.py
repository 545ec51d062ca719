"""What lies beneath the fills of a recording: samples exchanged, and samples set aside. No Qt.

The file has the samples as they are after all of this; `as_stored` has them as they were measured.
In between stand two layers: for each sample the marker that it was stored as, and the runs that
nobody shall believe. Fills are computed from what remains, so that neither their order nor that of
the corrections makes a difference.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from mocapmend.doubts import Doubt, Doubts, believed, doubted, exchanged
from mocapmend.files import (
    Corrections,
    KeptGap,
    MovedRun,
    RepairRecord,
    SampleRun,
    SetAside,
    Source,
)
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import (
    Exchange,
    Move,
    exchange,
    moved,
    moves,
    places_now,
    stored_places,
)
from mocapmend_algorithms.gaps import find_gaps, runs

Mask = NDArray[np.bool_]
Origins = NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Layers:
    """The corrections of a recording.

    Attributes
    ----------
    source : Source
        The file as it was read, with the corrections that it has had.
    origins : ndarray of int32, shape (frames, markers), or None
        The marker that each sample was stored as; None where each is still its own.
    set_aside : mapping of Gap to Doubt
        Runs of measured samples that count as missing, where they are after the exchanges.
    """

    source: Source
    origins: Origins | None = None
    set_aside: Mapping[Gap, Doubt] = field(default_factory=dict)

    @classmethod
    def of(cls, source: Source) -> "Layers":
        """Return the corrections that a file has had."""
        aside = {run: Doubt(one.problem, one.reason) for run, one in source.set_aside.items()}
        return cls(source, _origins_of(source), aside)

    @classmethod
    def with_moves(
        cls, source: Source, given: Iterable[Move], set_aside: Mapping[Gap, Doubt]
    ) -> "Layers":
        """Return corrections of a file, told by where samples are in the end.

        Raises
        ------
        ValueError
            If a sample would be in two places, or in none.
        """
        known, origins = list(given), None
        if known:
            origins = stored_places(source.recording.present.shape)
            moved(origins, known)
        return cls(source, origins, dict(set_aside))

    def corrected(self, exchanges: Iterable[Exchange], set_aside: Mapping[Gap, Doubt]) -> "Layers":
        """Return the same with samples exchanged and then more of them set aside.

        Of the runs only what is measured counts; what was set aside before stays so, and is
        exchanged like any other sample.

        Raises
        ------
        ValueError
            See `corrections.exchange`.
        """
        exchanges, aside = list(exchanges), dict(self.set_aside)
        origins = self.origins
        if exchanges:
            shape = self.source.recording.present.shape
            origins = stored_places(shape) if origins is None else origins.copy()
            exchange(origins, exchanges)
            for each in exchanges:
                aside = exchanged(aside, each).applied(aside)
        after = replace(self, origins=origins, set_aside=aside)
        of_marker: dict[int, dict[Gap, Doubt]] = {}
        for run, doubt in aside.items():
            of_marker.setdefault(run.marker, {})[run] = doubt
        for run, doubt in set_aside.items():
            known = of_marker.setdefault(run.marker, {})
            known |= doubted(known, run, doubt, after.measured(run)).come
        aside = {run: doubt for known in of_marker.values() for run, doubt in known.items()}
        return replace(after, set_aside=aside)

    def believing(self, some: Iterable[Gap]) -> "Layers":
        """Return the same with no sample of some runs set aside."""
        aside: Doubts = self.set_aside
        for run in some:
            aside = believed(aside, run).applied(aside)
        return replace(self, set_aside=aside)

    def is_same(self, other: "Layers") -> bool:
        """Say whether other layers of this file exchange and set aside the same."""
        return self.moves == other.moves and dict(self.set_aside) == dict(other.set_aside)

    def measured(self, run: Gap) -> Mask:
        """Say which samples of a run were measured, doubtful ones included."""
        present = self.source.as_stored.present[run.start : run.stop]
        if self.origins is None:
            return present[:, run.marker]
        origins = self.origins[run.start : run.stop, run.marker]
        found: Mask = present[np.arange(run.length), origins]
        return found

    @cached_property
    def recording(self) -> Recording:
        """What fills are computed from: measured samples that nobody doubts, where they belong."""
        if self._as_in_file:
            return self.source.measured
        stored = self.source.as_stored
        points = stored.points.copy()
        for move in self.moves:
            rows = slice(move.start, move.stop)
            points[rows, move.marker] = stored.points[rows, move.origin]
        for run in self.set_aside:
            points[run.start : run.stop, run.marker] = np.nan
        return self.source.recording.with_points(points)

    @cached_property
    def moves(self) -> list[Move]:
        """What is not where it was stored, by marker and start."""
        return [] if self.origins is None else moves(self.origins)

    @cached_property
    def earlier(self) -> dict[Gap, RepairRecord]:
        """The repairs of the file that still are repairs of whole gaps, by gap."""
        source = self.source
        known = dict(zip(source.repaired, source.repairs, strict=True))
        if self._as_in_file:
            return known
        return {gap: known[gap] for gap in self._gaps if gap in known}

    @cached_property
    def kept_open(self) -> dict[Gap, KeptGap]:
        """The gaps that the file keeps open and that still are whole gaps."""
        known = self.source.kept_open
        return {gap: known[gap] for gap in self._gaps if gap in known}

    def open_gaps(self) -> list[Gap]:
        """Return the gaps that no earlier repair fills, by marker and start."""
        return [gap for gap in self._gaps if gap not in self.earlier]

    def touched(self) -> Iterator[Gap]:
        """Yield runs outside which all samples are as in the file, but for new fills."""
        yield from self.source.repaired
        yield from self.source.set_aside
        yield from self.set_aside
        for move in (*self.moves, *self.source.moves):
            yield move.run

    def stored_runs(self, untouched: Callable[[Gap], Mask]) -> Iterator[SampleRun]:
        """Yield the stored samples that the file has elsewhere, or does not have any more.

        Parameters
        ----------
        untouched : callable
            Says which samples of a run, shape (frames of the run,), are to be as they were stored:
            neither filled nor set aside nor smoothed.
        """
        where = self._where
        if where is not None:
            for marker in np.flatnonzero((where != np.arange(where.shape[1])).any(axis=0)).tolist():
                for start, stop in runs(where[:, marker] != marker):
                    yield from self._untouched(Gap(marker, start, stop), untouched)
        for run in self.source.set_aside:
            yield from self._untouched(run, untouched)

    def corrections(self, others: Corrections) -> Corrections:
        """Return the corrections as the repair record has them.

        Parameters
        ----------
        others : Corrections
            What was smoothed and renamed.
        """
        known = self.source.set_aside
        entries = [
            known[run] if self._is_known(run, doubt) else self._entry(run, doubt)
            for run, doubt in sorted(self.set_aside.items())
        ]
        labels, points = self.source.recording.labels, self.source.stored_points
        moved_runs = [
            MovedRun(*self.source.place(move.run), labels[move.origin], points[move.origin] + 1)
            for move in self.moves
        ]
        return replace(
            others,
            set_aside=tuple(sorted(entries, key=lambda entry: entry.place)),
            moved=tuple(sorted(moved_runs, key=lambda entry: entry.place)),
        )

    @cached_property
    def _gaps(self) -> list[Gap]:
        return find_gaps(self.recording.present)

    @cached_property
    def _as_in_file(self) -> bool:
        same_runs = set(self.set_aside) == set(self.source.set_aside)
        return same_runs and tuple(self.moves) == tuple(self.source.moves)

    @cached_property
    def _where(self) -> Origins | None:
        """The marker of the file that holds each stored sample; None where each is its own."""
        in_file = _origins_of(self.source)
        if in_file is None:
            return self.origins
        origins = stored_places(in_file.shape) if self.origins is None else self.origins
        found: Origins = np.take_along_axis(places_now(in_file), origins, axis=1)
        return found

    @cached_property
    def _lost(self) -> Mask:
        """Which samples of the file are not as they were stored, shape (frames, markers)."""
        mask = np.zeros(self.source.recording.present.shape, np.bool_)
        for run in (*self.source.repaired, *self.source.set_aside):
            mask[run.start : run.stop, run.marker] = True
        return mask

    @cached_property
    def _known(self) -> dict[int, list[tuple[Gap, SetAside]]]:
        """What the file's record sets aside, by marker."""
        of_marker: dict[int, list[tuple[Gap, SetAside]]] = {}
        for run, entry in self.source.set_aside.items():
            of_marker.setdefault(run.marker, []).append((run, entry))
        return of_marker

    def _untouched(self, run: Gap, untouched: Callable[[Gap], Mask]) -> Iterator[SampleRun]:
        """Yield the parts of a run that are to be as they were stored."""
        chosen = untouched(run)
        for a, b in runs(chosen):
            for part, origin in self._parts(Gap(run.marker, run.start + a, run.start + b)):
                yield self._stored_run(part, origin)

    def _parts(self, run: Gap) -> Iterator[tuple[Gap, int]]:
        """Cut a run where the place of its samples in the file changes, or whether they are there.

        Yields
        ------
        part : Gap
            A part of it.
        origin : int
            The marker of the file that holds its samples; -1 where the repair record has them.
        """
        rows = np.arange(run.start, run.stop)
        where = np.full(run.length, run.marker)
        if self._where is not None:
            where = self._where[run.start : run.stop, run.marker]
        where = np.where(self._lost[rows, where], -1, where)
        cuts = [0, *(np.flatnonzero(np.diff(where)) + 1).tolist(), run.length]
        for a, b in pairwise(cuts):
            yield Gap(run.marker, run.start + a, run.start + b), int(where[a])

    def _stored_run(self, run: Gap, origin: int) -> SampleRun:
        if origin >= 0:
            values = self.source.recording.points[run.start : run.stop, origin]
            return SampleRun(run.marker, run.start, values, origin=origin)
        samples = self._samples(run)
        fourth = np.where(np.isnan(samples[:, 0]), np.float32(-1), samples[:, 3])
        return SampleRun(run.marker, run.start, samples[:, :3].astype(np.float64), fourth)

    def _entry(self, run: Gap, doubt: Doubt) -> SetAside:
        samples = [
            self._samples(part)
            if origin < 0
            else np.column_stack(
                (
                    self.source.recording.points[part.start : part.stop, origin],
                    self.source.read_fourth([Gap(origin, part.start, part.stop)])[0],
                )
            ).astype(np.float32)
            for part, origin in self._parts(run)
        ]
        encoded = SetAside.encoded(np.concatenate(samples))
        return SetAside(*self.source.place(run), doubt.problem, doubt.reason, encoded)

    def _samples(self, run: Gap) -> NDArray[np.float32]:
        """Return what the repair record has of stored samples, NaN without, shape (frames, 4)."""
        where = np.full(run.length, run.marker)
        if self._where is not None:
            where = self._where[run.start : run.stop, run.marker]
        samples = np.full((run.length, 4), np.nan, np.float32)
        frames = np.arange(run.start, run.stop)
        for marker in np.unique(where).tolist():
            for known, entry in self._known.get(marker, ()):
                inside = (where == marker) & (known.start <= frames) & (frames < known.stop)
                samples[inside] = entry.samples[frames[inside] - known.start]
        return samples

    def _is_known(self, run: Gap, doubt: Doubt) -> bool:
        """Say whether the file's record has a run that is set aside, for the same samples."""
        entry = self.source.set_aside.get(run)
        if entry is None or (entry.problem, entry.reason) != doubt:
            return False
        return all(origin < 0 for _, origin in self._parts(run))


def _origins_of(source: Source) -> Origins | None:
    if not source.moves:
        return None
    origins = stored_places(source.recording.present.shape)
    moved(origins, source.moves)
    return origins
