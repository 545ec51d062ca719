"""Tables of one line per sample: frame, time, marker, x, y, z."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mocapmend.files.formats.cells import not_a_number, read_rows, to_float
from mocapmend.files.formats.columns import check_count, clean_label
from mocapmend.files.formats.csv_header import LongColumns
from mocapmend.files.formats.frames import Frames, MissingRule
from mocapmend.files.formats.text import Block, Lines

SPARSEST = 8
"""Samples of the recording per line of the file, at most."""
FREE_SAMPLES = 1_000_000
"""Samples that are no burden however few lines there are."""


@dataclass
class _Samples:
    """Samples in the order of the file; lists of one array per block."""

    columns: LongColumns
    frames: list[NDArray[np.float64]] = field(default_factory=list)
    times: list[NDArray[np.float64]] = field(default_factory=list)
    markers: list[NDArray[np.intp]] = field(default_factory=list)
    points: list[NDArray[np.float64]] = field(default_factory=list)
    ids: dict[str, int] = field(default_factory=dict)
    """Of the labels, in the order of the file."""


def read_samples(
    lines: Lines, columns: LongColumns, separator: str, rule: MissingRule, warnings: list[str]
) -> tuple[Frames, tuple[str, ...]]:
    """Read all other lines of a file as samples.

    A label that a frame has more than once is that of as many markers.

    Returns
    -------
    frames : Frames
        In ascending order.
    labels : tuple of str
        Of the markers, in the order of the file.

    Raises
    ------
    MocapmendError
        If what is there is no table of samples, or hardly any marker is in more than one frame.
    """
    samples = _Samples(columns)
    used = [i for i in (columns.frame, columns.time) if i is not None]
    width = max(columns.marker, columns.x, columns.y, columns.z, *used) + 1
    for every in lines.blocks():
        block = every.without_blank(separator)
        rows = read_rows(lines, block, separator)
        if lines.cut and rows and len(rows[-1]) < width:
            warnings.append("The last line is cut off; it is left out.")
            del rows[-1]
        if not rows:
            continue
        _add(samples, lines, block, rows, separator)
        check_count(lines, len(samples.ids))
    if not samples.points:
        return Frames(np.empty(0), np.empty(0), np.empty((0, 0, 3))), ()
    points = _joined(samples.points)
    rule.apply(points)
    return _arranged(
        lines,
        _joined(samples.frames),
        _joined(samples.times),
        _joined(samples.markers),
        points,
        tuple(samples.ids),
    )


def _joined(parts: list[NDArray[Any]]) -> NDArray[Any]:
    """Join arrays and let go of the parts."""
    whole = np.concatenate(parts)
    parts.clear()
    return whole


def _add(
    samples: _Samples, lines: Lines, block: Block, rows: list[list[str]], separator: str
) -> None:
    columns = samples.columns

    def numbers(column: int | None) -> NDArray[np.float64]:
        if column is None:
            return np.full(len(rows), np.nan)
        return _numbers(lines, block, _cells(rows, column), separator)

    names = _cells(rows, columns.marker)
    ids = samples.ids
    by_name = {name: ids.setdefault(clean_label(name), len(ids)) for name in dict.fromkeys(names)}
    samples.markers.append(np.array([by_name[name] for name in names], np.intp))
    samples.frames.append(numbers(columns.frame))
    samples.times.append(numbers(columns.time) * columns.time_scale)
    samples.points.append(np.stack([numbers(c) for c in (columns.x, columns.y, columns.z)], axis=1))


def _cells(rows: list[list[str]], column: int) -> list[str]:
    try:
        return [row[column] for row in rows]
    except IndexError:
        return [row[column] if column < len(row) else "" for row in rows]


def _numbers(lines: Lines, block: Block, cells: list[str], separator: str) -> NDArray[np.float64]:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        values = [to_float(cell, separator) for cell in cells]
    if None in values:
        at = values.index(None)
        raise not_a_number(lines, block.numbers[at], cells[at])
    return np.array(values, float)


def _arranged(
    lines: Lines,
    frames: NDArray[np.float64],
    times: NDArray[np.float64],
    markers: NDArray[np.intp],
    points: NDArray[np.float64],
    labels: tuple[str, ...],
) -> tuple[Frames, tuple[str, ...]]:
    """Bring samples in any order into frames and markers."""
    key = times if np.isnan(frames).all() else frames
    if np.isnan(key).any():
        raise lines.error("Some lines name neither a frame nor a time.")
    distinct, first, row = np.unique(key, return_index=True, return_inverse=True)
    repeat = _occurrences(row, markers)
    columns, column_first, column = np.unique(
        markers + len(labels) * repeat, return_index=True, return_inverse=True
    )
    check_count(lines, len(columns))
    count = len(distinct) * len(columns)
    if count > SPARSEST * len(points) + FREE_SAMPLES:
        raise lines.error(
            f"{len(points)} lines are too few for {len(columns)} markers in {len(distinct)} frames."
        )
    # Markers are in the order in which the file first names them.
    order = np.argsort(column_first)
    place = np.empty_like(order)
    place[order] = np.arange(len(order))
    arranged = np.full((len(distinct), len(columns), 3), np.nan)
    arranged[row, place[column]] = points
    names = tuple(labels[i] for i in columns[order] % len(labels))
    numbers = distinct if key is frames else np.full(len(distinct), np.nan)
    return Frames(numbers, times[first], arranged), names


def _occurrences(row: NDArray[np.intp], markers: NDArray[np.intp]) -> NDArray[np.intp]:
    """Count, for each sample, how often its frame named its marker before."""
    order = np.lexsort((markers, row))
    same = (np.diff(row[order]) == 0) & (np.diff(markers[order]) == 0)
    if not same.any():
        return np.zeros(len(row), np.intp)
    position = np.arange(len(row))
    starts = np.maximum.accumulate(np.where(np.concatenate([[True], ~same]), position, 0))
    counts = np.empty(len(row), np.intp)
    counts[order] = position - starts
    return counts
