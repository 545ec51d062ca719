"""Proof that a repaired file differs from its original only where it may."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files import sidecar
from mocapmend.files.alignment import Alignment, Side, align, pairs, read_side
from mocapmend.files.c3d_group import decode_group
from mocapmend.files.c3d_labels import analog_labels, model_points, point_labels
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.check_allowed import Allowed
from mocapmend.files.check_corrections import Order, Originals
from mocapmend.files.corrections import Renamed, SetAside, changed_labels
from mocapmend.files.findings import Findings
from mocapmend.files.opening import open_file
from mocapmend.files.provenance import Provenance
from mocapmend_algorithms.gaps import runs


@dataclass(frozen=True)
class ChangedRun:
    """Frames of one marker that differ.

    Attributes
    ----------
    label : str
        The marker.
    point : int
        The stored point, from 0.
    first_frame, last_frame : int
        As the file counts frames.
    """

    label: str
    point: int
    first_frame: int
    last_frame: int

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self.last_frame - self.first_frame + 1


@dataclass(frozen=True)
class CheckReport:
    """What a comparison of two files found.

    Attributes
    ----------
    changed : tuple of ChangedRun
        Marker samples that differ, ordered by point and frame; those that may not differ are also
        among the other differences.
    changed_samples : int
        How many they are.
    allowed : tuple of str
        What else differs and may: the repair record, integers that became floats.
    other_differences : tuple of str
        Everything that differs and may not, as sentences.
    identical : bool
        Whether the files are the same, byte for byte.
    """

    changed: tuple[ChangedRun, ...]
    changed_samples: int
    allowed: tuple[str, ...]
    other_differences: tuple[str, ...]
    identical: bool

    @property
    def passed(self) -> bool:
        """Whether nothing differs but what may."""
        return not self.other_differences

    @property
    def sentence(self) -> str:
        """The finding in one sentence."""
        if self.identical:
            return "The files are the same, byte for byte."
        samples = f"{self.changed_samples} marker sample" + "s" * (self.changed_samples != 1)
        if self.changed:
            samples += f" in {len(self.changed)} run" + "s" * (len(self.changed) != 1)
        if self.passed and self.allowed:
            return (
                f"Check passed: {samples} changed; but for the differences that are allowed, all "
                "else is the same."
            )
        if self.passed:
            return f"Check passed: {samples} changed; all else is the same, byte for byte."
        others = len(self.other_differences)
        more = f"{others} other difference" + "s" * (others != 1)
        return f"Check failed: {samples} changed, and there is more: {more}."


@np.errstate(all="ignore")
def check_files(
    original: Path, repaired: Path, provenance: Provenance | None = None
) -> CheckReport:
    """Compare two files, byte by byte.

    These may differ: samples of markers that the original lacks, or that were repaired in it
    before, if the repaired file marks them as computed (fourth word 0) or as missing again;
    measured samples that a listed repair of a gap covers at its ends; the
    repair record, with the numbers of blocks that it moves; integers that became floats, samples
    that were exchanged between markers, set aside, or smoothed, if the repair record says so. A
    sample that the repair record of the repaired file does not list, or
    that is in a gap which it keeps open, may not differ.

    Parameters
    ----------
    original, repaired : Path
        The files.
    provenance : Provenance, optional
        The repair record of the repaired file, where it is neither in it nor beside it yet.

    Raises
    ------
    MocapmendError
        If one of them cannot be read or the original is not a C3D file.
    """
    original, repaired = Path(original), Path(repaired)
    with ExitStack() as stack:
        first, first_stamp = stack.enter_context(open_file(original))
        second, second_stamp = stack.enter_context(open_file(repaired))
        before = read_side(first, first_stamp.size, str(original))
        try:
            after: Side | None = read_side(second, second_stamp.size, str(repaired))
        except MocapmendError:
            after = None
        earlier = _record(original, before)
        record = provenance or (None if after is None else _record(repaired, after))
        labels = changed_labels(_renamed(earlier), _renamed(record))
        alignment = align(before, after, second_stamp.size, labels)
        order = Order(earlier, record, alignment.layout)
        found = Findings(
            alignment.layout,
            Originals(_set_aside(record), alignment.layout),
            Originals(_set_aside(earlier), alignment.layout, order),
        )
        for one, other in pairs(alignment, first, second, (str(original), str(repaired))):
            found.add(order.applied_to(one), other)
    layout = before.layout
    names = point_labels(layout, [])
    models = model_points(layout, names)
    others = []
    if not alignment.sizes_fit:
        others.append(f"The sizes differ: {first_stamp.size} and {second_stamp.size} bytes.")
    if not order.possible:
        others.append("The repair record lists exchanges that contradict each other.")
    allowed = Allowed(order, earlier, record, found, alignment.layout)
    if record is not None and not _names_original(record, earlier, original):
        others.append("The repair record names another original.")
    others += _sentences(layout, names, models, found, allowed)
    if alignment.converted and not (record is not None and record.converted):
        others.append("Integers became floats, and no repair record says so.")
    changed = found.changed
    changed[:, sorted(models)] = False
    return CheckReport(
        changed=tuple(_changed_runs(changed, names, layout)),
        changed_samples=int(np.count_nonzero(changed)),
        allowed=(*allowed.sentences(), *_about_labels(names, labels), *_about_structure(alignment)),
        other_differences=tuple(others),
        identical=alignment.heads_equal and not (others or changed.any()),
    )


def _record(path: Path, side: Side) -> Provenance | None:
    """Read a file's repair record; one that cannot be read counts as none."""
    beside = sidecar.read(path, [])
    if beside is not None:
        return beside
    try:
        return decode_group(side.layout.parameters)
    except ValueError:
        return None


def _names_original(record: Provenance, earlier: Provenance | None, original: Path) -> bool:
    # A copy without new repairs has the record of its original, which names one before.
    copied = earlier is not None and record.inputs == earlier.inputs
    return copied or sidecar.hash_file(original) in record.inputs


def _changed_runs(
    changed: NDArray[np.bool_], names: Sequence[str], layout: Layout
) -> Iterator[ChangedRun]:
    first = layout.first_frame
    for point in np.flatnonzero(changed.any(axis=0)).tolist():
        for start, stop in runs(changed[:, point]):
            yield ChangedRun(names[point], point, first + start, first + stop - 1)


def _renamed(record: Provenance | None) -> tuple[Renamed, ...]:
    return () if record is None else record.corrections.renamed


def _about_labels(names: Sequence[str], labels: Mapping[int, str]) -> Iterator[str]:
    if labels:
        point = min(labels)
        more = "" if len(labels) == 1 else f" and {len(labels) - 1} more"
        yield f"{names[point]} is called {labels[point]}{more}; the repair record lists it."


def _set_aside(record: Provenance | None) -> tuple[SetAside, ...]:
    return () if record is None else record.corrections.set_aside


def _about_structure(alignment: Alignment) -> Iterator[str]:
    """Say what differs outside the samples and may."""
    if alignment.before is None or alignment.after is None:
        return
    blocks = alignment.after.record_blocks - alignment.before.record_blocks
    if alignment.after.record_blocks and not alignment.heads_equal:
        yield (
            "The parameters hold the repair record; it moved the data by "
            f"{blocks} block{'' if abs(blocks) == 1 else 's'}."
        )
    elif blocks:
        yield f"The repair record was taken out of the parameters ({-blocks} blocks)."
    if alignment.converted:
        yield "The integers of the file became floats; all values that were not repaired are equal."


def _sentences(
    layout: Layout,
    labels: tuple[str, ...],
    models: frozenset[int],
    found: Findings,
    allowed: Allowed,
) -> Iterator[str]:
    """Say what differs besides marker samples that are marked as they should be."""
    for place, count in found.places.items():
        yield f"{_differ(count, 'byte')} in {place}."
    for point in np.flatnonzero(found.changed.any(axis=0)).tolist():
        if point in models:
            count, first = _extent(found.changed[:, point], layout)
            differ = _differ(count, "sample")
            yield f"Model output {labels[point]}: {differ}, the first at frame {first}."
            continue
        for wrong, what in (
            (found.measured, " although measured"),
            (found.empty, ", and still missing"),
            (found.unmarked, " without the mark of a computed sample (fourth word 0)"),
            (allowed.unlisted, " without an entry in the repair record"),
            (allowed.protected, " although the repair record keeps the gap open"),
        ):
            if wrong[:, point].any():
                count, first = _extent(wrong[:, point], layout)
                differ = _differ(count, "sample")
                yield f"Marker {labels[point]}: {differ}{what}, the first at frame {first}."
    for point in np.flatnonzero(found.misstated.any(axis=0)).tolist():
        count, first = _extent(found.misstated[:, point], layout)
        samples = "1 sample" if count == 1 else f"{count} samples"
        yield (
            f"Marker {labels[point]}: {samples} set aside were not measured as the repair record "
            f"says, the first at frame {first}."
        )
    names = analog_labels(layout)
    for channel in np.flatnonzero(found.analog).tolist():
        yield f"Analog channel {names[channel]}: {_differ(found.analog[channel], 'value')}."


def _differ(count: int, thing: str) -> str:
    return f"1 {thing} differs" if count == 1 else f"{count} {thing}s differ"


def _extent(changed: NDArray[np.bool_], layout: Layout) -> tuple[int, int]:
    """Return how many frames changed, and the first as the file counts frames."""
    at = np.flatnonzero(changed)
    return len(at), layout.first_frame + int(at[0])
