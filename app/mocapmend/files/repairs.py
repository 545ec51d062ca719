"""The repairs that a file has had, and its gaps kept open, made sure against its samples."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from mocapmend.files import sidecar
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RecordedRun, RepairRecord
from mocapmend.files.source import Source
from mocapmend_algorithms.gaps import Gap, find_gaps

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
    dropped = len(provenance.repairs) - len(kept)
    if dropped:
        warnings.append(
            f"{dropped} of {len(provenance.repairs)} repairs of the repair record are not in the "
            "file any more; their samples are taken as they are."
        )
    dropped = len(provenance.kept_open) - len(kept_open)
    if dropped:
        warnings.append(
            f"{dropped} of {len(provenance.kept_open)} gaps that the repair record keeps open are "
            "not in the file any more."
        )
    return replace(
        source,
        provenance=replace(
            provenance, repairs=tuple(kept.values()), kept_open=tuple(kept_open.values())
        ),
        repaired=tuple(kept),
        kept_open=kept_open,
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


def _places(source: Source, entries: Iterable[AnyRun]) -> Iterator[tuple[Gap, AnyRun]]:
    """Yield entries with their gaps, those left out that lie outside."""
    recording = source.recording
    for entry in entries:
        start, stop = entry.rows(recording.first_frame)
        marker = source.markers_by_point.get(entry.point)
        if marker is not None and 0 <= start < stop <= recording.frames:
            yield Gap(marker, start, stop), entry
