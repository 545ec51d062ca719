"""Writing a recording as a new file: other formats, and C3D for what was imported."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TypeGuard, TypeVar

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files import sidecar
from mocapmend.files.c3d_group import encode_group
from mocapmend.files.c3d_new import room_for_records, write_new_c3d
from mocapmend.files.c3d_numbers import Processor
from mocapmend.files.c3d_reader import C3DFile, read_c3d
from mocapmend.files.corrections import (
    NO_CORRECTIONS,
    Corrections,
    MovedRun,
    Renamed,
    SetAside,
    SmoothedRun,
)
from mocapmend.files.formats.export_csv import write_csv
from mocapmend.files.formats.export_npz import write_npz
from mocapmend.files.formats.export_trc import write_trc
from mocapmend.files.formats.table import FORMATS
from mocapmend.files.opening import changed_on_disk, open_file
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RepairRecord
from mocapmend.files.refinement import Refinement
from mocapmend.files.repairs import listed_samples
from mocapmend.files.saving import Saved, check_place
from mocapmend.files.source import Source
from mocapmend_algorithms.progress import Progress, no_progress
from mocapmend_algorithms.recording import Recording

AnyEntry = TypeVar("AnyEntry", RepairRecord, KeptGap, SetAside, MovedRun, SmoothedRun, Renamed)
GROUP = 6
"""A group number that no other group of a new file has."""


@dataclass(frozen=True, eq=False)
class _Content:
    """What is written, and how far it is."""

    source: Source
    recording: Recording
    filled: NDArray[np.bool_]
    group: bytes
    progress: Progress


_WRITERS: Mapping[str, Callable[[_Content, Path], tuple[str, ...]]] = {
    ".c3d": lambda content, out: write_new_c3d(
        content.recording,
        out,
        events=content.source.events,
        leading=content.group,
        progress=content.progress,
    ),
    ".trc": lambda content, out: write_trc(content.recording, out, progress=content.progress),
    ".csv": lambda content, out: write_csv(content.recording, out, progress=content.progress),
    ".npz": lambda content, out: write_npz(
        content.recording,
        out,
        bones=content.source.bones,
        filled=content.filled,
        progress=content.progress,
    ),
}
LONG_CSV = ".long.csv"
"""How the name of a CSV file with one line per sample ends."""
WRITTEN = (*_WRITERS, LONG_CSV)
"""How the names of the files end that can be written."""


def patches(source: Source, out: Path) -> TypeGuard[C3DFile]:
    """Say whether a file is written as a patched copy of its source, so that nothing is lost."""
    others = {end for item in FORMATS if item.read is not read_c3d for end in item.suffixes}
    return isinstance(source, C3DFile) and out.suffix.lower() not in others


def check_ending(source: Source, out: Path) -> None:
    """Refuse a name that says another format than those that can be written.

    Raises
    ------
    MocapmendError
        If it does.
    """
    if not patches(source, out):
        _writer(out)


def write_recording(
    source: Source,
    recording: Recording,
    repairs: Sequence[RepairRecord],
    out: Path,
    *,
    kept_open: Sequence[KeptGap] = (),
    corrections: Corrections = NO_CORRECTIONS,
    refined: Refinement | None = None,
    replace_source: bool = False,
    accept_truncated: bool = False,
    progress: Progress = no_progress,
) -> Saved:
    """Write markers as a new file of the format that its name says.

    Parameters
    ----------
    source : Source
        What was read.
    recording : Recording
        Its repaired samples.
    repairs : sequence of RepairRecord
        All of its repairs, points as in the source.
    out : Path
        Where the file goes.
    kept_open : sequence of KeptGap
        Its gaps that are kept open, points as in the source.
    corrections : Corrections
        What was put right in it besides filling gaps, points as in the source.
    refined : Refinement, optional
        How a network has made the samples from those of the source; by default as the source's
        own record says.
    replace_source : bool
        Whether `out` may be the source itself.
    accept_truncated : bool
        Whether a source that is truncated may be saved.
    progress : Progress
        Called often; may cancel.

    Raises
    ------
    MocapmendError
        If it cannot be written. Then nothing is left behind.
    """
    out = Path(out)
    check_place(source, out, replace_source=replace_source, accept_truncated=accept_truncated)
    writer = _writer(out)
    if not recording.markers:
        raise MocapmendError(
            "The recording has no markers to write.", str(source.path), "Choose another one."
        )
    if refined is None and source.provenance is not None:
        refined = source.provenance.refined
    provenance = _provenance(source, repairs, kept_open, corrections, refined)
    group = b""
    if provenance is not None and out.suffix.lower() == ".c3d":
        group = encode_group(provenance, GROUP, Processor.INTEL)
        if len(group) > room_for_records(recording, source.events):
            group = b""
    listed = () if provenance is None else provenance.repairs
    filled = listed_samples(listed, (recording.frames, recording.markers), recording.first_frame)
    content = _Content(source, recording, filled, group, progress)
    if provenance is None or group:
        notes = writer(content, out)
        sidecar.remove(out)
    else:
        with sidecar.staged_record(out, provenance) as finish:
            notes = writer(content, out)
            finish(provenance)
    record = "" if provenance is None else "group" if group else "sidecar"
    return Saved(out, int(filled.sum()), (*_lost(source, out), *notes), record=record)


def _writer(out: Path) -> Callable[[_Content, Path], tuple[str, ...]]:
    writer = _WRITERS.get(out.suffix.lower())
    if writer is None:
        raise MocapmendError(
            f"Files that end in {out.suffix or 'nothing'} cannot be written.",
            str(out),
            f"Choose a name that ends in one of {', '.join(_WRITERS)}.",
        )
    return _write_long if out.name.lower().endswith(LONG_CSV) else writer


def _write_long(content: _Content, out: Path) -> tuple[str, ...]:
    return write_csv(
        content.recording, out, layout="long", filled=content.filled, progress=content.progress
    )


def _provenance(
    source: Source,
    repairs: Sequence[RepairRecord],
    kept_open: Sequence[KeptGap],
    corrections: Corrections,
    refined: Refinement | None,
) -> Provenance | None:
    """Return the repair record of the new file, in which the points are the markers."""
    if not (repairs or kept_open or corrections or refined):
        return None
    earlier = () if source.provenance is None else source.provenance.inputs
    with open_file(source.path) as (_, stamp):
        if stamp != source.stamp:
            raise changed_on_disk(source.path)
    inputs = (*earlier, sidecar.hash_file(source.path))
    markers = source.markers_by_point
    exchanged = [
        replace(entry, from_point=markers[entry.from_point] + 1) for entry in corrections.moved
    ]
    return Provenance(
        _moved(source, repairs),
        inputs,
        kept_open=_moved(source, kept_open),
        corrections=Corrections(
            _moved(source, corrections.set_aside),
            _moved(source, exchanged),
            _moved(source, corrections.smoothed),
            _moved(source, corrections.renamed),
        ),
        refined=refined,
    )


def _moved(source: Source, entries: Sequence[AnyEntry]) -> tuple[AnyEntry, ...]:
    """Return entries of a record whose points are the markers."""
    markers = source.markers_by_point
    moved = [replace(entry, point=markers[entry.point] + 1) for entry in entries]
    # Whatever they were made in: the same entries give the same bytes.
    return tuple(sorted(moved, key=lambda entry: entry.place))


def _lost(source: Source, out: Path) -> tuple[str, ...]:
    """Say what the new file does not have."""
    end = out.suffix.lower()
    held = {
        "analog data": bool(source.analog_labels),
        "model outputs": bool(source.model_outputs),
        "residuals": isinstance(source, C3DFile),
        "events": bool(source.events) and end != ".c3d",
        "bones": bool(source.bones) and end != ".npz",
        "the axis that points up": end == ".trc",
    }
    lost = [name for name, there in held.items() if there]
    return (f"The new file has the markers alone, without {', '.join(lost)}.",) if lost else ()
