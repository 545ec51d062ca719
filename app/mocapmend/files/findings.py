"""Where two C3D files differ: which samples, which analog values, which parameters."""

from collections import Counter
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_header import BLOCK
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_samples import (
    Piece,
    Words,
    marked_missing,
    point_slots,
    point_words,
    unmarked_missing,
)
from mocapmend.files.check_corrections import Originals


class Findings:
    """What differs, collected piece by piece.

    Parameters
    ----------
    layout : Layout
        With which the pieces are read.
    stated, former : Originals
        What the record of the copy, and that of the original, say was measured.

    Attributes
    ----------
    changed : ndarray of bool, shape (frames, points)
        Samples that differ.
    measured, empty, unmarked : ndarray of bool, shape (frames, points)
        Those of them that were there before, that are missing afterwards, and that are not marked
        as computed.
    analog : ndarray of int, shape (channels,)
        Number of analog values that differ.
    places : Counter of str
        Number of bytes that differ outside the frames, by the name of the place.
    restored : ndarray of bool, shape (frames, points)
        Samples that are again what the record of the original says was measured.
    misstated : ndarray of bool, shape (frames, points)
        Samples of which the record of the copy says that something else was measured.
    """

    def __init__(self, layout: Layout, stated: Originals, former: Originals) -> None:
        self._layout = layout
        self._stated = stated
        self._former = former
        self.changed = np.zeros((layout.frames, layout.points), np.bool_)
        self.measured = np.zeros_like(self.changed)
        self.unmarked = np.zeros_like(self.changed)
        self.empty = np.zeros_like(self.changed)
        self.restored = np.zeros_like(self.changed)
        self.misstated = np.zeros_like(self.changed)
        self.analog = np.zeros(layout.channels, np.int64)
        self.places: Counter[str] = Counter()
        self._parts = _parts(layout)

    def forgive(self, earlier: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Allow samples that had been repaired before to be repaired anew, or to be missing again.

        Parameters
        ----------
        earlier : ndarray of bool, shape (frames, points)
            These samples.

        Returns
        -------
        ndarray of bool, shape (frames, points)
            Those of them that are missing again.
        """
        reverted: NDArray[np.bool_] = self.empty & earlier
        self.measured &= ~earlier
        self.empty &= ~reverted
        self.unmarked &= ~reverted
        return reverted

    def forgive_set_aside(self, set_aside: NDArray[np.bool_]) -> int:
        """Allow measured samples to be missing, or replaced, that a record sets aside.

        So are those that are measured again.

        Returns
        -------
        int
            How many measured samples are set aside, or are no longer.
        """
        self.restored &= self.changed
        gone = self.changed & set_aside & self.measured
        self.measured &= ~(set_aside | self.restored)
        left = self.empty & set_aside
        self.empty &= ~(left | self.restored)
        self.unmarked &= ~(left | self.restored)
        return int(np.count_nonzero(gone | self.restored))

    def forgive_ends(self, runs: Iterable[tuple[slice, int]]) -> int:
        """Allow measured samples to be replaced where a repair covers the ends of a gap.

        Parameters
        ----------
        runs : iterable of (slice, int)
            Frames and point of the repairs. One without a missing sample is no repair of a gap.

        Returns
        -------
        int
            How many measured samples these are.
        """
        count = 0
        for rows, point in runs:
            ends = self.measured[rows, point]
            if ends.any() and (self.changed[rows, point] & ~ends).any():
                count += int(np.count_nonzero(ends))
                self.measured[rows, point] = False
        return count

    def add(self, before: Piece, after: Piece) -> None:
        """Note where two pieces differ, and whether the first has what records say of it."""
        if before.frame is not None:
            self._look_at_originals(before, after)
        if np.array_equal(before.raw, after.raw):
            return
        if before.frame is None:
            offsets = before.offset + np.flatnonzero(before.raw != after.raw)
            starts = [start for start, _ in self._parts]
            counts = np.bincount(np.searchsorted(starts, offsets, "right") - 1)
            for at in np.flatnonzero(counts).tolist():
                self.places[self._parts[at][1]] += int(counts[at])
            return
        layout = self._layout
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

    def _look_at_originals(self, before: Piece, after: Piece) -> None:
        assert before.frame is not None
        here = slice(before.frame, before.frame + len(before.raw))
        if self._former.mask[here].any():
            self.restored[here] = self._former.equal(after)
        if self._stated.mask[here].any():
            # What was set aside before is not in the original any more.
            first = self._stated.mask[here] & ~self._former.mask[here]
            self.misstated[here] = first & ~self._stated.equal(before)


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
