"""Proof that a repaired file differs from its original only in repaired samples."""

from collections import Counter
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_labels import analog_labels, model_points, point_labels
from mocapmend.files.c3d_layout import Layout, read_layout
from mocapmend.files.c3d_samples import (
    Piece,
    Words,
    marked_missing,
    point_slots,
    point_words,
    read_pieces,
    unmarked_missing,
)
from mocapmend.files.opening import open_file
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
    other_differences : tuple of str
        Everything else that differs, as sentences.
    identical : bool
        Whether the files are the same, byte for byte.
    """

    changed: tuple[ChangedRun, ...]
    changed_samples: int
    other_differences: tuple[str, ...]
    identical: bool

    @property
    def passed(self) -> bool:
        """Whether nothing differs but marker samples that were missing and are filled."""
        return not self.other_differences

    @property
    def sentence(self) -> str:
        """The finding in one sentence."""
        if self.identical:
            return "The files are the same, byte for byte."
        samples = f"{self.changed_samples} marker sample" + "s" * (self.changed_samples != 1)
        if self.passed:
            return f"Check passed: {samples} changed; all else is the same, byte for byte."
        others = len(self.other_differences)
        more = f"{others} other difference" + "s" * (others != 1)
        return f"Check failed: {samples} changed, and there is more: {more}."


class _Findings:
    """What differs, collected piece by piece."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.changed = np.zeros((layout.frames, layout.points), np.bool_)
        self.measured = np.zeros_like(self.changed)
        self.unmarked = np.zeros_like(self.changed)
        self.empty = np.zeros_like(self.changed)
        self.analog = np.zeros(layout.channels, np.int64)
        self.places: Counter[str] = Counter()
        self._parts = _parts(layout)

    def add(self, before: Piece, after: Piece) -> None:
        """Note where two pieces differ."""
        if before.frame is None:
            offsets = before.offset + np.flatnonzero(before.raw != after.raw)
            starts = [start for start, _ in self._parts]
            counts = np.bincount(np.searchsorted(starts, offsets, "right") - 1)
            for at in np.flatnonzero(counts).tolist():
                self.places[self._parts[at][1]] += int(counts[at])
            return
        layout = self.layout
        here = slice(before.frame, before.frame + len(before.raw))
        # Wider words than bytes: a quarter of the time.
        slots = _differs(point_slots(before.raw, layout), point_slots(after.raw, layout), 8)
        self.changed[here] = slots.any(axis=2)
        words = point_words(after.raw, layout)
        self.measured[here] = self.changed[here] & ~_missing(point_words(before.raw, layout))
        self.unmarked[here] = self.changed[here] & (words[..., 3] != 0)
        self.empty[here] = self.changed[here] & _missing(words)
        if layout.channels:
            start = layout.points * layout.slot
            values = _differs(before.raw[:, start:], after.raw[:, start:], layout.word)
            self.analog += values.reshape(-1, layout.channels).sum(axis=0)


def _missing(words: Words) -> NDArray[np.bool_]:
    marked = marked_missing(np.ascontiguousarray(words[..., 3]))
    missing: NDArray[np.bool_] = marked | unmarked_missing(words, marked)
    return missing


def _differs(before: NDArray[np.uint8], after: NDArray[np.uint8], size: int) -> NDArray[np.bool_]:
    """Return which words of `size` bytes along the last axis differ."""
    different: NDArray[np.bool_] = before.view(f"u{size}") != after.view(f"u{size}")
    return different


def _parts(layout: Layout) -> list[tuple[int, str]]:
    """Name the parts of the file outside the frames by their first byte, in order."""
    parts = [(0, "the header"), (BLOCK, "blocks that nothing uses")]
    parts.append((layout.parameters_start, "the structure of the parameter section"))
    for name, item in layout.parameters.items():
        parts.append((item.start, f"the parameter {name}"))
        parts.append((item.stop, "the structure of the parameter section"))
    parts.append((layout.parameters.stop, "blocks that nothing uses"))
    if layout.data_start > layout.parameters_start:
        parts.append((layout.data_stop, "what follows the last frame"))
    return sorted(parts, key=lambda part: part[0])


@np.errstate(all="ignore")
def check_files(original: Path, repaired: Path) -> CheckReport:
    """Compare two files, byte by byte.

    Only samples of markers may differ that the original lacks, and only if the repaired file has
    them and marks them as computed (fourth word 0).

    Raises
    ------
    MocapmendError
        If one of them cannot be read or the original is not a C3D file.
    """
    with ExitStack() as stack:
        first, first_stamp = stack.enter_context(open_file(Path(original)))
        second, second_stamp = stack.enter_context(open_file(Path(repaired)))
        layout = read_layout(first, first_stamp.size, str(original))
        common = _limited(layout, min(first_stamp.size, second_stamp.size))
        found = _Findings(common)
        pairs = zip(
            read_pieces(first, common, str(original)),
            read_pieces(second, common, str(repaired)),
            strict=True,
        )
        for before, after in pairs:
            if not np.array_equal(before.raw, after.raw):
                found.add(before, after)
    labels = point_labels(layout, [])
    models = model_points(layout, labels)
    others = []
    if first_stamp.size != second_stamp.size:
        others.append(f"The sizes differ: {first_stamp.size} and {second_stamp.size} bytes.")
    others += _sentences(layout, labels, models, found)
    changed = found.changed
    changed[:, sorted(models)] = False
    return CheckReport(
        changed=tuple(
            ChangedRun(
                labels[point], point, layout.first_frame + start, layout.first_frame + stop - 1
            )
            for point in np.flatnonzero(changed.any(axis=0)).tolist()
            for start, stop in runs(changed[:, point])
        ),
        changed_samples=int(np.count_nonzero(changed)),
        other_differences=tuple(others),
        identical=not (others or changed.any()),
    )


def _limited(layout: Layout, size: int) -> Layout:
    """Return the layout of the first bytes of a file."""
    start = min(layout.data_start, size)
    frames = (size - start) // layout.frame_bytes if layout.frame_bytes else 0
    return replace(layout, size=size, data_start=start, frames=max(min(layout.frames, frames), 0))


def _sentences(
    layout: Layout, labels: tuple[str, ...], models: frozenset[int], found: _Findings
) -> Iterator[str]:
    """Say what differs besides marker samples that are marked as they should be."""
    for place, count in found.places.items():
        yield f"{count} bytes differ in {place}."
    for point in np.flatnonzero(found.changed.any(axis=0)).tolist():
        if point in models:
            count, first = _extent(found.changed[:, point], layout)
            yield (
                f"Model output {labels[point]}: {count} samples differ, the first at frame {first}."
            )
            continue
        for wrong, what in (
            (found.measured, "differ although they were measured"),
            (found.empty, "differ, but are still missing"),
            (found.unmarked, "differ, but are not marked as computed (fourth word 0)"),
        ):
            if wrong[:, point].any():
                count, first = _extent(wrong[:, point], layout)
                yield (
                    f"Marker {labels[point]}: {count} samples {what}, the first at frame {first}."
                )
    names = analog_labels(layout)
    for channel in np.flatnonzero(found.analog).tolist():
        yield f"Analog channel {names[channel]}: {found.analog[channel]} values differ."


def _extent(changed: NDArray[np.bool_], layout: Layout) -> tuple[int, int]:
    """Return how many frames changed, and the first as the file counts frames."""
    at = np.flatnonzero(changed)
    return len(at), layout.first_frame + int(at[0])
