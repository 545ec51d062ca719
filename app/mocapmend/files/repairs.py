"""The repairs that a file has had, made sure against its samples."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from mocapmend.files import sidecar
from mocapmend.files.provenance import Provenance, RepairRecord
from mocapmend.files.source import Source
from mocapmend_algorithms.gaps import Gap, find_gaps

AnySource = TypeVar("AnySource", bound=Source)


def with_repairs(source: AnySource, stated: Provenance | None = None) -> AnySource:
    """Return a source with its repair record: the one in the file, else the one beside it.

    Repairs that its samples contradict are left out, with a warning.

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
    kept = _confirmed(source, provenance)
    dropped = len(provenance.repairs) - len(kept)
    if dropped:
        warnings.append(
            f"{dropped} of {len(provenance.repairs)} repairs of the repair record are not in the "
            "file any more; their samples are taken as they are."
        )
    return replace(
        source,
        provenance=replace(provenance, repairs=tuple(kept.values())),
        repaired=tuple(kept),
        warnings=tuple(warnings),
    )


def _confirmed(source: Source, provenance: Provenance) -> Mapping[Gap, RepairRecord]:
    """Return the repairs whose samples are all there, and fill a gap of the measured samples."""
    recording = source.recording
    markers = {point + 1: marker for marker, point in enumerate(source.stored_points)}
    found: dict[Gap, RepairRecord] = {}
    for record in provenance.repairs:
        start = record.first_frame - recording.first_frame
        stop = record.last_frame - recording.first_frame + 1
        marker = markers.get(record.point)
        if marker is None or not 0 <= start < stop <= recording.frames:
            continue
        if recording.present[start:stop, marker].all():
            found[Gap(marker, start, stop)] = record
    present = recording.present.copy()
    for gap in found:
        present[gap.start : gap.stop, gap.marker] = False
    whole = set(find_gaps(present))
    return {gap: found[gap] for gap in sorted(found) if gap in whole}
