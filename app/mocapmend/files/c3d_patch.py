"""Saving repairs: the bytes of the source, in which only the repaired samples are replaced."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files import sidecar
from mocapmend.files.atomic import not_as_written, write_atomically
from mocapmend.files.c3d_encode import SampleRun, Slots, encode_runs, fits
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_reader import C3DFile
from mocapmend.files.c3d_samples import (
    Piece,
    as_float_block,
    coordinates,
    fill,
    point_slots,
    point_words,
    read_pieces,
)
from mocapmend.files.c3d_target import Target, plan
from mocapmend.files.corrections import NO_CORRECTIONS, Corrections
from mocapmend.files.opening import changed_on_disk, open_file
from mocapmend.files.provenance import Provenance
from mocapmend.files.records import KeptGap, RepairRecord
from mocapmend.files.saving import Saved, check_place
from mocapmend.files.sidecar import NO_HASH
from mocapmend_algorithms.progress import Progress, no_progress


@np.errstate(all="ignore")
def save_patched(
    source: C3DFile,
    runs: Sequence[SampleRun],
    out: Path,
    *,
    repairs: Sequence[RepairRecord] = (),
    kept_open: Sequence[KeptGap] = (),
    corrections: Corrections = NO_CORRECTIONS,
    replace_source: bool = False,
    accept_truncated: bool = False,
    progress: Progress = no_progress,
    confirm: Callable[[Path, Provenance | None], None] | None = None,
) -> Saved:
    """Save a copy of a file in which only the given samples differ.

    The copy is read back and compared before it gets its name. Without runs, and with the same
    gaps kept open, it is the same, byte for byte. Integers that cannot hold a repair become floats.

    Parameters
    ----------
    source : C3DFile
        The file, as it was read.
    runs : sequence of SampleRun
        The samples to be written.
    out : Path
        Where the copy goes.
    repairs : sequence of RepairRecord
        All repairs that the copy will have, for its repair record.
    kept_open : sequence of KeptGap
        All gaps that are kept open in it, for the same.
    corrections : Corrections
        All that was put right besides filling gaps, for the same.
    replace_source : bool
        Whether `out` may be the source itself.
    accept_truncated : bool
        Whether a source that is truncated may be saved.
    progress : Progress
        Called often; may cancel.
    confirm : callable, optional
        Called with the finished copy and its repair record before it gets its name; what it
        raises prevents that.

    Returns
    -------
    Saved
        Where it is and what was written.

    Raises
    ------
    MocapmendError
        If it cannot be saved. Then nothing is left behind.
    """
    out = Path(out)
    if not source.path.exists():
        raise MocapmendError(
            "The original is not there any more; saving copies its bytes.",
            str(source.path),
            "Put it back under this name, then save again.",
        )
    check_place(source, out, replace_source=replace_source, accept_truncated=accept_truncated)
    to_float = not fits(source, runs)
    entries = _Entries(repairs, kept_open, corrections)
    provenance = _provenance(source, runs, entries, to_float=to_float)
    target = plan(source, provenance, to_float=to_float)
    slots = encode_runs(source, runs, target.layout)
    copy = _Copy(source, slots, target, provenance, progress)

    def verify(written: Path) -> None:
        copy.verify(written)
        if confirm is not None:
            confirm(written, copy.provenance)

    if target.record == "sidecar" and copy.provenance is not None:
        with sidecar.staged_record(out, copy.provenance) as finish:
            write_atomically(out, copy.write, verify)
            finish(copy.provenance)
    else:
        write_atomically(out, copy.write, verify)
        sidecar.remove(out)
    return Saved(out, len(slots), slots.notes, to_float, target.record)


class _Entries(NamedTuple):
    """What the repair record of a copy lists."""

    repairs: Sequence[RepairRecord]
    kept_open: Sequence[KeptGap]
    corrections: Corrections


def _provenance(
    source: C3DFile, runs: Sequence[SampleRun], entries: _Entries, *, to_float: bool
) -> Provenance | None:
    """Return the repair record of the copy; the hash of the source is not known yet."""
    former, corrections = source.provenance, entries.corrections
    kept = tuple(sorted(entries.kept_open, key=lambda gap: gap.place))
    known = NO_CORRECTIONS if former is None else former.corrections
    same = not runs and kept == tuple(source.kept_open.values()) and corrections == known
    if same or (former is None and not (entries.repairs or kept or to_float or corrections)):
        return former
    inputs = () if former is None else former.inputs
    converted = to_float or (former is not None and former.converted)
    ordered = tuple(sorted(entries.repairs, key=lambda record: record.place))
    return Provenance(
        ordered,
        (*inputs, NO_HASH),
        converted,
        kept_open=kept,
        corrections=corrections,
        refined=None if former is None else former.refined,
    )


class _Copy:
    """The copy that is being written.

    Attributes
    ----------
    provenance : Provenance or None
        Its repair record; complete when it is written.
    """

    def __init__(
        self,
        source: C3DFile,
        slots: Slots,
        target: Target,
        provenance: Provenance | None,
        progress: Progress,
    ) -> None:
        self.provenance = provenance
        self._source = source
        self._slots = slots
        self._target = target
        self._progress = progress
        self._unsigned = source.analog_unsigned

    def write(self, stream: BinaryIO) -> None:
        """Write it, and hash the source meanwhile."""
        with ThreadPoolExecutor(max_workers=1) as hashing:
            unknown = self.provenance is not None and NO_HASH in self.provenance.inputs
            digest = hashing.submit(sidecar.hash_file, self._source.path) if unknown else None
            stream.writelines(piece.raw.data for piece in self._pieces(0.0))
            if digest is not None:
                self._set_hash(digest.result())
                stream.seek(0)
                stream.write(self._target.head)

    def _set_hash(self, digest: str) -> None:
        assert self.provenance is not None
        inputs = (*self.provenance.inputs[:-1], digest)
        self.provenance = replace(self.provenance, inputs=inputs)
        # Of the same size as before: all hashes have as many digits.
        self._target = plan(self._source, self.provenance, to_float=self._target.to_float)

    def verify(self, path: Path) -> None:
        """Read it back: the samples are as given, and everything else is as in the source.

        Raises
        ------
        MocapmendError
            If it is not so.
        """
        layout = self._target.layout
        with open_file(path) as (stream, stamp):
            if stamp.size != layout.size:
                raise not_as_written(path, "its size")
            for expected in self._pieces(0.5):
                read = np.empty(expected.raw.shape, np.uint8)
                fill(stream, read, str(path))
                if expected.frame is not None:
                    _check_samples(read, expected.frame, self._slots, layout, path)
                if not np.array_equal(expected.raw, read):
                    raise not_as_written(path, "bytes outside the repaired samples")
        self._progress(1.0)

    def _pieces(self, done: float) -> Iterator[Piece]:
        """Yield all that the copy consists of."""
        source, target = self._source, self._target
        yield Piece(0, None, np.frombuffer(target.head, np.uint8))
        with open_file(source.path) as (stream, stamp):
            if stamp != source.stamp:
                raise changed_on_disk(source.path)
            for piece in read_pieces(stream, source.layout, str(source.path)):
                self._progress(done + 0.5 * piece.offset / source.layout.size)
                if piece.frame is not None:
                    yield self._patched(piece, piece.frame)
                elif piece.offset >= source.layout.data_start:
                    yield piece
        yield Piece(target.layout.size, None, np.zeros(target.padding, np.uint8))

    def _patched(self, piece: Piece, frame: int) -> Piece:
        raw = piece.raw
        if self._target.to_float:
            raw = as_float_block(raw, self._source.layout, unsigned=self._unsigned)
        inside = self._slots.within(frame, len(raw))
        place = point_slots(raw, self._target.layout)
        rows, origins = self._slots.frames[inside] - frame, self._slots.origins[inside]
        copied = origins >= 0
        written = self._slots.raw[inside].copy()
        written[copied] = place[rows[copied], origins[copied]]
        place[rows, self._slots.points[inside]] = written
        return Piece(piece.offset, frame, raw)


def _check_samples(
    block: NDArray[np.uint8], frame: int, slots: Slots, layout: Layout, path: Path
) -> None:
    """Compare patched samples of a block, which begins with a frame, with what was to be there."""
    inside = slots.within(frame, len(block))
    # Where bytes were copied, these are compared.
    own = slots.origins[inside] < 0
    values, fourth = slots.values[inside][own], slots.fourth[inside][own]
    at = slots.frames[inside][own] - frame, slots.points[inside][own]
    words = point_words(block, layout)[at]
    missing = np.isnan(values[:, 0])
    read = np.stack([coordinates(words, layout, axis) for axis in range(3)], axis=-1)
    expected = np.where(missing[:, None], 0.0, values).astype(np.float32)
    if layout.is_float:
        same = (read == expected).all()
    else:
        # Half a step of the integers, and the rounding of the products.
        allowed = 0.5 * layout.scale + np.spacing(np.abs(expected))
        same = (np.abs(read.astype(np.float64) - expected) <= allowed).all()
    if not (same and np.array_equal(words[:, 3].astype(np.float32), fourth)):
        raise not_as_written(path, "repaired samples")
