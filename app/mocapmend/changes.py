"""What the repairs of a recording change in its file, and what its repair record says. No Qt."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from typing import Any, TypedDict, TypeVar

import numpy as np
from numpy.typing import NDArray

from mocapmend import training
from mocapmend.files import (
    NO_CORRECTIONS,
    Corrections,
    KeptGap,
    Renamed,
    RepairRecord,
    SampleRun,
    SmoothedRun,
    Source,
)
from mocapmend.files.corrections import changed_labels
from mocapmend.files.records import RecordedRun
from mocapmend.layers import Layers, Mask
from mocapmend.written import Places, differing_runs, places_of
from mocapmend_algorithms import Gap, Recording
from mocapmend_algorithms.corrections import merged_runs
from mocapmend_algorithms.fill.contract import FillResult, Patch
from mocapmend_algorithms.smooth.contract import SmoothResult

Entry = TypeVar("Entry", bound=RecordedRun)


@dataclass(frozen=True)
class Changes:
    """What a copy of a file has that the file has not.

    Attributes
    ----------
    runs : tuple of SampleRun
        The samples that change; where they overlap, the last one counts.
    repairs : tuple of RepairRecord
        All repairs that the copy has, earlier ones included.
    kept_open : tuple of KeptGap
        All gaps that are kept open in it.
    corrections : Corrections
        All that was put right in it besides filling gaps.
    """

    runs: tuple[SampleRun, ...]
    repairs: tuple[RepairRecord, ...]
    kept_open: tuple[KeptGap, ...] = ()
    corrections: Corrections = NO_CORRECTIONS

    def labels(self, source: Source) -> dict[int, str]:
        """Return the labels that the copy has in place of the file's, by stored point from 0."""
        earlier = NO_CORRECTIONS if source.provenance is None else source.provenance.corrections
        return changed_labels(earlier.renamed, self.corrections.renamed)


@dataclass(frozen=True, eq=False)
class Repaired:
    """A recording with its repairs, layer by layer.

    Attributes
    ----------
    layers : Layers
        What was exchanged and set aside.
    places : Places
        Where samples may differ from those of the file.
    values : ndarray, shape (samples, 3)
        What is there in the end, NaN where missing.
    fills : mapping of Gap to RepairRecord
        The gaps that are filled, by earlier repairs too.
    kept_open : mapping of Gap to KeptGap
        The gaps that are kept open.
    smoothed : mapping of Gap to SmoothedRun
        The runs that are smoothed, earlier ones included.
    renamed : tuple of Renamed
        The points with other labels, earlier ones included.
    """

    layers: Layers
    places: Places
    values: NDArray[np.float64]
    fills: Mapping[Gap, RepairRecord]
    kept_open: Mapping[Gap, KeptGap]
    smoothed: Mapping[Gap, SmoothedRun] = field(default_factory=dict)
    renamed: tuple[Renamed, ...] = ()

    @cached_property
    def recording(self) -> Recording:
        """All samples as they are in the end."""
        source = self.layers.source
        points = source.recording.points.copy()
        points[self.places] = self.values
        return source.recording.with_points(points)

    def changes(self) -> Changes:
        """Return what differs from the file."""
        source = self.layers.source
        runs = differing_runs(self.values, source.recording.points, self.places)
        others = Corrections(smoothed=_ordered(self.smoothed), renamed=self.renamed)
        return Changes(
            (*runs, *self.layers.stored_runs(self._untouched)),
            _ordered(self.fills),
            _ordered(self.kept_open),
            self.layers.corrections(others),
        )

    @cached_property
    def _replaced(self) -> dict[int, list[Gap]]:
        """What is filled, set aside or smoothed, by marker."""
        found: dict[int, list[Gap]] = {}
        for run in (*self.fills, *self.layers.set_aside, *self.smoothed):
            found.setdefault(run.marker, []).append(run)
        return found

    def _untouched(self, run: Gap) -> Mask:
        """Say which samples of a run are to be as they were stored."""
        mask = np.ones(run.length, np.bool_)
        for other in self._replaced.get(run.marker, ()):
            mask[max(0, other.start - run.start) : max(0, other.stop - run.start)] = False
        return mask


def earlier(layers: Layers, without: Collection[Gap] = ()) -> Repaired:
    """Return a recording with those repairs that its file has, but for some that are taken back."""
    points = layers.source.recording.points
    fills = {gap: entry for gap, entry in layers.earlier.items() if gap not in without}
    values = {gap: points[gap.start : gap.stop, gap.marker] for gap in fills}
    before = bare(layers)
    return replace(before, **_with(before, values), fills=fills)


def bare(layers: Layers) -> Repaired:
    """Return a recording without any repair but its corrections, and its open gaps as they were."""
    source, places = layers.source, places_of(merged_runs(layers.touched()))
    renamed = () if source.provenance is None else source.provenance.corrections.renamed
    values = layers.recording.points[places]
    return Repaired(layers, places, values, {}, layers.kept_open, source.smoothed, renamed)


def filled(before: Repaired, result: FillResult, method_id: str, params: Any) -> Repaired:
    """Return a recording with more gaps filled.

    Parameters
    ----------
    before : Repaired
        The recording; the fill was computed from its layers.
    result : FillResult
        The fill.
    method_id : str
        Its method.
    params : object
        The method's parameters.
    """
    source = before.layers.source
    values = {patch.gap: patch.values for patch in result.patches}
    new = {
        gap: record(source, patch, method_id, params, result.donors(gap))
        for gap, patch in zip(values, result.patches, strict=True)
    }
    kept = {gap: entry for gap, entry in before.kept_open.items() if gap not in new}
    fills = {**before.fills, **new}
    return replace(before, **_with(before, values), fills=fills, kept_open=kept)


def smoothed(before: Repaired, result: SmoothResult) -> Repaired:
    """Return a recording with runs smoothed."""
    runs, source = dict(before.smoothed), before.layers.source
    for done in result.runs:
        made = result.method, result.params, done.chosen
        runs[done.run] = smoothed_record(source, done.run, *made, done.rms)
    written = _with(before, {done.run: done.values for done in result.runs})
    return replace(before, **written, smoothed=runs)


def with_new_labels(source: Source, changes: Changes) -> Changes:
    """Return changes whose entries name markers as the copy does, which may have other labels."""
    labels = changes.labels(source)
    if not labels:
        return changes

    def named(entries: tuple[Entry, ...]) -> tuple[Entry, ...]:
        return tuple(
            replace(entry, marker=labels.get(entry.point - 1, entry.marker)) for entry in entries
        )

    corrections = changes.corrections
    moved = tuple(
        replace(entry, from_marker=labels.get(entry.from_point - 1, entry.from_marker))
        for entry in named(corrections.moved)
    )
    corrections = Corrections(
        named(corrections.set_aside), moved, named(corrections.smoothed), corrections.renamed
    )
    return replace(
        changes,
        repairs=named(changes.repairs),
        kept_open=named(changes.kept_open),
        corrections=corrections,
    )


class _Written(TypedDict):
    places: Places
    values: NDArray[np.float64]


def _with(before: Repaired, values: Mapping[Gap, NDArray[np.float64]]) -> _Written:
    """Return places and values of a recording after more was written."""
    frames, markers = places_of(values)
    places = np.concatenate((before.places[0], frames)), np.concatenate((before.places[1], markers))
    points = before.layers.source.recording.points
    written = np.concatenate((before.values, *values.values())).reshape(-1, 3)
    # What was written last counts, wherever a place is there twice.
    order = np.lexsort((np.arange(len(written)), places[0], places[1]))
    same = np.diff(places[1][order] * (len(points) + 1) + places[0][order]) == 0
    last = order[np.append(~same, True)] if len(order) else order
    return {"places": (places[0][last], places[1][last]), "values": written[last]}


def changes_of(source: Source, result: FillResult, method_id: str, params: Any) -> Changes:
    """Return what a fill changes in a file; its earlier repairs and open gaps stay."""
    return filled(earlier(Layers.of(source)), result, method_id, params).changes()


def _ordered(entries: Mapping[Gap, Entry]) -> tuple[Entry, ...]:
    """Return entries by point and frame, which is not always the order of markers."""
    return tuple(sorted(entries.values(), key=lambda entry: entry.place))


def record(
    source: Source,
    patch: Patch,
    method_id: str,
    params: Any,
    donors: tuple[str, ...] = (),
) -> RepairRecord:
    """Describe a repair for the repair record."""
    recording = source.recording
    return RepairRecord(
        *source.place(patch.gap),
        method=method_id,
        parameters=(
            dict(params)
            if isinstance(params, Mapping)
            else asdict(params) | training.digests(params)
        ),
        donors=donors,
        expected_error_mm=patch.expected_error * recording.mm,
        r90_mm=patch.typical_r90 * recording.mm,
    )


def renames(source: Source, labels: Sequence[str]) -> tuple[Renamed, ...]:
    """Return the points that are called otherwise than they were first.

    Parameters
    ----------
    source : Source
        The file.
    labels : sequence of str, length markers
        What its markers are called now.
    """
    known = () if source.provenance is None else source.provenance.corrections.renamed
    former = {entry.point: entry.former for entry in known}
    points = (point + 1 for point in source.stored_points)
    return tuple(
        Renamed(point, former.get(point, stored), label)
        for point, stored, label in sorted(
            zip(points, source.recording.labels, labels, strict=True)
        )
        if label != former.get(point, stored)
    )


def smoothed_record(
    source: Source,
    run: Gap,
    method_id: str,
    params: Mapping[str, Any],
    chosen: Mapping[str, Any],
    rms: float,
) -> SmoothedRun:
    """Describe a smoothed run for the repair record; `rms` is in the recording's unit."""
    change = rms * source.recording.mm
    return SmoothedRun(*source.place(run), method_id, dict(params), dict(chosen), change)


def kept_gap(source: Source, gap: Gap, *, never: bool, reason: str) -> KeptGap:
    """Describe a gap that is kept open for the repair record."""
    return KeptGap(*source.place(gap), never=never, reason=reason)


def repaired(recording: Recording, result: FillResult) -> Recording:
    """Return a recording with the filled samples in it."""
    points = recording.points.copy()
    for patch in result.patches:
        points[patch.gap.start : patch.gap.stop, patch.gap.marker] = patch.values
    return recording.with_points(points)
