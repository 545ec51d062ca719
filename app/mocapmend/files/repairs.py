"""The repairs that a file has had, made sure against its samples."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

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


def listed_samples(
    repairs: Iterable[RepairRecord], shape: tuple[int, int], first_frame: int
) -> NDArray[np.bool_]:
    """Mark the samples that repairs are about.

    Parameters
    ----------
    repairs : iterable of RepairRecord
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
    for repair in repairs:
        start, stop = repair.rows(first_frame)
        if 0 < repair.point <= shape[1]:
            mask[max(start, 0) : max(stop, 0), repair.point - 1] = True
    return mask


def _confirmed(source: Source, provenance: Provenance) -> Mapping[Gap, RepairRecord]:
    """Return the repairs whose samples are all there, and fill a gap of the measured samples."""
    recording = source.recording
    found: dict[Gap, RepairRecord] = {}
    for record in provenance.repairs:
        start, stop = record.rows(recording.first_frame)
        marker = source.markers_by_point.get(record.point)
        if marker is None or not 0 <= start < stop <= recording.frames:
            continue
        if recording.present[start:stop, marker].all():
            found[Gap(marker, start, stop)] = record
    present = recording.present.copy()
    for gap in found:
        present[gap.start : gap.stop, gap.marker] = False
    whole = set(find_gaps(present))
    return {gap: found[gap] for gap in sorted(found) if gap in whole}
