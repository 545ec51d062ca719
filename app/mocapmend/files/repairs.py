"""The repairs that a file has had, and its gaps kept open, made sure against its samples."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from mocapmend.files import sidecar
from mocapmend.files.corrections import Corrections, MovedRun, Renamed
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RecordedRun, RepairRecord
from mocapmend.files.source import Source
from mocapmend_algorithms.corrections import Move, moved, stored_places
from mocapmend_algorithms.gaps import Gap, find_gaps, seen_outside

AnySource = TypeVar("AnySource", bound=Source)
AnyRun = TypeVar("AnyRun", bound=RecordedRun)


def with_repairs(source: AnySource, stated: Provenance | None = None) -> AnySource:
    """Return a source with its repair record: the one in the file, else the one beside it.

    Repairs and gaps kept open that its samples contradict are left out, with a warning.

    Parameters
    ----------
    source : Source
        As it was read.
    stated : Provenance, optional
        What the file itself says.
    """
    warnings = list(source.warnings)
    beside = sidecar.read(source.path, warnings)
    provenance = beside if beside is not None else stated
    if provenance is None:
        return replace(source, warnings=tuple(warnings))
    kept, kept_open = _confirmed(source, provenance)
    fixed = _Corrected(source, provenance.corrections, kept)
    confirmed = replace(
        provenance,
        repairs=tuple(kept.values()),
        kept_open=tuple(kept_open.values()),
        corrections=fixed.corrections,
    )
    warnings += _dropped(provenance, confirmed)
    if provenance.refined is not None:
        warnings.append(provenance.refined.sentence)
    return replace(
        source,
        provenance=confirmed,
        repaired=tuple(kept),
        kept_open=kept_open,
        set_aside=fixed.set_aside,
        moves=tuple(fixed.moves),
        smoothed=fixed.smoothed,
        warnings=tuple(warnings),
    )


def listed_samples(
    entries: Iterable[RecordedRun], shape: tuple[int, int], first_frame: int
) -> NDArray[np.bool_]:
    """Mark the samples that repairs, or gaps kept open, are about.

    Parameters
    ----------
    entries : iterable of RecordedRun
        What lies outside is left out.
    shape : tuple of int
        Frames and stored points.
    first_frame : int
        Number of the first frame as the file counts it.

    Returns
    -------
    ndarray of bool, shape (frames, points)
    """
    mask = np.zeros(shape, np.bool_)
    for entry in entries:
        start, stop = entry.rows(first_frame)
        if 0 < entry.point <= shape[1]:
            mask[max(start, 0) : max(stop, 0), entry.point - 1] = True
    return mask


def _confirmed(
    source: Source, provenance: Provenance
) -> tuple[Mapping[Gap, RepairRecord], Mapping[Gap, KeptGap]]:
    """Return the repairs whose samples are all there, and the gaps kept open that are missing.

    All of them are whole gaps of the measured samples.
    """
    recording = source.recording
    found = {
        gap: record
        for gap, record in _places(source, provenance.repairs)
        if recording.present[gap.start : gap.stop, gap.marker].all()
    }
    present = recording.present.copy()
    for gap in found:
        present[gap.start : gap.stop, gap.marker] = False
    whole = set(find_gaps(present))
    kept_open = dict(_places(source, provenance.kept_open))
    return (
        {gap: found[gap] for gap in sorted(found) if gap in whole},
        {gap: kept_open[gap] for gap in sorted(kept_open) if gap in whole and gap not in found},
    )


class _Corrected:
    """The corrections of a record that the samples of a file do not contradict.

    Attributes
    ----------
    set_aside, moves, smoothed
        As a source has them.
    corrections : Corrections
        The entries that they come from.
    """

    def __init__(self, source: Source, stated: Corrections, repaired: Collection[Gap]) -> None:
        present = seen_outside(source.recording.present, repaired)
        self.set_aside = {
            run: entry
            for run, entry in sorted(_places(source, stated.set_aside), key=lambda item: item[0])
            if not present[run.start : run.stop, run.marker].any()
        }
        self.smoothed = dict(sorted(_places(source, stated.smoothed), key=lambda item: item[0]))
        self.moves = sorted(_moves(source, stated.moved))
        self.corrections = Corrections(
            tuple(self.set_aside.values()),
            stated.moved if self.moves else (),
            tuple(self.smoothed.values()),
            tuple(entry for entry in stated.renamed if _is_named(source, entry)),
        )


def _moves(source: Source, stated: Sequence[MovedRun]) -> list[Move]:
    """Return what was moved; nothing where samples would be in two places, or in none."""
    markers = source.markers_by_point
    found = [
        Move(*run, markers[entry.from_point])
        for run, entry in _places(source, stated)
        if entry.from_point in markers
    ]
    if len(found) < len(stated) or not found:
        return []
    try:
        moved(stored_places(source.recording.present.shape), found)
    except ValueError:
        return []
    return found


def _is_named(source: Source, entry: Renamed) -> bool:
    marker = source.markers_by_point.get(entry.point)
    return marker is not None and source.recording.labels[marker] == entry.marker


def _dropped(stated: Provenance, confirmed: Provenance) -> Iterator[str]:
    """Say which entries the file contradicts."""
    before, after = stated.corrections, confirmed.corrections
    as_they_are = "; their samples are taken as they are"
    for what, told, true, so in (
        ("repairs of the repair record", stated.repairs, confirmed.repairs, as_they_are),
        ("gaps that the repair record keeps open", stated.kept_open, confirmed.kept_open, ""),
        ("runs that the repair record sets aside", before.set_aside, after.set_aside, as_they_are),
        ("exchanged runs of the repair record", before.moved, after.moved, as_they_are),
        ("smoothed runs of the repair record", before.smoothed, after.smoothed, as_they_are),
        ("new names of the repair record", before.renamed, after.renamed, ""),
    ):
        if len(true) < len(told):
            lost = len(told) - len(true)
            yield f"{lost} of {len(told)} {what} are not in the file any more{so}."


def _places(source: Source, entries: Iterable[AnyRun]) -> Iterator[tuple[Gap, AnyRun]]:
    """Yield entries with their gaps, those left out that lie outside."""
    recording = source.recording
    for entry in entries:
        start, stop = entry.rows(recording.first_frame)
        marker = source.markers_by_point.get(entry.point)
        if marker is not None and 0 <= start < stop <= recording.frames:
            yield Gap(marker, start, stop), entry
