"""What corrections allow to differ between a file and its repaired copy."""

from collections.abc import Iterable
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_samples import Piece, coordinates, point_slots, point_words
from mocapmend.files.corrections import MovedRun, SetAside
from mocapmend.files.provenance import Provenance
from mocapmend_algorithms.corrections import Move, moved, places_now, stored_places

Mask = NDArray[np.bool_]
Value = TypeVar("Value", np.bool_, np.int32)


class Order:
    """Where the original has what each place of the copy holds, but for repairs.

    Parameters
    ----------
    earlier, record : Provenance or None
        Of the original and of the copy.
    layout : Layout
        Of both.

    Attributes
    ----------
    possible : bool
        Whether the exchanges that the records list can be.
    exchanged : int
        Samples that the copy has at another marker than the original.
    """

    def __init__(
        self, earlier: Provenance | None, record: Provenance | None, layout: Layout
    ) -> None:
        self._layout = layout
        self.possible = True
        self.exchanged = 0
        self._sources: NDArray[np.int32] | None = None
        runs = [() if one is None else one.corrections.moved for one in (earlier, record)]
        if runs[0] == runs[1]:
            return
        try:
            before, after = (_origins(one, layout) for one in runs)
        except ValueError:
            self.possible = False
            return
        self._sources = np.take_along_axis(places_now(before), after, axis=1)
        self.exchanged = int(np.count_nonzero(self._sources != np.arange(layout.points)))

    def applied_to(self, piece: Piece) -> Piece:
        """Return a piece of the original with its points where the copy has them."""
        if self._sources is None or piece.frame is None:
            return piece
        raw = piece.raw.copy()
        sources = self._sources[piece.frame : piece.frame + len(raw)]
        slots = point_slots(raw, self._layout)
        slots[...] = np.take_along_axis(slots, sources[..., None], axis=1)
        return replace(piece, raw=raw)

    def of(self, values: NDArray[Value]) -> NDArray[Value]:
        """Return what is said of places in the original, shape (frames, points), for the copy."""
        if self._sources is None:
            return values
        return np.take_along_axis(values, self._sources, axis=1)


class Originals:
    """The samples that records say were measured where the files have others.

    Parameters
    ----------
    stated : iterable of SetAside
        The runs.
    layout : Layout
        Of the file that they are in.
    order : Order, optional
        To find their places in the copy, where they are in the original.

    Attributes
    ----------
    mask : ndarray of bool, shape (frames, points)
        Where they are.
    """

    def __init__(
        self, stated: Iterable[SetAside], layout: Layout, order: Order | None = None
    ) -> None:
        self._layout = layout
        # The first row is for the places without any.
        rows = [np.full((1, 4), np.nan, np.float32)]
        number = np.zeros((layout.frames, layout.points), np.int32)
        count = 1
        for entry in stated:
            start, stop = entry.rows(layout.first_frame)
            if 0 < entry.point <= layout.points and 0 <= start < stop <= layout.frames:
                number[start:stop, entry.point - 1] = np.arange(count, count + stop - start)
                rows.append(entry.samples)
                count += stop - start
        self._number = number if order is None else order.of(number)
        self._rows = np.concatenate(rows)
        self.mask = self._number > 0

    def equal(self, piece: Piece) -> Mask:
        """Say where a piece of a file has these samples, shape (frames, points)."""
        assert piece.frame is not None
        words = point_words(piece.raw, self._layout)
        inside = slice(piece.frame, piece.frame + len(words))
        same = np.zeros(words.shape[:2], np.bool_)
        at = np.nonzero(self.mask[inside])
        stored = words[at]
        read = [coordinates(stored, self._layout, axis) for axis in range(3)]
        read.append(stored[:, 3].astype(np.float32))
        stated = self._rows[self._number[inside][at]]
        # Bits, because a NaN is not equal to itself.
        equal = np.stack(read, axis=1).view(np.int32) == stated.view(np.int32)
        same[at] = equal.all(axis=1)
        return same


def _origins(stated: Iterable[MovedRun], layout: Layout) -> NDArray[np.int32]:
    origins = stored_places((layout.frames, layout.points))
    moved(
        origins,
        [
            Move(entry.point - 1, *entry.rows(layout.first_frame), entry.from_point - 1)
            for entry in stated
        ],
    )
    return origins
