"""Decoding the points of a C3D file: where they are, how sure, and which are missing."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from io import FileIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from mocapmend.errors import MocapmendError
from mocapmend.files.c3d_layout import Layout
from mocapmend.files.c3d_samples import (
    coordinates,
    marked_missing,
    point_words,
    read_blocks,
    residual_steps,
    unmarked_missing,
)
from mocapmend.files.opening import Stamp, open_file

Room = Callable[[tuple[int, ...]], NDArray[np.float64]]
"""Makes an array of a shape whose values are not set."""

PART_BYTES = 8 << 20
"""How much a file has for each further thread: less is read before that has begun."""


@dataclass(frozen=True)
class Way:
    """How a large file is read.

    Attributes
    ----------
    room : callable
        Makes the array of the coordinates.
    threads : int
        How many read it at once.
    """

    room: Room = np.empty
    threads: int = 1


PLAIN = Way()


class Points:
    """The points of a file that are markers, shape (frames, markers) each.

    Attributes
    ----------
    coordinates : ndarray, shape (frames, markers, 3), float64
        In the file's unit, NaN where missing.
    residuals : ndarray of float32
        NaN where missing.
    present : ndarray of bool
        Where the markers are seen.
    unmarked : int
        Samples that are missing without a mark.

    Parameters
    ----------
    path : Path
        The file.
    layout : Layout
        Of its samples.
    stamp : Stamp
        Of the file when its layout was read.
    markers : tuple of int
        The stored points.
    way : Way
        How it is read.

    Raises
    ------
    MocapmendError
        If the file cannot be read or was changed since.
    MemoryError
        If there is too little of it.
    """

    def __init__(
        self, path: Path, layout: Layout, stamp: Stamp, markers: tuple[int, ...], way: Way
    ) -> None:
        self._path, self._layout, self._stamp = path, layout, stamp
        self._chosen = _index(markers)
        shape = (layout.frames, len(markers))
        self.coordinates = way.room((*shape, 3))
        self.residuals = np.empty(shape, np.float32)
        self.present = np.empty(shape, bool)
        self.unmarked = 0
        if not self.present.size:
            return
        parts = min(way.threads, 1 + layout.frames * layout.frame_bytes // PART_BYTES)
        bounds = np.linspace(0, layout.frames, parts + 1).astype(int).tolist()
        if parts == 1:
            self.unmarked = self._read(*bounds)
        else:
            with ThreadPoolExecutor(parts) as pool:
                self.unmarked = sum(pool.map(self._read, bounds[:-1], bounds[1:]))

    @np.errstate(all="ignore")
    def _read(self, start: int, stop: int) -> int:
        """Read some frames and return how many samples are missing without a mark."""
        # A stream of its own: each part reads on from where it is.
        with open_file(self._path) as (stream, stamp):
            if stamp != self._stamp:
                raise MocapmendError(
                    "The file was changed while it was read.", str(self._path), "Open it again."
                )
            return self._decode(stream, start, stop)

    def _decode(self, stream: FileIO, start: int, stop: int) -> int:
        layout, unmarked = self._layout, 0
        for first, block in read_blocks(stream, layout, str(self._path), start, stop):
            frames = slice(first, first + len(block))
            words = point_words(block, layout)[:, self._chosen]
            here = self.coordinates[frames]
            for axis in range(3):
                here[..., axis] = coordinates(words, layout, axis)
            fourth = np.ascontiguousarray(words[..., 3])
            missing = marked_missing(fourth)
            more = unmarked_missing(words, missing)
            unmarked += int(np.count_nonzero(more))
            missing |= more
            residual = self.residuals[frames]
            np.multiply(residual_steps(fourth), np.float32(layout.scale), out=residual)
            at = np.flatnonzero(missing)
            here.reshape(-1, 3)[at] = np.nan
            residual.reshape(-1)[at] = np.nan
            np.logical_not(missing, out=self.present[frames])
        return unmarked


def _index(markers: tuple[int, ...]) -> slice | list[int]:
    """Index the markers without a copy where they are neighbours."""
    if markers and markers[-1] - markers[0] == len(markers) - 1:
        return slice(markers[0], markers[-1] + 1)
    return list(markers)
